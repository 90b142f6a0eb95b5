//! Rays, surfaces and lights in words, for people.

use brilliance_renderer::inspect::{
    InterfaceEvent, LightKind, Limit, RayCounts, RayEnd, RayKind, ReceivedLight, SeenLight,
};
use brilliance_renderer::settings::Splitting;

/// How rays are divided, for the first line of a tree.
pub(crate) fn splitting(splitting: Splitting) -> &'static str {
    match splitting {
        Splitting::Paper => "splitting of the paper",
        Splitting::Exact => "exact splitting",
    }
}

/// How a ray came to be, in a word or two.
pub(crate) fn kind(kind: RayKind) -> &'static str {
    match kind {
        RayKind::Camera => "camera",
        RayKind::Refracted => "refracted",
        RayKind::Reflected => "reflected",
        RayKind::TotallyReflected => "totally reflected",
    }
}

/// What ended a ray.
pub(crate) fn end(end: &RayEnd) -> String {
    match end {
        RayEnd::Interface(event) => event.surface.to_string(),
        RayEnd::Lights { lights, observer_shadow } => {
            let seen: Vec<_> = lights.iter().map(seen_light).collect();
            format!("{}{}", seen.join(", "), shadow(*observer_shadow))
        }
        RayEnd::Backdrop => "backdrop".to_owned(),
        RayEnd::Dark { observer_shadow } => format!("dark{}", shadow(*observer_shadow)),
        RayEnd::Matte { surface, lights } => {
            let received: Vec<_> = lights.iter().map(received_light).collect();
            format!("{surface} (matte): {}", received.join(", "))
        }
        RayEnd::Pruned => "pruned".to_owned(),
        RayEnd::CutOff { limit: Limit::Depth } => "cut off: too deep".to_owned(),
        RayEnd::CutOff { limit: Limit::Stack } => "cut off: too many rays wait".to_owned(),
        RayEnd::Lost => "lost through a mesh".to_owned(),
    }
}

/// What an interface did to a ray: angles, indices, coefficients.
pub(crate) fn interface(event: &InterfaceEvent) -> String {
    let InterfaceEvent { incidence_degrees, n_before, n_after, .. } = event;
    let indices = format!("n {n_before:.4} to {n_after:.4}");
    let mut words = match event.refraction_degrees {
        Some(refraction_degrees) => vec![
            format!("at {incidence_degrees:.2}° to {refraction_degrees:.2}°"),
            indices,
            format!("R {:.4}, T {:.4}", event.reflectance, event.transmittance),
        ],
        None => vec![format!("at {incidence_degrees:.2}°"), "totally reflected".into(), indices],
    };
    if let Some(dividing_nm) = event.dividing_nm {
        words.push(format!("total reflection divided at {dividing_nm:.2} nm"));
    }
    if event.subrays > 1 {
        words.push(format!("{} sub-rays", event.subrays));
    }
    words.join(", ")
}

fn seen_light(seen: &SeenLight) -> String {
    let name = light_name(seen.light, &seen.name);
    if seen.overlap >= 1.0 {
        return name;
    }
    if seen.bands_nm.is_empty() {
        return format!("{name} ({})", percent(seen.overlap));
    }
    let band = |[low, high]: &[f32; 2]| format!("{low:.1}\u{2013}{high:.1}");
    let bands: Vec<_> = seen.bands_nm.iter().map(band).collect();
    format!("{name} ({} nm)", bands.join(", "))
}

fn light_name(light: LightKind, name: &str) -> String {
    match light {
        LightKind::Lamp => format!("lamp {name}"),
        LightKind::Hemisphere | LightKind::Environment => name.to_owned(),
    }
}

/// How a matte surface is lit.
fn received_light(received: &ReceivedLight) -> String {
    let name = light_name(received.light, &received.name);
    let mut words = match received.visible {
        0.0 => format!("{name} in shadow"),
        1.0.. => name,
        visible => format!("{name} ({:.0} %)", 100.0 * visible),
    };
    if received.through_bodies > 0.0 {
        let through = percent(received.through_bodies);
        words = format!("{words}, through a stone ({through})");
    }
    words
}

fn shadow(observer_shadow: f32) -> String {
    if observer_shadow > 0.0 {
        format!(", observer's shadow ({})", percent(observer_shadow))
    } else {
        String::new()
    }
}

/// A number of rays.
pub(crate) fn rays(count: u64) -> String {
    if count == 1 { "1 ray".to_owned() } else { format!("{count} rays") }
}

/// What became of all rays of a tree; the numbers add up to that of the rays.
pub(crate) fn counts(counts: &RayCounts) -> String {
    let words: Vec<_> = [
        (counts.interfaces, "met interfaces"),
        (counts.matte, "met matte surfaces"),
        (counts.lights, "found lights"),
        (counts.backdrop, "saw the backdrop"),
        (counts.dark, "saw no light"),
        (counts.pruned, "pruned"),
        (counts.cut_off, "cut off"),
        (counts.lost, "lost"),
        (counts.unrecorded, "not recorded further"),
    ]
    .into_iter()
    .filter(|(count, _)| *count > 0)
    .map(|(count, what)| format!("{count} {what}"))
    .collect();
    words.join(", ")
}

/// A part of a whole.
pub(crate) fn percent(part: f32) -> String {
    let percent = 100.0 * part;
    let decimals = match percent {
        0.0 | 100.0 => 0,
        1.0.. => 2,
        _ => 3,
    };
    format!("{percent:.decimals$} %")
}
