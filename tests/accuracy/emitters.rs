//! What shines, for rays of one direction and one wavelength.

use brilliance_renderer::light::{Lights, SkyLight};
use brilliance_renderer::spectrum::{Bins, Spectrum};
use glam::DVec3;

/// Most things that can shine.
const MAX: usize = 16;

/// How much of each emitter's radiance a camera ray sees, in the order of [`Emitters::radiances`].
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Shares(pub(crate) [f64; MAX]);

/// The lights of a scene.
pub(crate) struct Emitters {
    discs: Vec<Cone>,
    observer_shadow: Option<Cone>,
    has_backdrop: bool,
    /// Spectrum and radiance of the discs, the hemisphere, the environment and the backdrop; what
    /// is not there has a radiance of 0.
    radiances: Vec<(Spectrum, f64)>,
}

struct Cone {
    center: DVec3,
    /// In radians.
    radius: f64,
    cos_radius: f64,
}

impl Cone {
    fn new(center: DVec3, radius_radians: f32) -> Self {
        let radius = f64::from(radius_radians);
        Self { center: center.normalize(), radius, cos_radius: radius.cos() }
    }

    fn holds(&self, direction: DVec3) -> bool {
        self.center.dot(direction) >= self.cos_radius
    }
}

impl Emitters {
    /// `observer` points from the scene towards the camera.
    pub(crate) fn new(lights: &Lights, observer: DVec3) -> Self {
        let discs = lights.discs.iter().map(|disc| (disc.spectrum.clone(), disc.radiance));
        let skies = [&lights.hemisphere, &lights.environment, &lights.backdrop];
        let skies = skies.map(|sky| {
            let dark = SkyLight { radiance: 0.0, spectrum: Spectrum::Flat(1.0) };
            let sky = sky.clone().unwrap_or(dark);
            (sky.spectrum, sky.radiance)
        });
        let radiances: Vec<_> =
            discs.chain(skies).map(|(spectrum, radiance)| (spectrum, radiance.into())).collect();
        assert!(radiances.len() <= MAX, "{} emitters", radiances.len());
        let shadow_radians = lights.observer_shadow_radians;
        Self {
            discs: lights
                .discs
                .iter()
                .map(|disc| Cone::new(disc.direction.as_dvec3(), disc.angular_radius_radians))
                .collect(),
            observer_shadow: (shadow_radians > 0.0).then(|| Cone::new(observer, shadow_radians)),
            has_backdrop: lights.backdrop.is_some(),
            radiances,
        }
    }

    /// Adds what a ray in this direction that meets nothing sees.
    pub(crate) fn add_seen(&self, direction: DVec3, weight: f64, shares: &mut Shares) {
        let (discs, skies) = shares.0.split_at_mut(self.discs.len());
        for (disc, share) in self.discs.iter().zip(discs) {
            if disc.holds(direction) {
                *share += weight;
            }
        }
        if self.observer_shadow.as_ref().is_some_and(|head| head.holds(direction)) {
            return;
        }
        if direction.z > 0.0 {
            skies[0] += weight;
        }
        skies[1] += weight;
    }

    /// The radiance of the discs that a ray may see while it turns from one direction to another,
    /// give or take `margin_radians`, though it sees them at neither end.
    pub(crate) fn hidden_between(&self, from: DVec3, to: DVec3, margin_radians: f64) -> f64 {
        let way = to - from;
        let hidden = self.discs.iter().zip(&self.radiances).map(|(disc, (_, radiance))| {
            let part = (disc.center - from).dot(way) / way.length_squared().max(1e-30);
            let nearest = from + way * part.clamp(0.0, 1.0);
            let may_see = nearest.distance(disc.center) < disc.radius + margin_radians;
            let is_hidden = may_see && !disc.holds(from) && !disc.holds(to);
            if is_hidden { *radiance } else { 0.0 }
        });
        hidden.sum()
    }

    /// Adds what a camera ray sees that meets nothing.
    pub(crate) fn add_background(&self, direction: DVec3, shares: &mut Shares) {
        if self.has_backdrop {
            shares.0[self.discs.len() + 2] += 1.0;
        } else {
            self.add_seen(direction, 1.0, shares);
        }
    }

    /// Adds what a matte surface with this upward normal sends back where nothing shadows it: under
    /// the radiance L of an environment, its reflectance times L. No other light may shine.
    pub(crate) fn add_matte(&self, reflectance: f64, weight: f64, shares: &mut Shares) {
        let is_dark = |i: usize| self.radiances[i].1 == 0.0;
        assert!(
            (0..=self.discs.len()).all(is_dark),
            "matte surfaces are lit by environments alone"
        );
        shares.0[self.discs.len() + 1] += weight * reflectance;
    }

    /// Mean radiance of each emitter in each bin.
    pub(crate) fn radiances(&self, bins: Bins) -> Vec<Vec<f64>> {
        let rows = self.radiances.iter().map(|(spectrum, radiance)| {
            let means = spectrum.bin_means(bins);
            means.into_iter().map(|mean| f64::from(mean) * radiance).collect()
        });
        rows.collect()
    }

    /// Radiance of each disc.
    pub(crate) fn disc_levels(&self) -> impl Iterator<Item = f64> {
        self.levels().take(self.discs.len())
    }

    /// Radiance of each emitter, whatever the wavelength: about what its share counts.
    pub(crate) fn levels(&self) -> impl Iterator<Item = f64> {
        self.radiances.iter().map(|(_, radiance)| *radiance)
    }
}
