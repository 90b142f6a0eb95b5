//! Light that goes straight through clear bodies.

use brilliance_renderer::kernel::deposit::Reflectance;
use brilliance_renderer::kernel::diffuse::direction_on_disc;
use brilliance_renderer::kernel::interface::index_of_refraction;
use brilliance_renderer::kernel::passage::{
    Beam, bend, facet_gain, follow_back, is_out_of_reach, nears_both_facets, shine_through,
};
use brilliance_renderer::kernel::ray::{Hit, Ray};
use brilliance_renderer::spectrum::{LAMBDA_MAX_NM, LAMBDA_MIN_NM};
use glam::Vec3;

use super::diffuse::matte_points;
use crate::probe::{Case, Dice, EXACT, Probe, ROUNDING, Table, Tolerance, World, throw};

#[test]
fn passage() {
    table().check();
}

pub(super) fn table() -> Table {
    let probes =
        vec![shine_through_probe(), reach(), bend_probe(), gain(), nearness(), follow_back_probe()];
    Table { worlds: vec![World::throwing(), World::full()], probes }
}

fn shine_through_probe() -> Probe {
    Probe {
        name: "shine_through",
        wgsl: "begin_walk();
    let ray = take_ray();
    let hit = take_hit();
    let normal = take_vec3();
    let light = take_u32();
    shine_through(ray, hit, normal, light, take_vec3(), take_reflectance());
    put_walk();",
        rust: |world, take, put| {
            world.walk(take, put, |walk, take, _| {
                let (ray, hit, normal) = (take.ray(), take.hit(), take.vec3());
                let light = take.u32();
                let towards_light = take.vec3();
                let reflectance = take.reflectance();
                shine_through(walk, &ray, &hit, normal, light, towards_light, &reflectance);
            });
        },
        cases: |world| {
            let mut dice = Dice::new(43);
            let lit = lit_points(world, &mut dice);
            let case = |(ray, hit, light, towards): &(Ray, Hit, u32, Vec3)| {
                let start = Case::new().u32(dice.word()).u32(dice.word() >> 22);
                let start = start.ray(ray).hit(hit).vec3(hit.normal).u32(*light);
                start.vec3(*towards).reflectance(&Reflectance::bare(0))
            };
            lit.iter().map(case).collect()
        },
        // Where rounding decides which facet is met, or what is in the way.
        tolerance: Tolerance::relative(1e-4).or(1e-5).but(0.01),
    }
}

fn reach() -> Probe {
    Probe {
        name: "is_out_of_reach",
        wgsl: "put_bool(is_out_of_reach(passages[take_u32()], take_vec3()));",
        rust: |world, take, put| {
            let passage = &world.scene.passages[take.u32() as usize];
            put.bool(is_out_of_reach(passage, take.vec3()));
        },
        cases: |world| {
            let passages = world.scene.passages.len();
            let case = |dice: &mut Dice| {
                Case::new().u32(dice.below(passages) as u32).vec3(dice.point(8.0))
            };
            if passages == 0 { Vec::new() } else { throw(2000, case) }
        },
        // On the edge of the reach.
        tolerance: EXACT.but(0.002),
    }
}

fn bend_probe() -> Probe {
    Probe {
        name: "bend",
        wgsl: "let beam = bend(passages[take_u32()], take_vec3(), take_f32());
    put_vec3(beam.inside);
    put_vec3(beam.behind);
    put_f32(beam.gain);",
        rust: |world, take, put| {
            let passage = &world.scene.passages[take.u32() as usize];
            let beam = bend(&world.scene, passage, take.vec3(), take.f32());
            put.vec3(beam.inside);
            put.vec3(beam.behind);
            put.f32(beam.gain);
        },
        cases: |world| {
            let mut cases = Vec::new();
            let mut dice = Dice::new(47);
            let ends = [LAMBDA_MIN_NM, LAMBDA_MAX_NM];
            for (number, passage) in (0..).zip(&world.scene.passages) {
                let case = |towards: Vec3, nm: f32| Case::new().u32(number).vec3(towards).f32(nm);
                for (light, nm) in (0..world.scene.discs.len()).zip(ends.into_iter().cycle()) {
                    cases.push(case(on_disc(world, light, &mut dice), nm));
                }
                let nm = dice.between(LAMBDA_MIN_NM, LAMBDA_MAX_NM);
                cases.push(case(dice.direction(), nm));
                cases.push(case(passage.normal_in, nm));
                cases.push(case(-passage.normal_in, nm));
            }
            cases
        },
        // The cosine of a grazing angle is the root of a small difference; and where it is 0,
        // rounding decides whether light gets through.
        tolerance: Tolerance::relative(1e-4).or(2e-4).but(0.002),
    }
}

fn gain() -> Probe {
    Probe {
        name: "facet_gain",
        wgsl: "put_f32(facet_gain(take_f32(), take_f32()));",
        rust: |_, take, put| put.f32(facet_gain(take.f32(), take.f32())),
        cases: |world| {
            let mut cases = Vec::new();
            let mut dice = Dice::new(53);
            let medium = world.media()[0];
            for _ in 0..500 {
                let n = index_of_refraction(&world.scene, medium, dice.between(380.0, 730.0));
                cases.push(Case::new().f32(dice.between(0.0, 1.0)).f32(1.0 / n));
                let critical = (1.0 - 1.0 / (n * n)).sqrt();
                cases.push(Case::new().f32(dice.between(critical + 1e-3, 1.0)).f32(n));
            }
            cases.extend([0.4, 1.0, 2.5].map(|eta| Case::new().f32(1.0).f32(eta)));
            cases.extend([0.4, 1.0].map(|eta| Case::new().f32(1e-3).f32(eta)));
            cases
        },
        // Next to the critical angle the cosine beyond is the root of a small difference.
        tolerance: ROUNDING.or(2e-4),
    }
}

fn nearness() -> Probe {
    Probe {
        name: "nears_both_facets",
        wgsl: "let passage = passages[take_u32()];
    let beam = Beam(take_vec3(), take_vec3(), 1.0);
    put_bool(nears_both_facets(passage, beam, take_vec3()));",
        rust: |world, take, put| {
            let passage = &world.scene.passages[take.u32() as usize];
            let beam = Beam { inside: take.vec3(), behind: take.vec3(), gain: 1.0 };
            put.bool(nears_both_facets(passage, &beam, take.vec3()));
        },
        cases: |world| {
            let case = |found: &Found| {
                let case = Case::new().u32(found.number).vec3(found.beam.inside);
                case.vec3(found.beam.behind).vec3(found.ray.origin)
            };
            found_beams(world).iter().map(case).collect()
        },
        // On the edge of a sphere.
        tolerance: EXACT.but(0.002),
    }
}

fn follow_back_probe() -> Probe {
    Probe {
        name: "follow_back",
        wgsl: "begin_walk();
    let ray = take_ray();
    let hit = take_hit();
    let passage = passages[take_u32()];
    let beam = Beam(take_vec3(), take_vec3(), 1.0);
    put_f32(follow_back(ray, hit, passage, beam, take_vec3(), take_u32()));
    put_walk();",
        rust: |world, take, put| {
            world.walk(take, put, |walk, take, put| {
                let (ray, hit) = (take.ray(), take.hit());
                let passage = &walk.scene.passages[take.u32() as usize];
                let beam = Beam { inside: take.vec3(), behind: take.vec3(), gain: 1.0 };
                let (towards_light, bin) = (take.vec3(), take.u32());
                put.f32(follow_back(walk, &ray, &hit, passage, &beam, towards_light, bin));
            });
        },
        cases: |world| {
            let case = |found: &Found| {
                let case = Case::new().u32(0).u32(0).ray(&found.ray).hit(&found.hit);
                let case = case.u32(found.number).vec3(found.beam.inside);
                case.vec3(found.beam.behind).vec3(found.towards_light).u32(found.bin)
            };
            found_beams(world).iter().map(case).collect()
        },
        // Where rounding decides which facet is met, or what is in the way.
        tolerance: Tolerance::relative(1e-5).but(0.01),
    }
}

/// A beam that may fall on a point.
struct Found {
    ray: Ray,
    hit: Hit,
    number: u32,
    beam: Beam,
    towards_light: Vec3,
    bin: u32,
}

/// As many as the device has room for stacks for.
fn found_beams(world: &World) -> Vec<Found> {
    let mut found = Vec::new();
    let mut dice = Dice::new(59);
    for (ray, hit, light, towards_light) in lit_points(world, &mut dice) {
        let disc = world.scene.discs[light as usize];
        for number in disc.first_passage..disc.first_passage + disc.passage_count {
            let passage = &world.scene.passages[number as usize];
            let bin = dice.below(world.scene.bins.count());
            let (low_nm, high_nm) = world.scene.bins.range_nm(bin);
            let beam = bend(&world.scene, passage, towards_light, 0.5 * (low_nm + high_nm));
            if beam.gain > 0.0 && !is_out_of_reach(passage, ray.origin) {
                found.push(Found { ray, hit, number, beam, towards_light, bin: bin as u32 });
            }
        }
    }
    found.truncate(4000);
    found
}

/// Points of matte surfaces, each with a lamp and a direction on it.
fn lit_points(world: &World, dice: &mut Dice) -> Vec<(Ray, Hit, u32, Vec3)> {
    let point = |(ray, hit): (Ray, Hit)| {
        let light = dice.below(world.scene.discs.len());
        (ray, hit, light as u32, on_disc(world, light, dice))
    };
    matte_points(world).into_iter().map(point).collect()
}

fn on_disc(world: &World, light: usize, dice: &mut Dice) -> Vec3 {
    let at = [dice.between(0.0, 1.0), dice.between(0.0, 1.0)];
    direction_on_disc(&world.scene.discs[light], at)
}
