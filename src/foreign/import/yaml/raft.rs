//! Designs of RAFT: the tables `site`, `mooring`, and `array` with several floating turbines.
//!
//! What RAFT hands to MoorPy is read as MoorPy reads it (`System.parseYAML`): coordinates in the frame of the platform, which is at
//! the origin; diameters are volume-equivalent; friction of the bed is none. In an `array` each row places a mooring of its own by
//! `x_location`, `y_location` and `heading_adjust` \[deg\], about the vertical axis through its platform.

use std::collections::HashSet;
use std::path::Path;

use super::array;
use super::mapping::Mapping;
use super::system::{Dialect, Named, lines, point};
use crate::import::beside::ReferencedFile;
use crate::import::fault::Fault;
use crate::import::listing::listed;
use crate::import::moordyn::{self, files::Files};
use crate::import::mooring::{
    Damping, Given, Hold, Mass, Mooring, MooringLine, MooringLineType, MooringPoint, MooringSea,
    Program, ProgramSetting, Stiffness, Unmodelled,
};
use crate::import::words::Word;

/// Names of RAFT.
const DIALECT: Dialect = Dialect {
    points: ("points", "point"),
    hold: "type",
    mass: ["mass", "volume"],
    ends: ["endA", "endB"],
    line_type: "type",
    length: "length",
};

/// Keys of `mooring` that are read, or mean nothing at rest.
const KEYS: [&str; 14] = [
    "water_depth",
    "rho",
    "water_density",
    "file",
    "points",
    "lines",
    "line_types",
    "anchor_types",
    "rod_types",
    "currentMod",
    "moorMod",
    "tol",
    "name",
    "comments",
];

/// Keys that change the mooring, which RAFT does not read.
const REFUSED: [&str; 6] = [
    "bodies",
    "rods",
    "repeat",
    "symmetry",
    "headings",
    "bathymetry",
];

/// Keys of a line type that are read or do not act.
const TYPE_KEYS: [&str; 12] = [
    "name",
    "diameter",
    "mass_density",
    "stiffness",
    "breaking_load",
    "cost",
    "transverse_added_mass",
    "tangential_added_mass",
    "transverse_drag",
    "tangential_drag",
    "damping",
    "bending_stiffness",
];

/// The system of one `mooring` table.
#[derive(Debug, Clone)]
pub struct RaftMooring {
    /// What lines are made of.
    pub line_types: Vec<MooringLineType>,
    /// Its points, about the platform.
    pub points: Vec<MooringPoint>,
    /// Its lines.
    pub lines: Vec<MooringLine>,
}

/// Reads a design; `text` is the whole file, behind whose end the spans of a file beside it go on.
///
/// # Errors
/// All that is wrong, in the order of the file.
pub fn read(root: &Mapping<'_>, text: &str, folder: &Path) -> Result<Mooring, Vec<Fault>> {
    let mut faults = Vec::new();
    let mut mooring = Mooring::new(Program::Raft);
    mooring.title = root
        .get("name")
        .and_then(|name| name.text())
        .unwrap_or_default()
        .to_owned();
    let table = root.optional_mapping("mooring");
    sea(root, table.as_ref(), &mut mooring, &mut faults);
    if root.get("array").is_some() {
        array::read(root, text, folder, &mut mooring, &mut faults);
    } else {
        let remedy = "a design of RAFT has a table `mooring` with points, lines and line_types";
        if let Some(table) = root.mapping("mooring", remedy, &mut faults) {
            whole(&table, text, folder, &mut mooring, &mut faults);
        }
    }
    match faults.is_empty() {
        true => Ok(mooring),
        false => Err(faults),
    }
}

/// Reads a file that is the `mooring` table itself, as MoorPy reads it.
///
/// # Errors
/// All that is wrong, in the order of the file.
pub fn read_table(table: &Mapping<'_>, text: &str, folder: &Path) -> Result<Mooring, Vec<Fault>> {
    let mut faults = Vec::new();
    let mut mooring = Mooring::new(Program::Raft);
    sea(table, Some(table), &mut mooring, &mut faults);
    whole(table, text, folder, &mut mooring, &mut faults);
    match faults.is_empty() {
        true => Ok(mooring),
        false => Err(faults),
    }
}

/// The mooring of a single platform, from its table or the file that it names.
fn whole(
    table: &Mapping<'_>,
    text: &str,
    folder: &Path,
    mooring: &mut Mooring,
    faults: &mut Vec<Fault>,
) {
    if let Some(file) = table.get("file").filter(|file| file.text() != Some("")) {
        let Some(name) = file.text() else {
            let problem = format!("{} where a file is expected", file.description());
            faults.push(table.fault(&file, "file", problem, "name a file of MoorDyn"));
            return;
        };
        let at = Given::new(name.to_owned(), file.span());
        beside(&at, &table.key("file"), text, folder, mooring, faults);
        return;
    }
    let system = system(table, mooring, faults);
    mooring.line_types = system.line_types;
    mooring.points = system.points;
    mooring.lines = system.lines;
}

/// Points, lines and line types of a table.
pub fn system(table: &Mapping<'_>, mooring: &mut Mooring, faults: &mut Vec<Fault>) -> RaftMooring {
    settings(table, mooring, faults);
    let rows = table.mappings("line_types", "line type", faults);
    let path = table.key("line_types");
    let types = Named::read(&rows, "line type", &path, faults, line_type);
    let rows = table.mappings("points", "point", faults);
    let path = table.key("points");
    let points = Named::read(&rows, "point", &path, faults, |row, name, faults| {
        let place = row.place("location", faults);
        point(row, name, &DIALECT, place, faults)
    });
    let lines = lines(table, &DIALECT, &types, &points, faults);
    RaftMooring {
        line_types: types.valid(),
        points: points.valid(),
        lines,
    }
}

/// Keys of the table besides its lists.
fn settings(table: &Mapping<'_>, mooring: &mut Mooring, faults: &mut Vec<Fault>) {
    let (mut unread, mut seen) = (Vec::new(), HashSet::new());
    let mut remark = |key: String| {
        if seen.insert(key.clone()) {
            unread.push(key);
        }
    };
    for (key, node) in table.others(&KEYS) {
        if REFUSED.contains(&key) {
            let problem = format!("`{key}` of a mooring is read neither by RAFT nor here");
            let remedy = "write out points and lines, and leave it out";
            faults.push(Fault::new(node.key_span(), table.key(key), problem, remedy));
        } else {
            remark(table.key(key));
        }
    }
    for row in table
        .get("line_types")
        .and_then(|list| list.items())
        .unwrap_or_default()
    {
        for (key, _) in row.entries().unwrap_or_default() {
            if !TYPE_KEYS.contains(&key) {
                remark(table.key(&format!("line_types.{key}")));
            }
        }
    }
    if !unread.is_empty() {
        let are = if unread.len() == 1 { "is" } else { "are" };
        let unread = listed(&unread);
        let remark = format!("{unread} {are} read neither by RAFT nor here.");
        mooring.remarks.push(remark);
    }
    let Some(Some(current)) = table.optional("currentMod", faults) else {
        return;
    };
    mooring.settings.push(ProgramSetting {
        name: "currentmod".to_owned(),
        written: "currentMod".to_owned(),
        value: current.value.to_string(),
        span: current.span.clone(),
    });
    if current.value > 0.0 {
        mooring.unmodelled.push(Unmodelled {
            name: "currents",
            span: current.span,
            key: table.key("currentMod"),
            what: "currents of the load cases (currentMod)".to_owned(),
        });
    }
}

fn line_type(row: &Mapping<'_>, name: &str, faults: &mut Vec<Fault>) -> Option<MooringLineType> {
    let diameter = row.positive("diameter", faults);
    let mass = row.not_negative("mass_density", faults);
    let stiffness = row.positive("stiffness", faults);
    let common = common(row, faults);
    let (mass, stiffness) = (mass?, stiffness?);
    let common = common?;
    Some(MooringLineType {
        name: name.to_owned(),
        span: row.node.span(),
        diameter: diameter?,
        mass: Given::new(Mass::InAir(mass.value), mass.span),
        stiffness: Given::new(Stiffness::Constant(stiffness.value), stiffness.span),
        damping: common.damping,
        bending: common.bending,
        drag_normal: common.drag[0].clone(),
        drag_tangential: common.drag[1].clone(),
        added_mass_normal: common.added_mass[0].clone(),
        added_mass_tangential: common.added_mass[1].clone(),
        friction: None,
        break_load: common.break_load,
    })
}

/// What line types of both formats may have: 0 where they do not.
#[derive(Debug, Clone)]
pub struct Common {
    /// Damping \[N s\].
    pub damping: Given<Damping>,
    /// EI \[N m²\].
    pub bending: Given<f64>,
    /// Across and along the line.
    pub drag: [Given<f64>; 2],
    /// Across and along the line.
    pub added_mass: [Given<f64>; 2],
    /// \[N\].
    pub break_load: Option<Given<f64>>,
}

/// Reads what line types of both formats may have.
pub fn common(row: &Mapping<'_>, faults: &mut Vec<Fault>) -> Option<Common> {
    let damping = row.or_zero("damping", faults);
    let bending = row.or_zero("bending_stiffness", faults);
    let drag = ["transverse_drag", "tangential_drag"].map(|key| row.or_zero(key, faults));
    let added_mass =
        ["transverse_added_mass", "tangential_added_mass"].map(|key| row.or_zero(key, faults));
    // RAFT takes a breaking load of 0 where none is known.
    let break_load = row.or_zero("breaking_load", faults);
    let [Some(normal), Some(tangential)] = drag else {
        return None;
    };
    let [Some(across), Some(along)] = added_mass else {
        return None;
    };
    let damping = damping?;
    Some(Common {
        damping: Given::new(Damping::Coefficient(damping.value), damping.span),
        bending: bending?,
        drag: [normal, tangential],
        added_mass: [across, along],
        break_load: Some(break_load?).filter(|load| load.value > 0.0),
    })
}

/// Water and gravity. The mooring's own come first, as in RAFT.
fn sea(
    root: &Mapping<'_>,
    table: Option<&Mapping<'_>>,
    mooring: &mut Mooring,
    faults: &mut Vec<Fault>,
) {
    let site = root.optional_mapping("site");
    let mut of = |mapping: Option<&Mapping<'_>>, keys: &[&str]| {
        let mapping = mapping?;
        let key = keys.iter().find(|key| mapping.get(key).is_some())?;
        mapping.optional_positive(key, faults).flatten()
    };
    let site = site.as_ref();
    let depths = [of(table, &["water_depth"]), of(site, &["water_depth"])];
    let densities = [
        of(table, &["rho", "water_density"]),
        of(site, &["rho_water"]),
    ];
    let gravity = of(site, &["g"]);
    let differ = |[own, site]: &[Option<Given<f64>>; 2]| match (own, site) {
        (Some(own), Some(site)) if own.value != site.value => Some([own.value, site.value]),
        _ => None,
    };
    if let Some([own, site]) = differ(&depths) {
        mooring.remarks.push(format!(
            "The depth is {own} m in `mooring` and {site} m in `site`: lines have that of `mooring`, as in RAFT."
        ));
    }
    if let Some(density) = &densities[1]
        && densities[0].is_none()
        && density.value != super::constants::DENSITY
    {
        mooring.remarks.push(format!(
            "Lines have the density of `site`, {} kg/m3; RAFT computes them with {} where `mooring` gives none.",
            density.value,
            super::constants::DENSITY
        ));
    }
    if let Some(gravity) = &gravity
        && gravity.value != super::constants::GRAVITY
    {
        mooring.remarks.push(format!(
            "Lines have the gravity of `site`, {} m/s2; RAFT computes them with {}.",
            gravity.value,
            super::constants::GRAVITY
        ));
    }
    let first = |[own, site]: [Option<Given<f64>>; 2]| own.or(site);
    mooring.sea = MooringSea {
        gravity,
        density: first(densities),
        depth: first(depths),
        ..MooringSea::default()
    };
}

/// The mooring of a file of MoorDyn or MoorPy that a design names. What bodies the mooring has already, its points may be on.
pub fn beside(
    name: &Given<String>,
    key: &str,
    text: &str,
    folder: &Path,
    mooring: &mut Mooring,
    faults: &mut Vec<Fault>,
) {
    let word = Word {
        text: &name.value,
        start: name.span.start,
    };
    let found = match (Files { folder }).text(word, key) {
        Ok(found) => found,
        Err(fault) => {
            faults.push(fault);
            return;
        }
    };
    let start = text.len();
    let empty = Mooring {
        bodies: mooring.bodies.clone(),
        turbines: mooring.turbines,
        ..Mooring::new(Program::MoorDyn)
    };
    let beside = ReferencedFile {
        name: name.value.clone(),
        named_at: name.span.clone(),
        start,
        text: found,
    };
    match moordyn::read_into(empty, &beside.text, start, folder) {
        Ok(read) => take(read, mooring),
        Err(found) => faults.extend(found.iter().map(|fault| beside.at_its_name(fault, key))),
    }
    mooring.beside = Some(beside);
}

/// Takes what a file beside the design has; the design's water and gravity stay where the file has none.
fn take(read: Mooring, mooring: &mut Mooring) {
    let mut sea = read.sea.clone();
    sea.gravity = sea.gravity.or_else(|| mooring.sea.gravity.clone());
    sea.density = sea.density.or_else(|| mooring.sea.density.clone());
    sea.depth = sea.depth.or_else(|| mooring.sea.depth.clone());
    let mut remarks = std::mem::take(&mut mooring.remarks);
    remarks.extend(read.remarks.iter().cloned());
    let title = std::mem::take(&mut mooring.title);
    *mooring = Mooring {
        program: Program::Raft,
        title,
        sea,
        remarks,
        turbines: mooring.turbines,
        ..read
    };
}

/// Whether a point is on the platform.
#[must_use]
pub fn is_on_platform(point: &MooringPoint) -> bool {
    point.hold.value == Hold::Coupled
}
