//! The text of a file of MoorDyn 2.

use super::number::{all_written, written};
use super::sheet::Sheet;
use crate::padding::at_left;

/// The file.
#[must_use]
pub fn text(sheet: &Sheet) -> String {
    let mut text = Text::default();
    text.line("--------------------- MoorDyn Input File ---------------------");
    text.line(&title(sheet));
    types(sheet, &mut text);
    parts(sheet, &mut text);
    lines(sheet, &mut text);
    text.section("OPTIONS");
    for (value, name) in &sheet.options {
        text.line(&format!("{value}  {name}"));
    }
    text.section("OUTPUTS");
    for number in 1..=sheet.lines.len() {
        text.line(&format!("FairTen{number}"));
    }
    text.line("END");
    text.line("---------------------- need this line ------------------------");
    text.text
}

/// The title in one line that is no section.
fn title(sheet: &Sheet) -> String {
    let words: Vec<&str> = sheet.title.split_whitespace().collect();
    let title = words.join(" ");
    match title.starts_with(['-', '=']) || title.is_empty() {
        true => format!("System {title}").trim_end().to_owned(),
        false => title,
    }
}

/// Text that is written line by line.
#[derive(Debug, Default)]
struct Text {
    text: String,
}

impl Text {
    fn line(&mut self, line: &str) {
        self.text.push_str(line.trim_end());
        self.text.push('\n');
    }

    fn section(&mut self, title: &str) {
        let dashes = "-".repeat(60 - title.len().min(40));
        self.line(&format!("--- {title} {dashes}"));
    }

    /// A table: its section, names and units of its columns, and its rows, in columns.
    fn table(&mut self, title: &str, heads: [&str; 2], rows: &[String]) {
        self.section(title);
        let all = heads.iter().copied().chain(rows.iter().map(String::as_str));
        let cells: Vec<Vec<&str>> = all.map(|row| row.split_whitespace().collect()).collect();
        let count = cells.iter().map(Vec::len).max().unwrap_or(0);
        let width = |column: usize| {
            let lengths = cells.iter().filter_map(|row| row.get(column));
            lengths.map(|cell| cell.chars().count()).max().unwrap_or(0)
        };
        let widths: Vec<usize> = (0..count).map(width).collect();
        for row in &cells {
            let padded = row.iter().zip(&widths);
            let padded: Vec<String> = padded.map(|(cell, width)| at_left(cell, *width)).collect();
            self.line(&padded.join("  "));
        }
    }
}

fn types(sheet: &Sheet, text: &mut Text) {
    let rows: Vec<String> = sheet
        .types
        .iter()
        .map(|of| {
            let numbers = [of.diameter, of.mass];
            let water = [of.drag[0], of.added_mass[0], of.drag[1], of.added_mass[1]];
            format!(
                "{} {} {} {} {} {}",
                of.name,
                all_written(&numbers),
                of.ea,
                of.damping,
                written(of.bending),
                all_written(&water)
            )
        })
        .collect();
    text.table(
        "LINE TYPES",
        [
            "TypeName Diam Mass/m EA BA/-zeta EI Cd Ca CdAx CaAx",
            "(name) (m) (kg/m) (N) (N-s/-) (N-m^2) (-) (-) (-) (-)",
        ],
        &rows,
    );
    if sheet.rod_types.is_empty() {
        return;
    }
    let rows: Vec<String> = sheet
        .rod_types
        .iter()
        .map(|of| {
            let numbers = [
                of.diameter,
                of.mass,
                of.drag,
                of.added_mass,
                of.drag_end,
                of.added_mass_end,
            ];
            format!("{} {}", of.name, all_written(&numbers))
        })
        .collect();
    text.table(
        "ROD TYPES",
        [
            "TypeName Diam Mass/m Cd Ca CdEnd CaEnd",
            "(name) (m) (kg/m) (-) (-) (-) (-)",
        ],
        &rows,
    );
}

fn parts(sheet: &Sheet, text: &mut Text) {
    let bars = |numbers: &[f64]| {
        let all: Vec<String> = numbers.iter().copied().map(written).collect();
        all.join("|")
    };
    let rows = sheet.bodies.iter().zip(1..).map(|(body, number)| {
        format!(
            "{number} {} {} {} {} {} {} {} {} {}",
            body.hold,
            all_written(&body.place),
            all_written(&body.angles),
            written(body.mass),
            bars(&body.centre),
            bars(&body.inertia),
            written(body.volume),
            bars(&body.drag_area),
            bars(&body.added_mass)
        )
    });
    let rows: Vec<String> = rows.collect();
    if !rows.is_empty() {
        text.table(
            "BODIES",
            [
                "ID Attachment X0 Y0 Z0 r0 p0 y0 Mass CG* I* Volume CdA* Ca*",
                "(#) (-) (m) (m) (m) (deg) (deg) (deg) (kg) (m) (kg-m^2) (m^3) (m^2) (-)",
            ],
            &rows,
        );
    }
    let rows = sheet.rods.iter().zip(1..).map(|(rod, number)| {
        format!(
            "{number} {} {} {} {} {} -",
            rod.of_type,
            rod.hold,
            all_written(&rod.ends[0]),
            all_written(&rod.ends[1]),
            rod.segments
        )
    });
    let rows: Vec<String> = rows.collect();
    if !rows.is_empty() {
        text.table(
            "RODS",
            [
                "ID RodType Attachment Xa Ya Za Xb Yb Zb NumSegs RodOutputs",
                "(#) (name) (#/key) (m) (m) (m) (m) (m) (m) (-) (-)",
            ],
            &rows,
        );
    }
    points(sheet, text);
}

/// Points; with columns for loads where one has a load.
fn points(sheet: &Sheet, text: &mut Text) {
    let loaded = sheet.points.iter().any(|point| point.load != [0.0; 3]);
    let rows = sheet.points.iter().zip(1..).map(|(point, number)| {
        let load = match loaded {
            true => all_written(&point.load),
            false => String::new(),
        };
        format!(
            "{number} {} {} {} {load} {}",
            point.hold,
            all_written(&point.place),
            all_written(&[point.mass, point.volume]),
            all_written(&[point.drag_area, point.added_mass])
        )
    });
    let rows: Vec<String> = rows.collect();
    let heads = match loaded {
        true => [
            "ID Attachment X Y Z Mass Volume FX FY FZ CdA Ca",
            "(#) (-) (m) (m) (m) (kg) (m^3) (N) (N) (N) (m^2) (-)",
        ],
        false => [
            "ID Attachment X Y Z Mass Volume CdA Ca",
            "(#) (-) (m) (m) (m) (kg) (m^3) (m^2) (-)",
        ],
    };
    text.table("POINTS", heads, &rows);
}

fn lines(sheet: &Sheet, text: &mut Text) {
    let rows = sheet.lines.iter().zip(1..).map(|(line, number)| {
        format!(
            "{number} {} {} {} {} {} -",
            line.of_type,
            line.ends[0],
            line.ends[1],
            written(line.length),
            line.segments
        )
    });
    let rows: Vec<String> = rows.collect();
    text.table(
        "LINES",
        [
            "ID LineType AttachA AttachB UnstrLen NumSegs LineOutputs",
            "(#) (name) (#) (#) (m) (-) (-)",
        ],
        &rows,
    );
    let rows = sheet
        .failures
        .iter()
        .zip(1..)
        .map(|((at, line, limits), number)| {
            format!("{number} {at} {line} {}", all_written(limits))
        });
    let rows: Vec<String> = rows.collect();
    if !rows.is_empty() {
        text.table(
            "FAILURE",
            [
                "FailID Point Line(s) FailTime FailTen",
                "(#) (#) (#) (s) (N)",
            ],
            &rows,
        );
    }
    let rows = sheet.pasts.iter();
    let rows: Vec<String> = rows
        .map(|(line, past)| format!("{line} {}", all_written(past)))
        .collect();
    if !rows.is_empty() {
        text.table("SYROPE IC", ["Line(s) Tmax0 Tmean0", "(#) (N) (N)"], &rows);
    }
}
