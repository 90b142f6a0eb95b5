//! Drawings as SVG and PNG.

use brilliance_renderer::cuts::RoundBrilliant;
use brilliance_renderer::drawing::{Ink, Mark, Sheet, facet_diagram};
use glam::DVec2;
use quick_xml::Reader;
use quick_xml::events::Event;

use crate::bodies::*;

/// An element's name and its attributes.
type Element = (String, Vec<(String, String)>);

/// The elements of an SVG, and its texts.
fn read(svg: &str) -> (Vec<Element>, Vec<String>) {
    let mut reader = Reader::from_str(svg);
    let (mut elements, mut texts) = (Vec::new(), Vec::new());
    loop {
        match reader.read_event().unwrap() {
            Event::Eof => return (elements, texts),
            Event::Start(element) | Event::Empty(element) => {
                let name = String::from_utf8(element.name().as_ref().to_vec()).unwrap();
                let attributes = element.attributes().map(|attribute| {
                    let attribute = attribute.unwrap();
                    let key = String::from_utf8(attribute.key.as_ref().to_vec()).unwrap();
                    (key, String::from_utf8(attribute.value.to_vec()).unwrap())
                });
                elements.push((name, attributes.collect()));
            }
            Event::Text(text) => texts.push(text.decode().unwrap().into_owned()),
            Event::GeneralRef(reference) => {
                texts.push(format!("&{};", reference.decode().unwrap()));
            }
            _ => {}
        }
    }
}

#[test]
fn an_svg_is_well_formed_and_its_numbers_are_finite() {
    for object in [brilliant(RoundBrilliant::default()), step_cut(), octahedron()] {
        let sheet = facet_diagram(&object).unwrap();
        let (elements, texts) = read(&sheet.to_svg());
        let count = |wanted: &str| elements.iter().filter(|(name, _)| name == wanted).count();
        assert_eq!(count("svg"), 1);
        assert_eq!(count("text"), sheet.words().count());
        assert_eq!(count("path"), sheet.marks.len() - sheet.words().count());
        for (key, value) in elements.iter().flat_map(|(_, attributes)| attributes) {
            let is_number = ["x", "y", "d", "stroke-width", "font-size", "textLength", "viewBox"];
            if !is_number.contains(&key.as_str()) {
                continue;
            }
            for number in value.split(['M', 'L', 'Z', ' ']).filter(|part| !part.is_empty()) {
                let number: f64 = number.parse().unwrap();
                assert!(number.is_finite() && number.abs() < 1e4, "{key}={value}");
            }
        }
        for words in sheet.words().filter(|words| !words.text.contains(['&', '<', '>', '"'])) {
            assert!(texts.contains(&words.text), "{}", words.text);
        }
    }
}

#[test]
fn hostile_names_stay_text() {
    let mut object = brilliant(RoundBrilliant::default());
    object.name = "</text><script>\"a\" & 'b'\u{0}\u{1}\u{ffff}".to_owned();
    let svg = facet_diagram(&object).unwrap().to_svg();
    let (elements, texts) = read(&svg);
    assert!(
        elements
            .iter()
            .all(|(name, _)| ["svg", "title", "rect", "path", "text"].contains(&name.as_str()))
    );
    assert!(texts.concat().contains("&lt;/text&gt;&lt;script&gt;"), "{texts:?}");
    assert!(!svg.contains(['\u{0}', '\u{1}', '\u{ffff}']));
}

#[test]
fn a_png_has_ink_where_there_are_lines_and_paper_elsewhere() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("drawing.PNG");
    let sheet = facet_diagram(&brilliant(RoundBrilliant::default())).unwrap();
    let size = sheet.size_at(Sheet::DPI);
    assert_eq!(size, [2339, 1654], "A4 at 200 dots per inch");
    sheet.save(&path, size).unwrap();
    let picture = image::open(&path).unwrap().to_luma8();
    let at = |point: DVec2| {
        let [x, y] = (point * Sheet::DPI / 25.4).to_array().map(|pixel| pixel as u32);
        picture.get_pixel(x, y).0[0]
    };
    assert_eq!(at(DVec2::splat(3.0)), 255);
    let outlines = sheet.strokes().filter(|s| s.ink == Ink::Main && s.width_mm > 0.4);
    let mut checked = 0;
    for stroke in outlines {
        let middle = at(0.5 * (stroke.points[0] + stroke.points[1]));
        // A leader may cross it there, in its own grey.
        assert!(middle < 120, "{middle} in the middle of an outline");
        checked += 1;
    }
    assert!(checked > 30);
    let title = sheet.words().max_by(|a, b| a.em_mm.total_cmp(&b.em_mm)).unwrap().bounds();
    let [low, high] = [title.min, title.max].map(|p| (p * Sheet::DPI / 25.4).as_uvec2());
    let dark = (low.x..high.x)
        .flat_map(|x| (low.y..high.y).map(move |y| (x, y)))
        .filter(|(x, y)| picture.get_pixel(*x, *y).0[0] < 128)
        .count();
    let all = ((high.x - low.x) * (high.y - low.y)) as usize;
    assert!(dark * 20 > all && dark * 2 < all, "{dark} of {all} pixels of the title are ink");
}

#[test]
fn impossible_sizes_and_endings_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let sheet = facet_diagram(&brilliant(RoundBrilliant::default())).unwrap();
    for size in [[0, 10], [70_000, 10]] {
        assert!(sheet.to_rgba8(size).is_err());
    }
    let fault = sheet.save(&folder.path().join("drawing.pdf"), [10, 10]).unwrap_err().to_string();
    assert!(fault.contains(".svg or .png"), "{fault}");
    let fault = sheet.save(&folder.path().join("none/drawing.svg"), [10, 10]).unwrap_err();
    assert!(fault.to_string().contains("does not exist"), "{fault}");
}

#[test]
fn lights_keep_their_colour() {
    let mut sheet = Sheet::new("light", DVec2::splat(10.0));
    let all = [DVec2::ZERO, DVec2::new(10.0, 0.0), DVec2::splat(10.0), DVec2::new(0.0, 10.0)];
    sheet.fill(all, Ink::Light([200, 100, 50]));
    assert!(matches!(sheet.marks[..], [Mark::Fill(_)]));
    let pixels = sheet.to_rgba8([8, 8]).unwrap();
    assert_eq!(pixels[4 * 27..4 * 28], [200, 100, 50, 255]);
    assert!(sheet.to_svg().contains("#c86432"));
}
