//! Angles and directions: degrees in the file, radians and unit vectors in the scene.
//!
//! What is written reads back to the same bits; the shortest decimals that do are chosen.

use glam::{DQuat, DVec3, Quat, Vec3};

/// Most decimals that are tried for a number in degrees.
const DECIMALS: i32 = 12;

/// Radians in single precision, converted in double.
pub(super) fn radians(degrees: f64) -> f32 {
    degrees.to_radians() as f32
}

/// The shortest number of degrees that [`radians`] turns into `radians_wanted`.
pub(super) fn degrees(radians_wanted: f32) -> f64 {
    let exact = f64::from(radians_wanted).to_degrees();
    (0..=DECIMALS)
        .map(|decimals| rounded(exact, decimals))
        .find(|&candidate| radians(candidate) == radians_wanted)
        .unwrap_or(exact)
}

/// The unit vector at `azimuth` degrees from +x towards +y and `elevation` degrees above the
/// horizontal.
pub(super) fn direction(azimuth: f64, elevation: f64) -> Vec3 {
    let (sin_a, cos_a) = azimuth.to_radians().sin_cos();
    let (sin_e, cos_e) = elevation.to_radians().sin_cos();
    // A right angle has no exact radians; what is left of its cosine is not meant.
    let meant = |component: f64| if component.abs() < 1e-15 { 0.0 } else { component };
    DVec3::new(meant(cos_e * cos_a), meant(cos_e * sin_a), sin_e).as_vec3()
}

/// The shortest azimuth and elevation in degrees that [`direction`] turns into `wanted`; `None`
/// where none gives the same bits.
pub(super) fn azimuth_elevation(wanted: Vec3) -> Option<(f64, f64)> {
    let d = wanted.as_dvec3();
    let azimuth = d.y.atan2(d.x).to_degrees().rem_euclid(360.0);
    let elevation = d.z.atan2(d.x.hypot(d.y)).to_degrees();
    (0..=DECIMALS)
        .map(|decimals| (rounded(azimuth, decimals), rounded(elevation, decimals)))
        .find(|&(azimuth, elevation)| direction(azimuth, elevation) == wanted)
}

/// The rotation by `degrees` about `axis`; `None` for an axis without a direction.
pub(super) fn rotation(axis: [f64; 3], degrees: f64) -> Option<Quat> {
    let axis = DVec3::from_array(axis).try_normalize()?;
    Some(DQuat::from_axis_angle(axis, degrees.to_radians()).as_quat())
}

/// The shortest axis and angle in degrees that [`rotation`] turns into `wanted`; `None` where none
/// gives the same bits.
pub(super) fn axis_degrees(wanted: Quat) -> Option<([f64; 3], f64)> {
    let q = wanted.as_dquat();
    let vector = q.xyz();
    let axis = vector / vector.abs().max_element();
    if !axis.is_finite() {
        return None;
    }
    let angle = (2.0 * vector.length().atan2(q.w)).to_degrees();
    (0..=DECIMALS)
        .map(|decimals| {
            let axis = axis.to_array().map(|component| rounded(component, decimals));
            (axis, rounded(angle, decimals))
        })
        .find(|&(axis, angle)| rotation(axis, angle) == Some(wanted))
}

/// `value` to a number of decimals, without a negative zero.
fn rounded(value: f64, decimals: i32) -> f64 {
    let scale = 10.0_f64.powi(decimals);
    (value * scale).round() / scale + 0.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn written_angles_are_short_and_read_back_to_the_same_bits() {
        for wanted in [0.0, 0.265, 1.5, 18.0, 33.2, 90.0] {
            assert_eq!(degrees(radians(wanted)), wanted);
        }
        for bits in (0..1000_u32).map(|i| 0x3a00_0000 + i * 0x1_2345) {
            let angle = f32::from_bits(bits);
            assert_eq!(radians(degrees(angle)).to_bits(), bits);
        }
    }

    #[test]
    fn written_directions_read_back() {
        assert_eq!(azimuth_elevation(direction(20.0, 35.5)), Some((20.0, 35.5)));
        assert_eq!(azimuth_elevation(Vec3::Z), Some((0.0, 90.0)));
        assert_eq!(azimuth_elevation(Vec3::ZERO), None);
    }

    #[test]
    fn written_rotations_read_back() {
        let turn = rotation([0.0, 0.0, 2.0], 30.0).unwrap();
        assert_eq!(axis_degrees(turn), Some(([0.0, 0.0, 1.0], 30.0)));
        let tilt = rotation([1.0, -0.5, 0.0], -75.5).unwrap();
        assert_eq!(axis_degrees(tilt), Some(([-1.0, 0.5, 0.0], 75.5)));
        assert!(rotation([0.0; 3], 30.0).is_none());
    }
}
