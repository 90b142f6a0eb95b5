//! Drawings as pixels.

use vello_cpu::color::{AlphaColor, Srgb};
use vello_cpu::kurbo::{Affine, BezPath, Stroke as Pen};
use vello_cpu::{Pixmap, RenderContext, Resources};

use glam::DVec2;

use super::font;
use super::sheet::{Ink, Mark, Sheet};
use crate::error::RendererError;

impl Sheet {
    /// The drawing in the middle of a white picture of this size, as large as it fits: red, green,
    /// blue and alpha of each pixel, row by row from the top.
    ///
    /// # Errors
    /// A side of 0 pixels or of more than 65535.
    pub fn to_rgba8(&self, size: [u32; 2]) -> Result<Vec<u8>, RendererError> {
        let [Ok(width @ 1..), Ok(height @ 1..)] = size.map(u16::try_from) else {
            return Err(RendererError::Invalid(format!(
                "a drawing of {} × {} pixels can't be made; choose 1 to {} for each side",
                size[0],
                size[1],
                u16::MAX
            )));
        };
        let mut context = RenderContext::new(width, height);
        context.set_paint(AlphaColor::<Srgb>::WHITE);
        let (wide, high) = (f64::from(width), f64::from(height));
        context.fill_rect(&vello_cpu::kurbo::Rect::new(0.0, 0.0, wide, high));

        let scale = (wide / self.size_mm.x).min(high / self.size_mm.y);
        let corner = 0.5 * (DVec2::new(wide, high) - scale * self.size_mm);
        let pixels_from_mm = Affine::new([scale, 0.0, 0.0, scale, corner.x, corner.y]);
        context.set_transform(pixels_from_mm);
        for mark in &self.marks {
            draw(&mut context, pixels_from_mm, mark);
        }
        context.flush();
        let mut pixels = Pixmap::new(width, height);
        context.render(&mut pixels, &mut Resources::new());
        Ok(pixels.data_as_u8_slice().to_vec())
    }
}

fn draw(context: &mut RenderContext, pixels_from_mm: Affine, mark: &Mark) {
    match mark {
        Mark::Stroke(stroke) => {
            let mut pen = Pen::new(stroke.width_mm);
            if let Some(dash) = stroke.dash_mm {
                pen = pen.with_dashes(0.0, dash);
            }
            context.set_stroke(pen);
            set_ink(context, stroke.ink);
            context.stroke_path(&polyline(&stroke.points));
        }
        Mark::Fill(fill) => {
            let mut path = polyline(&fill.points);
            path.close_path();
            set_ink(context, fill.ink);
            context.fill_path(&path);
        }
        Mark::Words(words) => {
            let start = words.start();
            set_ink(context, words.ink);
            context.set_transform(pixels_from_mm * Affine::translate((start.x, start.y)));
            context.fill_path(&font::outline(&words.text, words.em_mm));
            context.set_transform(pixels_from_mm);
        }
    }
}

fn set_ink(context: &mut RenderContext, ink: Ink) {
    let [red, green, blue] = ink.on_paper();
    context.set_paint(AlphaColor::from_rgb8(red, green, blue));
}

fn polyline(points: &[DVec2]) -> BezPath {
    let mut path = BezPath::new();
    for (index, point) in points.iter().enumerate() {
        if index == 0 {
            path.move_to((point.x, point.y));
        } else {
            path.line_to((point.x, point.y));
        }
    }
    path
}
