//! How shaders lay out their structs, to compare with Rust's.

use wgpu::naga::front::wgsl;
use wgpu::naga::valid::{Capabilities, ValidationFlags, Validator};
use wgpu::naga::{Module, TypeInner};

/// The shader as naga understands it, if it is valid.
pub(crate) fn parse(source: &str) -> Module {
    let module =
        wgsl::parse_str(source).unwrap_or_else(|error| panic!("{}", error.emit_to_string(source)));
    Validator::new(ValidationFlags::all(), Capabilities::empty())
        .validate(&module)
        .unwrap_or_else(|error| panic!("{}", error.emit_to_string(source)));
    module
}

/// Size of a struct of the shader, and its members with their offsets.
pub(crate) fn layout_of(module: &Module, name: &str) -> (usize, Vec<(String, usize)>) {
    let found = module.types.iter().find(|(_, found)| found.name.as_deref() == Some(name));
    let TypeInner::Struct { members, span } = &found.expect(name).1.inner else {
        panic!("{name} is no struct");
    };
    let members = members.iter().map(|member| {
        let name = member.name.clone().unwrap_or_default();
        (name, member.offset as usize)
    });
    (*span as usize, members.collect())
}

/// Asserts that a struct of this scope, all of whose members are named, is laid out as the shader's.
macro_rules! assert_twins {
    ($module:expr, $name:ident { $($member:ident),* $(,)? }) => {{
        // All members are named, or this doesn't compile.
        let _ = |$name { $($member: _),* }: $name| ();
        let members =
            vec![$((stringify!($member).to_owned(), std::mem::offset_of!($name, $member))),*];
        assert_eq!(
            $crate::shaders::layout::layout_of($module, stringify!($name)),
            (size_of::<$name>(), members)
        );
    }};
}
pub(crate) use assert_twins;
