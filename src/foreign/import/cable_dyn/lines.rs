//! The tables POINTS, LINES and SECTIONS.

use std::collections::HashMap;

use super::bodies;
use crate::import::fault::Fault;
use crate::import::index::{Index, TypeIndex};
use crate::import::moordyn::holds::{Ends, attachment, hold, missing};
use crate::import::moordyn::line_types::unique;
use crate::import::moordyn::parts::{
    LINE_COLUMNS, POINT_COLUMNS, line, one_turbine, type_of, whole,
};
use crate::import::moordyn::sections::{SectionBlock, SectionTitle};
use crate::import::moordyn::table::{HeaderColumn, SectionTable, TableRow};
use crate::import::mooring::{Attachment, Given, Hold, Mooring, MooringLine, MooringPoint};
use crate::import::words::Row;

/// Columns of a point without masses.
const PLAIN_POINT: usize = 5;

/// Columns of a line whose sections are in a table of their own.
const SHORT_LINE: [HeaderColumn; 4] = [
    LINE_COLUMNS[0],
    ("NodeA", &["AttachA", "EndA"]),
    ("NodeB", &["AttachB", "EndB"]),
    ("Outputs", &["LineOutputs", "Flags"]),
];

/// Columns of a row of a short table of lines.
const SHORT_NEEDED: usize = 3;

const SECTION_COLUMNS: [HeaderColumn; 4] = [
    ("LineID", &["ID", "Line"]),
    ("LineType", &["Type", "TypeName"]),
    ("Length", &["UnstrLen"]),
    ("NumSegs", &["Segs", "NumSeg"]),
];

/// Points that are ends of rods, by their places in the list.
pub type AtRods = HashMap<usize, Attachment>;

/// Reads the points, and which of them are ends of rods.
pub fn read_points(
    block: &SectionBlock<'_>,
    mooring: &mut Mooring,
    faults: &mut Vec<Fault>,
) -> AtRods {
    let table = SectionTable::of_block(block, &POINT_COLUMNS, PLAIN_POINT, faults);
    let on_bodies = bodies::index(mooring);
    let ends = Ends::of_mooring(mooring);
    let mut turbines = Vec::new();
    let mut found = table.read(faults, |row| {
        one_turbine(row, mooring, &mut turbines)?;
        let at_rod = end_of_rod(row, &ends)?;
        let hold = match at_rod {
            Some(_) => Given::new(Hold::Fixed, row.words[1].span()),
            None => hold(row, 1, (mooring, &on_bodies))?,
        };
        Ok((point(row, hold)?, at_rod))
    });
    unique(&mut found, |(one, _)| (&one.id, &one.span), "point", faults);
    let mut at_rods = AtRods::new();
    for (number, (point, at_rod)) in found.into_iter().enumerate() {
        mooring.points.push(point);
        at_rods.extend(at_rod.map(|at| (number, at)));
    }
    at_rods
}

/// The end of a rod that a point is, by a word such as `Rod2A`.
fn end_of_rod(row: &TableRow<'_, '_>, ends: &Ends) -> Result<Option<Attachment>, Fault> {
    let lower = row.words[1].text.to_lowercase();
    match lower.starts_with("rod") {
        true => Ok(Some(attachment(row, 1, ends)?.value)),
        false => Ok(None),
    }
}

fn point(row: &TableRow<'_, '_>, hold: Given<Hold>) -> Result<MooringPoint, Fault> {
    let none = || Given::new(0.0, row.row.span());
    let optional = |column: usize| match row.words.get(column) {
        Some(_) => row.not_negative(column),
        None => Ok(none()),
    };
    Ok(MooringPoint {
        id: row.words[0].text.to_owned(),
        span: row.row.span(),
        hold,
        place: row.triple(2)?,
        mass: optional(5)?,
        volume: optional(6)?,
        drag_area: optional(7)?,
        added_mass: optional(8)?,
        load: [none(), none(), none()],
    })
}

/// Attaches lines that end at points that are ends of rods to these.
pub fn on_rods(mooring: &mut Mooring, at_rods: &AtRods) {
    for end in mooring.lines.iter_mut().flat_map(|line| &mut line.ends) {
        if let Attachment::Point(point) = end.value
            && let Some(at) = at_rods.get(&point)
        {
            end.value = *at;
        }
    }
}

/// A section of a line.
struct LineSection {
    of_type: Given<usize>,
    length: Given<f64>,
    segments: Given<usize>,
}

/// A row of the table of lines.
enum LineRow {
    /// With its type, length and segments.
    Whole(MooringLine),
    /// Its identifier, its row and what it is between.
    Short(Given<String>, [Given<Attachment>; 2]),
}

/// Reads the lines with their sections; each section is a line of the mooring that is joined to the next inside its line.
pub fn read_lines(
    block: &SectionBlock<'_>,
    sections: Option<&SectionBlock<'_>>,
    mooring: &mut Mooring,
    faults: &mut Vec<Fault>,
) {
    let mut rows = block.rows.iter().filter(|row| !row.is_blank());
    let header = rows.next().map(Row::words).unwrap_or_default();
    let is_short = !header.iter().any(|word| word.is("LineType"));
    let table = match is_short {
        true => SectionTable::of_block(block, &SHORT_LINE, SHORT_NEEDED, faults),
        false => SectionTable::of_block(block, &LINE_COLUMNS, SHORT_NEEDED, faults),
    };
    let types = TypeIndex::of_names(mooring.line_types.iter().map(|of| of.name.as_str()));
    let to = Ends::of_mooring(mooring);
    let found = table.read(faults, |row| line_row(row, (&to, &types)));
    let mut named: Vec<(Given<String>, LineRow)> =
        found.into_iter().map(|row| (id(&row), row)).collect();
    unique(&mut named, |(id, _)| (&id.value, &id.span), "line", faults);
    let index = Index::of_identifiers(named.iter().map(|(id, _)| id.value.as_str()));
    let mut pieces: Vec<Vec<LineSection>> = named.iter().map(|_| Vec::new()).collect();
    if let Some(block) = sections {
        let table = SectionTable::of_block(block, &SECTION_COLUMNS, SECTION_COLUMNS.len(), faults);
        for (line, piece) in table.read(faults, |row| piece(row, (&index, &types))) {
            pieces[line].push(piece);
        }
    }
    let mut lines = Vec::new();
    for ((id, row), pieces) in named.into_iter().zip(pieces) {
        match (row, pieces.is_empty()) {
            (LineRow::Whole(line), true) => lines.push(line),
            (LineRow::Short(_, ends), false) => put(&mut lines, &id, ends, pieces),
            (LineRow::Whole(_), false) => faults.push(Fault::new(
                id.span,
                "LINES",
                format!(
                    "line {} has a type and a length, and sections besides",
                    id.value
                ),
                "leave its rows of SECTIONS out, or its columns behind the ends",
            )),
            (LineRow::Short(..), true) => faults.push(Fault::new(
                id.span,
                "LINES",
                format!("line {} has no sections", id.value),
                "give one row of SECTIONS at least with its LineID",
            )),
        }
    }
    mooring.lines = lines;
}

fn id(row: &LineRow) -> Given<String> {
    match row {
        LineRow::Whole(line) => Given::new(line.id.clone(), line.span.clone()),
        LineRow::Short(id, _) => id.clone(),
    }
}

fn line_row(
    row: &TableRow<'_, '_>,
    (to, types): (&Ends, &TypeIndex<'_>),
) -> Result<LineRow, Fault> {
    if row.words.len() > SHORT_LINE.len() {
        return line(row, (to, types), [2, 3, 4, 5]).map(LineRow::Whole);
    }
    let ends = [attachment(row, 1, to)?, attachment(row, 2, to)?];
    if ends[0].value == ends[1].value {
        let problem = "both ends of the line are attached to the same point";
        return Err(row.fault(2, problem, "attach its ends to two points"));
    }
    let id = Given::new(row.words[0].text.to_owned(), row.row.span());
    Ok(LineRow::Short(id, ends))
}

fn piece(
    row: &TableRow<'_, '_>,
    (lines, types): (&Index, &TypeIndex<'_>),
) -> Result<(usize, LineSection), Fault> {
    let number = row.words[0].text;
    let line = lines.find(number);
    let line = line.ok_or_else(|| missing(row, 0, SectionTitle::Lines, number))?;
    let segments = whole(row, 3)?;
    if segments.value == 0 {
        return Err(row.fault(3, "the section has no segments", "give 1 or more"));
    }
    let piece = LineSection {
        of_type: type_of(row, 1, types, SectionTitle::LineTypes)?,
        length: row.positive(2)?,
        segments,
    };
    Ok((line, piece))
}

/// Puts a line down as its sections, from its end A to its end B.
fn put(
    lines: &mut Vec<MooringLine>,
    id: &Given<String>,
    [a, b]: [Given<Attachment>; 2],
    pieces: Vec<LineSection>,
) {
    let last = pieces.len() - 1;
    let mut from = a;
    for (number, piece) in pieces.into_iter().enumerate() {
        let span = piece.length.span.clone();
        let to = match number == last {
            true => b.clone(),
            false => Given::new(Attachment::Inside(lines.len()), span),
        };
        lines.push(MooringLine {
            id: id.value.clone(),
            span: id.span.clone(),
            of_type: piece.of_type,
            ends: [from, to.clone()],
            length: piece.length,
            segments: piece.segments,
            without_bed: None,
        });
        from = to;
    }
}
