//! What is long, deep or much: expressions, chains of parameters, and short inputs that are made long where a file has words, lists and rows.

use std::fmt::Write as _;

use seacable::case::{self, edit};
use seacable::import::{self, ImportOptions};

use super::Target;
use super::cases::shown;
use super::place::{contained, file, path, put};

const MOORDYN: &str = include_str!("../../trials/files/loud_moordyn.txt");

pub(super) const ALL: &[Target] = &[
    Target {
        name: "expression",
        run: expression,
        seeds: || {
            lines(
                "1.05 * a_m\nmax(min(a_m, 3), atan2(1, b + z))\n(-b)^2 - -(a_m^2)\n2^(3^2) * 1e-3 + .5 + b\nsin(30 * pi / 180) / (1 + exp(-b))\n{a_m} - round(a_m / 7)",
            )
        },
        share: 400,
    },
    Target {
        name: "parameters",
        run: parameters,
        seeds: || {
            let chain = |count: usize, end: &str| {
                let rows = (1..count).map(|i| format!("p{i} = \"p{} + 1\"\n", i + 1));
                format!("{}p{count} = {end}\n", rows.collect::<String>()).into_bytes()
            };
            vec![
                chain(5, "1.0"),
                chain(60, "2"),
                chain(210, "3.5"),
                b"p1 = \"length_m\"\ndepth_m = 200.0\nradius_m = \"4 * depth_m\"\nlength_m = \"1.02 * sqrt(radius_m^2 + depth_m^2)\"\n".to_vec(),
            ]
        },
        share: 40,
    },
    Target {
        name: "long_words",
        run: long_words,
        seeds: || {
            lines(
                "\0\u{0}5\n\0\u{1}p\n\0\u{2}1\n\u{3}\u{4}a\n\0\u{5}0.5\n\0\u{6}7\n\0\u{7}line.rope.length_m",
            )
        },
        share: 20,
    },
    Target {
        name: "long_tables",
        run: long_tables,
        seeds: || lines("\u{4}\u{4}0.1 0 1 0 0.5 0\n\u{6}\u{8}0 0 0 0 0 0\n\u{7}\u{5}1"),
        share: 4,
    },
];

fn lines(text: &str) -> Vec<Vec<u8>> {
    text.lines().map(|line| line.as_bytes().to_vec()).collect()
}

/// A line case with parameters and a length.
fn line(parameters: &str, length: &str) -> String {
    format!(
        "case.title = \"A line\"\nmaterials.rope = {{ diameter_m = 0.1, mass_kg_per_m = 10.0, ea_n = 1e6 }}\n\
         line = [{{ name = \"rope\", material = \"rope\", length_m = {length}, segments = 3 }}]\n\
         ends.a = {{ name = \"ship\", kind = \"fixed\", position_m = [0.0, 0.0, -1.0] }}\nends.b = {{ name = \"low\", kind = \"payload\" }}\n\
         payload = {{ dry_mass_kg = 1000.0, wet_mass_kg = 900.0, drag_area_m2 = 1.0, added_mass_kg = 10.0 }}\n\
         current = {{ speed_m_per_s = 0.5 }}\nsolver.duration_s = 3.0\n{parameters}\n"
    )
}

/// What is read has a finite length in its range.
fn is_read(text: &str) -> bool {
    match case::parse(text, &file("case.toml")) {
        Ok(case) => {
            assert!(case.line[0].length_m.is_finite());
            true
        }
        Err(faults) => shown(&faults),
    }
}

/// An expression of parameters as a length, and typed for it.
fn expression(data: &[u8]) -> bool {
    let text = String::from_utf8_lossy(data).into_owned();
    let known = "parameters = { a_m = 100, b = 2.5, z = 0 }";
    let quoted = toml::Value::String(text.clone()).to_string();
    drop(edit::set(&line(known, "20.0"), "line.rope.length_m", &text));
    is_read(&line(known, &quoted))
}

/// The table of the parameters of a file.
fn parameters(data: &[u8]) -> bool {
    is_read(&line(
        &format!("[parameters]\n{}", contained(data)),
        "\"p1\"",
    ))
}

/// How often the rest is repeated, the place, and the rest.
fn parts(data: &[u8]) -> Option<(usize, u8, String)> {
    let [times, place, unit @ ..] = data else {
        return None;
    };
    let unit = contained(&unit[..unit.len().min(40)]);
    Some((1 << (times % 17), *place, unit))
}

/// A word of a hundred kilobytes at a place of a file.
fn long_words(data: &[u8]) -> bool {
    const LONGEST: usize = 100_000;
    let Some((times, place, unit)) = parts(data) else {
        return false;
    };
    let long = unit.repeat(times.min(LONGEST / unit.len().max(1)));
    let known = "parameters = { p = 5 }";
    let quoted = |text: &str| toml::Value::String(text.to_owned()).to_string();
    let plain = line(known, "5.0");
    match place % 8 {
        0 => is_read(&line(known, &long)),
        1 => is_read(&line(known, &quoted(&long))),
        2 => is_read(&line(known, &quoted(&format!("p + {long}")))),
        3 => is_read(&format!("{plain}{long} = 1\n")),
        4 => is_read(&plain.replace("\"ship\"", &quoted(&long))),
        5 => {
            let cells = quoted(&format!("current.speed_m_per_s\n{long}\n"));
            is_read(&format!(
                "{plain}load_cases = [{{ file = \"l.csv\" }}]\nfiles.\"l.csv\".text = {cells}\n"
            ))
        }
        6 => edit::set(&plain, "line.rope.length_m", &long).is_ok(),
        _ => edit::set(&plain, &long, "1").is_ok(),
    }
}

/// Tables of up to 65,536 rows that follow from one: the motion of a coupled body, the elevation of the sea.
fn long_tables(data: &[u8]) -> bool {
    let Some((rows, place, row)) = parts(data) else {
        return false;
    };
    let is_motion = place % 2 == 0;
    let step = 0.01 * f64::from(place / 2 + 1);
    let mut table = String::new();
    for i in 0..rows {
        let time = step * i as f64;
        let written = match is_motion {
            true => writeln!(table, "{time} {row}"),
            false => writeln!(table, "{time} {:.3}{row}", (0.7 * time).sin()),
        };
        written.unwrap();
    }
    let (mut text, mut options) = (MOORDYN.to_owned(), ImportOptions::default());
    if is_motion {
        put(&path("long_motion.txt"), table.as_bytes());
        options.motion = Some(path("long_motion.txt"));
    } else {
        put(&path("wave_elevation.txt"), table.as_bytes());
        text = text.replace("50 WtrDpth", "50 WtrDpth\n3 WaveKin");
    }
    let read = import::read(&text, &file("long.dat"), &options);
    read.map_or_else(|faults| shown(&faults), |_| true)
}
