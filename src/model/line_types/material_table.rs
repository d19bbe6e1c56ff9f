//! A line type as the table `[materials.<name>]` of a case, with formulas and sources as comments.

use super::{LineProperties, Property};
use crate::case::{TomlNode, join};
use crate::number::{digits, si};

/// First words of every such table.
const HEADER: &str = "# Line type of `seacable lines`";

/// The name of the material: type and nominal diameter in millimetres, `chain-r4-studless-120mm`.
#[must_use]
pub fn material_name(line: &LineProperties) -> String {
    let size = digits(line.nominal_m * 1e3, 6).replace('.', "_");
    format!("{}-{size}mm", line.line_type.name)
}

/// The table `[materials.<name>]`, a comment with formula and source behind every value; d is the nominal diameter in m,
/// D the outer one, all else in SI.
#[must_use]
pub fn material_table(line: &LineProperties, name: &str) -> String {
    let of = &line.line_type;
    let mut lines = format!("{HEADER} {}.\n", env!("CARGO_PKG_VERSION"));
    lines += &format!(
        "# {}, nominal diameter d = {} mm; D is the outer diameter, by which drag, buoyancy and added mass act.\n",
        of.title,
        digits(line.nominal_m * 1e3, 6)
    );
    lines += &format!(
        "# {} kg/m in sea water of 1025 kg/m^3.\n",
        digits(line.wet_weight.value, 4)
    );
    if let Some(proof) = &line.proof_load {
        let load = si(proof.value, "N");
        lines += &format!(
            "# Proof load {load}: {} ({}).\n",
            proof.formula, proof.source
        );
    }
    if !of.note.is_empty() {
        lines += &format!("# {}\n", of.note);
    }
    if let Some(warning) = &line.warning {
        lines += &format!("# WARNING: {warning}\n");
    }
    lines += &format!("[materials.{}]\n", join(&[name]));
    let given =
        |(key, property): &(&str, &Property)| *key != "break_load_n" || property.value > 0.0;
    for (key, property) in keys(line).into_iter().filter(given) {
        lines += &row(key, property);
    }
    lines + &dynamic_stiffness(line)
}

/// The keys of the material that the library has values for.
fn keys(line: &LineProperties) -> [(&'static str, &Property); 8] {
    [
        ("diameter_m", &line.diameter),
        ("mass_kg_per_m", &line.mass),
        ("ea_n", &line.ea),
        ("break_load_n", &line.break_load),
        ("drag_normal", &line.drag_normal),
        ("drag_tangential", &line.drag_tangential),
        ("added_mass_normal", &line.added_mass_normal),
        ("added_mass_tangential", &line.added_mass_tangential),
    ]
}

fn row(key: &str, property: &Property) -> String {
    let value = toml_number(property.value);
    format!(
        "{key} = {value} # {} ({})\n",
        property.formula, property.source
    )
}

/// The keys of stiffness in motion, as comments: a case at rest has no use for them.
fn dynamic_stiffness(line: &LineProperties) -> String {
    let Some(([alpha, beta], source)) = &line.line_type.dynamic_stiffness else {
        return String::new();
    };
    format!(
        "# In motion ({}), Lm being the mean tension in percent of the breaking load:\n\
         # dynamic_stiffness = \"about-the-mean\"\n\
         # dynamic_alpha = {} # EA = (alpha + beta Lm) times the breaking load\n\
         # dynamic_beta = {}\n",
        source,
        toml_number(*alpha),
        toml_number(*beta)
    )
}

/// A value to seven digits, as TOML writes floats.
fn toml_number(value: f64) -> String {
    let rounded: f64 = format!("{value:.6e}").parse().unwrap_or(value);
    if rounded.abs() <= 0.0 || (1e-4..1e6).contains(&rounded.abs()) {
        format!("{rounded:?}")
    } else {
        format!("{rounded:e}")
    }
}

/// A file with the material added at its end, and the name that it has there: the first of `name`, `name-2`, `name-3`
/// and so on that is free.
#[must_use]
pub fn with_material(text: &str, line: &LineProperties) -> (String, String) {
    let root = TomlNode::parse(text).ok();
    let taken = root.as_ref().and_then(|root| root.get("materials"));
    let taken = taken.map_or_else(Vec::new, TomlNode::names);
    let base = material_name(line);
    let others = (2..=taken.len() + 2).map(|n| format!("{base}-{n}"));
    let mut names = std::iter::once(base.clone()).chain(others);
    let name = names.find(|name| !taken.contains(name)).unwrap_or(base);
    let end = if text.contains("\r\n") { "\r\n" } else { "\n" };
    let table = material_table(line, &name).replace('\n', end);
    let gap = if text.is_empty() || text.ends_with('\n') {
        ""
    } else {
        end
    };
    (format!("{text}{gap}{end}{table}"), name)
}
