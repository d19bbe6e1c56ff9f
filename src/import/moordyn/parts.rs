//! The tables BODIES, RODS, POINTS, LINES.

use super::holds::{attachment, hold};
use super::line_types::unique;
use super::sections::Block;
use super::table::{Column, Table, TableRow};
use crate::import::fault::Fault;
use crate::import::mooring::{Body, Given, Line, Mooring, Point, Rod};

const BODY_COLUMNS: [Column; 14] = [
    ("ID", &["#", "Name", "Body"]),
    ("Attachment", &["Type"]),
    ("X0", &["X"]),
    ("Y0", &["Y"]),
    ("Z0", &["Z"]),
    ("r0", &["roll"]),
    ("p0", &["pitch"]),
    ("y0", &["yaw"]),
    ("Mass", &["M", "m"]),
    ("CG*", &["CG"]),
    ("I*", &["I"]),
    ("Volume", &["V", "Vol"]),
    ("CdA*", &["CdA"]),
    ("Ca*", &["Ca"]),
];

const ROD_COLUMNS: [Column; 11] = [
    ("ID", &["#", "Name", "Rod"]),
    ("RodType", &["Type", "TypeName"]),
    ("Attachment", &["Type"]),
    ("Xa", &[]),
    ("Ya", &[]),
    ("Za", &[]),
    ("Xb", &[]),
    ("Yb", &[]),
    ("Zb", &[]),
    ("NumSegs", &[]),
    ("RodOutputs", &["Outputs", "Flags/Outputs"]),
];

const POINT_COLUMNS: [Column; 9] = [
    ("ID", &["#", "Node", "Name", "Point"]),
    ("Attachment", &["Type"]),
    ("X", &[]),
    ("Y", &[]),
    ("Z", &[]),
    ("Mass", &["M"]),
    ("Volume", &["V", "Vol"]),
    ("CdA", &[]),
    ("Ca", &[]),
];

const LOADED_POINT_COLUMNS: [Column; 12] = [
    POINT_COLUMNS[0],
    POINT_COLUMNS[1],
    POINT_COLUMNS[2],
    POINT_COLUMNS[3],
    POINT_COLUMNS[4],
    POINT_COLUMNS[5],
    POINT_COLUMNS[6],
    ("FX", &[]),
    ("FY", &[]),
    ("FZ", &[]),
    POINT_COLUMNS[7],
    POINT_COLUMNS[8],
];

const LINE_COLUMNS: [Column; 7] = [
    ("ID", &["#", "Line", "Name"]),
    ("LineType", &["Type", "TypeName"]),
    ("AttachA", &["NodeA", "EndA", "NodeAnch", "AttachmentA"]),
    ("AttachB", &["NodeB", "EndB", "NodeFair", "AttachmentB"]),
    ("UnstrLen", &["Length", "UnstrLength"]),
    ("NumSegs", &["Segs", "NumSeg"]),
    ("LineOutputs", &["Flags/Outputs", "Outputs", "Flags"]),
];

/// Lines of the first version: length and segments before the ends.
const LINE_COLUMNS_1: [Column; 7] = [
    LINE_COLUMNS[0],
    LINE_COLUMNS[1],
    LINE_COLUMNS[4],
    LINE_COLUMNS[5],
    LINE_COLUMNS[2],
    LINE_COLUMNS[3],
    LINE_COLUMNS[6],
];

/// Reads the bodies.
pub fn read_bodies(block: &Block<'_>, mooring: &mut Mooring, faults: &mut Vec<Fault>) {
    let table = Table::of(block, &BODY_COLUMNS, 14, faults);
    let mut found = table.read(faults, |row| body(row, mooring));
    unique(&mut found, |one| (&one.id, &one.span), "body", faults);
    if mooring.turbines == 0 {
        mooring.bodies = found;
    } else if !found.is_empty() {
        faults.push(Fault::new(
            block.span.clone(),
            "BODIES",
            "the file has bodies besides the turbines of the array",
            "attach points to turbines (`Turbine1`) and leave the section out",
        ));
    }
}

fn body(row: &TableRow<'_, '_>, mooring: &Mooring) -> Result<Body, Fault> {
    Ok(Body {
        id: row.words[0].text.to_owned(),
        span: row.row.span(),
        hold: hold(row, 1, mooring)?,
        place: row.triple(2)?,
        angles: row.triple(5)?,
        mass: row.not_negative(8)?,
        centre: counts(row, 9, |numbers| match *numbers {
            [z] => Some([0.0, 0.0, z]),
            [x, y, z] => Some([x, y, z]),
            _ => None,
        })?,
        inertia: counts(row, 10, |numbers| match *numbers {
            [all] => Some([all; 3]),
            [x, y, z] => Some([x, y, z]),
            _ => None,
        })?,
        volume: row.not_negative(11)?,
        drag_area: counts(row, 12, |numbers| match *numbers {
            [all] => Some([all; 6]),
            [along, about] => Some([along, along, along, about, about, about]),
            [x, y, z] => Some([x, y, z, x, y, z]),
            [x, y, z, rx, ry, rz] => Some([x, y, z, rx, ry, rz]),
            _ => None,
        })?,
        added_mass: counts(row, 13, |numbers| match *numbers {
            [all] => Some([all; 3]),
            [x, y, z] => Some([x, y, z]),
            _ => None,
        })?,
    })
}

/// Numbers between bars, as many as there may be.
fn counts<const N: usize>(
    row: &TableRow<'_, '_>,
    column: usize,
    take: impl Fn(&[f64]) -> Option<[f64; N]>,
) -> Result<Given<[f64; N]>, Fault> {
    let given = row.bars(column)?;
    match take(&given.value) {
        Some(value) => Ok(Given::new(value, given.span)),
        None => Err(row.fault(
            column,
            format!("there are {} numbers between bars", given.value.len()),
            "give one for all directions, or one for each",
        )),
    }
}

/// Reads the rods.
pub fn read_rods(block: &Block<'_>, mooring: &mut Mooring, faults: &mut Vec<Fault>) {
    let table = Table::of(block, &ROD_COLUMNS, 10, faults);
    let mut found = table.read(faults, |row| rod(row, mooring));
    unique(&mut found, |one| (&one.id, &one.span), "rod", faults);
    mooring.rods = found;
}

fn rod(row: &TableRow<'_, '_>, mooring: &Mooring) -> Result<Rod, Fault> {
    let types: Vec<&str> = mooring
        .rod_types
        .iter()
        .map(|of| of.name.as_str())
        .collect();
    Ok(Rod {
        id: row.words[0].text.to_owned(),
        span: row.row.span(),
        of_type: type_of(row, 1, &types, "rod type")?,
        hold: hold(row, 2, mooring)?,
        ends: [row.triple(3)?, row.triple(6)?],
        segments: whole(row, 9)?,
    })
}

/// Reads the points.
pub fn read_points(block: &Block<'_>, mooring: &mut Mooring, faults: &mut Vec<Fault>) {
    let has_loads = block
        .rows
        .iter()
        .take(2)
        .any(|row| row.words().iter().any(|word| word.is("FX")));
    let (columns, required): (&[Column], _) = match has_loads {
        true => (&LOADED_POINT_COLUMNS, 12),
        false => (&POINT_COLUMNS, 9),
    };
    let table = Table::of(block, columns, required, faults);
    let mut found = table.read(faults, |row| point(row, mooring, has_loads));
    unique(&mut found, |one| (&one.id, &one.span), "point", faults);
    mooring.points = found;
}

fn point(row: &TableRow<'_, '_>, mooring: &Mooring, has_loads: bool) -> Result<Point, Fault> {
    let none = || Given::new(0.0, row.row.span());
    let (load, last) = match has_loads {
        true => (row.triple(7)?, 10),
        false => ([none(), none(), none()], 7),
    };
    Ok(Point {
        id: row.words[0].text.to_owned(),
        span: row.row.span(),
        hold: hold(row, 1, mooring)?,
        place: row.triple(2)?,
        mass: row.not_negative(5)?,
        volume: row.not_negative(6)?,
        drag_area: row.not_negative(last)?,
        added_mass: row.not_negative(last + 1)?,
        load,
    })
}

/// Reads the lines.
pub fn read_lines(block: &Block<'_>, mooring: &mut Mooring, faults: &mut Vec<Fault>) {
    let length_first = block.rows.iter().take(2).any(|row| {
        let third = row.words().get(2).copied();
        third.is_some_and(|word| word.is("UnstrLen"))
    });
    let (columns, at): (&[Column], [usize; 4]) = match length_first {
        true => (&LINE_COLUMNS_1, [4, 5, 2, 3]),
        false => (&LINE_COLUMNS, [2, 3, 4, 5]),
    };
    let table = Table::of(block, columns, 6, faults);
    let mut found = table.read(faults, |row| line(row, mooring, at));
    unique(&mut found, |one| (&one.id, &one.span), "line", faults);
    mooring.lines = found;
}

fn line(
    row: &TableRow<'_, '_>,
    mooring: &Mooring,
    [a, b, length, segments]: [usize; 4],
) -> Result<Line, Fault> {
    let types: Vec<&str> = mooring
        .line_types
        .iter()
        .map(|of| of.name.as_str())
        .collect();
    let ends = [attachment(row, a, mooring)?, attachment(row, b, mooring)?];
    if ends[0].value == ends[1].value {
        return Err(row.fault(
            b,
            "both ends of the line are attached to the same point",
            "attach its ends to two points",
        ));
    }
    let divided = whole(row, segments)?;
    if divided.value == 0 {
        return Err(row.fault(segments, "the line has no segments", "give 1 or more"));
    }
    Ok(Line {
        id: row.words[0].text.to_owned(),
        span: row.row.span(),
        of_type: type_of(row, 1, &types, "line type")?,
        ends,
        length: row.positive(length)?,
        segments: divided,
    })
}

fn whole(row: &TableRow<'_, '_>, column: usize) -> Result<Given<usize>, Fault> {
    let word = row.words[column];
    Ok(Given::new(word.whole(&row.key(column))?, word.span()))
}

/// A type by its name.
pub fn type_of(
    row: &TableRow<'_, '_>,
    column: usize,
    types: &[&str],
    what: &str,
) -> Result<Given<usize>, Fault> {
    let word = row.words[column];
    let exact = types.iter().position(|name| *name == word.text);
    let found = exact.or_else(|| {
        types
            .iter()
            .position(|name| name.eq_ignore_ascii_case(word.text))
    });
    found
        .map(|number| Given::new(number, word.span()))
        .ok_or_else(|| {
            let remedy = match types {
                [] => format!("give a table of {what}s"),
                names => format!("{what}s are {}", names.join(", ")),
            };
            row.fault(
                column,
                format!("there is no {what} `{}`", word.text),
                remedy,
            )
        })
}
