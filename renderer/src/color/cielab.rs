//! CIELAB and the CIEDE2000 colour difference.

use glam::DVec3;

/// A colour in CIE 1976 L*a*b*.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lab {
    /// Lightness L*, 0 (black) to 100 (the reference white).
    pub l: f64,
    /// a*: red against green.
    pub a: f64,
    /// b*: yellow against blue.
    pub b: f64,
}

impl Lab {
    /// The colour XYZ seen beside the reference white `white` (CIE 15:2004, 8.2.1).
    pub fn from_xyz(xyz: DVec3, white: DVec3) -> Self {
        const EPSILON: f64 = 216.0 / 24389.0;
        const KAPPA: f64 = 24389.0 / 27.0;
        let [x, y, z] = (xyz / white).to_array().map(|ratio| {
            if ratio > EPSILON { ratio.cbrt() } else { (KAPPA * ratio + 16.0) / 116.0 }
        });
        Self { l: 116.0 * y - 16.0, a: 500.0 * (x - y), b: 200.0 * (y - z) }
    }

    /// The colour difference ΔE₀₀ with unit weights; about 1 is just noticeable.
    ///
    /// G. Sharma, W. Wu and E. N. Dalal, "The CIEDE2000 Color-Difference Formula: Implementation
    /// Notes, Supplementary Test Data, and Mathematical Observations", Color Research and
    /// Application 30(1), 2005. Numbers in the comments are its equations.
    pub fn delta_e_2000(self, other: Self) -> f64 {
        // Chroma with a* stretched for greys (2–7).
        let mean_chroma = 0.5 * (self.a.hypot(self.b) + other.a.hypot(other.b));
        let stretch = 1.0 + 0.5 * (1.0 - saturation(mean_chroma));
        let (chroma1, hue1) = polar(self.a * stretch, self.b);
        let (chroma2, hue2) = polar(other.a * stretch, other.b);

        // Differences (8–11).
        let delta_l = other.l - self.l;
        let delta_chroma = chroma2 - chroma1;
        let gray = chroma1 * chroma2 == 0.0;
        let delta_hue = if gray { 0.0 } else { wrapped(hue2 - hue1) };
        let delta_h = 2.0 * (chroma1 * chroma2).sqrt() * (0.5 * delta_hue).to_radians().sin();

        // Means (12–14).
        let l = 0.5 * (self.l + other.l);
        let chroma = 0.5 * (chroma1 + chroma2);
        let hue = if gray { hue1 + hue2 } else { mean_hue(hue1, hue2) };

        // Weights (15–21).
        let cos = |degrees: f64| degrees.to_radians().cos();
        let t = 1.0 - 0.17 * cos(hue - 30.0) + 0.24 * cos(2.0 * hue) + 0.32 * cos(3.0 * hue + 6.0)
            - 0.20 * cos(4.0 * hue - 63.0);
        let s_l = 1.0 + 0.015 * (l - 50.0).powi(2) / (20.0 + (l - 50.0).powi(2)).sqrt();
        let s_c = 1.0 + 0.045 * chroma;
        let s_h = 1.0 + 0.015 * chroma * t;
        let turn = 30.0 * (-((hue - 275.0) / 25.0).powi(2)).exp();
        let rotation = -(2.0 * turn).to_radians().sin() * 2.0 * saturation(chroma);

        // The sum (22).
        let (l, c, h) = (delta_l / s_l, delta_chroma / s_c, delta_h / s_h);
        (l * l + c * c + h * h + rotation * c * h).sqrt()
    }
}

/// √(C⁷/(C⁷ + 25⁷)): 0 for greys, towards 1 for strong colours.
fn saturation(chroma: f64) -> f64 {
    let power = chroma.powi(7);
    (power / (power + 25.0_f64.powi(7))).sqrt()
}

/// Chroma, and hue angle in degrees in 0..360; the hue of a grey is 0.
fn polar(a: f64, b: f64) -> (f64, f64) {
    (a.hypot(b), b.atan2(a).to_degrees().rem_euclid(360.0))
}

/// A difference of hue angles brought into −180..=180 degrees.
fn wrapped(degrees: f64) -> f64 {
    if degrees > 180.0 {
        degrees - 360.0
    } else if degrees < -180.0 {
        degrees + 360.0
    } else {
        degrees
    }
}

/// The hue halfway between two, the short way round, in degrees.
fn mean_hue(hue1: f64, hue2: f64) -> f64 {
    let sum = hue1 + hue2;
    if (hue1 - hue2).abs() <= 180.0 {
        0.5 * sum
    } else if sum < 360.0 {
        0.5 * (sum + 360.0)
    } else {
        0.5 * (sum - 360.0)
    }
}
