//! The font of drawings, Ubuntu Light, which is also that of the window.

use skrifa::instance::{LocationRef, Size};
use skrifa::outline::{DrawSettings, OutlinePen};
use skrifa::{FontRef, GlyphId, MetadataProvider as _};
use vello_cpu::kurbo::BezPath;

const FONT: &[u8] = include_bytes!("../../../assets/fonts/Ubuntu-Light.ttf");

/// Height of capitals and digits over the size of the font.
pub const CAP_HEIGHT: f64 = 0.6875;
/// How far letters reach below the baseline, over the size of the font.
pub const DESCENT: f64 = 0.19;

/// Length of a line of text, in the unit of `em`.
pub fn width(text: &str, em: f64) -> f64 {
    Glyphs::of(text).map(|glyph| glyph.advance).sum::<f64>() * em
}

/// The outlines of a line of text of size `em` that begins at the origin, with y down.
pub(super) fn outline(text: &str, em: f64) -> BezPath {
    let mut path = BezPath::new();
    let mut x = 0.0;
    let outlines = font().outline_glyphs();
    for Glyph { id, advance } in Glyphs::of(text) {
        if let Some(outline) = outlines.get(id) {
            let mut pen = Pen { path: &mut path, x, em };
            let settings = DrawSettings::unhinted(Size::new(1.0), LocationRef::default());
            // A glyph that can't be drawn leaves its room empty.
            let _ = outline.draw(settings, &mut pen);
        }
        x += advance * em;
    }
    path
}

fn font() -> FontRef<'static> {
    FontRef::new(FONT).expect("the font is compiled in, and every drawing reads it")
}

struct Glyph {
    id: GlyphId,
    /// Over the size of the font.
    advance: f64,
}

struct Glyphs;

impl Glyphs {
    /// The glyphs of `text`, in its order.
    fn of(text: &str) -> impl Iterator<Item = Glyph> {
        let font = font();
        let (letters, metrics) =
            (font.charmap(), font.glyph_metrics(Size::new(1.0), LocationRef::default()));
        text.chars().map(move |letter| {
            let id = letters.map(letter).unwrap_or_default();
            Glyph { id, advance: f64::from(metrics.advance_width(id).unwrap_or_default()) }
        })
    }
}

/// Writes outlines of glyphs of size 1, y up, into a path of size `em`, y down.
struct Pen<'a> {
    path: &'a mut BezPath,
    x: f64,
    em: f64,
}

impl Pen<'_> {
    fn place(&self, x: f32, y: f32) -> (f64, f64) {
        (self.x + f64::from(x) * self.em, -f64::from(y) * self.em)
    }
}

impl OutlinePen for Pen<'_> {
    fn move_to(&mut self, x: f32, y: f32) {
        self.path.move_to(self.place(x, y));
    }

    fn line_to(&mut self, x: f32, y: f32) {
        self.path.line_to(self.place(x, y));
    }

    fn quad_to(&mut self, cx: f32, cy: f32, x: f32, y: f32) {
        self.path.quad_to(self.place(cx, cy), self.place(x, y));
    }

    fn curve_to(&mut self, ax: f32, ay: f32, bx: f32, by: f32, x: f32, y: f32) {
        self.path.curve_to(self.place(ax, ay), self.place(bx, by), self.place(x, y));
    }

    fn close(&mut self) {
        self.path.close_path();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_font_has_what_drawings_write() {
        let letters = font().charmap();
        for letter in ('a'..='z').chain('A'..='Z').chain("0123456789 .,:;=+%()°–\u{2212}…".chars())
        {
            assert!(letters.map(letter).is_some(), "{letter}");
        }
    }

    #[test]
    fn widths_add_up_and_grow_with_the_size() {
        let both = width("table 56 %", 3.0);
        assert!((both - width("table", 3.0) - width(" 56 %", 3.0)).abs() < 1e-9);
        assert!((width("table 56 %", 6.0) - 2.0 * both).abs() < 1e-9);
        assert!(both > 10.0 && both < 18.0, "{both}");
    }

    #[test]
    fn capitals_are_as_high_as_stated() {
        use vello_cpu::kurbo::Shape as _;
        let height = -outline("H", 1.0).bounding_box().y0;
        assert!((height - CAP_HEIGHT).abs() < 0.005, "{height}");
        let below = outline("gpqy", 1.0).bounding_box().y1;
        assert!(below <= DESCENT + 0.01, "{below}");
    }
}
