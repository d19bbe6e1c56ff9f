//! A system mirrored in the plane of x and z.

use toml::Table;

use super::space::Space;
use super::variant::Variant;

pub(super) fn mirrored(system: &Table) -> Variant {
    let space = Space {
        mirrored: true,
        ..Space::default()
    };
    let mut variant = Variant::of(system.clone());
    space.apply(&mut variant.file);
    variant.space = space;
    variant
}
