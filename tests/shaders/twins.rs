//! Every function of the kernel has its twin in WGSL, under the same name and in the same order,
//! and both sides say the same of it.

use std::fs;
use std::path::Path;

use brilliance_renderer::shaders::KERNEL;

/// Functions of a module that have no twin, and why.
type Singles = (&'static str, &'static [&'static str], &'static str);

const RUST_ONLY: &[Singles] = &[
    (
        "convex",
        &["hit", "new_wide_ray", "project", "greatest", "with_simd", "nearest_exit"],
        "the processor tests as many planes at a time as it can, a shader one after the other",
    ),
    (
        "facet",
        &["new_wide_points", "outside", "narrow", "with_simd"],
        "the processor tests as many planes at a time as it can, a shader one after the other",
    ),
    (
        "band",
        &["weights_of_bins", "whole_bins"],
        "the processor sums up many bins at a time, a shader one after the other",
    ),
    ("axis", &["all_axis_moments"], "the same"),
    ("fan_trace", &["trace_fans"], "walkers follow fans from one dispatch to the next"),
    ("fan_walk", &["of_fans"], "a walker's state lies in buffers"),
    (
        "packed",
        &["new_packed_scene", "spectrum_row"],
        "the processor packs, and has rows as slices",
    ),
    ("trace", &["trace"], "walkers follow rays from one dispatch to the next"),
    ("walk", &["new_ray_stack", "default", "new_walk", "keep"], "a walker's state lies in buffers"),
];

const WGSL_ONLY: &[Singles] = &[
    ("convex", &["plane_of", "plane_hit"], "Rust has the planes of a solid as slices"),
    ("fan_walk", &["pop_fan", "push_fan"], "stacks of Rust hold either rays or fans"),
    (
        "vector",
        &["normalize_or_zero", "length_squared", "max_element", "min_element", "max_position"],
        "glam has them",
    ),
];

/// A function as it stands in a file: its name, and the first sentence that is said of it.
#[derive(Clone, Debug, PartialEq)]
struct Function {
    name: String,
    sentence: String,
}

/// The functions of a text in their order. A method `new` of `BoxRay` is `new_box_ray`, as in WGSL.
fn functions(text: &str, comment: &str) -> Vec<Function> {
    let text = text.split("#[cfg(test)]").next().unwrap_or_default();
    let (mut functions, mut said, mut owner) = (Vec::new(), Vec::new(), String::new());
    for line in text.lines() {
        let code = line.trim_start();
        if let Some(words) = code.strip_prefix(comment) {
            said.push(words.trim());
        } else if let Some(rest) = code.strip_prefix("pub fn ").or(code.strip_prefix("fn ")) {
            let name = rest.split(['(', '<']).next().unwrap_or_default();
            let sentence = first_sentence(&said);
            functions.push(Function { name: in_wgsl(name, &owner), sentence });
        } else if line.starts_with("impl") {
            owner = owner_of(line);
        } else if !code.starts_with("#[") {
            said.clear();
        }
    }
    functions
}

/// The type that a line `impl<…> Trait for Type<…> {` is about.
fn owner_of(line: &str) -> String {
    let mut depth = 0;
    let is_outside = |letter: &char| {
        match letter {
            '<' => depth += 1,
            '>' => depth -= 1,
            _ => return depth == 0,
        }
        false
    };
    let words: String = line.trim_end_matches([' ', '{']).chars().filter(is_outside).collect();
    words.trim_end().rsplit(' ').next().unwrap_or_default().to_owned()
}

fn in_wgsl(name: &str, owner: &str) -> String {
    if name != "new" {
        return name.to_owned();
    }
    let mut whole = name.to_owned();
    for letter in owner.chars() {
        if letter.is_uppercase() {
            whole.push('_');
        }
        whole.extend(letter.to_lowercase());
    }
    whole
}

/// Up to the first full stop or empty line. [`Hit::MISS`] in a link is `MISS`.
fn first_sentence(said: &[&str]) -> String {
    let paragraph: Vec<_> = said.iter().copied().take_while(|line| !line.is_empty()).collect();
    let words = paragraph.join(" ").replace("[`", "`").replace("`]", "`").replace("Hit::", "");
    let end = words.find(". ").unwrap_or(words.len());
    words[..end].trim_end_matches('.').to_owned()
}

fn source_folder() -> &'static Path {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/src"))
}

/// The Rust file that a module is the twin of.
fn rust_text(module: &str) -> String {
    let folder = source_folder();
    let file = match module {
        "vector" => return String::new(),
        "packed" => folder.join("packed.rs"),
        _ => folder.join(format!("kernel/{module}.rs")),
    };
    fs::read_to_string(&file).unwrap_or_else(|error| panic!("{}: {error}", file.display()))
}

/// The functions that are in `functions` and should have a twin. The list of those that have none
/// must not outlive them.
fn with_twin(module: &str, functions: Vec<Function>, singles: &[Singles]) -> Vec<Function> {
    let singles: Vec<_> = singles.iter().filter(|(name, ..)| *name == module).collect();
    for (_, names, _) in &singles {
        for name in *names {
            let is_there = functions.iter().any(|function| function.name == *name);
            assert!(is_there, "{module}: {name} is no more");
        }
    }
    let is_single = |function: &Function| {
        singles.iter().any(|(_, names, _)| names.contains(&function.name.as_str()))
    };
    functions.into_iter().filter(|function| !is_single(function)).collect()
}

#[test]
fn every_function_has_its_twin_at_the_same_place() {
    for module in KERNEL {
        let name = module.name;
        let rust = with_twin(name, functions(&rust_text(name), "///"), RUST_ONLY);
        let wgsl = with_twin(name, functions(module.source, "//"), WGSL_ONLY);
        let names = |functions: &[Function]| -> Vec<_> {
            functions.iter().map(|function| function.name.clone()).collect()
        };
        assert_eq!(names(&rust), names(&wgsl), "{name}");
        for (rust, wgsl) in rust.iter().zip(&wgsl) {
            assert_eq!(rust.sentence, wgsl.sentence, "{name}: {}", rust.name);
        }
    }
}

#[test]
fn every_file_has_its_twin() {
    let files = fs::read_dir(source_folder().join("kernel")).expect("the kernel is a folder");
    for file in files {
        let path = file.expect("the folder is listed").path();
        let stem = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let is_known = stem == "mod" || KERNEL.iter().any(|module| module.name == stem);
        assert!(is_known, "{}", path.display());
    }
}

/// The tests above can fail only if functions are found at all.
#[test]
fn functions_are_found_with_their_names_and_words() {
    let rust = "
impl BoxRay {
    /// For a ray; see [`Hit::MISS`]. And more.
    #[inline]
    pub fn new(origin: Vec3) -> Self {
    }
}
impl<'a, S: Simd> WideRay<'a, S> {
    fn new(simd: S) {}
}
/// Two
/// lines.
///
/// And more.
fn least<S: Simd>(simd: S) {}
#[cfg(test)]
mod tests { fn skipped() {} }
";
    let found = functions(rust, "///");
    let expected =
        [("new_box_ray", "For a ray; see `MISS`"), ("new_wide_ray", ""), ("least", "Two lines")];
    let expected = expected
        .map(|(name, sentence)| Function { name: name.to_owned(), sentence: sentence.to_owned() });
    assert_eq!(found, expected);
}
