// The state of one camera ray's walk: the rays that wait, and the books.

// Counts of one camera ray; energies in units of the camera ray's.
struct Tally {
    segments: u32,
    depth: u32,
    returned: f32,
    absorbed: f32,
    pruned: f32,
    cut_off: f32,
    lost: f32,
}

// One camera ray's walk. Its stack and its radiance lie in the buffers below, at the place of the
// walker that it belongs to.
struct Walk {
    walker: u32,
    seed: u32,
    pass_index: u32,
    stack_count: u32,
    tally: Tally,
}

// `STACK_LEN` rays per walker, or in their place fans.
@group(1) @binding(1) var<storage, read_write> stack: array<Ray>;
// One value per bin and walker.
@group(1) @binding(2) var<storage, read_write> radiance: array<f32>;

var<private> walk: Walk;

// A random word that is the same in every pass at the same place of the walk.
fn next_seed() -> u32 {
    walk.seed += 1u;
    return hash(walk.seed);
}

// Whether rays wait.
fn has_rays() -> bool {
    return walk.stack_count > 0u;
}

// Takes the ray that was put on the stack last.
fn pop() -> Ray {
    walk.stack_count--;
    return stack[walk.walker * STACK_LEN + walk.stack_count];
}

// Number of rays that wait.
fn waiting() -> u32 {
    return walk.stack_count;
}

// Has a ray wait, for which there must be room.
fn push(ray: Ray) {
    stack[walk.walker * STACK_LEN + walk.stack_count] = ray;
    walk.stack_count++;
}

// The energy that a ray still carries at its end, after its path's absorption is booked.
fn retire(ray: Ray) -> f32 {
    let energy = ray.significance * bandwidth(ray);
    let kept = mean_transmittance(ray);
    walk.tally.absorbed += energy * (1.0 - kept);
    return energy * kept;
}

// Puts a ray on the stack, or into the books where it is too weak, too deep or too much.
fn send(ray: Ray) {
    let fate = fate_of(ray, waiting());
    if fate == FATE_KEPT {
        push(ray);
        return;
    }
    let energy = retire(ray);
    if fate == FATE_TOO_WEAK {
        walk.tally.pruned += energy;
    } else {
        walk.tally.cut_off += energy;
    }
}

// What becomes of a ray that is sent on while `waiting` others wait.
fn fate_of(ray: Ray, waiting: u32) -> u32 {
    if ray.significance * transmittance_bound(ray) < frame.rules.significance_threshold {
        return FATE_TOO_WEAK;
    }
    if ray.depth > frame.rules.max_depth {
        return FATE_TOO_DEEP;
    }
    if waiting == STACK_LEN {
        return FATE_TOO_MANY;
    }
    return FATE_KEPT;
}
