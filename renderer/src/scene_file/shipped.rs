//! The scenes that ship.

/// A scene that ships inside the program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ShippedScene {
    /// Its name in the menu.
    pub name: &'static str,
    /// The scene file; it needs no other file.
    pub text: &'static str,
}

const SCENES: [ShippedScene; 6] = [
    ShippedScene { name: "Diamond", text: include_str!("../../../assets/scenes/diamond.toml") },
    ShippedScene {
        name: "Seven diamonds",
        text: include_str!("../../../assets/scenes/seven-diamonds.toml"),
    },
    ShippedScene { name: "Prism", text: include_str!("../../../assets/scenes/prism.toml") },
    ShippedScene {
        name: "Prism and word",
        text: include_str!("../../../assets/scenes/prism-word.toml"),
    },
    ShippedScene { name: "Slab", text: include_str!("../../../assets/scenes/slab.toml") },
    ShippedScene { name: "Furnace", text: include_str!("../../../assets/scenes/furnace.toml") },
];

/// The scenes that ship, in the order of the menu.
pub fn scenes() -> &'static [ShippedScene] {
    &SCENES
}
