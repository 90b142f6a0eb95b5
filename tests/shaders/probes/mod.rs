//! The kernel's functions on both sides, module by module.

mod absorption;
mod camera;
mod convex;
mod deposit;
mod diffuse;
mod fork;
mod interface;
mod intersect;
mod lights;
mod mesh;
mod packed;
mod ray;
mod rng;
mod spread;
mod trace;
mod vector;
mod walk;

use crate::probe::Table;

/// All tables, by the module that they are about.
pub(crate) fn tables() -> Vec<(&'static str, Table)> {
    vec![
        ("vector", vector::table()),
        ("packed", packed::table()),
        ("ray", ray::table()),
        ("rng", rng::table()),
        ("camera", camera::table()),
        ("spread", spread::table()),
        ("interface", interface::table()),
        ("mesh", mesh::table()),
        ("convex", convex::table()),
        ("intersect", intersect::table()),
        ("absorption", absorption::table()),
        ("walk", walk::table()),
        ("deposit", deposit::table()),
        ("lights", lights::table()),
        ("diffuse", diffuse::table()),
        ("fork", fork::table()),
        ("trace", trace::table()),
    ]
}
