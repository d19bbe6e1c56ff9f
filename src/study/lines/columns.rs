//! CSV of single lines in a uniform current.

use std::io;

use csv::{ByteRecord, ReaderBuilder, StringRecord, Terminator, WriterBuilder};
use rayon::prelude::*;

use super::drift::{InCurrent, Pulls};
use super::{PULLS, shown};
use crate::statics::catenary::{SectionProps, TableFault, Written};

/// Columns by name, and by the short name they have as well.
const COLUMNS: [[&str; 2]; 16] = [
    ["a_x_m", "ax"],
    ["a_y_m", "ay"],
    ["a_z_m", "az"],
    ["b_x_m", "bx"],
    ["b_y_m", "by"],
    ["b_z_m", "bz"],
    ["length_m", "l"],
    ["weight_n_per_m", "w_npm"],
    ["ea_n", "ea_n"],
    ["diameter_m", "d_m"],
    ["drag_normal", "cd"],
    ["drag_tangential", "cdax"],
    ["water_density_kg_per_m3", "rho"],
    ["current_x_m_per_s", "ux"],
    ["current_y_m_per_s", "uy"],
    ["current_z_m_per_s", "uz"],
];
/// The last of the columns may be left out: a current is level.
const NEEDED: usize = 15;

fn names(head: &StringRecord) -> Vec<String> {
    head.iter()
        .map(|name| name.trim().to_ascii_lowercase())
        .collect()
}

fn reader(input: &[u8]) -> csv::Reader<&[u8]> {
    ReaderBuilder::new().flexible(true).from_reader(input)
}

/// Whether the columns are those of lines in a current.
pub(super) fn in_current(input: &[u8]) -> bool {
    let Ok(head) = reader(input).byte_headers().cloned() else {
        return false;
    };
    let names = names(&StringRecord::from_byte_record_lossy(head));
    COLUMNS[13]
        .iter()
        .any(|name| names.iter().any(|n| n == name))
}

/// Solves every row.
///
/// # Errors
/// [`TableFault`] when the columns are not there or the bytes are no table.
pub(super) fn solve(input: &[u8]) -> Result<Written, TableFault> {
    let mut reader = reader(input);
    let head = StringRecord::from_byte_record_lossy(reader.byte_headers()?.clone());
    let names = names(&head);
    let mut places = [None; 16];
    let mut missing = Vec::new();
    for (i, known) in COLUMNS.iter().enumerate() {
        let mut found = (0..names.len()).filter(|&k| known.contains(&names[k].as_str()));
        places[i] = found.next();
        if found.next().is_some() {
            return Err(TableFault::Twice(known[0].to_owned()));
        }
        if places[i].is_none() && i < NEEDED {
            missing.push(known[0]);
        }
    }
    if !missing.is_empty() {
        return Err(TableFault::Columns(missing.join(", ")));
    }
    let rows: Vec<ByteRecord> = reader.byte_records().collect::<Result<_, _>>()?;
    let answers: Vec<Result<Pulls, String>> = rows
        .par_iter()
        .map(|row| answer(row, &places, head.len()))
        .collect();
    let kept: Vec<usize> = (0..head.len())
        .filter(|&i| !PULLS.contains(&names[i].as_str()) && names[i] != "status")
        .collect();
    write(&head, &kept, &rows, &answers).map_err(TableFault::from)
}

fn answer(row: &ByteRecord, places: &[Option<usize>; 16], count: usize) -> Result<Pulls, String> {
    let line = row.position().map_or(0, csv::Position::line);
    if row.len() != count {
        return Err(format!(
            "line {line}: {} cells where the first line names {count} columns",
            row.len()
        ));
    }
    let mut n = [0.0; 16];
    for ((value, place), [name, _]) in n.iter_mut().zip(places).zip(COLUMNS) {
        let Some(place) = *place else { continue };
        let text = String::from_utf8_lossy(&row[place]);
        let number = text.trim().parse::<f64>().ok().filter(|v| v.is_finite());
        *value = number.ok_or_else(|| {
            format!(
                "line {line}, column {name}: \"{}\" is not a number",
                text.trim()
            )
        })?;
    }
    if n[15] != 0.0 {
        return Err(format!(
            "line {line}, column {}: a current is level here; 0 is needed",
            COLUMNS[15][0]
        ));
    }
    let asked = InCurrent {
        a_m: [n[0], n[1], n[2]],
        b_m: [n[3], n[4], n[5]],
        sections: vec![SectionProps::new(n[6], n[7], n[8])],
        diameter_m: n[9],
        drag_normal: n[10],
        drag_tangential: n[11],
        water_density_kg_per_m3: n[12],
        current: vec![[0.0, n[13], n[14]]],
    };
    asked.solve().map_err(|why| format!("line {line}: {why}"))
}

fn write(
    head: &StringRecord,
    kept: &[usize],
    rows: &[ByteRecord],
    answers: &[Result<Pulls, String>],
) -> Result<Written, csv::Error> {
    let mut writer = WriterBuilder::new()
        .terminator(Terminator::Any(b'\n'))
        .from_writer(Vec::new());
    writer.write_record(
        kept.iter()
            .map(|&i| &head[i])
            .chain(PULLS)
            .chain(["status"]),
    )?;
    for (row, answer) in rows.iter().zip(answers) {
        for &i in kept {
            writer.write_field(row.get(i).unwrap_or_default())?;
        }
        let cells = match answer {
            Ok(pulls) => pulls.numbers().map(shown),
            Err(_) => PULLS.map(|_| String::new()),
        };
        for cell in &cells {
            writer.write_field(cell)?;
        }
        writer.write_field(answer.as_ref().err().map_or("ok", String::as_str))?;
        writer.write_record(None::<&[u8]>)?;
    }
    let text = writer
        .into_inner()
        .map_err(|e| io::Error::other(e.to_string()))?;
    Ok(Written {
        text,
        rows: rows.len(),
        refused: answers.iter().filter(|answer| answer.is_err()).count(),
    })
}
