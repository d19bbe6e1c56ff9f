//! One JSON object: a line of several sections at rest in still water, or in a current.

use super::drift::InCurrent;
use super::json::{self, Kind, Value};
use super::{Numbers, PULLS, shown};
use crate::statics::catenary::{Bed, Ends, Line, SectionProps};

/// A line of text with its answer.
pub(super) struct Answered {
    pub text: String,
    pub is_line: bool,
    pub refused: bool,
}

/// What is wrong; with which key's value, at which byte of the text, where it is one.
struct Trouble {
    place: Option<(String, usize)>,
    problem: String,
}

type Entries = Vec<(String, Value)>;

/// Keys of a line in still water, and what they are called in short.
const STILL: [&str; 10] = [
    "sections",
    "segs",
    "x_m",
    "radius",
    "z_m",
    "depth",
    "friction",
    "bed_below_a_m",
    "bed_slope_deg",
    "surface_above_a_m",
];
/// Keys that only a line in a current has.
const MOVING: [&str; 7] = [
    "a_m",
    "b_m",
    "current",
    "diameter_m",
    "drag_normal",
    "drag_tangential",
    "water_density_kg_per_m3",
];
const AT_REST: [&str; 5] = ["h_b_n", "v_b_n", "h_a_n", "v_a_n", "on_bed_m"];

/// Answers one line of text; `number` counts from 1.
pub(super) fn answer(text: &str, number: usize) -> Answered {
    let plain = |text: &str| Answered {
        text: text.to_owned(),
        is_line: false,
        refused: false,
    };
    if text.trim().is_empty() {
        return plain(text);
    }
    let place = |at: usize| {
        let before = text.get(..at).unwrap_or(text);
        format!("line {number}, column {}", before.chars().count() + 1)
    };
    let entries = match json::object(text) {
        Ok(entries) => entries,
        Err(fault) => {
            let status = format!("{}: {}", place(fault.at), fault.problem);
            return Answered {
                text: format!("{{\"status\": {}}}", quoted(&status)),
                is_line: true,
                refused: true,
            };
        }
    };
    let known = |key: &str| STILL.contains(&key) || MOVING.contains(&key);
    if !entries.iter().any(|(key, _)| known(key)) {
        return plain(text);
    }
    let moving = entries
        .iter()
        .any(|(key, _)| MOVING.contains(&key.as_str()));
    let solved = if moving {
        in_current(&entries)
    } else {
        at_rest(&entries)
    };
    let (numbers, status) = match solved {
        Ok(numbers) => (numbers, "ok".to_owned()),
        Err(Trouble { place: at, problem }) => {
            let told = at.map_or_else(
                || format!("line {number}: {problem}"),
                |(key, at)| format!("{}, {key}: {problem}", place(at)),
            );
            (Vec::new(), told)
        }
    };
    Answered {
        refused: status != "ok",
        text: with(text, &entries, &numbers, &status),
        is_line: true,
    }
}

/// The object as it was, answers of an earlier time left out, and these added.
fn with(text: &str, entries: &Entries, numbers: &Numbers, status: &str) -> String {
    let old = |key: &str| {
        AT_REST.contains(&key) || PULLS.contains(&key) || ["status", "shape"].contains(&key)
    };
    let mut parts: Vec<String> = entries
        .iter()
        .filter(|(key, _)| !old(key))
        .map(|(key, value)| {
            let value = text.get(value.at.clone()).unwrap_or("null");
            format!("\"{key}\": {value}")
        })
        .collect();
    parts.extend(
        numbers
            .iter()
            .map(|(name, number)| format!("\"{name}\": {number}")),
    );
    parts.push(format!("\"status\": {}", quoted(status)));
    format!("{{{}}}", parts.join(", "))
}

fn quoted(text: &str) -> String {
    let mut quoted = String::from('"');
    for c in text.chars() {
        match c {
            '"' | '\\' => quoted.extend(['\\', c]),
            c if c < ' ' => quoted += &format!("\\u{:04x}", u32::from(c)),
            c => quoted.push(c),
        }
    }
    quoted + "\""
}

fn find<'a>(entries: &'a Entries, keys: &[&str]) -> Result<Option<&'a (String, Value)>, Trouble> {
    let mut found = entries
        .iter()
        .filter(|(key, _)| keys.contains(&key.as_str()));
    let first = found.next();
    match found.next() {
        Some((key, value)) => Err(Trouble {
            place: Some((key.clone(), value.at.start)),
            problem: "given twice".into(),
        }),
        None => Ok(first),
    }
}

fn wanted(key: &str) -> Trouble {
    refused(format!("the key {key} is missing"))
}

fn wrong(key: &str, value: &Value, needs: &str) -> Trouble {
    Trouble {
        place: Some((key.to_owned(), value.at.start)),
        problem: format!("{needs} is needed"),
    }
}

fn number(entries: &Entries, keys: &[&str]) -> Result<Option<f64>, Trouble> {
    match find(entries, keys)? {
        None => Ok(None),
        Some((
            _,
            Value {
                kind: Kind::Number(n),
                ..
            },
        )) => Ok(Some(*n)),
        Some((
            _,
            Value {
                kind: Kind::Word, ..
            },
        )) if keys.len() == 1 => Ok(None),
        Some((key, value)) => Err(wrong(key, value, "a number")),
    }
}

fn needed(entries: &Entries, keys: &[&str]) -> Result<f64, Trouble> {
    number(entries, keys)?.ok_or_else(|| wanted(keys[0]))
}

/// A list of numbers, as many as these.
fn numbers(
    key: &str,
    value: &Value,
    counts: std::ops::RangeInclusive<usize>,
    needs: &str,
) -> Result<Vec<f64>, Trouble> {
    let Kind::List(items) = &value.kind else {
        return Err(wrong(key, value, needs));
    };
    let read = |item: &Value| match item.kind {
        Kind::Number(n) => Ok(n),
        _ => Err(wrong(key, item, "a number")),
    };
    let list: Vec<f64> = items.iter().map(read).collect::<Result<_, _>>()?;
    if counts.contains(&list.len()) {
        Ok(list)
    } else {
        Err(wrong(key, value, needs))
    }
}

/// Lists of numbers in a list.
fn rows(
    entries: &Entries,
    keys: &[&str],
    counts: std::ops::RangeInclusive<usize>,
    needs: &str,
) -> Result<Vec<Vec<f64>>, Trouble> {
    let (key, value) = find(entries, keys)?.ok_or_else(|| wanted(keys[0]))?;
    match &value.kind {
        Kind::List(items) if !items.is_empty() => items
            .iter()
            .map(|item| numbers(key, item, counts.clone(), needs))
            .collect(),
        _ => Err(wrong(key, value, &format!("a list of {needs}"))),
    }
}

fn sections(entries: &Entries) -> Result<Vec<SectionProps>, Trouble> {
    let needs = "[length_m, weight_n_per_m, ea_n] or [length_m, weight_n_per_m, ea_n, body_n]";
    let section = |n: Vec<f64>| SectionProps {
        clump_n: n.get(3).copied().unwrap_or(0.0),
        ..SectionProps::new(n[0], n[1], n[2])
    };
    let lists = rows(entries, &["sections", "segs"], 3..=4, needs)?;
    Ok(lists.into_iter().map(section).collect())
}

fn refused(problem: impl Into<String>) -> Trouble {
    Trouble {
        place: None,
        problem: problem.into(),
    }
}

fn at_rest(entries: &Entries) -> Result<Numbers, Trouble> {
    let sections = sections(entries)?;
    let anchored = find(entries, &["depth"])?.is_some() || find(entries, &["radius"])?.is_some();
    let below = number(entries, &["bed_below_a_m"])?.or(anchored.then_some(0.0));
    let (friction, slope) = (
        number(entries, &["friction"])?,
        number(entries, &["bed_slope_deg"])?,
    );
    if below.is_none() && (friction.unwrap_or(0.0) != 0.0 || slope.unwrap_or(0.0) != 0.0) {
        return Err(refused(
            "there is a slope or friction but no bed; give bed_below_a_m, 0 for a bed through A",
        ));
    }
    let line = Line {
        ends: Ends {
            x_m: needed(entries, &["x_m", "radius"])?,
            z_m: needed(entries, &["z_m", "depth"])?,
        },
        sections: &sections,
        bed: below.map(|below_a_m| Bed {
            below_a_m,
            slope_rad: slope.unwrap_or(0.0).to_radians(),
            friction: friction.unwrap_or(0.0),
        }),
        surface_above_a_m: number(entries, &["surface_above_a_m"])?,
    };
    let rest = line.solve().map_err(|why| refused(why.to_string()))?;
    let found = [
        rest.h_b_n,
        rest.v_b_n,
        rest.h_a_n,
        rest.v_a_n,
        rest.on_bed_m,
    ];
    let mut numbers: Numbers = AT_REST.into_iter().zip(found.map(shown)).collect();
    numbers.push(("shape", quoted(rest.shape_name())));
    Ok(numbers)
}

fn in_current(entries: &Entries) -> Result<Numbers, Trouble> {
    if let Some((key, value)) = entries
        .iter()
        .find(|(key, _)| STILL[2..].contains(&key.as_str()))
    {
        return Err(Trouble {
            place: Some((key.clone(), value.at.start)),
            problem: "a line in a current goes from a_m to b_m and has no bed; leave this key out"
                .into(),
        });
    }
    let point = |key: &'static str| -> Result<[f64; 3], Trouble> {
        let (_, value) = find(entries, &[key])?.ok_or_else(|| wanted(key))?;
        let list = numbers(key, value, 3..=3, "[x, y, z]")?;
        Ok([list[0], list[1], list[2]])
    };
    let current = rows(
        entries,
        &["current"],
        3..=3,
        "[depth_m, x_m_per_s, y_m_per_s]",
    )?;
    let line = InCurrent {
        a_m: point("a_m")?,
        b_m: point("b_m")?,
        sections: sections(entries)?,
        diameter_m: needed(entries, &["diameter_m"])?,
        drag_normal: needed(entries, &["drag_normal"])?,
        drag_tangential: number(entries, &["drag_tangential"])?.unwrap_or(0.0),
        water_density_kg_per_m3: number(entries, &["water_density_kg_per_m3"])?.unwrap_or(1025.0),
        current: current.into_iter().map(|u| [u[0], u[1], u[2]]).collect(),
    };
    let pulls = line.solve().map_err(refused)?;
    Ok(PULLS.into_iter().zip(pulls.numbers().map(shown)).collect())
}
