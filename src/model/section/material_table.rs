//! A design as the material table of a line case.

use super::design::Design;
use super::stiffness::EndRotation;
use crate::number::si;

/// First words of every such table.
const MATERIAL_HEADER: &str = "# Material of a line, made by `seacable section`";

/// The table `[materials.<name>]` of a line case, with further results in comments.
#[must_use]
pub fn material_table(design: &Design) -> String {
    let about = &design.section.about;
    let material = design.material();
    let other = |core: super::model::Core| si(design.matrix(core).ea(EndRotation::Fixed), "N");
    let mut lines = format!("{MATERIAL_HEADER} {}.\n", env!("CARGO_PKG_VERSION"));
    lines += &comment(&format!("{}.", about.title.trim_end_matches('.')));
    if !about.source.is_empty() {
        lines += &comment(&format!("Source: {}", about.source));
    }
    lines += &comment(&format!(
        "EA with fixed ends (Knapp 1979; Lin et al. 2016, eqs. (16)-(17)): {} with a rigid core, {} with an incompressible one; the difference is a model error. Used here: {}.",
        other(super::model::Core::Rigid),
        other(super::model::Core::Incompressible),
        about.core
    ));
    lines += &comment(&format!(
        "EI = {} at full slip (Costello 1976, eqs. (18)-(19)), sheaths added; {} at full stick.",
        si(design.bending.full_slip(), "N m²"),
        si(design.bending.full_stick(), "N m²")
    ));
    lines += &comment(&format!(
        "GJ = {} at fixed length (eq. (17)).",
        si(design.matrix(about.core).gj_fixed_length(), "N m²")
    ));
    if let Some(strength) = &design.strength {
        lines += &comment(&format!(
            "Breaking load: {} in layer {} reaches its strength first; allowable tension {}.",
            strength.weakest.1,
            strength.weakest.0,
            si(strength.allowable, "N")
        ));
    }
    lines += &comment("A section has no drag coefficients: add drag_normal and drag_tangential.");
    lines += &format!("[materials.{}]\n", crate::case::join(&[&about.name]));
    lines += &key("diameter_m", material.diameter_m);
    lines += &key("mass_kg_per_m", material.mass_kg_per_m);
    if let Some(wet) = material.wet_weight_kg_per_m {
        lines += &key("wet_weight_kg_per_m", wet);
    }
    lines += &key("ea_n", design.ea());
    lines += &key("ei_n_m2", material.ei_n_m2);
    if let Some(load) = material.break_load_n {
        lines += &key("break_load_n", load);
    }
    lines
}

fn comment(words: &str) -> String {
    let words = words.split_whitespace().collect::<Vec<_>>().join(" ");
    format!("# {words}\n")
}

/// A key with its value to seven digits, as TOML writes floats.
fn key(name: &str, value: f64) -> String {
    let rounded: f64 = format!("{value:.6e}").parse().unwrap_or(value);
    let text = if (1e-4..1e6).contains(&rounded.abs()) {
        format!("{rounded:?}")
    } else {
        format!("{rounded:e}")
    };
    format!("{name} = {text}\n")
}
