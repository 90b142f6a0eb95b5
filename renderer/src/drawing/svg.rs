//! Drawings as SVG.

use std::fmt::Write as _;

use glam::DVec2;

use super::sheet::{Anchor, Fill, Ink, Mark, Sheet, Stroke, Words};

impl Sheet {
    /// The drawing as an SVG document in millimetres, on white paper.
    ///
    /// Texts stay texts, each set to the length it was laid out with, whatever font the reader has.
    pub fn to_svg(&self) -> String {
        let [width, height] = self.size_mm.to_array().map(number);
        let title = escaped(&self.title);
        let mut svg = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}mm\" height=\"{height}mm\" \
             viewBox=\"0 0 {width} {height}\" font-family=\"Ubuntu, Helvetica, Arial, sans-serif\" \
             stroke-linecap=\"round\" stroke-linejoin=\"round\">\n<title>{title}</title>\n\
             <rect width=\"{width}\" height=\"{height}\" fill=\"#ffffff\"/>\n"
        );
        for mark in &self.marks {
            match mark {
                Mark::Stroke(stroke) => push_stroke(&mut svg, stroke),
                Mark::Fill(fill) => push_fill(&mut svg, fill),
                Mark::Words(words) => push_words(&mut svg, words),
            }
        }
        svg.push_str("</svg>\n");
        svg
    }
}

fn push_stroke(svg: &mut String, stroke: &Stroke) {
    let Stroke { points, width_mm, dash_mm, ink } = stroke;
    let dash = dash_mm.map_or_else(String::new, |[dash, gap]| {
        format!(" stroke-dasharray=\"{} {}\"", number(dash), number(gap))
    });
    let (points, width, color) = (path(points), number(*width_mm), color(*ink));
    push_line(
        svg,
        &format!(
            "<path d=\"{points}\" fill=\"none\" stroke=\"{color}\" stroke-width=\"{width}\"{dash}/>"
        ),
    );
}

fn push_fill(svg: &mut String, Fill { points, ink }: &Fill) {
    push_line(svg, &format!("<path d=\"{}Z\" fill=\"{}\"/>", path(points), color(*ink)));
}

fn push_words(svg: &mut String, words: &Words) {
    let anchor = match words.anchor {
        Anchor::Start => "start",
        Anchor::Middle => "middle",
        Anchor::End => "end",
    };
    let [x, y] = words.at.to_array().map(number);
    let (size, length) = (number(words.em_mm), number(words.width_mm()));
    let (color, text) = (color(words.ink), escaped(&words.text));
    push_line(
        svg,
        &format!(
            "<text x=\"{x}\" y=\"{y}\" font-size=\"{size}\" text-anchor=\"{anchor}\" \
             textLength=\"{length}\" lengthAdjust=\"spacingAndGlyphs\" fill=\"{color}\">{text}</text>"
        ),
    );
}

fn push_line(svg: &mut String, line: &str) {
    svg.push_str(line);
    svg.push('\n');
}

fn path(points: &[DVec2]) -> String {
    let mut path = String::new();
    for (index, point) in points.iter().enumerate() {
        let command = if index == 0 { 'M' } else { 'L' };
        // Writing to a string does not fail.
        let _ = write!(path, "{command}{} {}", number(point.x), number(point.y));
    }
    path
}

fn color(ink: Ink) -> String {
    let [red, green, blue] = ink.on_paper();
    format!("#{red:02x}{green:02x}{blue:02x}")
}

/// A length to a micrometre, without zeros that say nothing.
fn number(value: f64) -> String {
    let text = format!("{value:.3}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

/// Text as XML holds it; what XML 1.0 can't hold is left out.
fn escaped(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for letter in text.chars() {
        match letter {
            '&' => escaped.push_str("&amp;"),
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            '"' => escaped.push_str("&quot;"),
            '\u{fffe}' | '\u{ffff}' => {}
            control if control.is_control() => escaped.push(' '),
            other => escaped.push(other),
        }
    }
    escaped
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short() {
        assert_eq!(number(12.0), "12");
        assert_eq!(number(0.12345), "0.123");
        assert_eq!(number(-0.0001), "0");
        assert_eq!(number(100.0), "100");
    }

    #[test]
    fn what_xml_means_is_escaped() {
        assert_eq!(escaped("a<b> & \"c\"\n\u{0}d"), "a&lt;b&gt; &amp; &quot;c&quot;  d");
    }
}
