//! Turbines of the IEA ontology (windIO): `components: mooring` with nodes, lines, line types.
//!
//! Nodes lie at a `location` or at a joint of the floating platform. Density, gravity and depth come from `environment`, which files
//! of version 2 no longer have.

use super::joints::PlatformJoints;
use super::mapping::{Mapping, listed};
use super::ontology_types;
use super::system::{Dialect, Named, lines, point};
use crate::import::fault::Fault;
use crate::import::mooring::{Given, Mooring, MooringPoint, MooringSea, Program};

/// Names of the ontology.
const DIALECT: Dialect = Dialect {
    points: ("nodes", "node"),
    hold: "node_type",
    mass: ["node_mass", "node_volume"],
    ends: ["node1", "node2"],
    line_type: "line_type",
    length: "unstretched_length",
};

/// Reads the mooring of a turbine.
///
/// # Errors
/// All that is wrong, in the order of the file.
pub fn read(root: &Mapping<'_>) -> Result<Mooring, Vec<Fault>> {
    let mut faults = Vec::new();
    let mut mooring = Mooring::new(Program::Ontology);
    mooring.title = root
        .get("name")
        .and_then(|name| name.text())
        .unwrap_or_default()
        .to_owned();
    if let Some(components) = root.mapping("components", "give the parts", &mut faults) {
        let joints = PlatformJoints::of_components(root, &components, &mut faults);
        let remedy = "a moored turbine has `components: mooring` with nodes, lines and line_types";
        if let Some(table) = components.mapping("mooring", remedy, &mut faults) {
            system(&table, &joints, &mut mooring, &mut faults);
        }
        if joints.has_angles {
            let unit = match joints.in_radians {
                true => "radians, as before version 2 of windIO",
                false => "degrees, as from version 2 of windIO",
            };
            let remark = format!("Angles of cylindrical joints are taken in {unit}.");
            mooring.remarks.push(remark);
        }
    }
    mooring.sea = sea(root, &mut faults);
    match faults.is_empty() {
        true => Ok(mooring),
        false => Err(faults),
    }
}

fn system(
    table: &Mapping<'_>,
    joints: &PlatformJoints<'_>,
    mooring: &mut Mooring,
    faults: &mut Vec<Fault>,
) {
    let rows = table.mappings("line_types", "line type", faults);
    let path = table.key("line_types");
    let remarks = &mut mooring.remarks;
    let types = Named::read(&rows, "line type", &path, faults, |row, name, faults| {
        ontology_types::line_type(row, name, remarks, faults)
    });
    let anchors = anchors(table);
    let rows = table.mappings("nodes", "node", faults);
    let path = table.key("nodes");
    let points = Named::read(&rows, "node", &path, faults, |row, name, faults| {
        anchor_type(row, &anchors, faults);
        node(row, name, joints, faults)
    });
    mooring.lines = lines(table, &DIALECT, &types, &points, faults);
    mooring.line_types = types.valid();
    mooring.points = points.valid();
}

fn node(
    row: &Mapping<'_>,
    name: &str,
    joints: &PlatformJoints<'_>,
    faults: &mut Vec<Fault>,
) -> Option<MooringPoint> {
    let is_given = |key: &str| row.get(key).is_some_and(|node| node.text() != Some("none"));
    let place = if row.get("location").is_some() {
        row.place("location", faults)
    } else if is_given("joint") {
        let word = row.word("joint", "name a joint of the platform", faults);
        word.and_then(|word| joints.place(&word, &row.key("joint"), faults))
    } else {
        let problem = "the node has neither `location` nor `joint`";
        let remedy = "give `location: [x, y, z]` in m, or the name of a joint";
        faults.push(Fault::new(
            row.node.span(),
            row.path.clone(),
            problem,
            remedy,
        ));
        None
    };
    point(row, name, &DIALECT, place, faults)
}

/// The names of the anchor types: they hold whatever pulls at them, here and at rest in other programs.
fn anchors(table: &Mapping<'_>) -> Vec<String> {
    let list = table.get("anchor_types").and_then(|list| list.items());
    let names = list.unwrap_or_default().into_iter();
    names
        .filter_map(|row| row.get("name")?.text().map(str::to_owned))
        .collect()
}

/// An anchor type that a node names must be there.
fn anchor_type(row: &Mapping<'_>, anchors: &[String], faults: &mut Vec<Fault>) {
    let Some(node) = row.get("anchor_type") else {
        return;
    };
    let name = node.text().unwrap_or_default();
    if name == "none" || anchors.iter().any(|anchor| anchor == name) {
        return;
    }
    let problem = format!("there is no anchor type {}", node.description());
    let remedy = listed("anchor type", anchors);
    faults.push(row.fault(&node, "anchor_type", problem, remedy));
}

/// Water and gravity of `environment`.
fn sea(root: &Mapping<'_>, faults: &mut Vec<Fault>) -> MooringSea {
    let Some(environment) = root.optional_mapping("environment") else {
        return MooringSea::default();
    };
    let mut of =
        |key: &str| -> Option<Given<f64>> { environment.optional_positive(key, faults).flatten() };
    MooringSea {
        gravity: of("gravity"),
        density: of("water_density"),
        depth: of("water_depth"),
        ..MooringSea::default()
    }
}
