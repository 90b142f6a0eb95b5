// What three wavelengths of a fan meet at an interface, and whether three are enough.

// What three nodes of a fan meet at an interface.
struct Crossing {
    eta: vec3f,
    cos_i: vec3f,
    cos_t_squared: vec3f,
}

// What the nodes of a fan meet at an interface.
fn crossing_of(at: Interface, fan: Fan) -> Crossing {
    let eta = indices_at(at.medium_from, fan.axis) / indices_at(at.medium_to, fan.axis);
    let cos_i = -dot_each(fan.direction, at.normal);
    let sin_i_squared = 1.0 - cos_i * cos_i;
    return Crossing(eta, cos_i, 1.0 - eta * eta * sin_i_squared);
}

// Unpolarised Fresnel reflectances at the nodes, as `fresnel` has them for one ray; 1 beyond the
// critical angle.
fn reflectances(crossing: Crossing) -> vec3f {
    let eta = crossing.eta;
    let cos_i = max(crossing.cos_i, vec3f(0.0));
    let cos_t = sqrt(max(crossing.cos_t_squared, vec3f(0.0)));
    // At the critical angle both amplitudes are 1 by themselves.
    let parallel = (cos_i - eta * cos_t) / max(cos_i + eta * cos_t, vec3f(1e-12));
    let perpendicular = (eta * cos_i - cos_t) / max(eta * cos_i + cos_t, vec3f(1e-12));
    let reflectance = (parallel * parallel + perpendicular * perpendicular) * 0.5;
    let is_total = crossing.cos_t_squared <= vec3f(0.0);
    return select(clamp(reflectance, vec3f(0.0), vec3f(1.0)), vec3f(1.0), is_total);
}

// Whether between the nodes the parabola through the reflectances puts more energy into the wrong part
// than is worth telling apart.
fn is_misjudged(at: Interface, fan: Fan, reflectance: vec3f) -> bool {
    let between = fan_through(fan, vec3f(-0.5, 0.0, 0.5));
    let judged = basis_of(vec3f(-0.5, 0.0, 0.5)) * reflectance;
    let missed = abs(reflectances(crossing_of(at, between)) - judged);
    let energy = max(missed.x, missed.z) * largest(fan.weight) * axis_width(fan);
    return energy > max(frame.rules.cut_threshold, LEAST_MISJUDGED);
}

// A fan that may have been drawn to the critical wavelength.
struct DrawnFan {
    fan: Fan,
    is_elsewhere: bool,
}

// The fan with its middle node so near to the critical wavelength that the cosine of refraction there
// is about the mean of those at the ends, if that is elsewhere than it was: the cosine is the root of
// what is linear along the axis, and with it go reflectance and direction.
fn drawn_to_critical(fan: Fan, crossing: Crossing) -> DrawnFan {
    let low = max(crossing.cos_t_squared.x, 0.0);
    let high = max(crossing.cos_t_squared.z, 0.0);
    let difference = high - low;
    if abs(difference) <= DRAWING_CONTRAST * (high + low) {
        return DrawnFan(fan, false);
    }
    let mean = 0.5 * (sqrt(low) + sqrt(high));
    let share = (mean * mean - low) / difference;
    let middle = position_of(fan, fan.axis.x + share * axis_width(fan));
    var drawn = fan_through(fan, vec3f(-1.0, middle, 1.0));
    // Another parabola through the weights has another integral; the ledger must not notice.
    let energy = fan_energy(fan);
    let drawn_energy = fan_energy(drawn);
    if drawn_energy < 0.25 * energy || drawn_energy <= 0.0 {
        return DrawnFan(fan, false);
    }
    drawn.weight *= energy / drawn_energy;
    return DrawnFan(drawn, true);
}
