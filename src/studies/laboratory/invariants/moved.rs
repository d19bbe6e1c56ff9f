//! A system moved horizontally: in waves along their crests, so that they come to it as they came.

use toml::{Table, Value};

use super::space::Space;
use super::tree::number;
use super::variant::SystemVariant;

/// Ways \[m\].
const WITHOUT_WAVES: [f64; 2] = [137.0, -61.0];
const ALONG_CRESTS: f64 = 150.0;

pub(super) fn moved(system: &Table) -> SystemVariant {
    let waves = system.get("waves").and_then(Value::as_array);
    let first = waves.and_then(|all| all.first()?.as_table());
    let shift = first.map_or(WITHOUT_WAVES, |waves| {
        let towards = number(waves, "direction_deg").unwrap_or(0.0).to_radians();
        [-towards.sin() * ALONG_CRESTS, towards.cos() * ALONG_CRESTS]
    });
    let space = Space {
        shift,
        ..Space::default()
    };
    let mut variant = SystemVariant::of_file(system.clone());
    space.apply(&mut variant.file);
    variant.space = space;
    variant
}
