//! Input files of MAP++: line dictionary, nodes, lines, options.
//!
//! Gravity, density and depth come from the program that calls MAP++ and are asked for. A number behind `#` is one that MAP++ solves for:
//! here it is where the search begins. `repeat` copies all lines about the vertical axis through the origin.

pub mod flags;
pub mod options;

use self::flags::Flags;
use super::fault::{Fault, without_followers};
use super::index::{Index, TypeIndex};
use super::listing::listed;
use super::moordyn::holds::missing;
use super::moordyn::line_types::unique;
use super::moordyn::parts::type_of;
use super::moordyn::sections::{SectionBlock, SectionTitle, Sections};
use super::moordyn::table::{HeaderColumn, SectionTable, TableRow};
use super::mooring::{
    Attachment, Damping, Given, Hold, Mass, Mooring, MooringLine, MooringLineType, MooringPoint,
    Program, Stiffness,
};
use super::words::{Row, Word};

const TYPE_COLUMNS: [HeaderColumn; 9] = [
    ("LineType", &["Name", "TypeName"]),
    ("Diam", &["Diameter"]),
    ("MassDenInAir", &["MassDen", "Mass/m", "MassDensityInAir"]),
    ("EA", &["AxialStiffness"]),
    ("CB", &["CableFriction"]),
    ("CIntDamp", &["IntDamp", "c_int"]),
    ("Ca", &[]),
    ("Cdn", &[]),
    ("Cdt", &[]),
];

const NODE_COLUMNS: [HeaderColumn; 10] = [
    ("Node", &["ID"]),
    ("Type", &[]),
    ("X", &[]),
    ("Y", &[]),
    ("Z", &[]),
    ("M", &["Mass"]),
    ("B", &["V", "Volume"]),
    ("FX", &[]),
    ("FY", &[]),
    ("FZ", &[]),
];

const LINE_COLUMNS: [HeaderColumn; 6] = [
    ("Line", &["ID"]),
    ("LineType", &["Type"]),
    ("UnstrLen", &["Length", "UnstretchedLength"]),
    ("NodeAnch", &["NodeA"]),
    ("NodeFair", &["NodeB"]),
    ("Flags", &[]),
];

/// Words of headers that MAP++ has and MoorDyn has not, and the other way round.
const OWN_WORDS: [&str; 1] = ["CB"];
/// See [`OWN_WORDS`].
const MOORDYN_WORDS: [&str; 16] = [
    "EI",
    "BA",
    "BA/-zeta",
    "BA/-z",
    "Can",
    "Cat",
    "Cd",
    "CdAx",
    "CaAx",
    "NumSegs",
    "NumSeg",
    "Segs",
    "NumNodes",
    "Cd_n",
    "Ca_n",
    "LineOutputs",
];

/// Whether the sections are those of MAP++: more words of their headers are those of MAP++ alone than of MoorDyn alone. A table of lines
/// without a column of segments is one of MAP++.
#[must_use]
pub fn is_map(sections: &Sections<'_>) -> bool {
    let words = |section| {
        let rows = sections
            .block(section)
            .into_iter()
            .flat_map(|block| &block.rows);
        let header = rows.map(Row::words_with_marks);
        header.take(2).flatten().collect::<Vec<Word<'_>>>()
    };
    let (types, lines) = (words(SectionTitle::LineTypes), words(SectionTitle::Lines));
    let count = |names: &[&str]| {
        let all = types.iter().chain(&lines);
        all.filter(|word| names.iter().any(|name| word.is(name)))
            .count()
    };
    let has = |name: &str| lines.iter().any(|word| word.is(name));
    let is_undivided = has("UnstrLen") && has("NodeAnch") && !has("NumSegs") && !has("NumNodes");
    count(&OWN_WORDS) + usize::from(is_undivided) > count(&MOORDYN_WORDS)
}

/// Columns of a line type that MAP++ needs.
const NEEDED: usize = 5;

/// Reads a file that was cut into sections.
///
/// # Errors
/// All that is wrong, in the order of the file.
pub fn read(sections: &Sections<'_>) -> Result<Mooring, Vec<Fault>> {
    let mut faults = sections.faults.clone();
    let mut mooring = Mooring::new(Program::MapPlusPlus);
    let mut block = |section: SectionTitle,
                     read: &mut dyn FnMut(&SectionBlock<'_>, &mut Vec<Fault>)| {
        match sections.block(section) {
            Some(block) => read(block, &mut faults),
            None => faults.push(Fault::new(
                0..0,
                section.title(),
                format!("there is no section {}", section.title()),
                "a MAP++ file has LINE DICTIONARY, NODE PROPERTIES and LINE PROPERTIES",
            )),
        }
    };
    block(SectionTitle::LineTypes, &mut |rows, faults| {
        line_types(rows, &mut mooring, faults);
    });
    block(SectionTitle::Points, &mut |rows, faults| {
        nodes(rows, &mut mooring, faults);
    });
    block(SectionTitle::Lines, &mut |rows, faults| {
        lines(rows, &mut mooring, faults);
    });
    if let Some(rows) = sections.block(SectionTitle::Options) {
        options::read(rows, &mut mooring, &mut faults);
    }
    if faults.is_empty() {
        return Ok(mooring);
    }
    without_followers(&mut faults);
    faults.sort_by_key(|fault| fault.span.start);
    Err(faults)
}

fn line_types(block: &SectionBlock<'_>, mooring: &mut Mooring, faults: &mut Vec<Fault>) {
    let table = SectionTable::of_block(block, &TYPE_COLUMNS, NEEDED, faults);
    let mut unused = Vec::new();
    let mut found = table.read(faults, |row| {
        let mass = row.not_negative(2)?;
        let stiffness = row.positive(3)?;
        let mut in_motion = |column| of_motion(row, column, &mut unused);
        let damping = in_motion(5)?;
        let none = || Given::new(0.0, row.row.span());
        Ok(MooringLineType {
            name: row.words[0].text.to_owned(),
            span: row.row.span(),
            diameter: row.positive(1)?,
            mass: Given::new(Mass::InAir(mass.value), mass.span),
            stiffness: Given::new(Stiffness::Constant(stiffness.value), stiffness.span),
            damping: Given::new(Damping::Coefficient(damping.value), damping.span),
            bending: none(),
            drag_normal: in_motion(7)?,
            drag_tangential: in_motion(8)?,
            added_mass_normal: in_motion(6)?,
            added_mass_tangential: none(),
            // Below 0 where it is not used: then a line of this type may not lie on the bed.
            friction: Some(row.number(4)?),
            break_load: None,
        })
    });
    unique(
        &mut found,
        |one| (&one.name, &one.span),
        "line type",
        faults,
    );
    mooring.line_types = found;
    if !unused.is_empty() {
        mooring.remarks.push(format!(
            "Coefficients that MAP++ does not use are 0 here; they matter in motion only: {}.",
            listed(&unused)
        ));
    }
}

/// Numbers by which the template and the manual of MAP++ mark coefficients that its statics do not use.
const NOT_USED: [f64; 2] = [-999.9, -1.0];

/// A coefficient of motion; 0 where it is not given, or marked as not used.
fn of_motion(
    row: &TableRow<'_, '_>,
    column: usize,
    unused: &mut Vec<String>,
) -> Result<Given<f64>, Fault> {
    let name = || format!("{} of {}", TYPE_COLUMNS[column].0, row.words[0].text);
    let Some(given) = row.optional(column)? else {
        unused.push(format!("{} (not given)", name()));
        return Ok(Given::new(0.0, row.row.span()));
    };
    if !NOT_USED.contains(&given.value) {
        return row.not_negative(column);
    }
    unused.push(format!("{} ({})", name(), row.words[column].text));
    Ok(Given::new(0.0, given.span))
}

fn nodes(block: &SectionBlock<'_>, mooring: &mut Mooring, faults: &mut Vec<Fault>) {
    let table = SectionTable::with_marks(block, &NODE_COLUMNS, 10, faults);
    let mut found = table.read(faults, node);
    unique(&mut found, |one| (&one.id, &one.span), "node", faults);
    mooring.points = found;
}

fn node(row: &TableRow<'_, '_>) -> Result<MooringPoint, Fault> {
    let word = row.words[1];
    let hold = if ["fix", "fixed"].iter().any(|one| word.is(one)) {
        Hold::Fixed
    } else if word.is("vessel") {
        Hold::Coupled
    } else if ["connect", "free"].iter().any(|one| word.is(one)) {
        Hold::Free
    } else {
        let problem = format!("`{}` is not a type of node", word.text);
        return Err(row.fault(1, problem, "it is fix, vessel or connect"));
    };
    let solved_for = |column: usize| {
        let word = row.words[column];
        let text = word.text.trim_start_matches('#');
        let plain = Word {
            text,
            start: word.start + (word.text.len() - text.len()),
        };
        // A lone mark: MAP++ has no value to begin with.
        let value = match text.is_empty() {
            true => 0.0,
            false => plain.required(&row.key(column))?,
        };
        Ok(Given::new(value, word.span()))
    };
    let depth = row.words[4].is("depth");
    let height = match depth {
        true => Given::new(f64::NEG_INFINITY, row.words[4].span()),
        false => solved_for(4)?,
    };
    let is_free = hold == Hold::Free;
    let load = |column| match is_free {
        true => solved_for(column),
        false => Ok(Given::new(0.0, row.words[column].span())),
    };
    Ok(MooringPoint {
        id: row.words[0].text.to_owned(),
        span: row.row.span(),
        hold: Given::new(hold, word.span()),
        place: [solved_for(2)?, solved_for(3)?, height],
        mass: solved_for(5)?,
        volume: solved_for(6)?,
        drag_area: Given::new(0.0, row.row.span()),
        added_mass: Given::new(0.0, row.row.span()),
        load: [load(7)?, load(8)?, load(9)?],
    })
}

fn lines(block: &SectionBlock<'_>, mooring: &mut Mooring, faults: &mut Vec<Fault>) {
    let table = SectionTable::with_marks(block, &LINE_COLUMNS, 5, faults);
    let mut flags = Flags::default();
    let types = TypeIndex::of_names(mooring.line_types.iter().map(|of| of.name.as_str()));
    let nodes = Index::of_identifiers(mooring.points.iter().map(|node| node.id.as_str()));
    let mut found = table.read(faults, |row| {
        let end = |column: usize| {
            let word = row.words[column];
            let point = nodes.find(word.text);
            let point = point.ok_or_else(|| Fault {
                problem: format!("there is no node `{}`", word.text),
                ..missing(row, column, SectionTitle::Points, word.text)
            })?;
            Ok(Given::new(point, word.span()))
        };
        let ends = [end(3)?, end(4)?];
        if ends[0].value == ends[1].value {
            let problem = "both ends of the line are at the same node";
            return Err(row.fault(4, problem, "give two nodes"));
        }
        let length = length(row)?;
        let without_bed = flags.read(row);
        Ok(MooringLine {
            id: row.words[0].text.to_owned(),
            span: row.row.span(),
            of_type: type_of(row, 1, &types, SectionTitle::LineTypes)?,
            ends: ends.map(|end| Given::new(Attachment::Point(end.value), end.span)),
            length,
            segments: Given::new(0, row.row.span()),
            without_bed,
        })
    });
    unique(&mut found, |one| (&one.id, &one.span), "line", faults);
    mooring.lines = found;
    mooring.remarks.extend(flags.remarks);
    springs(&flags.springs, mooring);
}

/// Gives lines that are springs a type without weight in water; its mass counts in motion only.
fn springs(ids: &[String], mooring: &mut Mooring) {
    let mut types: Vec<(usize, usize)> = Vec::new();
    for number in 0..mooring.lines.len() {
        let line = &mooring.lines[number];
        if !ids.contains(&line.id) {
            continue;
        }
        let plain = line.of_type.value;
        let known = types.iter().find(|(of, _)| *of == plain);
        let spring = known.map_or(mooring.line_types.len(), |(_, spring)| *spring);
        if known.is_none() {
            let mut of = mooring.line_types[plain].clone();
            let Mass::InAir(mass) = of.mass.value else {
                continue;
            };
            of.name = format!("{}_spring", of.name);
            of.mass.value = Mass::InWater(0.0, Some(mass.max(LEAST_MASS)));
            mooring.line_types.push(of);
            types.push((plain, spring));
        }
        mooring.lines[number].of_type.value = spring;
    }
}

/// Mass of a spring that has none \[kg/m\]: motion needs some.
const LEAST_MASS: f64 = 1e-3;

/// The unstretched length. Behind `#` it is a variable of the solution of MAP++, for which a node then has a known force.
fn length(row: &TableRow<'_, '_>) -> Result<Given<f64>, Fault> {
    let word = row.words[2];
    if !word.text.starts_with('#') {
        return row.positive(2);
    }
    let problem = format!(
        "`{}`: behind `#` MAP++ solves for the length, which is not done here",
        word.text
    );
    Err(row.fault(
        2,
        problem,
        "give the length in m that MAP++ found, without `#`",
    ))
}
