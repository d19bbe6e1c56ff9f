//! Line types of the IEA ontology: with their properties, or by a material and a diameter.
//!
//! By the schema of the ontology a diameter is volume-equivalent. Files with `type: chain` and no more than a diameter have the
//! nominal one all the same (185 mm in the file of the IEA 15 MW turbine, whose chain has 685 kg/m), except where no such chain is made
//! (0.333 m in WISDEM's copy of the same file). Which was taken is a remark.

use super::mapping::Mapping;
use super::raft;
use super::tree::shortened;
use crate::import::fault::Fault;
use crate::import::mooring::{Given, Mass, MooringLineType, Stiffness};
use crate::line_types::{self, LineProperties, find, properties};
use crate::number::digits;

/// Materials of the ontology and the line types of the library whose formulas are taken for them.
const MATERIALS: [(&str, &str); 6] = [
    ("chain", "chain-r4-studless"),
    ("chain_stud", "chain-r4-stud"),
    ("wire", "spiral-strand"),
    ("iwrc", "wire-six-strand"),
    ("polyester", "polyester"),
    ("nylon", "nylon"),
];

/// Materials without a formula here.
const WITHOUT_FORMULA: [&str; 4] = ["polypropylene", "fiber", "wire_fiber", "wire_wire"];

/// The greatest nominal diameter \[m\] that lines are made with: larger ones are taken for volume-equivalent.
const GREATEST_NOMINAL: f64 = 0.25;

/// Keys that state what a line type is.
const STATED: [&str; 2] = ["mass_density", "stiffness"];

/// Reads a line type.
pub fn line_type(
    row: &Mapping<'_>,
    name: &str,
    remarks: &mut Vec<String>,
    faults: &mut Vec<Fault>,
) -> Option<MooringLineType> {
    let diameter = row.positive("diameter", faults);
    let common = raft::common(row, faults);
    let is_custom = row
        .get("type")
        .and_then(|node| node.text())
        .is_none_or(|text| text.eq_ignore_ascii_case("custom"));
    let is_stated = is_custom || STATED.iter().any(|key| row.get(key).is_some());
    let (diameter, mass, stiffness, break_load) = if is_stated {
        let mass = row.not_negative(STATED[0], faults);
        let stiffness = row.positive(STATED[1], faults);
        (diameter?, mass?, stiffness?, None)
    } else {
        let line = by_material(row, &diameter?, faults)?;
        let at = row.node.span();
        let load = Given::new(line.properties.break_load.value, at.clone());
        remarks.push(line.remark(name));
        let of = &line.properties;
        let given = |value: f64| Given::new(value, line.given.span.clone());
        (
            given(of.diameter.value),
            given(of.mass.value),
            given(of.ea.value),
            Some(load),
        )
    };
    let common = common?;
    let [drag_normal, drag_tangential] = common.drag;
    let [added_mass_normal, added_mass_tangential] = common.added_mass;
    Some(MooringLineType {
        name: name.to_owned(),
        span: row.node.span(),
        diameter,
        mass: Given::new(Mass::InAir(mass.value), mass.span),
        stiffness: Given::new(Stiffness::Constant(stiffness.value), stiffness.span),
        damping: common.damping,
        bending: common.bending,
        drag_normal,
        drag_tangential,
        added_mass_normal,
        added_mass_tangential,
        friction: None,
        break_load: common.break_load.or(break_load),
    })
}

/// A line type by its material and diameter.
struct ByMaterial {
    properties: LineProperties,
    /// The diameter of the file.
    given: Given<f64>,
    /// Whether that is the nominal one.
    is_nominal: bool,
}

fn by_material(
    row: &Mapping<'_>,
    diameter: &Given<f64>,
    faults: &mut Vec<Fault>,
) -> Option<ByMaterial> {
    let remedy = "give `type: custom` with mass_density, stiffness and breaking_load";
    let word = row.word("type", remedy, faults)?;
    let lower = word.value.to_lowercase();
    let known = MATERIALS.iter().find(|(material, _)| *material == lower);
    let Some(of) = known.and_then(|(_, name)| find(name)) else {
        let problem = match WITHOUT_FORMULA.contains(&lower.as_str()) {
            true => format!("there is no formula for lines of `{lower}` here"),
            false => format!(
                "`{}` is not a material of the ontology",
                shortened(&word.value)
            ),
        };
        let names: Vec<&str> = MATERIALS.iter().map(|(material, _)| *material).collect();
        let remedy = format!("{remedy}; formulas are here for {}", names.join(", "));
        faults.push(Fault::new(word.span, row.key("type"), problem, remedy));
        return None;
    };
    let is_nominal = diameter.value <= GREATEST_NOMINAL;
    let line = match is_nominal {
        true => properties(of, diameter.value),
        false => nominal_of_volume(of, diameter.value),
    };
    match line {
        Ok(properties) => Some(ByMaterial {
            properties,
            given: diameter.clone(),
            is_nominal,
        }),
        Err(why) => {
            let key = row.key("diameter");
            faults.push(Fault::new(
                diameter.span.clone(),
                key,
                why.to_string(),
                remedy,
            ));
            None
        }
    }
}

/// The line whose volume-equivalent diameter \[m\] this is: the two have a fixed ratio in all formulas.
fn nominal_of_volume(
    of: &'static line_types::LineType,
    volume: f64,
) -> Result<LineProperties, line_types::NominalDiameterError> {
    let unit = properties(of, GREATEST_NOMINAL)?;
    properties(of, volume * GREATEST_NOMINAL / unit.diameter.value)
}

impl ByMaterial {
    /// What was taken, for the notes of the case.
    fn remark(&self, name: &str) -> String {
        let of = &self.properties;
        let mm = |length: f64| digits(length * 1e3, 4);
        let kind = match self.is_nominal {
            true => {
                "nominal, as files of the ontology have it, though its schema calls it volume-equivalent"
            }
            false => "volume-equivalent",
        };
        format!(
            "Line type {name} has a material and a diameter alone: {} mm is taken as {kind}; mass {} kg/m, EA {} N and breaking load are those \
             of {} with nominal {} mm in `seacable lines`. mass_density and stiffness in the file replace them.",
            mm(self.given.value),
            digits(of.mass.value, 4),
            digits(of.ea.value, 4),
            of.line_type.name,
            mm(of.nominal_m)
        )
    }
}
