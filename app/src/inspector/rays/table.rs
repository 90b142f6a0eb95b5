//! The events of the tree, row by row.

use brilliance_renderer::inspect::{RayEnd, RecordedRay};
use brilliance_renderer::spectrum::{LAMBDA_MAX_NM, LAMBDA_MIN_NM};
use eframe::egui::accesskit::Role;
use eframe::egui::{
    Align2, Color32, FontId, Painter, Pos2, Rect, Response, ScrollArea, Sense, Ui, WidgetInfo,
    pos2, vec2,
};

use super::traced::{Traced, sees_lamp};
use super::{Focus, legend, palette};
use crate::ray_words;
use crate::theme;

const ROW_HEIGHT: f32 = 36.0;
/// Where the text of a row begins.
const TEXT_LEFT: f32 = 56.0;
/// The track that shows where in the spectrum an interval lies.
const TRACK_WIDTH: f32 = 46.0;
/// Steps of depth that are shown by indentation, and how wide each is.
const MOST_STEPS: u32 = 12;
const STEP: f32 = 2.0;

/// The table.
pub(super) struct Table<'a> {
    pub(super) traced: &'a Traced,
    /// Ids in the order of the rows.
    pub(super) rows: &'a [u32],
    pub(super) is_indented: bool,
}

impl Table<'_> {
    /// Shows the rows that are in sight; a click on one selects it. `bring` is a row to be brought
    /// into sight.
    pub(super) fn show(&self, ui: &mut Ui, focus: &mut Focus, bring: Option<u32>) {
        focus.row = None;
        let row_height = ROW_HEIGHT + ui.spacing().item_spacing.y;
        let mut area = ScrollArea::vertical().auto_shrink(false).id_salt("events");
        if let Some(row) = bring.and_then(|id| self.rows.iter().position(|row| *row == id)) {
            let middle = (row as f32 + 0.5) * row_height - 0.5 * ui.available_height();
            area = area.vertical_scroll_offset(middle.max(0.0));
        }
        area.show_rows(ui, ROW_HEIGHT, self.rows.len(), |ui, sight| {
            focus.in_sight.clear();
            for &id in &self.rows[sight] {
                focus.in_sight.push(id);
                let response = self.row_ui(ui, id, focus);
                if response.hovered() {
                    focus.row = Some(id);
                }
                if response.clicked() {
                    focus.selected = if focus.selected == Some(id) { None } else { Some(id) };
                }
            }
        });
    }

    fn row_ui(&self, ui: &mut Ui, id: u32, focus: &Focus) -> Response {
        let ray = self.traced.ray(id);
        let size = vec2(ui.available_width(), ROW_HEIGHT);
        let (rect, response) = ui.allocate_exact_size(size, Sense::click());
        response.widget_info(|| WidgetInfo::labeled(Role::ListItem, true, spoken(ray)));
        let fill = if focus.selected == Some(id) {
            theme::ACCENT_DIM
        } else if response.hovered() || focus.in_picture == Some(id) {
            theme::FIELD
        } else {
            Color32::TRANSPARENT
        };
        let painter = ui.painter();
        painter.rect_filled(rect, 3.0, fill);
        let steps = if self.is_indented { ray.depth.min(MOST_STEPS) } else { 0 };
        let inner = rect.shrink2(vec2(6.0, 2.0));
        let inner = inner.with_min_x(inner.left() + STEP * steps as f32);
        self.paint_row(painter, inner, ray);
        response
    }

    fn paint_row(&self, painter: &Painter, rect: Rect, ray: &RecordedRay) {
        let (upper, lower) = (rect.top() + 9.0, rect.bottom() - 8.0);
        let sample_at = pos2(rect.left() + 0.5 * TRACK_WIDTH, upper);
        legend::sample(painter, sample_at, ray.kind, self.traced.color(ray.id));
        paint_interval(painter, pos2(rect.left(), lower), ray);
        let strong = FontId::proportional(13.0);
        let texts = [title_of(ray), strength_of(ray)];
        paint_texts(painter, rect, upper, texts, &strong, [title_color(ray), theme::TEXT]);
        let weak = FontId::proportional(11.5);
        let texts = [interval_of(ray), event_of(ray)];
        paint_texts(painter, rect, lower, texts, &weak, [theme::TEXT_WEAK; 2]);
    }
}

/// Says what stands where in a row.
pub(super) fn heading_ui(ui: &mut Ui) {
    let size = vec2(ui.available_width(), 30.0);
    let (rect, _) = ui.allocate_exact_size(size, Sense::hover());
    let rect = rect.shrink2(vec2(6.0, 0.0));
    let font = FontId::proportional(11.5);
    for (y, texts) in [
        (rect.top() + 8.0, ["what it met or saw", "spread, significance"]),
        (rect.bottom() - 8.0, ["interval", "index, angles, R and T"]),
    ] {
        let texts = texts.map(str::to_owned);
        paint_texts(ui.painter(), rect, y, texts, &font, [theme::TEXT_WEAK; 2]);
    }
}

/// Writes one text at the left, as far as there is room, and another at the right.
fn paint_texts(
    painter: &Painter,
    rect: Rect,
    y: f32,
    [left, right]: [String; 2],
    font: &FontId,
    colors: [Color32; 2],
) {
    let right_at = pos2(rect.right(), y);
    let taken = painter.text(right_at, Align2::RIGHT_CENTER, right, font.clone(), colors[1]);
    let left_at = pos2(rect.left() + TEXT_LEFT, y);
    let room = Rect::from_x_y_ranges(left_at.x..=taken.left() - 6.0, rect.y_range());
    let painter = painter.with_clip_rect(room.intersect(painter.clip_rect()));
    painter.text(left_at, Align2::LEFT_CENTER, left, font.clone(), colors[0]);
}

/// The spectrum with the ray's interval in its colours.
fn paint_interval(painter: &Painter, left: Pos2, ray: &RecordedRay) {
    let x = |lambda_nm: f32| {
        let part = (lambda_nm - LAMBDA_MIN_NM) / (LAMBDA_MAX_NM - LAMBDA_MIN_NM);
        left.x + TRACK_WIDTH * part
    };
    let track = Rect::from_x_y_ranges(left.x..=left.x + TRACK_WIDTH, left.y - 3.0..=left.y + 3.0);
    painter.rect_filled(track, 1.0, theme::FIELD);
    let (low, high) = (x(ray.lambda_low_nm), x(ray.lambda_high_nm));
    // The narrowest interval is seen too.
    let slices = ((high - low) / 2.0).ceil().max(1.0) as u32;
    let width = (high - low).max(1.5) / slices as f32;
    for i in 0..slices {
        let part = (i as f32 + 0.5) / slices as f32;
        let lambda_nm = ray.lambda_low_nm + part * (ray.lambda_high_nm - ray.lambda_low_nm);
        let from = low + i as f32 * width;
        let slice = Rect::from_x_y_ranges(from..=from + width, track.y_range());
        painter.rect_filled(slice, 0.0, palette::color_at(lambda_nm));
    }
}

/// What a row is about: what the ray came to.
pub(super) fn title_of(ray: &RecordedRay) -> String {
    match &ray.end {
        // In a scene of one stone, its name in every row would tell nothing.
        RayEnd::Interface(event) => match (&event.surface.facet, &ray.medium) {
            (Some(facet), Some(medium)) if *medium == event.surface.object => facet.to_string(),
            _ => event.surface.to_string(),
        },
        end => ray_words::end(end),
    }
}

fn title_color(ray: &RecordedRay) -> Color32 {
    match &ray.end {
        RayEnd::Interface(_) | RayEnd::Matte { .. } => theme::TEXT_STRONG,
        RayEnd::Lights { .. } if sees_lamp(ray) => theme::WARNING,
        RayEnd::Lights { .. } | RayEnd::Backdrop => theme::ACCENT,
        RayEnd::Lost => theme::ERROR,
        RayEnd::Dark { .. } | RayEnd::Pruned | RayEnd::CutOff { .. } => theme::TEXT_WEAK,
    }
}

fn event_of(ray: &RecordedRay) -> String {
    let RayEnd::Interface(event) = &ray.end else {
        if ray.radiance_per_bin.is_empty() {
            return String::new();
        }
        return format!("adds {}", number(ray.mean_radiance() as f32));
    };
    let angles = match event.refraction_degrees {
        Some(refraction) => format!(
            "{:.1}\u{b0} \u{203a} {refraction:.1}\u{b0}  R {}  T {}",
            event.incidence_degrees,
            part(event.reflectance),
            part(event.transmittance)
        ),
        None => format!("{:.1}\u{b0} total  R 1", event.incidence_degrees),
    };
    format!("n {:.3}  {angles}", event.n_before)
}

fn strength_of(ray: &RecordedRay) -> String {
    let significance = number(ray.significance);
    if ray.spread_degrees >= 0.005 {
        format!("{:.2}\u{b0}   {significance}", ray.spread_degrees)
    } else {
        significance
    }
}

fn interval_of(ray: &RecordedRay) -> String {
    let [low, high] = [ray.lambda_low_nm, ray.lambda_high_nm];
    let decimals = usize::from(high - low < 10.0);
    format!("{low:.decimals$}\u{2013}{high:.decimals$} nm")
}

/// A part of 1 without the 0 before its point.
fn part(part: f32) -> String {
    format!("{part:.3}").trim_start_matches('0').to_owned()
}

/// The row for who can't see it.
fn spoken(ray: &RecordedRay) -> String {
    format!(
        "ray {}, {}, {}, significance {}",
        ray.id,
        ray_words::kind(ray.kind),
        ray_words::end(&ray.end),
        number(ray.significance)
    )
}

/// Three digits, of small numbers with their power of ten.
pub(super) fn number(value: f32) -> String {
    match value.abs() {
        0.0 => "0".to_owned(),
        0.001.. => format!("{value:.4}"),
        _ => format!("{value:.2e}"),
    }
}
