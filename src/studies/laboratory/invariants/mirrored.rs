//! A system mirrored in the plane of x and z.

use toml::Table;

use super::space::Space;
use super::variant::SystemVariant;

pub(super) fn mirrored(system: &Table) -> SystemVariant {
    let space = Space {
        mirrored: true,
        ..Space::default()
    };
    let mut variant = SystemVariant::of_file(system.clone());
    space.apply(&mut variant.file);
    variant.space = space;
    variant
}
