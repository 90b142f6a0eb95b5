//! The recorded tree of rays is the tree of the picture.

#[path = "parity/cases.rs"]
mod cases;

use std::cell::Cell;
use std::path::Path;
use std::sync::Arc;

use brilliance_renderer::error::RendererError;
use brilliance_renderer::inspect::{
    LightKind, Limit, RayEnd, RayKind, RayTree, RayTreeRequest, RecordedRay,
};
use brilliance_renderer::kernel::absorption::{bin_overlap, bin_range};
use brilliance_renderer::kernel::nodes::{basis_at, blend, nodes_of};
use brilliance_renderer::scene_file::{Document, scenes};
use brilliance_renderer::settings::Splitting;
use brilliance_renderer::statistics::Ledger;
use brilliance_renderer::tracer::{CpuTracer, Tracer as _};
use cases::Case;

fn request(case: &Case, pixel: [u32; 2], pass_index: u32) -> RayTreeRequest {
    RayTreeRequest {
        scene: Arc::new(case.document.scene.clone()),
        camera: case.document.scene.camera,
        size: case.size,
        pixel,
        pass_index,
        trace: case.settings().clone(),
    }
}

fn tree(case: &Case, pixel: [u32; 2]) -> RayTree {
    RayTree::trace(&request(case, pixel, 0), RayTree::MAX_RAYS).expect("the tree is traced")
}

const SPLITTINGS: [Splitting; 2] = [Splitting::Paper, Splitting::Exact];

/// The case as it is traced by `splitting`.
fn split(mut case: Case, splitting: Splitting) -> Case {
    case.document.trace.splitting = splitting;
    case
}

/// The same with less left to chance, so that there is more to be seen.
fn split_finely(case: Case, splitting: Splitting) -> Case {
    let mut case = split(case, splitting);
    case.document.trace.roulette_threshold = 1e-3;
    case
}

/// A pixel in the middle of the picture of a brilliant in its usual light.
fn tree_in_diamond(splitting: Splitting) -> RayTree {
    let tree = tree(&split_finely(cases::diamond(), splitting), [22, 25]);
    assert!(tree.rays.len() > 100, "{} rays", tree.rays.len());
    tree
}

/// Trees of one stone and of several, by both splittings.
fn trees_in_both() -> impl Iterator<Item = RayTree> {
    SPLITTINGS.into_iter().flat_map(|splitting| {
        [tree_in_diamond(splitting), tree(&split_finely(cases::nested(), splitting), [10, 22])]
    })
}

fn all_cases() -> Vec<Case> {
    let cases = [
        cases::diamond,
        cases::beam,
        cases::print,
        cases::seven_diamonds,
        cases::mesh,
        cases::prism,
        cases::nested,
        cases::furnace,
        cases::small_diamond,
        cases::banded,
    ];
    let shipped = scenes().iter().map(|scene| {
        let document = Document::from_toml(scene.text, Path::new("")).expect("it is right");
        Case { size: [24, 24], passes: 1, ..Case::new(scene.name, document) }
    });
    let of_splitting = |splitting| {
        let cases = cases.map(|case| case()).into_iter().chain(shipped.clone());
        cases.map(move |case| split(case, splitting)).collect::<Vec<_>>()
    };
    SPLITTINGS.into_iter().flat_map(of_splitting).collect()
}

/// What the processor adds to the film in each pass, and to the books.
fn films(case: &Case) -> Vec<(Vec<f32>, Ledger)> {
    let tracer = CpuTracer::new(0).expect("threads");
    let (scene, view) = (case.packed(), case.view());
    let mut film = tracer.film(case.size, case.bins(), None).expect("a film");
    (0..case.passes)
        .map(|_| {
            // The film begins at 0 again, but goes on to the next pass.
            film.sums_mut().fill(0.0);
            let statistics = tracer
                .trace(&scene, &view, case.settings(), &mut film, 1, &|| false)
                .expect("a pass is traced");
            (film.sums().to_vec(), statistics.ledger)
        })
        .collect()
}

/// What the recorded rays added to the pixel, summed up.
fn sum_of_leaves(tree: &RayTree) -> Vec<f32> {
    let mut sums = vec![0.0_f64; tree.radiance_per_bin.len()];
    for ray in &tree.rays {
        for (sum, radiance) in sums.iter_mut().zip(&ray.radiance_per_bin) {
            *sum += radiance;
        }
    }
    sums.into_iter().map(|sum| sum as f32).collect()
}

#[test]
fn the_rays_add_up_to_the_film_bit_for_bit() {
    for case in all_cases() {
        let bins = case.bins().count();
        let [width, height] = case.size;
        for (pass_index, (film, _)) in films(&case).iter().enumerate() {
            for number in (0..width * height).step_by(13) {
                let pixel = [number % width, number / width];
                let request = request(&case, pixel, pass_index as u32);
                let tree = RayTree::trace(&request, RayTree::MAX_RAYS).expect("it is traced");
                assert!(!tree.is_truncated);
                let start = number as usize * bins;
                let of_film = &film[start..start + bins];
                let splitting = case.settings().splitting;
                let place = format!("{} {splitting:?} {pixel:?} pass {pass_index}", case.name);
                assert_eq!(tree.radiance_per_bin, of_film, "{place}");
                assert_eq!(sum_of_leaves(&tree), of_film, "{place}");
            }
        }
    }
}

#[test]
fn the_books_of_all_pixels_are_those_of_the_picture() {
    let cases = [cases::nested, cases::small_diamond];
    let in_both = cases.map(|case| SPLITTINGS.map(|splitting| split(case(), splitting)));
    for case in in_both.into_iter().flatten() {
        let [width, height] = case.size;
        let mut sum = Ledger::default();
        let (_, of_picture) = &films(&case)[0];
        for number in 0..width * height {
            let tree = tree(&case, [number % width, number / width]);
            sum += tree.ledger;
            let within = |account: f64, sum: f32| (account - f64::from(sum)).abs() < 1e-5;
            let gained: f32 = tree.rays.iter().map(|ray| ray.energy_gained).sum();
            let ended = |is_end: fn(&RayEnd) -> bool| -> f32 {
                let ends = tree.rays.iter().filter(|ray| is_end(&ray.end));
                ends.map(|ray| ray.energy_at_end).sum()
            };
            let ledger = &tree.ledger;
            let pruned = ended(|end| matches!(end, RayEnd::Pruned)) - gained;
            assert!(within(ledger.pruned, pruned), "{} {pruned}", ledger.pruned);
            assert!(within(ledger.cut_off, ended(|end| matches!(end, RayEnd::CutOff { .. }))));
            assert!(within(ledger.lost, ended(|end| matches!(end, RayEnd::Lost))));
            assert!(within(ledger.returned, ended(is_returned)));
            let absorbed = tree.rays.iter().map(|ray| ray.energy_absorbed).sum();
            assert!(within(ledger.absorbed, absorbed), "{} {absorbed}", ledger.absorbed);
        }
        let accounts = |ledger: &Ledger| {
            let Ledger { entered, returned, absorbed, pruned, cut_off, lost } = *ledger;
            [entered, returned, absorbed, pruned, cut_off, lost]
        };
        for (sum, of_picture) in accounts(&sum).into_iter().zip(accounts(of_picture)) {
            // Sums of the same doubles in another order.
            assert!((sum - of_picture).abs() <= 1e-12 * of_picture.abs(), "{sum} {of_picture}");
        }
    }
}

fn is_returned(end: &RayEnd) -> bool {
    use RayEnd::{Backdrop, Dark, Lights, Matte};
    matches!(end, Backdrop | Dark { .. } | Lights { .. } | Matte { .. })
}

#[test]
fn no_energy_is_made_or_lost_from_a_ray_to_those_that_come_of_it() {
    for tree in trees_in_both() {
        let mut of_children = vec![0.0; tree.rays.len()];
        for ray in &tree.rays {
            if let Some(parent) = ray.parent {
                of_children[parent as usize] += ray.energy - ray.energy_gained;
            }
        }
        for (ray, of_children) in tree.rays.iter().zip(of_children) {
            // What a coloured body has absorbed is paid for later, or at the next one.
            let after = of_children + ray.energy_absorbed + ray.energy_at_end;
            assert!((after - ray.energy).abs() <= 1e-5 * ray.energy, "{ray:?}: {after}");
        }
    }
}

#[test]
fn rays_stand_in_tree_order_and_join_end_to_end() {
    for tree in trees_in_both() {
        for (i, ray) in tree.rays.iter().enumerate() {
            assert_eq!(ray.id as usize, i);
            let Some(parent) = ray.parent else {
                assert_eq!((i, ray.depth, ray.kind), (0, 0, RayKind::Camera));
                continue;
            };
            let parent = &tree.rays[parent as usize];
            assert!(parent.id < ray.id);
            assert_eq!(ray.depth, parent.depth + 1);
            if tree.splitting == Splitting::Paper {
                assert_eq!(Some(ray.origin_mm), parent.end_mm);
            } else {
                assert!(starts_within_end_of(ray, parent), "{ray:?} {parent:?}");
            }
            // The ends of parts of fans are rounded.
            let rounding_nm = if tree.splitting == Splitting::Paper { 0.0 } else { 1e-3 };
            assert!(ray.lambda_low_nm >= parent.lambda_low_nm - rounding_nm);
            assert!(ray.lambda_high_nm <= parent.lambda_high_nm + rounding_nm);
            let RayEnd::Interface(event) = &parent.end else { panic!("{parent:?}") };
            assert_eq!(ray.from.as_ref(), Some(&event.surface));
            // Right behind its parent, or behind another ray of the same branch.
            let branch = tree.path_to_camera(ray.id - 1).any(|before| before.id == parent.id);
            assert!(branch, "{i}");
        }
    }
}

/// Whether all three places where the rays start lie on the curve through those where the other ray's
/// wavelengths end.
fn starts_within_end_of(ray: &RecordedRay, parent: &RecordedRay) -> bool {
    let [low, high] = parent.edges.map(|edge| edge.end_mm.expect("it ends at a surface"));
    let middle = parent.end_mm.expect("so does its middle");
    // Of 64 chords of the parabola through them.
    let points: Vec<_> = (0..=64)
        .map(|i| {
            let position = i as f32 / 32.0 - 1.0;
            blend(&nodes_of(low, middle, high), basis_at(position))
        })
        .collect();
    let [first, last] = ray.edges.map(|edge| edge.origin_mm);
    [first, ray.origin_mm, last].iter().all(|start| {
        points.windows(2).any(|chord| {
            let chord_length = chord[0].distance(chord[1]);
            start.distance(chord[0]) + start.distance(chord[1]) < 1.01 * chord_length + 1e-4
        })
    })
}

#[test]
fn interfaces_obey_snell_and_fresnel() {
    let mut refractions = 0;
    for ray in SPLITTINGS.into_iter().flat_map(|splitting| tree_in_diamond(splitting).rays) {
        let RayEnd::Interface(event) = &ray.end else { continue };
        assert_eq!(event.reflectance + event.transmittance, 1.0);
        let sine = event.n_before / event.n_after * event.incidence_degrees.to_radians().sin();
        let Some(refraction) = event.refraction_degrees else {
            assert!(sine > 0.999_99 && event.reflectance == 1.0, "{event:?}");
            continue;
        };
        refractions += 1;
        assert!((refraction.to_radians().sin() - sine).abs() < 2e-4, "{event:?}");
        // Fresnel by the angles (Hecht, Optics, 4.6): sin² and tan² of difference over sum.
        let [i, t] = [event.incidence_degrees, refraction].map(f32::to_radians);
        if i > 0.02 {
            let across = ((i - t).sin() / (i + t).sin()).powi(2);
            let along = ((i - t).tan() / (i + t).tan()).powi(2);
            let expected = 0.5 * (across + along);
            assert!((event.reflectance - expected).abs() < 3e-3, "{event:?} {expected}");
        }
    }
    assert!(refractions > 20);
}

/// Parts of a fan that meet different facets stand side by side, and part where those do.
#[test]
fn fans_part_at_the_edges_of_facets() {
    let tree = tree_in_diamond(Splitting::Exact);
    let facet_of = |ray: &RecordedRay| match &ray.end {
        RayEnd::Interface(event) => event.surface.facet.clone(),
        _ => None,
    };
    let mut pairs = 0;
    for low in &tree.rays {
        let is_next = |high: &&RecordedRay| {
            (high.parent, high.kind, high.lambda_low_nm)
                == (low.parent, low.kind, low.lambda_high_nm)
        };
        let Some(high) = tree.rays.iter().find(is_next) else { continue };
        let (Some(low_end), Some(high_end)) = (low.edges[1].end_mm, high.edges[0].end_mm) else {
            continue;
        };
        if facet_of(low) != facet_of(high) {
            pairs += 1;
            assert_eq!(low.from, high.from);
            assert!(low_end.distance(high_end) < 2e-3, "{low:?} {high:?}");
        }
    }
    assert!(pairs > 4, "{pairs} fans are divided at edges");
}

#[test]
fn facets_objects_and_lamps_have_their_names() {
    let tree = tree_in_diamond(Splitting::Exact);
    let met: Vec<_> = tree.rays.iter().filter_map(|ray| ray.from.as_ref()).collect();
    for facet in ["table", "main", "lower half"] {
        let is_met = |name: &str| name.starts_with(facet);
        assert!(met.iter().any(|s| s.facet.as_deref().is_some_and(is_met)), "{facet}");
    }
    let case = cases::diamond();
    let object = &case.document.scene.objects[0];
    assert!(met.iter().all(|surface| *surface.object == object.name));
    let lamps = tree.rays.iter().filter_map(|ray| match &ray.end {
        RayEnd::Lights { lights, .. } => Some(lights),
        _ => None,
    });
    let named = lamps.flatten().filter(|light| light.light == LightKind::Lamp);
    let discs = &case.document.scene.lights.discs;
    for light in named {
        assert!(discs.iter().any(|disc| disc.name == *light.name), "{light:?}");
    }

    let nested = cases::nested();
    let surfaces: Vec<_> = (0..48 * 48)
        .step_by(7)
        .flat_map(|number| tree_surfaces(&nested, [number % 48, number / 48]))
        .collect();
    for name in ["ground", "Green glass: facet 1", "Diamond in glass: table", "Matte block: "] {
        assert!(surfaces.iter().any(|surface| surface.starts_with(name)), "{name}");
    }
}

fn tree_surfaces(case: &Case, pixel: [u32; 2]) -> Vec<String> {
    tree(case, pixel)
        .rays
        .iter()
        .filter_map(|ray| match &ray.end {
            RayEnd::Interface(event) => Some(event.surface.to_string()),
            RayEnd::Matte { surface, .. } => Some(surface.to_string()),
            _ => None,
        })
        .collect()
}

/// Where the lamp lights the streak, where its light comes through the prism, and where neither does.
#[test]
fn a_matte_surface_tells_how_it_is_lit() {
    let case = cases::beam();
    let [width, height] = case.size;
    let (mut streak, mut spectrum, mut shadow) = (0, 0, 0);
    for number in (0..width * height).step_by(5) {
        let tree = tree(&case, [number % width, number / width]);
        let RayEnd::Matte { surface, lights } = &tree.rays[0].end else { continue };
        let [lamp, sky] = &lights[..] else { panic!("a lamp and a sky: {lights:?}") };
        assert_eq!((lamp.light, sky.light), (LightKind::Lamp, LightKind::Hemisphere));
        assert!((0.0..=1.0).contains(&lamp.visible) && (0.0..=1.0).contains(&sky.visible));
        let radiance = tree.rays[0].mean_radiance();
        match (lamp.visible, lamp.through_bodies) {
            (1.0, 0.0) => {
                streak += 1;
                assert!(&*surface.object != "ground" || radiance > 0.3, "{radiance}");
            }
            (0.0, 0.0) => {
                shadow += 1;
                assert!(radiance < 0.1, "only the sky lights it: {radiance}");
            }
            (0.0, _) => spectrum += 1,
            _ => {}
        }
    }
    assert!(streak > 0 && spectrum > 0 && shadow > 0, "{streak} {spectrum} {shadow}");
}

/// The overlaps that are told are those that were deposited.
#[test]
fn what_a_ray_sees_makes_what_it_adds() {
    let case = cases::diamond();
    let packed = case.packed();
    let tree = tree_in_diamond(Splitting::Paper);
    let discs = &case.document.scene.lights.discs;
    let mut seeing = 0;
    for ray in &tree.rays {
        let RayEnd::Lights { lights, .. } = &ray.end else { continue };
        seeing += 1;
        let range = bin_range(&packed, ray.lambda_low_nm, ray.lambda_high_nm);
        for bin in range.first..=range.last {
            let radiance: f32 = lights
                .iter()
                .map(|seen| {
                    let row = match seen.light {
                        LightKind::Hemisphere => packed.sky.hemisphere,
                        LightKind::Environment => packed.sky.environment,
                        LightKind::Lamp => {
                            let disc = discs.iter().position(|disc| disc.name == *seen.name);
                            packed.discs[disc.expect("a lamp of the scene")].spectrum
                        }
                    };
                    seen.overlap * packed.spectrum_value(row, bin)
                })
                .sum();
            let expected = ray.significance * bin_overlap(&range, bin) * radiance;
            let found = ray.radiance_per_bin.get(bin as usize).copied().unwrap_or(0.0) as f32;
            // What is added to the film is rounded as the film is.
            assert!((found - expected).abs() < 1e-6 + 1e-5 * expected, "{ray:?}: {expected}");
        }
    }
    assert!(seeing > 10);
}

/// Of the fan, only the wavelengths that are told see a light, and these all of it.
#[test]
fn a_fan_tells_which_wavelengths_see_a_lamp() {
    let mut case = split_finely(cases::diamond(), Splitting::Exact);
    case.document.scene.lights.hemisphere = None;
    let packed = case.packed();
    let discs = &case.document.scene.lights.discs;
    let (mut whole, mut parts) = (0, 0);
    for number in (0..48 * 48).step_by(11) {
        for ray in &tree(&case, [number % 48, number / 48]).rays {
            let RayEnd::Lights { lights, .. } = &ray.end else { continue };
            let [seen] = &lights[..] else { continue };
            let [band_nm] = seen.bands_nm[..] else { continue };
            assert!(ray.lambda_low_nm <= band_nm[0] && band_nm[1] <= ray.lambda_high_nm);
            let width_nm = ray.lambda_high_nm - ray.lambda_low_nm;
            assert!((seen.overlap - (band_nm[1] - band_nm[0]) / width_nm).abs() < 1e-5);
            let disc = discs.iter().position(|disc| disc.name == *seen.name);
            let row = packed.discs[disc.expect("a lamp of the scene")].spectrum;
            let range = bin_range(&packed, band_nm[0], band_nm[1]);
            let mut energy = 0.0;
            for (bin, found) in (0..).zip(&ray.radiance_per_bin) {
                let is_in_band = (range.first..=range.last).contains(&bin);
                assert!(is_in_band || *found == 0.0, "{ray:?}");
                energy += *found as f32 / packed.spectrum_value(row, bin);
            }
            energy /= case.bins().count() as f32;
            if seen.overlap == 1.0 {
                whole += 1;
                // What is added to the film is rounded as the film is.
                assert!((energy - ray.energy).abs() < 2e-5 + 1e-3 * ray.energy, "{energy} {ray:?}");
            } else {
                parts += 1;
                assert!(energy < ray.energy + 2e-5, "{ray:?}");
            }
        }
    }
    assert!(whole > 10 && parts > 10, "{whole} {parts}");
}

#[test]
fn total_reflection_is_told_with_the_wavelength_that_divides_it() {
    for splitting in SPLITTINGS {
        total_reflection_is_told(&split_finely(cases::diamond(), splitting));
    }
}

fn total_reflection_is_told(case: &Case) {
    let mut divided = 0;
    for pixel in [[22, 25], [25, 22], [30, 20], [18, 28]] {
        let tree = tree(case, pixel);
        for ray in &tree.rays {
            let RayEnd::Interface(event) = &ray.end else { continue };
            let children: Vec<_> =
                tree.rays.iter().filter(|child| child.parent == Some(ray.id)).collect();
            let total = children.iter().any(|child| child.kind == RayKind::TotallyReflected);
            if let Some(dividing_nm) = event.dividing_nm {
                divided += 1;
                assert!(total && event.subrays > 0);
                assert!(ray.lambda_low_nm < dividing_nm && dividing_nm < ray.lambda_high_nm);
                // At that wavelength n₁·sin θ = n₂: between the two ends of diamond's n.
                let sine = event.incidence_degrees.to_radians().sin();
                assert!((event.n_before * sine - 1.0).abs() < 0.03, "{event:?}");
            } else if total {
                // A fan may come apart on its way from there.
                let is_one = children.len() == 1 || tree.splitting == Splitting::Exact;
                assert!(event.subrays == 0 && is_one, "{event:?}");
            }
        }
    }
    assert!(divided > 0, "one of these pixels has such an interface");
}

#[test]
fn limits_are_named_where_they_cut() {
    for splitting in SPLITTINGS {
        let mut case = split_finely(cases::diamond(), splitting);
        case.document.trace.max_depth = 3;
        let tree = tree(&case, [22, 25]);
        let deep = tree.rays.iter().filter(|ray| matches!(ray.end, RayEnd::CutOff { .. }));
        for ray in deep.clone() {
            assert_eq!((&ray.end, ray.depth), (&RayEnd::CutOff { limit: Limit::Depth }, 4));
        }
        assert!(deep.count() > 0 && tree.ledger.cut_off > 0.0);
    }
}

#[test]
fn a_full_record_says_so_and_keeps_the_totals() {
    for splitting in SPLITTINGS {
        a_full_record_says_so(&split_finely(cases::diamond(), splitting));
    }
}

fn a_full_record_says_so(case: &Case) {
    let request = request(case, [22, 25], 0);
    let whole = RayTree::trace(&request, RayTree::MAX_RAYS).expect("it is traced");
    let few = RayTree::trace(&request, 50).expect("it is traced");
    assert!(few.is_truncated && !whole.is_truncated);
    assert_eq!(few.rays.len(), 50);
    assert_eq!(few.rays.len() as u64 + few.unrecorded_rays, whole.rays.len() as u64);
    assert_eq!(few.radiance_per_bin, whole.radiance_per_bin);
    assert_eq!((few.ledger, few.segments), (whole.ledger, whole.segments));
    // Each ray has all that came of it, here or by number.
    let children = |tree: &RayTree, ray: u32| {
        tree.rays.iter().filter(|child| child.parent == Some(ray)).count() as u32
    };
    let mut cut = 0;
    for ray in &few.rays {
        let is_same = |other: &&RecordedRay| {
            (other.origin_mm, other.direction, other.lambda_low_nm, other.lambda_high_nm)
                == (ray.origin_mm, ray.direction, ray.lambda_low_nm, ray.lambda_high_nm)
                && other.significance == ray.significance
        };
        let same = whole.rays.iter().find(is_same).expect("the whole tree has it");
        assert_eq!(ray.end, same.end);
        let recorded = children(&few, ray.id);
        assert_eq!(recorded + ray.unrecorded_children, children(&whole, same.id), "{ray:?}");
        cut += u32::from(ray.unrecorded_children > 0);
    }
    assert!(cut > 0, "some rays have children that had no place");
    assert!(whole.rays.iter().all(|ray| ray.unrecorded_children == 0));
}

#[test]
fn a_tree_is_left_undone_where_nobody_wants_it_any_more() {
    let case = split(cases::diamond(), Splitting::Paper);
    let request = request(&case, [22, 25], 0);
    let asked = Cell::new(0);
    let trace = |last: u32| {
        asked.set(0);
        let is_cancelled = || asked.replace(asked.get() + 1) == last;
        RayTree::trace_packed(&request, &case.packed(), RayTree::MAX_RAYS, &is_cancelled)
    };
    let whole = RayTree::trace(&request, RayTree::MAX_RAYS).expect("it is traced");
    assert_eq!(trace(u32::MAX).expect("it is traced"), whole);
    assert!(asked.get() > 100, "asked before each ray");
    assert!(matches!(trace(20), Err(RendererError::Cancelled)));
    assert_eq!(asked.get(), 21, "and not followed further");
}

#[test]
fn a_pixel_outside_and_a_broken_scene_are_errors() {
    let case = cases::diamond();
    let error = RayTree::trace(&request(&case, [48, 3], 0), 10).expect_err("there is none");
    assert!(error.to_string().contains("columns 0 to 47"), "{error}");
    let mut broken = Document::default();
    broken.scene.objects[0].transform.scale = 0.0;
    let broken = RayTreeRequest { scene: Arc::new(broken.scene), ..request(&case, [1, 1], 0) };
    assert!(RayTree::trace(&broken, 10).is_err());
}

#[test]
fn the_json_has_stable_names() {
    let json = serde_json::to_value(tree_in_diamond(Splitting::Paper)).expect("it is JSON");
    for key in ["pixel", "size_px", "pass_index", "bin_edges_nm", "radiance_per_bin", "ledger"] {
        assert!(json.get(key).is_some(), "{key}");
    }
    let rays = json["rays"].as_array().expect("rays");
    assert_eq!(json["splitting"], "paper");
    assert_eq!(rays[0]["edges"][0]["origin_mm"], rays[0]["origin_mm"]);
    assert_eq!(rays[0]["kind"], "camera");
    assert_eq!(rays[0]["end"]["kind"], "interface");
    assert_eq!(rays[0]["end"]["n_before"], 1.0);
    assert_eq!(rays[1]["parent"], 0);
    assert_eq!(rays[1]["kind"], "reflected");
    assert_eq!(rays[1]["lambda_high_nm"].as_f64(), rays[0]["lambda_high_nm"].as_f64());
}
