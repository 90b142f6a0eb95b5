// Fans that are sent on: they wait to be followed, or go into the books.

// `FAN_STACK_LEN` fans per walker, in place of the rays.
@group(1) @binding(1) var<storage, read_write> fans: array<Fan>;

// Takes the fan that was put on the stack last.
fn pop_fan() -> Fan {
    walk.stack_count--;
    return fans[walk.walker * FAN_STACK_LEN + walk.stack_count];
}

// Has a fan wait, for which there must be room.
fn push_fan(fan: Fan) {
    fans[walk.walker * FAN_STACK_LEN + walk.stack_count] = fan;
    walk.stack_count++;
}

// Puts a fan on the stack, or into the books where it is too weak, too deep or too much.
fn send_fan(fan: Fan) {
    var sent = fan;
    if fate_of_fan(&sent, frame.rules.significance_threshold) == FATE_KEPT {
        push_fan(sent);
    }
}

// What becomes of a fan that is sent on; one that is not kept goes into the books.
//
// A fan that carries less energy than `threshold` lives on by chance, and then carries as much more
// as others like it lose. What is gained and lost is booked as pruned: in the mean nothing.
fn fate_of_fan(fan: ptr<function, Fan>, threshold: f32) -> u32 {
    var fate = FATE_KEPT;
    if (*fan).depth > frame.rules.max_depth {
        fate = FATE_TOO_DEEP;
    } else if waiting() == FAN_STACK_LEN {
        fate = FATE_TOO_MANY;
    }
    if fate != FATE_KEPT {
        walk.tally.cut_off += retire_fan(*fan);
        return fate;
    }
    var chance = energy_bound(*fan) / threshold;
    if (*fan).depth <= 1u {
        chance *= FIRST_GRACE;
    }
    if chance >= 1.0 {
        return fate;
    }
    // Before what its path has absorbed: that is booked where those end that live.
    let energy = fan_energy(*fan);
    if chance_sample((*fan).seed, walk.pass_index) >= chance {
        walk.tally.pruned += energy;
        return FATE_TOO_WEAK;
    }
    walk.tally.pruned -= energy * (1.0 / chance - 1.0);
    (*fan).weight /= chance;
    return fate;
}

// About the energy of a fan, after the least that its path may have absorbed.
fn energy_bound(fan: Fan) -> f32 {
    return significance_bound(fan) * axis_width(fan);
}

// The largest of the fan's weights, after the least that its path may have absorbed: but no more than
// nearly all of it, so that chance makes none much larger than it was.
fn significance_bound(fan: Fan) -> f32 {
    let weight = largest(fan.weight);
    if fan.absorber == NONE {
        return weight;
    }
    let path_mm = max(least_of(fan.path_mm), 0.0);
    let kept = exp(-materials[fan.absorber].least_absorption * path_mm);
    return weight * max(kept, LEAST_KEPT);
}

// The largest of the values at the nodes.
fn largest(values: vec3f) -> f32 {
    return max(values.x, max(values.y, values.z));
}

// The least of the values at the nodes.
fn least_of(values: vec3f) -> f32 {
    return min(values.x, min(values.y, values.z));
}

// Whether the fan carries enough for its wavelengths to be told apart where they part.
fn is_worth_dividing(fan: Fan) -> bool {
    return largest(fan.weight) * axis_width(fan) >= frame.rules.cut_threshold;
}
