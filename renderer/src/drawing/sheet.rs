//! A drawing as a plain value, before it becomes a file or is shown.

use glam::DVec2;

use super::font;
use super::rect::Rect;

/// A line drawing on a sheet of paper. Lengths are millimetres; the origin is the upper left corner
/// and y runs down.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Sheet {
    /// What it shows, in one line.
    pub title: String,
    /// Width and height of the paper.
    pub size_mm: DVec2,
    /// What is drawn, the first lowest.
    pub marks: Vec<Mark>,
}

/// One thing on a sheet.
#[derive(Clone, Debug, PartialEq)]
pub enum Mark {
    /// A line.
    Stroke(Stroke),
    /// An area.
    Fill(Fill),
    /// A line of text.
    Words(Words),
}

/// A polyline with round ends and corners.
#[derive(Clone, Debug, PartialEq)]
pub struct Stroke {
    /// Its corners, at least two.
    pub points: Vec<DVec2>,
    /// Width of the pen.
    pub width_mm: f64,
    /// Lengths of dash and gap; none for a solid line.
    pub dash_mm: Option<[f64; 2]>,
    /// Colour.
    pub ink: Ink,
}

/// A filled polygon.
#[derive(Clone, Debug, PartialEq)]
pub struct Fill {
    /// Its corners, at least three.
    pub points: Vec<DVec2>,
    /// Colour.
    pub ink: Ink,
}

/// A line of text.
#[derive(Clone, Debug, PartialEq)]
pub struct Words {
    /// The text.
    pub text: String,
    /// A point of its baseline.
    pub at: DVec2,
    /// Which point of the baseline that is.
    pub anchor: Anchor,
    /// Size of the font.
    pub em_mm: f64,
    /// Colour.
    pub ink: Ink,
}

/// Where a text stands relative to its point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Anchor {
    /// It begins there.
    Start,
    /// It is centred there.
    Middle,
    /// It ends there.
    End,
}

/// What a mark is for; the paper and the window each have their colour for it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ink {
    /// What the drawing is about: edges, names, numbers.
    Main,
    /// What explains it: leaders, dimension lines, captions.
    Fine,
    /// Areas to be told from the paper.
    Tint,
    /// Areas without light, on which light is drawn.
    Dark,
    /// Lines on such areas.
    Pale,
    /// Light of this colour, as sRGB codes.
    Light([u8; 3]),
}

impl Ink {
    /// The sRGB codes on white paper.
    pub fn on_paper(self) -> [u8; 3] {
        match self {
            Self::Main => [20, 22, 26],
            Self::Fine => [104, 110, 120],
            Self::Tint => [236, 239, 244],
            Self::Dark => [16, 17, 20],
            Self::Pale => [150, 156, 166],
            Self::Light(codes) => codes,
        }
    }
}

impl Sheet {
    /// An empty sheet.
    pub fn new(title: impl Into<String>, size_mm: DVec2) -> Self {
        Self { title: title.into(), size_mm, marks: Vec::new() }
    }

    /// Draws a solid polyline.
    pub fn stroke(&mut self, points: impl Into<Vec<DVec2>>, width_mm: f64, ink: Ink) {
        let points = points.into();
        self.marks.push(Mark::Stroke(Stroke { points, width_mm, dash_mm: None, ink }));
    }

    /// Draws a dashed polyline.
    pub fn dashes(&mut self, points: impl Into<Vec<DVec2>>, width_mm: f64, ink: Ink) {
        let (points, dash_mm) = (points.into(), Some([1.6, 1.2]));
        self.marks.push(Mark::Stroke(Stroke { points, width_mm, dash_mm, ink }));
    }

    /// Fills a polygon.
    pub fn fill(&mut self, points: impl Into<Vec<DVec2>>, ink: Ink) {
        self.marks.push(Mark::Fill(Fill { points: points.into(), ink }));
    }

    /// Fills a small disc.
    pub fn dot(&mut self, center: DVec2, radius_mm: f64, ink: Ink) {
        const CORNERS: u32 = 24;
        let corner = |k| {
            let turn = std::f64::consts::TAU * f64::from(k) / f64::from(CORNERS);
            center + radius_mm * DVec2::from_angle(turn)
        };
        self.fill((0..CORNERS).map(corner).collect::<Vec<_>>(), ink);
    }

    /// Draws the head of an arrow that points along `direction`, with its tip at `tip`.
    pub fn arrow_head(&mut self, tip: DVec2, direction: DVec2, ink: Ink) {
        const LENGTH_MM: f64 = 1.8;
        const HALF_WIDTH_MM: f64 = 0.45;
        let along = direction.normalize_or_zero();
        let (back, aside) = (tip - LENGTH_MM * along, HALF_WIDTH_MM * along.perp());
        self.fill([tip, back + aside, back - aside], ink);
    }

    /// Writes a line of text with a point of its baseline at `at`.
    pub fn write(
        &mut self,
        text: impl Into<String>,
        at: DVec2,
        anchor: Anchor,
        em_mm: f64,
        ink: Ink,
    ) {
        self.marks.push(Mark::Words(Words { text: text.into(), at, anchor, em_mm, ink }));
    }

    /// The lines, the lowest first.
    pub fn strokes(&self) -> impl Iterator<Item = &Stroke> {
        self.marks.iter().filter_map(Mark::as_stroke)
    }

    /// The texts, the lowest first.
    pub fn words(&self) -> impl Iterator<Item = &Words> {
        self.marks.iter().filter_map(Mark::as_words)
    }

    /// True if no line and no text passes through `room`.
    pub fn is_blank(&self, room: &Rect) -> bool {
        let mut pieces = self.strokes().flat_map(|stroke| stroke.points.windows(2));
        let is_crossed = pieces.any(|ends| room.is_crossed_by([ends[0], ends[1]]));
        !is_crossed && !self.words().any(|words| words.bounds().overlaps(room))
    }
}

impl Mark {
    /// The line that this is, if it is one.
    pub fn as_stroke(&self) -> Option<&Stroke> {
        if let Self::Stroke(stroke) = self { Some(stroke) } else { None }
    }

    /// The text that this is, if it is one.
    pub fn as_words(&self) -> Option<&Words> {
        if let Self::Words(words) = self { Some(words) } else { None }
    }
}

impl Words {
    /// Where the baseline begins.
    pub fn start(&self) -> DVec2 {
        let before = match self.anchor {
            Anchor::Start => 0.0,
            Anchor::Middle => 0.5,
            Anchor::End => 1.0,
        };
        self.at - DVec2::new(before * self.width_mm(), 0.0)
    }

    /// Length of the text.
    pub fn width_mm(&self) -> f64 {
        font::width(&self.text, self.em_mm)
    }

    /// The room that the text takes, from capitals to descenders.
    pub fn bounds(&self) -> Rect {
        let start = self.start();
        Rect {
            min: start - DVec2::new(0.0, font::CAP_HEIGHT * self.em_mm),
            max: start + DVec2::new(self.width_mm(), font::DESCENT * self.em_mm),
        }
    }
}
