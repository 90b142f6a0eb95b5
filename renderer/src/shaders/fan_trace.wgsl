// Following fans of rays through the tree of a camera ray's descendants.

// Takes the next fan that waits to the next surface, or to the lights. Only the part about its middle
// goes there; what meets other surfaces waits again.
fn follow_fan() {
    let fan = pop_fan();
    walk.tally.segments += segment_count(fan);
    walk.tally.depth = max(walk.tally.depth, fan.depth);
    var middle = ray_in_fan(fan, 0.0);
    let hit = next_surface(&middle);
    let part = send_rest(fan, reach(fan, middle, hit));
    if is_lost(middle, hit) {
        walk.tally.lost += retire_fan(part);
    } else if hit.instance == NONE {
        end_at_lights(part);
    } else {
        let height = dot(middle.origin + middle.direction * hit.distance, hit.normal);
        let arrived = arrive(part, hit, height);
        if meets_opaque(hit) {
            shade_fan(arrived, hit);
        } else {
            divide_fan(arrived, middle, hit);
        }
    }
}

// Sends what is outside of the reached part of the fan back to wait, and gives that part.
fn send_rest(fan: Fan, reached: vec2f) -> Fan {
    let half_width = 0.5 * (fan.high - fan.low);
    var low = reached.x;
    var high = reached.y;
    if (low + 1.0) * half_width <= NARROW {
        low = -1.0;
    }
    if (1.0 - high) * half_width <= NARROW {
        high = 1.0;
    }
    if low == -1.0 && high == 1.0 {
        return fan;
    }
    if high < 1.0 {
        send_fan(part_of_fan(fan, high, 1.0));
    }
    if low > -1.0 {
        send_fan(part_of_fan(fan, -1.0, low));
    }
    return part_of_fan(fan, low, high);
}
