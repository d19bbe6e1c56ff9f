//! The library of line types in tables: the list of types, and one type at a diameter.

use seacable_base::number::{digits, si};
use seacable_display::table::{NumberFormat, Table};
use seacable_model::line_types::{
    LINE_TYPES, Library, LibraryType, LineProperties, LineType, OuterDiameter, Property,
};

/// A property in a table: what it is, its unit, its value with formula and source.
type Entry<'a> = (&'static str, &'static str, &'a Property);

/// The list of types: name, what it is, nominal diameters.
#[must_use]
pub fn list() -> Table {
    let range = |line: &LineType| {
        let [least, greatest] = line.diameters_m.map(|length| digits(length * 1e3, 6));
        format!("{least} to {greatest}")
    };
    let table = Table::of_records("Line types", LINE_TYPES)
        .text("type", |line| line.name)
        .text("what", |line| line.title)
        .text("nominal diameter [mm]", range)
        .text("strength by", |line| line.break_load.source);
    table.build().noted([
        "`seacable lines TYPE DIAMETER` computes the properties of one, such as `seacable lines chain-r4-studless 120mm`; with `--toml` as a material.",
    ])
}

/// The types of a library of the user with their formulas.
#[must_use]
pub fn library(library: &Library) -> Table {
    let or_none = |formula: String| match formula.is_empty() {
        true => "none".to_owned(),
        false => formula,
    };
    let outer = |line: &LibraryType| match line.outer {
        OuterDiameter::Times(ratio) => format!("{} d", digits(ratio, 4)),
        OuterDiameter::ByDensity(density) => format!("by {} kg/m^3", digits(density, 6)),
    };
    let table = Table::of_records("Line types of the library", &library.types)
        .text("type", |line| line.name.as_str())
        .text("mass", |line| format!("{} d^2", digits(line.mass, 6)))
        .text("outer diameter", outer)
        .text("EA", move |line| or_none(line.ea_formula()))
        .text("breaking load", move |line| {
            or_none(line.break_load.formula())
        });
    table.build().noted([
        "d is the nominal diameter in m, results are in SI. `seacable lines --library FILE TYPE DIAMETER` computes the properties of one; with \
         `--toml` as a material.",
    ])
}

/// The properties of a type with formulas and sources.
#[must_use]
pub fn properties(line: &LineProperties) -> Table {
    let entries = entries(line);
    let table = Table::of_records(title(line), &entries)
        .text("property", |entry| entry.0)
        .text("value", |entry| si(entry.2.value, entry.1))
        .text("formula", |entry| entry.2.formula.as_str())
        .text("source", |entry| entry.2.source.as_ref());
    table.build().noted(notes(line))
}

/// The properties with every digit, in SI, for other programs.
#[must_use]
pub fn data(line: &LineProperties) -> Table {
    const EVERY_DIGIT: NumberFormat = NumberFormat::With(|value| format!("{value}"));
    let entries = entries(line);
    let table = Table::of_records(title(line), &entries)
        .text("property", |entry| entry.0)
        .number("value", EVERY_DIGIT, |entry| entry.2.value)
        .text("unit", |entry| entry.1)
        .text("formula", |entry| entry.2.formula.as_str())
        .text("source", |entry| entry.2.source.as_ref());
    table.build().noted(notes(line))
}

fn title(line: &LineProperties) -> String {
    let size = digits(line.nominal_m * 1e3, 6);
    format!("{}, nominal diameter {size} mm", line.line_type.title)
}

fn entries(line: &LineProperties) -> Vec<Entry<'_>> {
    let mut entries = vec![
        ("outer diameter D", "m", &line.diameter),
        ("mass in air", "kg/m", &line.mass),
        ("mass in sea water", "kg/m", &line.wet_weight),
        ("axial stiffness EA", "N", &line.ea),
        ("breaking load", "N", &line.break_load),
    ];
    entries.extend(
        line.proof_load
            .as_ref()
            .map(|load| ("proof load", "N", load)),
    );
    entries.extend([
        ("normal drag, on D", "", &line.drag_normal),
        ("tangential drag, on D", "", &line.drag_tangential),
        ("normal added mass", "", &line.added_mass_normal),
        ("tangential added mass", "", &line.added_mass_tangential),
    ]);
    entries
}

fn notes(line: &LineProperties) -> Vec<String> {
    let of = &line.line_type;
    let diameter = of.nominal;
    let mut notes = vec![format!(
        "d is the nominal diameter in m, {diameter}; D displaces the volume of the line, and is `diameter_m` of a material. Results in SI."
    )];
    notes.extend(of.dynamic_stiffness.as_ref().map(|([alpha, beta], source)| {
        format!(
            "Stiffness in motion: {alpha} + {beta} Lm times the breaking load, with the mean tension Lm in percent of it ({source})."
        )
    }));
    notes.extend((!of.note.is_empty()).then(|| of.note.to_string()));
    notes.extend(
        line.warning
            .as_ref()
            .map(|warning| format!("WARNING: {warning}")),
    );
    notes
}
