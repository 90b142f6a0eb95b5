//! How shaders lay out their structures, to compare with Rust's.

use wgpu::naga::TypeInner;
use wgpu::naga::front::wgsl;

/// Name and offset of each member of structure `name`, and then its size as of one more member.
pub(in crate::develop) fn layout(modules: &[&str], name: &str) -> Vec<(String, usize)> {
    let module = wgsl::parse_str(&super::source(modules)).unwrap();
    let found = module.types.iter().find(|(_, found)| found.name.as_deref() == Some(name));
    let TypeInner::Struct { members, span } = &found.unwrap().1.inner else {
        panic!("{name} is no structure");
    };
    let members = members.iter().map(|member| (member.name.clone().unwrap(), member.offset));
    let members = members.chain([("size".to_owned(), *span)]);
    members.map(|(name, offset)| (name, offset as usize)).collect()
}

/// The same of the structure `$name` of this scope.
macro_rules! rust_layout {
    ($name:ident { $($member:ident),* $(,)? }) => {{
        // All members are named, or this doesn't compile.
        let _ = |$name { $($member: _),* }: $name| ();
        let mut members = vec![$((stringify!($member).to_owned(), std::mem::offset_of!($name, $member))),*];
        members.push(("size".to_owned(), size_of::<$name>()));
        members
    }};
}
pub(in crate::develop) use rust_layout;
