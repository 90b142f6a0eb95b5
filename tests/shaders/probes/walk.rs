//! The stack and the books.

use brilliance_renderer::kernel::ray::Ray;
use brilliance_renderer::kernel::walk::{STACK_LEN, fate_of};
use brilliance_renderer::packed::NONE;

use crate::probe::{Case, Dice, EXACT, Probe, Table, Tolerance, World, throw};

#[test]
fn walk() {
    table().check();
}

/// e^x may be off by 3 + 2|x| ulp, and 1 − e^x by as much in all.
const ENERGY: Tolerance = Tolerance::relative(1e-5).or(2e-6);

pub(super) fn table() -> Table {
    Table {
        worlds: vec![World::full(), World::curt()],
        probes: [stack(), books()].into_iter().flatten().collect(),
    }
}

fn stack() -> Vec<Probe> {
    vec![
        Probe {
            name: "has_rays",
            wgsl: "begin_walk();
    put_bool(has_rays());
    send(take_ray());
    put_bool(has_rays());
    put_walk();",
            rust: |world, take, put| {
                world.walk(take, put, |walk, take, put| {
                    put.bool(walk.has_rays());
                    walk.send(&take.ray());
                    put.bool(walk.has_rays());
                });
            },
            cases: |world| rays_to_send(world, 1),
            tolerance: ENERGY,
        },
        Probe {
            name: "pop",
            wgsl: "begin_walk();
    send(take_ray());
    send(take_ray());
    if has_rays() {
        put_ray(pop());
    }
    send(take_ray());
    put_walk();",
            rust: |world, take, put| {
                world.walk(take, put, |walk, take, put| {
                    walk.send(&take.ray());
                    walk.send(&take.ray());
                    if walk.has_rays() {
                        put.ray(&walk.pop());
                    }
                    walk.send(&take.ray());
                });
            },
            cases: |world| rays_to_send(world, 3),
            tolerance: ENERGY,
        },
        Probe {
            name: "send to a full stack",
            wgsl: "begin_walk();
    let ray = take_ray();
    for (var i = 0u; i < STACK_LEN; i++) {
        send(ray);
    }
    put_u32(walk.stack_count);
    send(ray);
    put_u32(walk.stack_count);
    walk.stack_count = 1u;
    put_walk();",
            rust: |world, take, put| {
                world.walk(take, put, |walk, take, put| {
                    let ray = take.ray();
                    for _ in 0..STACK_LEN {
                        walk.send(&ray);
                    }
                    put.u32(STACK_LEN as u32);
                    walk.send(&ray);
                    put.u32(STACK_LEN as u32);
                    for _ in 1..STACK_LEN {
                        walk.pop();
                    }
                });
            },
            cases: |_| throw(20, |dice| walk_case().ray(&Ray { significance: 1.0, ..dice.ray() })),
            tolerance: ENERGY,
        },
    ]
}

fn books() -> Vec<Probe> {
    vec![
        Probe {
            name: "next_seed",
            wgsl: "begin_walk();
    put_u32(next_seed());
    put_u32(next_seed());
    put_walk();",
            rust: |world, take, put| {
                world.walk(take, put, |walk, _, put| {
                    put.u32(walk.next_seed());
                    put.u32(walk.next_seed());
                });
            },
            cases: |_| {
                let mut cases = throw(100, |dice| Case::new().u32(dice.word()).u32(0));
                cases.push(Case::new().u32(u32::MAX).u32(0));
                cases
            },
            tolerance: EXACT,
        },
        Probe {
            name: "retire",
            wgsl: "begin_walk();
    put_f32(retire(take_ray()));
    put_walk();",
            rust: |world, take, put| {
                world.walk(take, put, |walk, take, put| put.f32(walk.retire(&take.ray())));
            },
            cases: |world| rays_to_send(world, 1),
            tolerance: ENERGY,
        },
        Probe {
            name: "fate_of",
            wgsl: "put_u32(fate_of(take_ray(), take_u32()));",
            rust: |world, take, put| {
                let (ray, waiting) = (take.ray(), take.u32());
                put.u32(fate_of(&world.scene, &world.rules, &ray, waiting) as u32);
            },
            cases: |world| {
                let full = STACK_LEN as u32;
                throw(400, |dice| {
                    let waiting = dice.pick(&[0, 1, full - 1, full]);
                    Case::new().ray(&ray_to_send(world, dice)).u32(waiting)
                })
            },
            tolerance: EXACT,
        },
    ]
}

fn walk_case() -> Case {
    Case::new().u32(1).u32(0)
}

/// Rays to be kept, to be pruned and to be cut off, coloured ones among them.
fn rays_to_send(world: &World, count: usize) -> Vec<Case> {
    throw(400, |dice| (0..count).fold(walk_case(), |case, _| case.ray(&ray_to_send(world, dice))))
}

fn ray_to_send(world: &World, dice: &mut Dice) -> Ray {
    let most = world.rules.max_depth;
    let absorber = dice.pick(&world.absorbers());
    let absorber = dice.pick(&[NONE, absorber]);
    // Where rounding weighs a ray against the threshold there is none.
    let threshold = world.rules.significance_threshold;
    let significance = dice.pick(&[0.5 * threshold, 2.0 * threshold, 1.0]);
    let ray = dice.ray();
    let [low, high] = [ray.lambda_low_nm, ray.lambda_high_nm];
    Ray {
        depth: dice.pick(&[0, most - 1, most, most + 1]),
        significance,
        absorber,
        path_mm: dice.pick(&[0.0, 1e-3, 40.0]),
        lambda_high_nm: if high - low < 0.5 { low } else { high },
        ..ray
    }
}
