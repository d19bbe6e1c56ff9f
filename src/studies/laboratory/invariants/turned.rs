//! A system turned about the vertical.

use toml::Table;

use super::space::Space;
use super::variant::SystemVariant;

/// The turn \[deg\].
const TURN_DEG: f64 = 37.0;

pub(super) fn turned(system: &Table) -> SystemVariant {
    let space = Space {
        turn: TURN_DEG.to_radians(),
        ..Space::default()
    };
    let mut variant = SystemVariant::of_file(system.clone());
    space.apply(&mut variant.file);
    variant.space = space;
    variant
}
