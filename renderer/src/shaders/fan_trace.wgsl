// Following fans of rays through the tree of a camera ray's descendants.

// Takes the next fan that waits to the next surface, or to the lights. Only the part about its middle
// goes there; what meets other surfaces waits again.
fn follow_fan() {
    var fan = pop_fan();
    walk.tally.segments += segment_count(fan);
    walk.tally.depth = max(walk.tally.depth, fan.depth);
    var middle = ray_in_fan(fan, 0.0);
    var hit = MISS;
    if !can_only_meet_lights(fan) {
        hit = next_surface(&middle);
        fan = send_rest(fan, reach(fan, middle, hit));
    }
    if is_lost(middle, hit) {
        walk.tally.lost += retire_fan(fan);
    } else if hit.instance == NONE {
        end_at_lights(fan);
    } else {
        let height = dot(middle.origin + middle.direction * hit.distance, hit.normal);
        let arrived = arrive(fan, hit, height);
        if meets_opaque(hit) {
            shade_fan(arrived, hit);
        } else {
            divide_fan(arrived, middle, hit);
        }
    }
}

// Sends what is outside of the reached part of the fan back to wait, and gives that part.
fn send_rest(fan: Fan, reached: vec2f) -> Fan {
    var low = reached.x;
    var high = reached.y;
    let least_energy = REST_SHARE * frame.rules.cut_threshold;
    let least_width = max(least_energy / max(largest(fan.weight), 1e-12), NARROW);
    if axis_position_in(fan, low) - fan.axis.x <= least_width {
        low = -1.0;
    }
    if fan.axis.z - axis_position_in(fan, high) <= least_width {
        high = 1.0;
    }
    if low == -1.0 && high == 1.0 {
        return fan;
    }
    let rest = vec4f(high, 1.0, -1.0, low);
    var seed = fan.seed;
    for (var i = 0u; i < 4u; i += 2u) {
        seed = seed_of_way(seed, NEXT_PART);
        if rest[i] < rest[i + 1u] {
            var part = part_of_fan(fan, rest[i], rest[i + 1u]);
            part.seed = seed;
            send_fan(part);
        }
    }
    return part_of_fan(fan, low, high);
}
