// The dispersion axis, along which wavelengths are spaced by what refraction makes of them.

// The value of a table of `len` numbers at `place`, in 0..=1 from its first to its last.
fn table_at(first: u32, len: u32, place: f32) -> f32 {
    let step = clamp(place, 0.0, 1.0) * f32(len - 1u);
    let i = min(u32(step), len - 2u);
    let at = first + i;
    let low = spectra[at];
    let high = spectra[at + 1u];
    return low + (high - low) * (step - f32(i));
}

// The wavelength at a position on the axis, in nm.
fn wavelength_at(axis_position: f32) -> f32 {
    return table_at(frame.axis, AXIS_LEN, axis_position);
}

// How fast the wavelength changes at a position on the axis: nm from one number of the table to the
// next.
fn wavelength_slope_at(axis_position: f32) -> f32 {
    let step = clamp(axis_position, 0.0, 1.0) * f32(AXIS_LEN - 1u);
    let at = frame.axis + min(u32(step), AXIS_LEN - 2u);
    return spectra[at + 1u] - spectra[at];
}

// The position of a wavelength on the axis.
fn axis_position_of(lambda_nm: f32) -> f32 {
    let place = (lambda_nm - LAMBDA_MIN_NM) * (1.0 / f32(INDEX_TABLE_LEN - 1u));
    return table_at(frame.axis + AXIS_LEN, INDEX_TABLE_LEN, place);
}

// The mean over a bin's wavelengths of their position on the axis, and its variance.
fn axis_moments(bin: u32) -> vec2f {
    let first = frame.axis + AXIS_LEN + INDEX_TABLE_LEN + bin;
    return vec2f(spectra[first], spectra[first + frame.bin_count]);
}

// Indices of refraction of a medium at the nodes, which lie at these positions on the axis; 1 for
// air.
fn indices_at(medium: u32, axis_positions: vec3f) -> vec3f {
    if medium == NONE {
        return vec3f(1.0);
    }
    let first = medium + INDEX_TABLE_LEN;
    return vec3f(
        table_at(first, AXIS_LEN, axis_positions.x),
        table_at(first, AXIS_LEN, axis_positions.y),
        table_at(first, AXIS_LEN, axis_positions.z),
    );
}
