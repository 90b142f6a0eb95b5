//! What crosses over to a graphics device lies at the same places on both sides.

use std::collections::BTreeSet;
use std::mem::{offset_of, size_of};

use brilliance_renderer::kernel::walk::TraceRules;
use brilliance_renderer::packed::{
    BvhNode, Instance, PackedDisc, PackedGround, PackedMaterial, PackedPassage, PackedPrint,
    PackedSky, PackedTriangle,
};
use brilliance_renderer::shaders::{Frame, KERNEL, join};
use glam::{Vec3, Vec4};
use wgpu::naga::{AddressSpace, ArraySize, Handle, Module, Scalar, StructMember, Type, TypeInner};

use crate::wgsl::parse;

/// Structs of the shaders that have no twin of the same layout.
const WITHOUT_TWIN: &[(&str, &str)] = &[
    ("Ray", "stacks never leave the device: 76 bytes in Rust, 80 where vec3f is aligned"),
    ("Fan", "the same: Rust orders its members as it likes"),
    ("Nodes", "of fans alone"),
];

/// A type as WGSL spells it.
trait Spelled {
    const WGSL: &str;
}

macro_rules! spelled {
    ($($rust:ty: $wgsl:literal),* $(,)?) => {
        $(impl Spelled for $rust {
            const WGSL: &str = $wgsl;
        })*
    };
}

spelled! {
    u32: "u32",
    f32: "f32",
    Vec3: "vec3<f32>",
    [u32; 2]: "vec2<u32>",
    [u32; 3]: "vec3<u32>",
    [Vec4; 3]: "array<vec4<f32>, 3>",
    TraceRules: "TraceRules",
    PackedPrint: "PackedPrint",
    PackedSky: "PackedSky",
    PackedGround: "PackedGround",
}

/// A member of a struct: its name, its type in WGSL, and where it begins.
#[derive(Clone, Debug, PartialEq)]
struct Member {
    name: String,
    ty: String,
    offset: u32,
}

/// A struct.
#[derive(Clone, Debug, PartialEq)]
struct Layout {
    name: String,
    members: Vec<Member>,
    span: u32,
}

fn spelling<S, T: Spelled>(_: fn(&S) -> &T) -> String {
    T::WGSL.to_owned()
}

/// The layouts of `repr(C)` structs. A member that is left out does not compile.
macro_rules! layouts {
    ($($name:ident { $($member:ident),* $(,)? })*) => {
        vec![$({
            let _all_members = |$name { $($member: _),* }: $name| ();
            Layout {
                name: stringify!($name).to_owned(),
                members: vec![$(Member {
                    name: stringify!($member).to_owned(),
                    ty: spelling(|whole: &$name| &whole.$member),
                    offset: offset_of!($name, $member) as u32,
                }),*],
                span: size_of::<$name>() as u32,
            }
        }),*]
    };
}

fn rust_layouts() -> Vec<Layout> {
    layouts! {
        BvhNode { min, primitive_count, max, first }
        PackedTriangle { a, facet, b, normal_x, c, normal_y, normal_z, padding }
        Instance {
            object_from_world, kind, first, count, material, center, interior_is_clear
        }
        PackedPrint {
            front, front_offset, tint, primaries, size, outside, texels, levels, projection,
            projection_stride
        }
        PackedMaterial { index_table, absorption, reflectance, least_absorption, print }
        PackedDisc {
            direction, cos_radius, sin_squared_radius, solid_angle, spectrum, first_passage,
            passage_count, padding
        }
        PackedPassage {
            center_out, radius_out, direction, cos_bound, normal_in, sin_bound, normal_out,
            instance, center_in, radius_in, facet_in, facet_out, padding
        }
        PackedGround { height, square, reflectance }
        PackedSky {
            hemisphere, environment, backdrop, light_spread, cos_observer_shadow,
            sin_squared_observer_shadow, padding
        }
        Frame {
            position, width, forward, height, right, first_row, up, pixel_count, rules, sky,
            ground, first_pass, item_count, budget, bin_count, bin_width_nm, disc_count,
            top_node_count, first_walker, instance_count, axis, padding
        }
        TraceRules {
            observer, split_count, significance_threshold, max_depth, perturb, cut_threshold
        }
    }
}

fn scalar_spelling(scalar: Scalar) -> &'static str {
    match scalar {
        Scalar::U32 => "u32",
        Scalar::F32 => "f32",
        other => panic!("{other:?} is in no buffer"),
    }
}

/// The kernel as naga understands it.
struct Shader(Module);

impl Shader {
    fn spelling(&self, handle: Handle<Type>) -> String {
        let ty = &self.0.types[handle];
        if let Some(name) = &ty.name {
            return name.clone();
        }
        match ty.inner {
            TypeInner::Array { base, size: ArraySize::Constant(count), .. } => {
                format!("array<{}, {count}>", self.spelling(base))
            }
            TypeInner::Atomic(scalar) => format!("atomic<{}>", scalar_spelling(scalar)),
            TypeInner::Scalar(scalar) => scalar_spelling(scalar).to_owned(),
            TypeInner::Vector { size, scalar } => {
                format!("vec{}<{}>", size as u32, scalar_spelling(scalar))
            }
            ref other => panic!("{other:?} is not looked for in a struct"),
        }
    }

    fn layout(&self, handle: Handle<Type>) -> Option<Layout> {
        let ty = &self.0.types[handle];
        let TypeInner::Struct { members, span } = &ty.inner else { return None };
        let member = |member: &StructMember| Member {
            name: member.name.clone().unwrap_or_default(),
            ty: self.spelling(member.ty),
            offset: member.offset,
        };
        let name = ty.name.clone()?;
        Some(Layout { name, members: members.iter().map(member).collect(), span: *span })
    }

    /// The structs that lie in buffers, whole or as parts of others.
    fn stored(&self) -> Vec<Layout> {
        let is_stored =
            |space| matches!(space, AddressSpace::Storage { .. } | AddressSpace::Uniform);
        let variables = self.0.global_variables.iter().map(|(_, variable)| variable);
        let mut waiting: Vec<_> =
            variables.filter(|variable| is_stored(variable.space)).map(|v| v.ty).collect();
        let mut seen = BTreeSet::new();
        let mut stored = Vec::new();
        while let Some(handle) = waiting.pop() {
            if !seen.insert(handle) {
                continue;
            }
            match &self.0.types[handle].inner {
                TypeInner::Array { base, .. } => waiting.push(*base),
                TypeInner::Struct { members, .. } => {
                    waiting.extend(members.iter().map(|member| member.ty));
                }
                _ => {}
            }
            stored.extend(self.layout(handle));
        }
        stored
    }
}

/// Where the two sides differ; nothing where they don't.
fn differences(rust: &[Layout], shader: &Shader) -> Vec<String> {
    let mut differences = Vec::new();
    let stored = shader.stored();
    for wgsl in &stored {
        if WITHOUT_TWIN.iter().any(|(name, _)| *name == wgsl.name) {
            continue;
        }
        let Some(rust) = rust.iter().find(|rust| rust.name == wgsl.name) else {
            differences.push(format!("{} has no twin in the table", wgsl.name));
            continue;
        };
        // What only fills up the end need not be named in WGSL, which fills up by itself.
        let mut members = rust.members.clone();
        if members.len() > wgsl.members.len() {
            members.pop_if(|last| last.name == "padding");
        }
        if members != wgsl.members || rust.span != wgsl.span {
            differences.push(format!("{rust:#?} is not\n{wgsl:#?}"));
        }
    }
    let names = rust.iter().map(|rust| rust.name.as_str());
    for name in names.chain(WITHOUT_TWIN.iter().map(|(name, _)| *name)) {
        if stored.iter().all(|wgsl| wgsl.name != name) {
            differences.push(format!("{name} lies in no buffer"));
        }
    }
    differences
}

#[test]
fn what_crosses_over_has_one_layout() {
    let differences = differences(&rust_layouts(), &Shader(parse(&join(KERNEL))));
    assert!(differences.is_empty(), "{}", differences.join("\n"));
}

/// The test can fail: each of these is the mistake that it is there for.
#[test]
fn a_slip_in_a_struct_is_found() {
    // Where nothing uses the members: the test looks at the declarations alone.
    let source = join(&KERNEL[..2]);
    let slips = [
        (
            "    min: vec3f,\n    primitive_count: u32,\n    max: vec3f,",
            "    max: vec3f,\n    primitive_count: u32,\n    min: vec3f,",
        ),
        ("    least_absorption: f32,\n", ""),
        ("    texels: u32,\n    levels: u32,\n", "    levels: u32,\n    texels: u32,\n"),
        (
            "    solid_angle: f32,\n    spectrum: u32,\n",
            "    spectrum: u32,\n    solid_angle: f32,\n",
        ),
        ("    backdrop: u32,\n", "    backdrop: f32,\n"),
        ("    normal_y: f32,\n    normal_z: f32,\n", "    normal_z: f32,\n    normal_y: f32,\n"),
        ("    object_from_world: array<vec4f, 3>,", "    object_from_world: array<vec4f, 4>,"),
    ];
    for (from, to) in slips {
        assert_eq!(source.matches(from).count(), 1, "{from}");
        let shader = Shader(parse(&source.replace(from, to)));
        assert!(!differences(&rust_layouts(), &shader).is_empty(), "{from}");
    }
}
