//! The tables LINE TYPES and ROD TYPES.

use std::collections::HashSet;

use super::files::Files;
use super::sections::SectionBlock;
use super::table::{HeaderColumn, SectionTable, TableRow};
use crate::import::fault::Fault;
use crate::import::mooring::{
    Damping, Given, Mass, Mooring, MooringLineType, Program, RodType, Stiffness, Syrope, Unmodelled,
};
use crate::import::words::{Row, Word};

/// Coefficients of the water: headers have them in another order than the program reads, see [`coefficients_by_name`].
const COEFFICIENTS: &[&str] = &[
    "Cd", "Ca", "CdAx", "CaAx", "Can", "Cat", "Cdn", "Cdt", "Ca*", "Cd*", "Cd_n", "Cd_t", "Ca_n",
    "Ca_t",
];

/// Columns of the second version.
const COLUMNS: [HeaderColumn; 13] = [
    ("TypeName", &["Name", "LineType", "Type"]),
    ("Diam", &["Diameter", "D"]),
    ("Mass/m", &["MassDen", "MassDenInAir", "Mass", "w"]),
    ("EA", &[]),
    ("BA/-zeta", &["BA", "cIntDamp", "BA/-z", "IntDamp"]),
    ("EI", &[]),
    ("Cd", COEFFICIENTS),
    ("Ca", COEFFICIENTS),
    ("CdAx", COEFFICIENTS),
    ("CaAx", COEFFICIENTS),
    ("Cl", COEFFICIENTS),
    ("dF", &[]),
    ("cF", &[]),
];

/// Columns of the first version, in the order of its documentation.
const COLUMNS_1: [HeaderColumn; 9] = [
    COLUMNS[0],
    COLUMNS[1],
    COLUMNS[2],
    COLUMNS[3],
    COLUMNS[4],
    ("Can", COEFFICIENTS),
    ("Cat", COEFFICIENTS),
    ("Cdn", COEFFICIENTS),
    ("Cdt", COEFFICIENTS),
];

/// Columns of `CableDyn`; with four of shear and rotation before the coefficients of the water, which are not read.
const COLUMNS_CABLE: [HeaderColumn; 14] = [
    COLUMNS[0],
    COLUMNS[1],
    COLUMNS[2],
    COLUMNS[3],
    COLUMNS[4],
    COLUMNS[5],
    ("GAs", &[]),
    ("GJ", &[]),
    ("Irt", &[]),
    ("Irn", &[]),
    ("Cd_n", COEFFICIENTS),
    ("Cd_t", COEFFICIENTS),
    ("Ca_n", COEFFICIENTS),
    ("Ca_t", COEFFICIENTS),
];

const ROD_COLUMNS: [HeaderColumn; 7] = [
    ("TypeName", &["Name", "RodType", "Type"]),
    ("Diam", &["Diameter", "D"]),
    ("Mass/m", &["MassDen", "MassDenInAir", "Mass", "w"]),
    ("Cd", &[]),
    ("Ca", &[]),
    ("CdEnd", &["CdAx"]),
    ("CaEnd", &["CaAx"]),
];

/// Whether the header of a block has a column for bending stiffness: the first version has none.
#[must_use]
pub fn is_first_version(block: &SectionBlock<'_>) -> bool {
    let header = block.rows.iter().map(Row::words).find(|words| {
        let is = |name: &str| words.iter().any(|word| word.is(name));
        is("EA")
    });
    header.is_some_and(|words| !words.iter().any(|word| word.is("EI")) && words.len() <= 9)
}

/// Reads the line types.
pub fn read_line_types(
    block: &SectionBlock<'_>,
    files: &Files<'_>,
    mooring: &mut Mooring,
    faults: &mut Vec<Fault>,
) {
    let program = mooring.program;
    let first = program == Program::MoorDyn1;
    let has_shear = program == Program::CableDyn && has_shear(block);
    let (columns, required): (&[HeaderColumn], _) = match (first, has_shear) {
        (true, _) => (&COLUMNS_1, 9),
        (_, true) => (&COLUMNS_CABLE, 14),
        _ => (&COLUMNS, 10),
    };
    let order = coefficients_by_name(block, program, faults);
    if has_shear {
        let remark = "Stiffness in shear and torsion and rotary inertia of the line types (GAs, GJ, Irt, Irn) are passed over.";
        mooring.remarks.push(remark.to_owned());
    }
    if program == Program::MoorDyn && order == CoefficientOrder::AddedMass {
        mooring.remarks.push(
            "The header of the line types names Can Cat Cdn Cdt; MoorDyn 2 reads these four columns as Cd Ca CdAx CaAx, by their \
             order, and so they are read here."
                .to_owned(),
        );
    }
    let table = SectionTable::of_block(block, columns, required, faults);
    let mut unmodelled = Vec::new();
    let mut found: Vec<MooringLineType> = table.read(faults, |row| {
        match program {
            Program::MoorDyn1 => nine_columns(row)?,
            Program::CableDyn => {}
            _ => vortices(row, &mut unmodelled)?,
        }
        let at = match (first, has_shear) {
            (true, _) => 5,
            (_, true) => 10,
            _ => 6,
        };
        line_type(row, files, (first, at), order)
    });
    unique(
        &mut found,
        |one| (&one.name, &one.span),
        "line type",
        faults,
    );
    mooring.line_types = found;
    mooring.unmodelled.extend(unmodelled);
}

/// Whether the header of a block has the columns of shear and rotation of `CableDyn`.
fn has_shear(block: &SectionBlock<'_>) -> bool {
    let mut rows = block.rows.iter().take(2);
    rows.any(|row| row.words().iter().any(|word| word.is("GAs")))
}

/// Reads the rod types.
pub fn read_rod_types(block: &SectionBlock<'_>, mooring: &mut Mooring, faults: &mut Vec<Fault>) {
    let table = SectionTable::of_block(block, &ROD_COLUMNS, 7, faults);
    let mut found = table.read(faults, |row| {
        Ok(RodType {
            name: row.words[0].text.to_owned(),
            span: row.row.span(),
            diameter: row.positive(1)?,
            mass: row.not_negative(2)?,
            drag_normal: row.not_negative(3)?,
            added_mass_normal: row.not_negative(4)?,
            drag_end: row.not_negative(5)?,
            added_mass_end: row.not_negative(6)?,
        })
    });
    unique(&mut found, |one| (&one.name, &one.span), "rod type", faults);
    mooring.rod_types = found;
}

/// Faults for names that stand twice; the first of each stays.
pub fn unique<T>(
    all: &mut Vec<T>,
    name: impl Fn(&T) -> (&String, &std::ops::Range<usize>),
    what: &str,
    faults: &mut Vec<Fault>,
) {
    let mut seen: HashSet<String> = HashSet::new();
    all.retain(|one| {
        let (name, span) = name(one);
        if seen.contains(name) {
            faults.push(Fault::new(
                span.clone(),
                what,
                format!("there is a second {what} `{name}`"),
                "give it a name or number of its own",
            ));
            return false;
        }
        seen.insert(name.clone());
        true
    });
}

/// What one of the four coefficients of the water is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum WaterCoefficient {
    DragNormal,
    AddedNormal,
    DragTangential,
    AddedTangential,
}

use WaterCoefficient::{AddedNormal, AddedTangential, DragNormal, DragTangential};

/// The order in which the second version reads them.
const DRAG_FIRST: [WaterCoefficient; 4] =
    [DragNormal, AddedNormal, DragTangential, AddedTangential];
/// The order in which the first version reads them.
const ADDED_MASS_FIRST: [WaterCoefficient; 4] =
    [AddedNormal, AddedTangential, DragNormal, DragTangential];

/// The order in which `CableDyn` reads them.
const DRAG_PAIR_FIRST: [WaterCoefficient; 4] =
    [DragNormal, DragTangential, AddedNormal, AddedTangential];

/// Names in headers.
const NAMES: [(&str, WaterCoefficient); 12] = [
    ("Cd_n", DragNormal),
    ("Cd_t", DragTangential),
    ("Ca_n", AddedNormal),
    ("Ca_t", AddedTangential),
    ("Cd", DragNormal),
    ("Cdn", DragNormal),
    ("Ca", AddedNormal),
    ("Can", AddedNormal),
    ("CdAx", DragTangential),
    ("Cdt", DragTangential),
    ("CaAx", AddedTangential),
    ("Cat", AddedTangential),
];

/// Which of the four coefficients come first.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum CoefficientOrder {
    Drag,
    AddedMass,
    DragPair,
}

impl CoefficientOrder {
    /// The order in which a program reads them where the header does not name them.
    fn of_program(program: Program) -> Self {
        match program {
            Program::MoorDyn1 => Self::AddedMass,
            Program::CableDyn => Self::DragPair,
            _ => Self::Drag,
        }
    }
}

/// The order that the header names; a fault where it is none of the two that files have.
fn coefficients_by_name<'t>(
    block: &SectionBlock<'t>,
    program: Program,
    faults: &mut Vec<Fault>,
) -> CoefficientOrder {
    let coefficient = |word: &Word<'t>| {
        let known = NAMES
            .iter()
            .find(|(name, _)| word.is(name.trim_end_matches('*')));
        known.map(|(_, coefficient)| (*word, *coefficient))
    };
    let named = |row: &Row<'t>| {
        row.words()
            .iter()
            .filter_map(coefficient)
            .collect::<Vec<_>>()
    };
    let header = block.rows.iter().map(named).find(|named| named.len() == 4);
    let Some(header) = header else {
        return CoefficientOrder::of_program(program);
    };
    let order: Vec<WaterCoefficient> = header.iter().map(|(_, coefficient)| *coefficient).collect();
    let of_cables = program == Program::CableDyn;
    if order == DRAG_PAIR_FIRST && of_cables {
        return CoefficientOrder::DragPair;
    }
    if order == ADDED_MASS_FIRST && !of_cables {
        return CoefficientOrder::AddedMass;
    }
    if order != DRAG_FIRST {
        let (read, names) = match program {
            Program::MoorDyn1 => (ADDED_MASS_FIRST, "Can Cat Cdn Cdt"),
            Program::CableDyn => (DRAG_PAIR_FIRST, "Cd_n Cd_t Ca_n Ca_t"),
            _ => (DRAG_FIRST, "Cd Ca CdAx CaAx"),
        };
        let out_of_place = header
            .iter()
            .zip(read)
            .find(|((_, named), read)| named != read);
        let word = out_of_place.map_or(header[0].0, |((word, _), _)| *word);
        faults.push(Fault::new(
            word.span(),
            format!("LINE TYPES, {}", word.text),
            format!(
                "the header names the coefficients of the water in an order that {} does not read",
                program.name()
            ),
            format!("columns are read by their order: {names}"),
        ));
    }
    CoefficientOrder::Drag
}

/// Refuses a row with more numbers than the header has names: which of the columns the header leaves out is not known.
fn nine_columns(row: &TableRow<'_, '_>) -> Result<(), Fault> {
    let behind = row.words.get(COLUMNS_1.len());
    match behind.filter(|word| word.number().is_some()) {
        None => Ok(()),
        Some(_) => Err(row.fault(
            COLUMNS_1.len(),
            format!("the row has more columns than the {} that the header names", COLUMNS_1.len()),
            "name all columns in the header: the second version of MoorDyn has EI in front of the coefficients of the water",
        )),
    }
}

/// Vibrations in the wake of vortices: columns behind the tenth.
fn vortices(row: &TableRow<'_, '_>, unmodelled: &mut Vec<Unmodelled>) -> Result<(), Fault> {
    let count = row.words.len();
    if count == 12 || count > 13 {
        let fault = row.fault(
            count.min(13) - 1,
            format!("the row has {count} columns"),
            "a line type has 10 columns, 11 with Cl, or 13 with Cl, dF and cF",
        );
        return Err(fault);
    }
    if let Some(lift) = row.optional(10)?
        && lift.value != 0.0
    {
        unmodelled.push(Unmodelled {
            name: "viv",
            span: lift.span,
            key: row.key(10),
            what: "vibrations in the wake of vortices (a lift coefficient Cl)".to_owned(),
        });
    }
    for column in 11..count {
        row.number(column)?;
    }
    Ok(())
}

fn line_type(
    row: &TableRow<'_, '_>,
    files: &Files<'_>,
    (first, at): (bool, usize),
    order: CoefficientOrder,
) -> Result<MooringLineType, Fault> {
    let stiffness = stiffness(row, files)?;
    let damping = damping(row, &stiffness.value)?;
    let bending = match first {
        true => Given::new(0.0, row.row.span()),
        false => bending(row)?,
    };
    let [a, b, c, d] = [at, at + 1, at + 2, at + 3].map(|column| row.not_negative(column));
    let by_order = [a?, b?, c?, d?];
    let [
        drag_normal,
        added_mass_normal,
        drag_tangential,
        added_mass_tangential,
    ] = match (first, order) {
        (true, CoefficientOrder::AddedMass) => {
            let [can, cat, cdn, cdt] = by_order;
            [cdn, can, cdt, cat]
        }
        (_, CoefficientOrder::DragPair) => {
            let [cdn, cdt, can, cat] = by_order;
            [cdn, can, cdt, cat]
        }
        _ => by_order,
    };
    let mass = row.not_negative(2)?;
    Ok(MooringLineType {
        name: row.words[0].text.to_owned(),
        span: row.row.span(),
        diameter: row.positive(1)?,
        mass: Given::new(Mass::InAir(mass.value), mass.span),
        stiffness,
        damping,
        bending,
        drag_normal,
        drag_tangential,
        added_mass_normal,
        added_mass_tangential,
        friction: None,
        break_load: None,
    })
}

/// Bending stiffness: a number; a file of moments over curvatures is not read.
fn bending(row: &TableRow<'_, '_>) -> Result<Given<f64>, Fault> {
    let bending = row.not_negative(5);
    bending.map_err(|fault| {
        let is_file = row.words[5].text.contains('.') && row.words[5].number().is_none();
        match is_file {
            true => row.fault(
                5,
                "a table of moments over curvatures is not modelled",
                "give one bending stiffness in N m2",
            ),
            false => fault,
        }
    })
}

/// EA: a number, two, three, a file, or a Syrope rope.
fn stiffness(row: &TableRow<'_, '_>, files: &Files<'_>) -> Result<Given<Stiffness>, Fault> {
    let word = row.words[3];
    let key = row.key(3);
    let parts = word.parts('|');
    let value = if parts[0].text.starts_with(SYROPE) {
        syrope(row, &parts, files)?
    } else {
        match parts.as_slice() {
            [table] if is_file(*table, files) => Stiffness::Table(files.curve(*table, &key)?),
            [constant] => Stiffness::Constant(above_zero(*constant, &key)?),
            [slow, fast, rest @ ..] if rest.len() < 2 => Stiffness::Viscoelastic {
                slow: above_zero(*slow, &key)?,
                fast: above_zero(*fast, &key)?,
                per_tension: rest
                    .first()
                    .map_or(Ok(0.0), |factor| factor.required(&key))?,
            },
            _ => {
                return Err(row.fault(
                    3,
                    "there are more than three stiffnesses between bars",
                    "write EA, EA|EA of fast motion, or EA|EA of fast motion|its growth by the mean tension",
                ));
            }
        }
    };
    Ok(Given::new(value, word.span()))
}

/// The word before the file of a Syrope rope.
const SYROPE: &str = "SYROPE:";

fn syrope(
    row: &TableRow<'_, '_>,
    parts: &[Word<'_>],
    files: &Files<'_>,
) -> Result<Stiffness, Fault> {
    let key = row.key(3);
    let &[named, fast, per_tension] = parts else {
        return Err(row.fault(
            3,
            "a Syrope rope has three entries between bars",
            "write SYROPE:file|stiffness|factor of the mean tension",
        ));
    };
    let file = Word {
        text: &named.text[SYROPE.len()..],
        start: named.start + SYROPE.len(),
    };
    let (working_curve, first_loading) = files.syrope(file, &key)?;
    Ok(Stiffness::Syrope(Syrope {
        first_loading,
        working_curve,
        fast: above_zero(fast, &key)?,
        per_tension: per_tension.required(&key)?,
    }))
}

/// Whether an entry names a file rather than a number that is written wrongly.
fn is_file(entry: Word<'_>, files: &Files<'_>) -> bool {
    let begins_as_name = |letter: char| letter.is_alphabetic() || "./".contains(letter);
    let like_a_name =
        entry.text.starts_with(begins_as_name) && entry.text.contains(['.', '/', '_']);
    entry.number().is_none() && (like_a_name || files.path(entry.text).is_some())
}

/// A stiffness \[N\].
fn above_zero(entry: Word<'_>, key: &str) -> Result<f64, Fault> {
    let value = entry.required(key)?;
    match value > 0.0 {
        true => Ok(value),
        false => Err(Fault::new(
            entry.span(),
            key,
            format!("`{}` is not above 0", entry.text),
            "give a positive stiffness in N",
        )),
    }
}

/// BA or -zeta: one number, or two for a viscoelastic rope.
fn damping(row: &TableRow<'_, '_>, stiffness: &Stiffness) -> Result<Given<Damping>, Fault> {
    let given = row.bars(4)?;
    let is_fibre = matches!(
        stiffness,
        Stiffness::Viscoelastic { .. } | Stiffness::Syrope(_)
    );
    let damping = match given.value.as_slice() {
        [one] if *one < 0.0 && !is_fibre => Damping::Ratio(-one),
        [one] if is_fibre => Damping::Two(*one, 0.0),
        [one] => Damping::Coefficient(*one),
        [slow, fast] if is_fibre => Damping::Two(*slow, *fast),
        [_, _] => {
            return Err(row.fault(
                4,
                "there are two dampings for one stiffness",
                "give one, or two stiffnesses in EA as well",
            ));
        }
        _ => {
            return Err(row.fault(
                4,
                "there are more than two dampings between bars",
                "give one or two",
            ));
        }
    };
    if let Damping::Two(slow, fast) = damping
        && (slow < 0.0 || fast < 0.0)
    {
        return Err(row.fault(
            4,
            "a share of critical damping (a negative number) is not defined for two stiffnesses",
            "give both dampings in N s",
        ));
    }
    Ok(Given::new(damping, given.span))
}
