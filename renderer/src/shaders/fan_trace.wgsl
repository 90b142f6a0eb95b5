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
        send_rest(&fan, reach(fan, middle, hit));
    }
    if is_lost(middle, hit) {
        walk.tally.lost += retire_fan(fan);
    } else if hit.instance == NONE {
        end_at_lights(fan);
    } else {
        let height = dot(middle.origin + middle.direction * hit.distance, hit.normal);
        arrive(&fan, hit, height);
        if meets_opaque(hit) {
            shade_fan(fan, hit);
        } else {
            divide_fan(fan, middle, hit);
        }
    }
}

// Sends what is outside of the reached part of the fan back to wait, and leaves that part.
fn send_rest(fan: ptr<function, Fan>, reached: vec2f) {
    let whole = *fan;
    var low = reached.x;
    var high = reached.y;
    let least_energy = REST_SHARE * frame.rules.cut_threshold;
    let least_width = max(least_energy / max(largest(whole.weight), 1e-12), NARROW);
    if axis_position_in(whole, low) - whole.axis.x <= least_width {
        low = -1.0;
    }
    if whole.axis.z - axis_position_in(whole, high) <= least_width {
        high = 1.0;
    }
    if low == -1.0 && high == 1.0 {
        return;
    }
    let rest = vec4f(high, 1.0, -1.0, low);
    var seed = whole.seed;
    for (var i = 0u; i < 4u; i += 2u) {
        seed = seed_of_way(seed, NEXT_PART);
        if rest[i] < rest[i + 1u] {
            var part = part_of_fan(whole, rest[i], rest[i + 1u]);
            part.seed = seed;
            send_fan(part);
        }
    }
    *fan = part_of_fan(whole, low, high);
}
