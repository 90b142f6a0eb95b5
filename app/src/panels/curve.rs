//! The form of the index over wavelength.

use brilliance_renderer::material::{Dielectric, Dispersion, LibraryMaterial, find};
use eframe::egui::Ui;

use crate::row::{combo, labelled};

/// Two curves whose index and dispersion differ by less are the same.
const ROUNDING: f64 = 1e-9;

/// The forms of a curve that can be chosen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Form {
    /// The straight line of the paper.
    StraightLine,
    /// A + B/λ².
    Cauchy,
    /// The library's measurement, moved and stretched by the sliders.
    Measured,
    /// A formula or a table of the scene file.
    OfScene,
}

impl Form {
    /// The form of the stone's curve.
    pub(super) fn of(stone: &Dielectric) -> Self {
        let is_measured = || find(&stone.name).is_some_and(|known| known.measurement.is_some());
        match stone.dispersion {
            Dispersion::Linear { .. } => Self::StraightLine,
            Dispersion::Cauchy { .. } => Self::Cauchy,
            Dispersion::Sellmeier { .. } | Dispersion::Tabulated { .. } if is_measured() => {
                Self::Measured
            }
            Dispersion::Sellmeier { .. } | Dispersion::Tabulated { .. } => Self::OfScene,
        }
    }

    /// The curve of this form that the library has of a material.
    pub(super) fn standard(self, known: &LibraryMaterial) -> Option<Dispersion> {
        let figures = &known.figures;
        match self {
            Self::StraightLine => Some(known.linear()),
            Self::Cauchy => Some(Dispersion::cauchy_from(figures.n_d(), figures.dispersion_bg)),
            Self::Measured => known.measurement.as_ref().map(|_| known.dispersion.clone()),
            Self::OfScene => None,
        }
    }

    /// The curve of this form with the index `n_d` and the dispersion `dispersion_bg`, for a stone
    /// that has another now.
    pub(super) fn through(self, stone: &Dielectric, n_d: f64, dispersion_bg: f64) -> Dispersion {
        match find(&stone.name).and_then(|known| self.standard(known)) {
            Some(curve)
                if (curve.n_d() - n_d).abs() < ROUNDING
                    && (curve.dispersion_bg() - dispersion_bg).abs() < ROUNDING =>
            {
                curve
            }
            // Always from the library's curve: one that was made flat has lost its shape.
            Some(curve) => curve.rescaled(n_d, dispersion_bg),
            None => match self {
                Self::StraightLine => Dispersion::Linear { n_d, dispersion_bg },
                Self::Cauchy => Dispersion::cauchy_from(n_d, dispersion_bg),
                Self::Measured | Self::OfScene => stone.dispersion.rescaled(n_d, dispersion_bg),
            },
        }
    }
}

/// True for a stone as the library has it, in any form.
pub(super) fn is_standard(stone: &Dielectric, known: &LibraryMaterial) -> bool {
    Form::of(stone).standard(known).as_ref() == Some(&stone.dispersion)
}

/// The choice of the form. What the sliders say stays, unless they say what the library says.
pub(super) fn curve_ui(ui: &mut Ui, stone: &mut Dielectric) {
    let tooltip = "The form of the index over wavelength, between the same violet and red.";
    let current = Form::of(stone);
    let known = find(&stone.name);
    let chosen = labelled(ui, "Index curve", tooltip, |ui, label| {
        let mut chosen = None;
        combo(ui, "index curve", shown(stone, current), |ui| {
            for (form, name, tooltip) in choices(known) {
                let item = ui.selectable_label(form == current, name);
                if item.on_hover_text(tooltip).clicked() {
                    chosen = Some(form);
                }
            }
        })
        .labelled_by(label.id)
        .on_hover_text(tooltip);
        chosen
    });
    if let Some(form) = chosen {
        let standard = known.filter(|known| is_standard(stone, known));
        stone.dispersion = standard.and_then(|known| form.standard(known)).unwrap_or_else(|| {
            form.through(stone, stone.dispersion.n_d(), stone.dispersion.dispersion_bg())
        });
    }
}

/// The forms that a stone can have, with what is said of them.
fn choices(known: Option<&LibraryMaterial>) -> Vec<(Form, &'static str, String)> {
    let mut choices = vec![
        (
            Form::StraightLine,
            "Straight line (Thomas 1986)",
            "The index falls evenly from violet to red, as in the paper.".to_owned(),
        ),
        (
            Form::Cauchy,
            "Cauchy",
            "The index falls with the square of the wavelength: steep in violet, flat in red, as \
             in most clear materials."
                .to_owned(),
        ),
    ];
    if let Some(measurement) = known.and_then(|known| known.measurement.as_ref()) {
        let [shortest, longest] = measurement.range_nm;
        let tooltip = format!(
            "The index as measured from {shortest:.0} to {longest:.0} nm.\n{}",
            measurement.source
        );
        choices.push((Form::Measured, "Measured", tooltip));
    }
    choices
}

fn shown(stone: &Dielectric, form: Form) -> &'static str {
    match (form, &stone.dispersion) {
        (Form::StraightLine, _) => "Straight line",
        (Form::Cauchy, _) => "Cauchy",
        (Form::Measured, dispersion) => {
            let measured = find(&stone.name).is_some_and(|known| known.dispersion == *dispersion);
            if measured { "Measured" } else { "Measured, changed" }
        }
        (Form::OfScene, Dispersion::Sellmeier { .. }) => "Sellmeier, of this scene",
        (Form::OfScene, _) => "Table, of this scene",
    }
}
