//! Small lines for tests: a bare rope in a vacuum, and what a test changes of it, both in the words of a case.

use seacable::case::{self, Case};
use toml::{Table, Value};

/// 100 m of rope, 2 kg/m, in ten segments, hung by its top in a vacuum, the foot free.
const BARE: &str = r#"
[case]
title = "A bare rope"
[environment]
water_density_kg_per_m3 = 0.0
[materials.rope]
diameter_m = 0.1
mass_kg_per_m = 2.0
ea_n = 1.0e6
added_mass_normal = 0.0
[[line]]
name = "rope"
material = "rope"
length_m = 100.0
segments = 10
[ends.a]
name = "top"
kind = "fixed"
position_m = [0.0, 0.0, 0.0]
[ends.b]
name = "foot"
kind = "free"
[solver]
error_estimate = false
"#;

/// The bare rope with changes, written as lines of a case with dotted keys: `materials.rope.ea_n = 1e9`. What is
/// said of `line` changes its one section. The case passes every check that a file passes.
pub(crate) fn line(changes: &str) -> Case {
    let text = text(changes);
    case::parse(&text, "test.toml").unwrap_or_else(|found| panic!("{found:#?}\n{text}"))
}

/// The text of that case.
pub(crate) fn text(changes: &str) -> String {
    let mut base: Table = BARE.parse().unwrap();
    merge(&mut base, changes.parse().unwrap());
    toml::to_string(&base).unwrap()
}

pub(crate) fn merge(base: &mut Table, changes: Table) {
    for (key, change) in changes {
        match (base.get_mut(&key), change) {
            (Some(Value::Table(old)), Value::Table(new)) => merge(old, new),
            (Some(Value::Array(list)), Value::Table(new)) => {
                merge(list[0].as_table_mut().unwrap(), new);
            }
            // A change to "" takes the key away.
            (_, Value::String(word)) if word.is_empty() => drop(base.remove(&key)),
            (_, change) => drop(base.insert(key, change)),
        }
    }
}
