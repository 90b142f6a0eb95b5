// The walkers. Each follows the rays of one item, a pixel in a pass, to the end and then takes the
// next. All that a walker knows lies in buffers, so that a dispatch may end after any ray and the
// next one carries on.

// What an item comes to, as the film counts it.
struct Counts {
    segments: u32,
    depth: u32,
    pruned: f32,
}

// What a walker remembers from one dispatch to the next.
struct Walker {
    walk: Walk,
    item: u32,
    is_walking: u32,
    // Of the item, in earlier dispatches.
    counts: Counts,
}

// Sums of what walkers did. Each of `sums` takes two words, the lower one first; energies are in
// units of 1 / `ENERGY_UNIT`, so that the sum of millions loses nothing.
struct Account {
    items: atomic<u32>,
    // Of those, of settled pixels, which are done without a ray.
    settled_items: atomic<u32>,
    max_segments: atomic<u32>,
    sums: array<atomic<u32>, 2 * SUM_COUNT>,
}

// How far the work has come. The accounts are many so that few walkers wait for one.
struct Progress {
    next_item: atomic<u32>,
    accounts: array<Account, ACCOUNT_COUNT>,
}

// What one walker does in one dispatch, in the units of `Account`; sums with the lower word first.
struct Books {
    items: u32,
    settled_items: u32,
    max_segments: u32,
    segments: vec2u,
    returned: vec2u,
    absorbed: vec2u,
    pruned: vec2u,
    cut_off: vec2u,
    lost: vec2u,
}

// Sums as f32: radiance pixel by pixel, the bins of a pixel side by side; behind those of all pixels
// the counts, `COUNTS_LEN` numbers per pixel; behind those a word per pixel that is 1 where it is
// settled, which no walker changes.
@group(2) @binding(0) var<storage, read_write> film: array<atomic<u32>>;
@group(2) @binding(1) var<storage, read_write> walkers: array<Walker>;
@group(2) @binding(2) var<storage, read_write> progress: Progress;

// The item at work, or `NONE`.
var<private> item: u32;
// The item's counts that are in the books.
var<private> item_counts: Counts;
var<private> books: Books;

@compute @workgroup_size(WORKGROUP_SIZE)
fn walk_items(@builtin(global_invocation_id) id: vec3u) {
    let walker = frame.first_walker + id.x;
    resume(walker);
    // Looking first keeps the counter from running over: past the end, each walker counts once.
    if item == NONE && atomicLoad(&progress.next_item) >= frame.item_count {
        return;
    }
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
            get_on();
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
    books = Books();
    walk.walker = walker;
    if walkers[walker].is_walking != 0u {
        item = walkers[walker].item;
        item_counts = walkers[walker].counts;
        walk = walkers[walker].walk;
    }
}

// Leaves the walk for the next dispatch and closes the books of this one.
fn suspend(walker: u32) {
    let is_walking = item != NONE;
    if is_walking {
        book_tally();
        walkers[walker].item = item;
        walkers[walker].counts = item_counts;
        walkers[walker].walk = walk;
    }
    walkers[walker].is_walking = u32(is_walking);
    close_books(walker % ACCOUNT_COUNT);
}

// Takes the next item; false where none is left. That of a settled pixel is done at once.
fn begin_item() -> bool {
    let next = atomicAdd(&progress.next_item, 1u);
    if next >= frame.item_count {
        return false;
    }
    let pixel = next % frame.pixel_count;
    if is_settled(pixel) {
        books.items += 1u;
        books.settled_items += 1u;
        return true;
    }
    item = next;
    item_counts = Counts();
    let x = pixel % frame.width;
    let y = frame.first_row + pixel / frame.width;
    walk.seed = pixel_seed(x, y);
    walk.pass_index = frame.first_pass + item / frame.pixel_count;
    walk.stack_count = 0u;
    walk.tally = Tally();
    for (var bin = 0u; bin < frame.bin_count; bin++) {
        radiance[walk.walker * frame.bin_count + bin] = 0.0;
    }
    set_out(camera_ray(x, y, walk.pass_index));
    return true;
}

// Whether passes leave the pixel out.
fn is_settled(pixel: u32) -> bool {
    let first_mark = frame.pixel_count * (frame.bin_count + COUNTS_LEN);
    return atomicLoad(&film[first_mark + pixel]) != 0u;
}

// Adds the radiance that was found and the counts to the film, and books the item.
fn complete_item() {
    if item == NONE {
        return;
    }
    let pixel = item % frame.pixel_count;
    var sum = 0.0;
    for (var bin = 0u; bin < frame.bin_count; bin++) {
        let value = radiance[walk.walker * frame.bin_count + bin];
        add_to_film(pixel * frame.bin_count + bin, value);
        sum += value;
    }
    let mean = sum / f32(frame.bin_count);
    book_tally();
    let counts_at = frame.pixel_count * frame.bin_count + pixel * COUNTS_LEN;
    add_to_film(counts_at, f32(item_counts.segments));
    add_to_film(counts_at + 1u, f32(item_counts.depth));
    add_to_film(counts_at + 2u, item_counts.pruned);
    add_to_film(counts_at + 3u, 1.0);
    add_to_film(counts_at + 4u, mean * mean);
    books.items += 1u;
    books.max_segments = max(books.max_segments, item_counts.segments);
    item = NONE;
}

// Adds to one number of the film. Another walker may be at the same pixel in another pass.
fn add_to_film(at: u32, value: f32) {
    if value == 0.0 {
        return;
    }
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

// Enters the walk's tally into the books and begins a new one.
fn book_tally() {
    item_counts.segments += walk.tally.segments;
    item_counts.depth = max(item_counts.depth, walk.tally.depth);
    item_counts.pruned += walk.tally.pruned;
    books.segments = plus(books.segments, vec2u(walk.tally.segments, 0u));
    books.returned = plus(books.returned, energy_units(walk.tally.returned));
    books.absorbed = plus(books.absorbed, energy_units(walk.tally.absorbed));
    books.pruned = plus(books.pruned, energy_units(walk.tally.pruned));
    books.cut_off = plus(books.cut_off, energy_units(walk.tally.cut_off));
    books.lost = plus(books.lost, energy_units(walk.tally.lost));
    walk.tally = Tally();
}

// An energy as a whole number of two words, the lower one first; one below 0 in two's complement.
// Rounding may have left it a trifle above 1.
fn energy_units(energy: f32) -> vec2u {
    let units = i32(round(clamp(energy, -1.9, 1.9) * ENERGY_UNIT));
    return vec2u(bitcast<u32>(units), bitcast<u32>(units >> 31u));
}

// The sum of two numbers of two words.
fn plus(a: vec2u, b: vec2u) -> vec2u {
    let low = a.x + b.x;
    return vec2u(low, a.y + b.y + u32(low < a.x));
}

// Enters the books into an account.
fn close_books(account: u32) {
    if books.items > 0u {
        atomicAdd(&progress.accounts[account].items, books.items);
        atomicAdd(&progress.accounts[account].settled_items, books.settled_items);
        atomicMax(&progress.accounts[account].max_segments, books.max_segments);
    }
    add_to_sum(account, 0u, books.segments);
    add_to_sum(account, 1u, books.returned);
    add_to_sum(account, 2u, books.absorbed);
    add_to_sum(account, 3u, books.pruned);
    add_to_sum(account, 4u, books.cut_off);
    add_to_sum(account, 5u, books.lost);
}

// Adds to the sum number `sum`, and carries.
fn add_to_sum(account: u32, sum: u32, value: vec2u) {
    var high = value.y;
    if value.x > 0u {
        let old = atomicAdd(&progress.accounts[account].sums[2u * sum], value.x);
        high += u32(old + value.x < old);
    }
    if high > 0u {
        atomicAdd(&progress.accounts[account].sums[2u * sum + 1u], high);
    }
}
