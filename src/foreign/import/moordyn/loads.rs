//! The table EXTERNAL LOADS of `MoorDyn` in OpenFAST (and of `CableDyn`): steady loads and damping of points, bodies and rods.
//!
//! As in source `modules/moordyn/src/MoorDyn.f90`: the force on a point is along the axes of the earth, that on a body by `CSys` along those
//! of the earth (`G`) or of the body (`L`), at its origin, that on a rod along the axes of the earth at its end A; damping is along the same axes,
//! of a rod across it and along it, of the velocity over ground. One number of a damping is that along all axes.

use super::holds::{missing, point_number};
use super::sections::{SectionBlock, SectionTitle};
use super::table::{HeaderColumn, SectionTable, TableRow};
use crate::import::fault::Fault;
use crate::import::index::Index;
use crate::import::mooring::{BodyLoad, Given, Hold, Mooring, Unmodelled};

const COLUMNS: [HeaderColumn; 6] = [
    ("ID", &["#", "LoadID"]),
    ("Object", &["Name", "Attachment"]),
    ("Fext", &["F", "Force"]),
    ("Blin", &["B"]),
    ("Bquad", &["B2"]),
    ("CSys", &["CoordSys"]),
];

/// Where a row has its columns: as `MoorDyn` has them, or with the axes before the numbers.
const AXES_LAST: [usize; 4] = [2, 3, 4, 5];
/// See [`AXES_LAST`].
const AXES_FIRST: [usize; 4] = [3, 4, 5, 2];

/// What a row is about.
enum Object {
    Point(usize),
    Body(usize),
    Rod(usize),
}

/// Identifiers of what rows may be about.
struct Objects {
    points: Index,
    bodies: Index,
    rods: Index,
}

/// Reads the loads onto the points and bodies that were read before.
pub fn read(block: &SectionBlock<'_>, mooring: &mut Mooring, faults: &mut Vec<Fault>) {
    let objects = Objects {
        points: Index::of_identifiers(mooring.points.iter().map(|point| point.id.as_str())),
        bodies: Index::of_identifiers(mooring.bodies.iter().map(|body| body.id.as_str())),
        rods: Index::of_identifiers(mooring.rods.iter().map(|rod| rod.id.as_str())),
    };
    let table = SectionTable::of_block(block, &COLUMNS, COLUMNS.len(), faults);
    let found = table.read(faults, |row| load(row, &objects));
    for (object, load) in found {
        match object {
            Object::Point(point) => on_point(mooring, point, &load),
            Object::Body(body) => mooring.bodies[body].loads.push(load),
            Object::Rod(rod) => mooring.rods[rod].loads.push(load),
        }
    }
}

fn load(row: &TableRow<'_, '_>, objects: &Objects) -> Result<(Object, BodyLoad), Fault> {
    let first = row.words[2];
    let [force, linear, quadratic, axes] = match ["G", "L", "-"].iter().any(|one| first.is(one)) {
        true => AXES_FIRST,
        false => AXES_LAST,
    };
    let object = object(row, objects)?;
    let is_local = match (&object, row.words[axes]) {
        (Object::Body(_), word) if word.is("G") => false,
        (Object::Body(_), word) if word.is("L") => true,
        (Object::Body(_), word) => {
            let problem = format!(
                "`{}` does not say along which axes a body is loaded",
                word.text
            );
            let remedy = "write G for those of the earth, L for those of the body";
            return Err(row.fault(axes, problem, remedy));
        }
        _ => false,
    };
    let damping = |column: usize| -> Result<Given<[f64; 3]>, Fault> {
        let given = triple(row, column, &object, true)?;
        match given.value.iter().any(|value| *value < 0.0) {
            true => Err(row.fault(column, "a damping is negative", "give 0 or more")),
            false => Ok(given),
        }
    };
    let load = BodyLoad {
        span: row.row.span(),
        force: triple(row, force, &object, false)?,
        linear: damping(linear)?,
        quadratic: damping(quadratic)?,
        is_local,
    };
    Ok((object, load))
}

/// What a row is about, by a word such as `Point2`, `P2`, `Body1`.
fn object(row: &TableRow<'_, '_>, objects: &Objects) -> Result<Object, Fault> {
    let lower = row.words[1].text.to_lowercase();
    let (section, number, found) = if let Some(number) = lower.strip_prefix("body") {
        let body = objects.bodies.find(number).map(Object::Body);
        (SectionTitle::Bodies, number, body)
    } else if let Some(number) = lower.strip_prefix("rod").or(lower.strip_prefix('r')) {
        let rod = objects.rods.find(number).map(Object::Rod);
        (SectionTitle::Rods, number, rod)
    } else if lower.starts_with('p') {
        let number = point_number(&lower);
        let point = objects.points.find(number).map(Object::Point);
        (SectionTitle::Points, number, point)
    } else {
        let problem = format!("`{}` is no point, rod or body", row.words[1].text);
        return Err(row.fault(1, problem, "write Point, Rod or Body with its number"));
    };
    found.ok_or_else(|| missing(row, 1, section, number))
}

/// Three numbers between bars; of a damping one that counts along all axes, of a rod two, across and along it; of a force one that is 0.
fn triple(
    row: &TableRow<'_, '_>,
    column: usize,
    object: &Object,
    is_damping: bool,
) -> Result<Given<[f64; 3]>, Fault> {
    let given = row.bars(column)?;
    let value = match *given.value.as_slice() {
        [all] if is_damping || all == 0.0 => Some([all; 3]),
        [across, along] if is_damping && matches!(object, Object::Rod(_)) => {
            Some([across, along, 0.0])
        }
        [x, y, z] => Some([x, y, z]),
        _ => None,
    };
    let value = value.ok_or_else(|| {
        let remedy = match is_damping {
            true => "give one number for all axes, or three",
            false => "give 0, or three numbers: along x, y and z",
        };
        let problem = format!("`{}` is not read so", row.words[column].text);
        row.fault(column, problem, remedy)
    })?;
    Ok(Given::new(value, given.span))
}

/// Adds a load to that of a point; damping of a point has no key.
fn on_point(mooring: &mut Mooring, number: usize, load: &BodyLoad) {
    let point = &mut mooring.points[number];
    for (axis, force) in load.force.value.into_iter().enumerate() {
        point.load[axis].value += force;
        point.load[axis].span = load.force.span.clone();
    }
    let is_free = matches!(point.hold.value, Hold::Free | Hold::Body(_));
    let dampings = [&load.linear, &load.quadratic].into_iter();
    let acts = |damping: &&Given<[f64; 3]>| damping.value != [0.0; 3] && is_free;
    mooring
        .unmodelled
        .extend(dampings.filter(acts).map(|damping| Unmodelled {
            name: "loads",
            span: damping.span.clone(),
            key: "EXTERNAL LOADS, Blin Bquad".to_owned(),
            what: "damping of a point over ground".to_owned(),
        }));
}
