//! That the probes can fail: every slip in a shader makes some of them do so.

use brilliance_renderer::shaders::{KERNEL, ShaderModule, join};
use wgpu::naga::front::wgsl;

use crate::probes::tables;

/// What a slip of the pen makes of a piece of WGSL.
const SLIPS: &[(&str, &str)] = &[
    (" + ", " - "),
    (" - ", " + "),
    (" * ", " / "),
    (" / ", " * "),
    (" += ", " -= "),
    (" < ", " >= "),
    (" > ", " <= "),
    (" <= ", " > "),
    (" >= ", " < "),
    (" == ", " != "),
    (" != ", " == "),
    (" && ", " || "),
    (" || ", " && "),
    (" >> ", " << "),
    (" ^ ", " & "),
    ("min(", "max("),
    ("max(", "min("),
    ("floor(", "ceil("),
    ("ceil(", "floor("),
    ("cos(", "sin("),
    ("sin(", "cos("),
    ("sqrt(", "abs("),
    ("exp(", "abs("),
    ("-dot(", "dot("),
    ("abs(", "-("),
    ("(-", "("),
    ("return -", "return "),
    (", -", ", "),
    ("!", ""),
    ("0.5", "0.6"),
    ("1.0", "1.1"),
    ("2.0", "2.1"),
    ("NONE", "0u"),
    ("low", "high"),
    (".x", ".y"),
    (".y", ".z"),
    (".z", ".x"),
    ("0u", "1u"),
    ("1u", "2u"),
];
