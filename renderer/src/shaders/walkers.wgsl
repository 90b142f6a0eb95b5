// The walkers. Each follows the rays of one item, a pixel in a pass, to the end and then takes the
// next. All that a walker knows lies in buffers, so that a dispatch may end after any ray and the
// next one carries on.

// What a walker remembers from one dispatch to the next.
struct Walker {
    walk: Walk,
    item: u32,
    is_walking: u32,
}

// Sums over items. Each of `sums` takes two words, the lower one first; energies are in units of
// 1 / `ENERGY_UNIT`, so that the sum of millions loses nothing.
struct Account {
    items: atomic<u32>,
    max_segments: atomic<u32>,
    sums: array<atomic<u32>, 2 * SUM_COUNT>,
}

// How far the work has come. The accounts are many so that few walkers wait for one.
struct Progress {
    next_item: atomic<u32>,
    accounts: array<Account, ACCOUNT_COUNT>,
}

// Radiance sums as f32, pixel by pixel, the bins of a pixel side by side.
@group(2) @binding(0) var<storage, read_write> film: array<atomic<u32>>;
@group(2) @binding(1) var<storage, read_write> walkers: array<Walker>;
@group(2) @binding(2) var<storage, read_write> progress: Progress;

// The item at work, or `NONE`.
var<private> item: u32;

@compute @workgroup_size(WORKGROUP_SIZE)
fn walk_items(@builtin(global_invocation_id) id: vec3u) {
    let walker = id.x;
    if walker >= frame.walker_count {
        return;
    }
    resume(walker);
    // One ray per turn, whosever it is: a walker with a new item does not wait for its neighbours
    // to end theirs.
    for (var left = frame.budget; left > 0u; left--) {
        if !has_rays() {
            complete_item();
            if !begin_item() {
                break;
            }
        }
        if has_rays() {
            follow();
        }
    }
    if !has_rays() {
        complete_item();
    }
    suspend(walker);
}

// Takes up where the walker was.
fn resume(walker: u32) {
    item = NONE;
    walk.walker = walker;
    if walkers[walker].is_walking != 0u {
        item = walkers[walker].item;
        walk = walkers[walker].walk;
    }
}

// Leaves the walk for the next dispatch.
fn suspend(walker: u32) {
    let is_walking = item != NONE;
    if is_walking {
        walkers[walker].item = item;
        walkers[walker].walk = walk;
    }
    walkers[walker].is_walking = u32(is_walking);
}

// Takes the next item; false where none is left.
fn begin_item() -> bool {
    // Looking first keeps the counter from running over.
    if atomicLoad(&progress.next_item) >= frame.item_count {
        return false;
    }
    let next = atomicAdd(&progress.next_item, 1u);
    if next >= frame.item_count {
        return false;
    }
    item = next;
    let pixel = item % frame.pixel_count;
    let x = pixel % frame.width;
    let y = frame.first_row + pixel / frame.width;
    walk.seed = pixel_seed(x, y);
    walk.pass_index = frame.first_pass + item / frame.pixel_count;
    walk.stack_count = 0u;
    walk.tally = Tally();
    for (var bin = 0u; bin < frame.bin_count; bin++) {
        radiance[walk.walker * frame.bin_count + bin] = 0.0;
    }
    send(camera_ray(x, y, walk.pass_index));
    return true;
}

// Adds the radiance that was found to the film and closes the item's books.
fn complete_item() {
    if item == NONE {
        return;
    }
    let pixel = item % frame.pixel_count;
    for (var bin = 0u; bin < frame.bin_count; bin++) {
        let value = radiance[walk.walker * frame.bin_count + bin];
        if value != 0.0 {
            add_to_film(pixel * frame.bin_count + bin, value);
        }
    }
    book();
    item = NONE;
}

// Adds to one number of the film. Another walker may be at the same pixel in another pass.
fn add_to_film(at: u32, value: f32) {
    var old = atomicLoad(&film[at]);
    loop {
        let sum = bitcast<u32>(bitcast<f32>(old) + value);
        let result = atomicCompareExchangeWeak(&film[at], old, sum);
        if result.exchanged {
            break;
        }
        old = result.old_value;
    }
}

// Enters the walk's tally into an account.
fn book() {
    let account = walk.walker % ACCOUNT_COUNT;
    atomicAdd(&progress.accounts[account].items, 1u);
    atomicMax(&progress.accounts[account].max_segments, walk.tally.segments);
    add_to_sum(account, 0u, walk.tally.segments);
    add_to_sum(account, 1u, energy_units(walk.tally.returned));
    add_to_sum(account, 2u, energy_units(walk.tally.absorbed));
    add_to_sum(account, 3u, energy_units(walk.tally.pruned));
    add_to_sum(account, 4u, energy_units(walk.tally.cut_off));
    add_to_sum(account, 5u, energy_units(walk.tally.lost));
}

// An energy as a whole number; rounding may have left it a trifle below 0 or above 1.
fn energy_units(energy: f32) -> u32 {
    return u32(clamp(energy, 0.0, 2.0) * ENERGY_UNIT + 0.5);
}

// Adds to the sum number `sum`, and carries.
fn add_to_sum(account: u32, sum: u32, value: u32) {
    if value == 0u {
        return;
    }
    let old = atomicAdd(&progress.accounts[account].sums[2u * sum], value);
    if old + value < old {
        atomicAdd(&progress.accounts[account].sums[2u * sum + 1u], 1u);
    }
}
