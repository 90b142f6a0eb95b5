//! Snell, Fresnel and total reflection.

use brilliance_renderer::kernel::interface::{
    Interface, cos_refracted_squared, find_total_refl_wave, fresnel, index_of_refraction,
    is_totally_reflected, reflect, refract, relative_index,
};
use brilliance_renderer::kernel::ray::Ray;
use brilliance_renderer::packed::NONE;
use glam::Vec3;

use crate::probe::{Case, Dice, EXACT, Probe, ROUNDING, Table, Tolerance, World, throw};

#[test]
fn interface() {
    table().check();
}

/// Near the critical angle the refracted cosine is the root of a small difference: an error of
/// 1e-6 in its square is one of 1e-3 in itself.
const CRITICAL: f32 = 1e-3;

pub(super) fn table() -> Table {
    let probes = [media(), refraction(), total_reflection()];
    Table { worlds: vec![World::full()], probes: probes.into_iter().flatten().collect() }
}

fn media() -> Vec<Probe> {
    vec![
        Probe {
            name: "index_of_refraction",
            wgsl: "put_f32(index_of_refraction(take_u32(), take_f32()));",
            rust: |world, take, put| {
                put.f32(index_of_refraction(&world.scene, take.u32(), take.f32()));
            },
            cases: |world| {
                throw(400, |dice| {
                    Case::new().u32(dice.pick(&world.media())).f32(any_wavelength_nm(dice))
                })
            },
            tolerance: ROUNDING,
        },
        Probe {
            name: "relative_index",
            wgsl: "put_f32(relative_index(take_interface(), take_f32()));",
            rust: |world, take, put| {
                put.f32(relative_index(&world.scene, &take.interface(), take.f32()));
            },
            cases: |world| {
                throw(400, |dice| {
                    let at = any_interface(world, dice);
                    Case::new().interface(&at).f32(any_wavelength_nm(dice))
                })
            },
            tolerance: ROUNDING,
        },
    ]
}

fn refraction() -> Vec<Probe> {
    vec![
        Probe {
            name: "reflect",
            wgsl: "put_vec3(reflect(take_vec3(), take_vec3()));",
            rust: |_, take, put| put.vec3(reflect(take.vec3(), take.vec3())),
            cases: |_| incidences(),
            tolerance: ROUNDING,
        },
        Probe {
            name: "cos_refracted_squared",
            wgsl: "let direction = take_vec3();
    put_f32(cos_refracted_squared(-dot(direction, take_vec3()), take_f32()));",
            rust: |_, take, put| {
                let direction = take.vec3();
                put.f32(cos_refracted_squared(-direction.dot(take.vec3()), take.f32()));
            },
            cases: |_| incidences_with_index(),
            // A difference of numbers up to 6.
            tolerance: ROUNDING.or(3e-6),
        },
        Probe {
            name: "refract",
            wgsl: "put_vec3(refract(take_vec3(), take_vec3(), take_f32()));",
            rust: |_, take, put| put.vec3(refract(take.vec3(), take.vec3(), take.f32())),
            cases: |_| incidences_with_index(),
            tolerance: Tolerance::relative(0.0).or(CRITICAL),
        },
        Probe {
            name: "refract away from the critical angle",
            wgsl: "put_vec3(refract(take_vec3(), take_vec3(), take_f32()));",
            rust: |_, take, put| put.vec3(refract(take.vec3(), take.vec3(), take.f32())),
            cases: |_| far_from_critical(),
            tolerance: ROUNDING.or(5e-6),
        },
        Probe {
            name: "fresnel",
            wgsl: "put_f32(fresnel(take_f32(), take_f32(), take_f32()));",
            rust: |_, take, put| put.f32(fresnel(take.f32(), take.f32(), take.f32())),
            cases: |_| cosines(),
            tolerance: ROUNDING,
        },
    ]
}

fn total_reflection() -> Vec<Probe> {
    vec![
        Probe {
            name: "is_totally_reflected",
            wgsl: "put_bool(is_totally_reflected(take_interface(), take_vec3(), take_f32()));",
            rust: |world, take, put| {
                let (at, direction) = (take.interface(), take.vec3());
                put.bool(is_totally_reflected(&world.scene, &at, direction, take.f32()));
            },
            cases: around_critical,
            tolerance: EXACT,
        },
        Probe {
            name: "find_total_refl_wave",
            wgsl: "put_f32(find_total_refl_wave(take_interface(), take_ray(), take_u32() == 1u));",
            rust: |world, take, put| {
                let (at, ray) = (take.interface(), take.ray());
                put.f32(find_total_refl_wave(&world.scene, &at, &ray, take.u32() == 1));
            },
            cases: divided_rays,
            // A rounding of 1e-6 in the sine's square over dn²/dλ·sin²θ of 1.4e-4 per nm.
            tolerance: Tolerance::relative(0.0).or(0.02),
        },
    ]
}

/// Also somewhat outside of the table.
fn any_wavelength_nm(dice: &mut Dice) -> f32 {
    let inside = dice.wavelength_nm();
    dice.pick(&[inside, inside.floor(), 380.0, 730.0, 379.0, 731.0])
}

fn any_interface(world: &World, dice: &mut Dice) -> Interface {
    let media = world.media();
    let (medium_from, medium_to) = (dice.pick(&media), dice.pick(&media));
    Interface { normal: dice.direction(), medium_from, medium_to }
}

/// Cosines of incidence: any, normal, grazing.
fn any_cosine(dice: &mut Dice) -> f32 {
    let any = dice.between(0.0, 1.0);
    let grazing = dice.magnitude(1e-6, 1e-2);
    dice.pick(&[any, any, any, 1.0, 1.0 - 1e-6, grazing, 0.0])
}

/// Directions and the normals that they come in against.
fn incidences() -> Vec<Case> {
    throw(500, |dice| {
        let normal = dice.direction();
        let cos = any_cosine(dice);
        Case::new().vec3(dice.direction_at(-normal, cos)).vec3(normal)
    })
}

/// Both ways through surfaces of diamond, glass, air and nothing; a quarter on the critical angle.
fn incidences_with_index() -> Vec<Case> {
    throw(1000, |dice| {
        let normal = dice.direction();
        let eta = dice.pick(&[2.46, 1.0 / 2.46, 1.784, 1.0, 1.3, 1.0 / 1.3]);
        let critical = (1.0_f32 - 1.0 / (eta * eta)).max(0.0).sqrt();
        let cos = any_cosine(dice);
        let cos = dice.pick(&[cos, cos, cos, critical]);
        Case::new().vec3(dice.direction_at(-normal, cos)).vec3(normal).f32(eta)
    })
}

fn far_from_critical() -> Vec<Case> {
    throw(1000, |dice| {
        let normal = dice.direction();
        let eta = dice.pick(&[2.46, 1.0 / 2.46, 1.784, 1.0, 1.3, 1.0 / 1.3]);
        let critical = (1.0_f32 - 1.0 / (eta * eta)).max(0.0).sqrt();
        let above = dice.between(critical + 0.05, 1.0);
        let cos = dice.pick(&[above, critical - 0.05]);
        Case::new().vec3(dice.direction_at(-normal, cos.clamp(0.1, 1.0))).vec3(normal).f32(eta)
    })
}

/// Cosines on both sides of a surface, from normal to grazing and critical.
fn cosines() -> Vec<Case> {
    throw(1000, |dice| {
        let eta = dice.pick(&[2.46, 1.0 / 2.46, 1.784, 1.0]);
        let cos_i = any_cosine(dice).max(1e-6);
        let cos_t = cos_refracted_squared(cos_i, eta).max(0.0).sqrt();
        Case::new().f32(cos_i).f32(cos_t).f32(eta)
    })
}

/// The cosine of the critical angle at `lambda_nm` from the denser side.
fn critical_cosine(world: &World, at: &Interface, lambda_nm: f32) -> f32 {
    let eta = relative_index(&world.scene, at, lambda_nm);
    (1.0 - 1.0 / (eta * eta)).max(0.0).sqrt()
}

/// Directions of about length 1 on both sides of the critical angle, but a thousandth from it.
fn around_critical(world: &World) -> Vec<Case> {
    throw(1000, |dice| {
        let at = any_interface(world, dice);
        let lambda_nm = dice.wavelength_nm();
        let critical = critical_cosine(world, &at, lambda_nm);
        let any = any_cosine(dice);
        let cos = dice.pick(&[any, critical + 1e-3, critical - 1e-3]);
        let cos = if (cos - critical).abs() < 9e-4 { 0.5 * critical } else { cos };
        let direction = dice.direction_at(-at.normal, cos.clamp(0.001, 1.0));
        let length = dice.between(0.9, 1.1);
        Case::new().interface(&at).vec3(direction * length).f32(lambda_nm)
    })
}

/// Rays of which a part is totally reflected, with and without spread.
fn divided_rays(world: &World) -> Vec<Case> {
    let media = world.media();
    let mut dice = Dice::new(3);
    let mut cases = Vec::new();
    while cases.len() < 300 {
        let medium_from = dice.pick(&media);
        let at = Interface { normal: dice.direction(), medium_from, medium_to: NONE };
        let lambda_nm = dice.wavelength_nm();
        let direction = dice.direction_at(-at.normal, critical_cosine(world, &at, lambda_nm));
        let spread = direction.cross(dice.direction()) * dice.pick(&[0.0, 1e-3, 0.02]);
        let [lambda_low_nm, lambda_high_nm] = dice.interval_nm();
        let ray =
            Ray { lambda_low_nm, lambda_high_nm, spread, ..Ray::white(Vec3::ZERO, direction) };
        let reflects = |end: Vec3, nm| is_totally_reflected(&world.scene, &at, end, nm);
        let low_is_reflected = reflects(direction - spread, lambda_low_nm);
        if low_is_reflected != reflects(direction + spread, lambda_high_nm) {
            cases.push(Case::new().interface(&at).ray(&ray).u32(u32::from(low_is_reflected)));
        }
    }
    cases
}
