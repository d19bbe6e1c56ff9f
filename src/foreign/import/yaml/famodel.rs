//! Arrays of `FAModel`: platforms by place and heading, each with the lines of a mooring system.
//!
//! Headings are those of a compass: clockwise from north, which is +y; those of lines are relative to their platform's. A line runs from
//! its anchor, at `span` from the fairlead, to the platform; between its sections are connectors, which are free points.

use std::path::Path;

use super::famodel_fairleads::{Fairleads, fairleads};
use super::famodel_lines::{ArrayParts, LineConfig};
use super::famodel_rows::rows;
use super::mapping::Mapping;
use super::tree::{YamlNode, shortened};
use crate::import::fault::Fault;
use crate::import::mooring::{
    Attachment, Given, Hold, Mooring, MooringBody, MooringLine, MooringPoint, MooringSea, Program,
};

/// Lines that an array may have at most.
const GREATEST_COUNT: usize = 20_000;

/// Tables that change the lines and are not read.
const REFUSED: [(&str, &str); 2] = [
    ("array_mooring", "lines and anchors that platforms share"),
    ("uniform_array", "arrays by spacings"),
];

/// A line of a mooring system.
#[derive(Debug, Clone)]
struct SystemLine<'d> {
    config: Given<String>,
    /// Relative to the platform's \[deg\].
    heading: Given<f64>,
    /// Its fairlead by number from 1.
    fairlead: Option<Given<f64>>,
    row: YamlNode<'d>,
}

/// A row of the array.
struct Platform<'d> {
    name: Given<String>,
    place: [Given<f64>; 3],
    heading: Given<f64>,
    mooring: YamlNode<'d>,
    kind: Given<f64>,
}

/// Reads the moorings of an array.
///
/// # Errors
/// All that is wrong, in the order of the file.
pub fn read(root: &Mapping<'_>, folder: &Path) -> Result<Mooring, Vec<Fault>> {
    let mut faults = Vec::new();
    let mut mooring = Mooring::new(Program::FaModel);
    for (key, what) in REFUSED {
        if let Some(node) = root.get(key) {
            let problem = format!("{what} are not read from an array of FAModel");
            let remedy = "write them as a file of MoorDyn, whose points and lines are read";
            faults.push(Fault::new(node.key_span(), key, problem, remedy));
        }
    }
    let depth = sea(root, &mut mooring, &mut faults);
    let parts = ArrayParts::read(root, &mut faults);
    let platforms = platforms(root, &mut faults);
    if let Some(depth) = depth {
        for platform in &platforms {
            moor(
                root,
                folder,
                platform,
                &depth,
                &parts,
                &mut mooring,
                &mut faults,
            );
        }
    }
    if mooring.lines.is_empty() && faults.is_empty() {
        let problem = "no platform of the array has lines";
        let remedy = "give a mooringID that is one of the mooring_systems";
        faults.push(Fault::new(root.node.key_span(), "array", problem, remedy));
    }
    if root.get("cables").is_some() || root.get("array_cables").is_some() {
        mooring
            .remarks
            .push("Cables of the array are not read.".to_owned());
    }
    mooring.line_types = parts.types.valid();
    match faults.is_empty() {
        true => Ok(mooring),
        false => Err(faults),
    }
}

/// Water of `site: general`; the depth, on a bed that is flat.
fn sea(root: &Mapping<'_>, mooring: &mut Mooring, faults: &mut Vec<Fault>) -> Option<Given<f64>> {
    let remedy = "give `site: general: water_depth`";
    let site = root.mapping("site", remedy, faults)?;
    let general = site.mapping("general", remedy, faults)?;
    let depth = general.positive("water_depth", faults);
    mooring.sea = MooringSea {
        density: general.optional_positive("rho_water", faults).flatten(),
        depth: depth.clone(),
        ..MooringSea::default()
    };
    let depth = depth?;
    if let Some(bed) = site.optional_mapping("bathymetry") {
        let rows = bed
            .get("depths")
            .and_then(|rows| rows.items())
            .unwrap_or_default();
        let cells = rows.iter().flat_map(|row| row.items().unwrap_or_default());
        let is_flat = cells
            .map(|cell| cell.number())
            .all(|cell| cell == Some(depth.value));
        if bed.get("file").is_some() || !is_flat {
            let problem = "a bed with other depths than `water_depth` is not read from an array";
            let remedy =
                "leave it out for a bed at `water_depth`, or write a case with `depth_file`";
            let span = bed.node.key_span();
            faults.push(Fault::new(span, "site.bathymetry", problem, remedy));
        }
    }
    Some(depth)
}

/// The rows of the array.
fn platforms<'d>(root: &Mapping<'d>, faults: &mut Vec<Fault>) -> Vec<Platform<'d>> {
    const REMEDY: &str = "give `keys: [ID, topsideID, platformID, mooringID, x_location, y_location, heading_adjust]` and rows of `data`";
    let Some(array) = root.mapping("array", REMEDY, faults) else {
        return Vec::new();
    };
    let mut platforms = Vec::new();
    for row in rows(&array, REMEDY, faults) {
        let number = |key: &str, faults: &mut Vec<Fault>| row.number(key, faults);
        let name = row.word("ID", "name the platform", faults);
        let [x, y, heading, kind] = ["x_location", "y_location", "heading_adjust", "platformID"]
            .map(|key| number(key, faults));
        let mooring = row.required("mooringID", REMEDY, faults);
        let z = match row.get("z_location") {
            Some(_) => number("z_location", faults),
            None => Some(Given::new(0.0, row.span.clone())),
        };
        let (Some(name), Some(mooring), Some(kind)) = (name, mooring, kind) else {
            continue;
        };
        let (Some(x), Some(y), Some(z), Some(heading)) = (x, y, z, heading) else {
            continue;
        };
        platforms.push(Platform {
            name,
            place: [x, y, z],
            heading,
            mooring,
            kind,
        });
    }
    platforms
}

/// The lines of a mooring system.
fn system<'d>(
    root: &Mapping<'d>,
    name: &YamlNode<'_>,
    faults: &mut Vec<Fault>,
) -> Option<Vec<SystemLine<'d>>> {
    let remedy = "give `mooring_systems` with the lines of each by heading";
    let systems = root.mapping("mooring_systems", remedy, faults)?;
    let text = name.text().unwrap_or_default();
    let Some(node) = systems.get(text) else {
        let names: Vec<String> = systems
            .others(&[])
            .iter()
            .map(|(key, _)| (*key).to_owned())
            .collect();
        let problem = format!("there is no mooring system {}", name.description());
        let remedy = super::mapping::listed("mooring system", &names);
        faults.push(Fault::new(
            name.span(),
            "array.data.mooringID",
            problem,
            remedy,
        ));
        return None;
    };
    let table = Mapping::of_node(node, systems.key(&shortened(text)), faults)?;
    let mut lines = Vec::new();
    for row in rows(
        &table,
        "give `keys: [MooringConfigID, heading, anchorType]` and rows of `data`",
        faults,
    ) {
        let config = row.word("MooringConfigID", "name a configuration", faults);
        let heading = row.number("heading", faults);
        let fairlead = match row.get("fairlead") {
            Some(_) => Some(row.number("fairlead", faults)?),
            None => None,
        };
        lines.push(SystemLine {
            config: config?,
            heading: heading?,
            fairlead,
            row: row.cells.first().map_or(node, |(_, node)| *node),
        });
    }
    Some(lines)
}

/// Adds the lines of a platform.
fn moor(
    root: &Mapping<'_>,
    folder: &Path,
    platform: &Platform<'_>,
    depth: &Given<f64>,
    parts: &ArrayParts,
    mooring: &mut Mooring,
    faults: &mut Vec<Fault>,
) {
    if platform.mooring.number() == Some(0.0) {
        return;
    }
    let before = faults.len();
    let fairleads = fairleads(root, folder, &platform.kind, faults);
    let lines = system(root, &platform.mooring, faults);
    let (Some(fairleads), Some(lines)) = (fairleads, lines) else {
        // The same fault for each platform of a kind is said once.
        let mut found = faults.split_off(before);
        found.retain(|fault| !faults.contains(fault));
        faults.extend(found);
        return;
    };
    let body = mooring.bodies.len();
    mooring.bodies.push(body_of(platform));
    for (number, line) in lines.iter().enumerate() {
        let Some(config) = parts.config(&line.config, faults) else {
            continue;
        };
        if mooring.lines.len() + config.sections.len() > GREATEST_COUNT {
            let problem = format!("the array has more than {GREATEST_COUNT} sections of lines");
            let span = root.node.key_span();
            faults.push(Fault::new(span, "array", problem, "give a part of it"));
            return;
        }
        let bearing = (platform.heading.value + line.heading.value).to_radians();
        let along = [bearing.sin(), bearing.cos()];
        let Some(at) = fairlead(&fairleads, platform, line, number, along, faults) else {
            continue;
        };
        let span = line.row.span();
        let center = platform.place.clone().map(|given| given.value);
        let anchor = [
            center[0] + at[0] + config.span.value * along[0],
            center[1] + at[1] + config.span.value * along[1],
            -depth.value,
        ];
        let ends = [anchor, at, center];
        let name = format!("{}-{}", platform.name.value, number + 1);
        add(&name, config, ends, body, &span, parts, mooring);
    }
}

/// Where a line is attached, about the platform in the directions of the earth \[m\].
fn fairlead(
    fairleads: &Fairleads,
    platform: &Platform<'_>,
    line: &SystemLine<'_>,
    number: usize,
    along: [f64; 2],
    faults: &mut Vec<Fault>,
) -> Option<[f64; 3]> {
    let (places, span) = match fairleads {
        Fairleads::Radius([radius, height]) => {
            let [x, y] = along.map(|part| part * radius.value);
            return Some([x, y, height.value]);
        }
        Fairleads::Places(places, span) => (places, span),
    };
    let wanted = line.fairlead.as_ref().map_or(number, |given| {
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "out of range is beyond the list"
        )]
        let from_one = given.value as usize;
        from_one.wrapping_sub(1)
    });
    let Some([x, y, z]) = places.get(wanted).copied() else {
        let at = line.fairlead.as_ref().map_or(span, |given| &given.span);
        let problem = format!("there is no fairlead {}", wanted.wrapping_add(1));
        let remedy = format!("the platform has {}", places.len());
        faults.push(Fault::new(
            at.clone(),
            "platforms.fairleads",
            problem,
            remedy,
        ));
        return None;
    };
    // Clockwise by the heading of the platform.
    let (sin, cos) = (-platform.heading.value).to_radians().sin_cos();
    Some([cos * x - sin * y, sin * x + cos * y, z])
}

/// Adds a line: its anchor, its fairlead, the connectors between them on a straight line, and its sections. Ends are the anchor,
/// the fairlead about the platform, and the platform \[m\].
fn add(
    name: &str,
    config: &LineConfig,
    [anchor, at, center]: [[f64; 3]; 3],
    body: usize,
    span: &std::ops::Range<usize>,
    parts: &ArrayParts,
    mooring: &mut Mooring,
) {
    let point = |id: String, hold: Hold, place: [f64; 3]| MooringPoint {
        id,
        span: span.clone(),
        hold: Given::new(hold, span.clone()),
        place: place.map(|value| Given::new(value, span.clone())),
        ..ArrayParts::no_connector(span)
    };
    let first = mooring.points.len();
    let point_name = |number: usize| format!("{name}-p{number}");
    mooring
        .points
        .push(point(point_name(0), Hold::Fixed, anchor));
    let whole: f64 = config
        .sections
        .iter()
        .map(|section| section.length.value)
        .sum();
    let mut length = 0.0;
    for (number, section) in config.sections.iter().enumerate() {
        length += section.length.value;
        let is_last = number + 1 == config.sections.len();
        if is_last {
            mooring
                .points
                .push(point(point_name(number + 1), Hold::Body(body), at));
        } else {
            let share = length / whole;
            let end = [0, 1, 2].map(|axis| center[axis] + at[axis]);
            let place = [0, 1, 2].map(|axis| anchor[axis] + share * (end[axis] - anchor[axis]));
            let free = point(point_name(number + 1), Hold::Free, place);
            mooring
                .points
                .push(parts.connector(section.connector, free));
        }
        let attached =
            |number: usize| Given::new(Attachment::Point(first + number), section.span.clone());
        mooring.lines.push(MooringLine {
            id: format!("{name}-s{}", number + 1),
            span: section.span.clone(),
            of_type: section.of_type.clone(),
            ends: [attached(number), attached(number + 1)],
            length: section.length.clone(),
            segments: Given::new(0, section.span.clone()),
            without_bed: None,
        });
    }
}

fn body_of(platform: &Platform<'_>) -> MooringBody {
    let span = platform.name.span.clone();
    let none = || Given::new(0.0, span.clone());
    MooringBody {
        id: platform.name.value.clone(),
        span: span.clone(),
        hold: Given::new(Hold::Coupled, span.clone()),
        place: platform.place.clone(),
        // Fairleads are turned, the platform is not: stiffness is along the axes of the earth.
        angles: [none(), none(), none()],
        mass: none(),
        centre: Given::new([0.0; 3], span.clone()),
        inertia: Given::new([0.0; 3], span.clone()),
        volume: none(),
        drag_area: Given::new([0.0; 6], span.clone()),
        added_mass: Given::new([0.0; 3], span.clone()),
        waterplane: Given::new([0.0; 3], span.clone()),
        loads: Vec::new(),
    }
}
