//! The tables BODIES, RODS, POINTS, LINES.

use super::holds::{Ends, attachment, hold, idle_numbers, turbine};
use super::line_types::unique;
use super::sections::{SectionBlock, SectionTitle};
use super::table::{HeaderColumn, SectionTable, TableRow, is_named};
use crate::import::fault::Fault;
use crate::import::index::{Index, TypeIndex};
use crate::import::listing::listed;
use crate::import::mooring::{Given, Hold, Mooring, MooringBody, MooringLine, MooringPoint, Rod};
use crate::import::words::Word;

const BODY_COLUMNS: [HeaderColumn; 14] = [
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

const ROD_COLUMNS: [HeaderColumn; 11] = [
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

/// Columns of a point.
pub const POINT_COLUMNS: [HeaderColumn; 9] = [
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

const LOADED_POINT_COLUMNS: [HeaderColumn; 12] = [
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

/// Columns of a line.
pub const LINE_COLUMNS: [HeaderColumn; 7] = [
    ("ID", &["#", "Line", "Name"]),
    ("LineType", &["Type", "TypeName"]),
    ("AttachA", &["NodeA", "EndA", "NodeAnch", "AttachmentA"]),
    ("AttachB", &["NodeB", "EndB", "NodeFair", "AttachmentB"]),
    ("UnstrLen", &["Length", "UnstrLength"]),
    ("NumSegs", &["Segs", "NumSeg", NODES]),
    ("LineOutputs", &["Flags/Outputs", "Outputs", "Flags"]),
];

/// The column of the outputs of a line.
const OUTPUT_FLAGS: usize = 6;

/// The older name of the column for segments in the first version, which reads it as their number.
const NODES: &str = "NumNodes";

/// Lines of the first version: length and segments before the ends.
const LINE_COLUMNS_1: [HeaderColumn; 7] = [
    LINE_COLUMNS[0],
    LINE_COLUMNS[1],
    LINE_COLUMNS[4],
    LINE_COLUMNS[5],
    LINE_COLUMNS[2],
    LINE_COLUMNS[3],
    LINE_COLUMNS[6],
];

/// Reads the bodies.
pub fn read_bodies(block: &SectionBlock<'_>, mooring: &mut Mooring, faults: &mut Vec<Fault>) {
    let table = SectionTable::of_block(block, &BODY_COLUMNS, 14, faults);
    let none = Index::default();
    let mut found = table.read(faults, |row| body(row, (mooring, &none)));
    mooring.remarks.extend(idle_numbers(table.words(1)));
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

fn body(row: &TableRow<'_, '_>, on: (&Mooring, &Index)) -> Result<MooringBody, Fault> {
    Ok(MooringBody {
        id: row.words[0].text.to_owned(),
        span: row.row.span(),
        hold: hold(row, 1, on)?,
        place: row.triple(2)?,
        angles: row.triple(5)?,
        mass: row.not_negative(8)?,
        centre: counts(
            row,
            9,
            "one number for the height, or three",
            |numbers| match *numbers {
                [z] => Some([0.0, 0.0, z]),
                [x, y, z] => Some([x, y, z]),
                _ => None,
            },
        )?,
        inertia: counts(
            row,
            10,
            "one number for all axes, or three",
            |numbers| match *numbers {
                [all] => Some([all; 3]),
                [x, y, z] => Some([x, y, z]),
                _ => None,
            },
        )?,
        volume: row.not_negative(11)?,
        drag_area: counts(
            row,
            12,
            "one number, two for directions and turns, three for axes, or six",
            |numbers| match *numbers {
                [all] => Some([all; 6]),
                [along, about] => Some([along, along, along, about, about, about]),
                [x, y, z] => Some([x, y, z, x, y, z]),
                [x, y, z, rx, ry, rz] => Some([x, y, z, rx, ry, rz]),
                _ => None,
            },
        )?,
        added_mass: counts(
            row,
            13,
            "one number for all directions, or three",
            |numbers| match *numbers {
                [all] => Some([all; 3]),
                [x, y, z] => Some([x, y, z]),
                _ => None,
            },
        )?,
        waterplane: Given::new([0.0; 3], row.row.span()),
        loads: Vec::new(),
    })
}

/// Numbers between bars, as many as there may be.
fn counts<const N: usize>(
    row: &TableRow<'_, '_>,
    column: usize,
    counts: &str,
    take: impl Fn(&[f64]) -> Option<[f64; N]>,
) -> Result<Given<[f64; N]>, Fault> {
    let given = row.bars(column)?;
    match take(&given.value) {
        Some(value) => Ok(Given::new(value, given.span)),
        None => Err(row.fault(
            column,
            format!("there are {} numbers between bars", given.value.len()),
            format!("give {counts}"),
        )),
    }
}

/// Reads the rods.
pub fn read_rods(block: &SectionBlock<'_>, mooring: &mut Mooring, faults: &mut Vec<Fault>) {
    let table = SectionTable::of_block(block, &ROD_COLUMNS, 10, faults);
    let bodies = bodies_of(mooring);
    let types = TypeIndex::of_names(mooring.rod_types.iter().map(|of| of.name.as_str()));
    let mut found = table.read(faults, |row| rod(row, (mooring, &bodies), &types));
    mooring.remarks.extend(idle_numbers(table.words(2)));
    unique(&mut found, |one| (&one.id, &one.span), "rod", faults);
    mooring.rods = found;
}

fn bodies_of(mooring: &Mooring) -> Index {
    Index::of_identifiers(mooring.bodies.iter().map(|body| body.id.as_str()))
}

fn rod(
    row: &TableRow<'_, '_>,
    on: (&Mooring, &Index),
    types: &TypeIndex<'_>,
) -> Result<Rod, Fault> {
    Ok(Rod {
        id: row.words[0].text.to_owned(),
        span: row.row.span(),
        of_type: type_of(row, 1, types, SectionTitle::RodTypes)?,
        hold: hold(row, 2, on)?,
        ends: [row.triple(3)?, row.triple(6)?],
        segments: whole(row, 9)?,
        loads: Vec::new(),
    })
}

/// Reads the points.
pub fn read_points(block: &SectionBlock<'_>, mooring: &mut Mooring, faults: &mut Vec<Fault>) {
    let has_loads = block
        .rows
        .iter()
        .take(2)
        .any(|row| row.words().iter().any(|word| word.is("FX")));
    let (columns, required): (&[HeaderColumn], _) = match has_loads {
        true => (&LOADED_POINT_COLUMNS, 12),
        false => (&POINT_COLUMNS, 9),
    };
    let table = SectionTable::of_block(block, columns, required, faults);
    let mut turbines: Vec<String> = Vec::new();
    let bodies = bodies_of(mooring);
    let mut found = table.read(faults, |row| {
        one_turbine(row, mooring, &mut turbines)?;
        point(row, (mooring, &bodies), has_loads)
    });
    mooring.remarks.extend(idle_numbers(table.words(1)));
    unique(&mut found, |one| (&one.id, &one.span), "point", faults);
    mooring.points = found;
}

fn point(
    row: &TableRow<'_, '_>,
    on: (&Mooring, &Index),
    has_loads: bool,
) -> Result<MooringPoint, Fault> {
    let numbers = row.words.iter().skip(2).map_while(Word::number).count();
    if !has_loads && numbers >= 10 {
        return Err(row.fault(
            7,
            format!("the row has {} columns where the header names {}", 2 + numbers, POINT_COLUMNS.len()),
            "name FX FY FZ in the header, as which MoorDyn takes the columns behind Volume in rows of 12",
        ));
    }
    let none = || Given::new(0.0, row.row.span());
    let (load, last) = match has_loads {
        true => (row.triple(7)?, 10),
        false => ([none(), none(), none()], 7),
    };
    Ok(MooringPoint {
        id: row.words[0].text.to_owned(),
        span: row.row.span(),
        hold: hold_of_point(row, on)?,
        place: row.triple(2)?,
        mass: row.not_negative(5)?,
        volume: row.not_negative(6)?,
        drag_area: row.not_negative(last)?,
        added_mass: row.not_negative(last + 1)?,
        load,
    })
}

/// Refuses points of a second turbine where no array says the places of the turbines: those of the points are about them.
///
/// # Errors
/// The point is of another turbine than those before.
pub fn one_turbine(
    row: &TableRow<'_, '_>,
    mooring: &Mooring,
    seen: &mut Vec<String>,
) -> Result<(), Fault> {
    let word = row.words[1].text.to_lowercase();
    let Some(number) = turbine(&word).filter(|_| mooring.turbines == 0) else {
        return Ok(());
    };
    match seen.first() {
        None => seen.push(number.to_owned()),
        Some(first) if first != number => {
            return Err(row.fault(
                1,
                format!("points of turbine {first} are about that turbine, those of turbine {number} about another: where the turbines are is not in this file"),
                "give the array in a RAFT design that names this file as array_mooring, or the points as Body1, Body2 of a table BODIES",
            ));
        }
        Some(_) => {}
    }
    Ok(())
}

/// What holds a point, which has no directions that could be free: on a body it is there, and else it is not pinned.
fn hold_of_point(row: &TableRow<'_, '_>, on: (&Mooring, &Index)) -> Result<Given<Hold>, Fault> {
    let given = hold(row, 1, on)?;
    match given.value {
        Hold::Pinned(held) if matches!(*held, Hold::Body(_)) => Ok(Given::new(*held, given.span)),
        Hold::Pinned(_) => Err(row.fault(
            1,
            "a point cannot be pinned: it has no directions",
            "write Fixed, Free, Coupled, or Body with the number of a body",
        )),
        _ => Ok(given),
    }
}

/// Reads the lines.
pub fn read_lines(block: &SectionBlock<'_>, mooring: &mut Mooring, faults: &mut Vec<Fault>) {
    let length_first = block.rows.iter().take(2).any(|row| {
        let third = row.words().get(2).copied();
        third.is_some_and(|word| is_named(&LINE_COLUMNS[4], word.text))
    });
    let (columns, at): (&[HeaderColumn], [usize; 4]) = match length_first {
        true => (&LINE_COLUMNS_1, [4, 5, 2, 3]),
        false => (&LINE_COLUMNS, [2, 3, 4, 5]),
    };
    let table = SectionTable::of_block(block, columns, 6, faults);
    let types = TypeIndex::of_names(mooring.line_types.iter().map(|of| of.name.as_str()));
    let to = Ends::of_mooring(mooring);
    let mut found = table.read(faults, |row| line(row, (&to, &types), at));
    let asks = |word: Word<'_>| word.text != "-" && word.text != "0";
    if table.words(OUTPUT_FLAGS).any(asks) {
        mooring
            .passed_over
            .push("the flags of outputs of lines".to_owned());
    }
    mooring.remarks.extend(numbers_of_nodes(block));
    unique(&mut found, |one| (&one.id, &one.span), "line", faults);
    mooring.lines = found;
}

/// What is said where the header names nodes for segments.
fn numbers_of_nodes(block: &SectionBlock<'_>) -> Option<String> {
    let mut rows = block.rows.iter().take(2);
    let is_named = rows.any(|row| row.words().iter().any(|word| word.is(NODES)));
    is_named.then(|| {
        "NumNodes is the number of segments, as which the first version of MoorDyn reads it."
            .to_owned()
    })
}

/// A line by a row whose ends, length and segments are in these columns.
///
/// # Errors
/// What is wrong with the row.
pub fn line(
    row: &TableRow<'_, '_>,
    (to, types): (&Ends, &TypeIndex<'_>),
    [a, b, length, segments]: [usize; 4],
) -> Result<MooringLine, Fault> {
    let ends = [attachment(row, a, to)?, attachment(row, b, to)?];
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
    Ok(MooringLine {
        id: row.words[0].text.to_owned(),
        span: row.row.span(),
        of_type: type_of(row, 1, types, SectionTitle::LineTypes)?,
        ends,
        length: row.positive(length)?,
        segments: divided,
        without_bed: None,
    })
}

/// The whole number in a column.
///
/// # Errors
/// It is none.
pub fn whole(row: &TableRow<'_, '_>, column: usize) -> Result<Given<usize>, Fault> {
    let word = row.words[column];
    Ok(Given::new(word.whole(&row.key(column))?, word.span()))
}

/// A type by its name.
///
/// # Errors
/// There is none of this name.
pub fn type_of(
    row: &TableRow<'_, '_>,
    column: usize,
    types: &TypeIndex<'_>,
    section: SectionTitle,
) -> Result<Given<usize>, Fault> {
    let word = row.words[column];
    types
        .find(word.text)
        .map(|number| Given::new(number, word.span()))
        .ok_or_else(|| {
            let what = section.of_one();
            let remedy = match types.names() {
                [] => format!("give a table of {what}s"),
                names => format!("{what}s are {}", listed(names)),
            };
            let problem = format!("there is no {what} `{}`", word.text);
            Fault {
                refers_to: Some(Box::new((section.title(), word.text.to_owned()))),
                ..row.fault(column, problem, remedy)
            }
        })
}
