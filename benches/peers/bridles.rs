//! Bridles around a circle at rest: the program and MoorPy.

use std::f64::consts::TAU;

use crate::place::{Peer, Place, output};
use crate::table::Table;

/// Lines, three to a bridle.
const SIZES: [usize; 2] = [99, 300];
/// Tolerances of MoorPy on places \[m\]: its default, and one at which places have the digits of those here.
const TOLERANCES_M: [&str; 2] = ["0.05", "1e-6"];

const DIAMETER_M: f64 = 0.06;
const MASS_KG_PER_M: f64 = 20.0;
const EA_N: f64 = 1e8;
const JOINT_KG: f64 = 500.0;
const UPPER_M: f64 = 120.0;
const LOWER_M: f64 = 95.0;
/// The program finds the joints from nothing; MoorPy begins at this radius and height.
const BEGIN_M: [f64; 2] = [260.0, -110.0];

pub(crate) fn run(place: &Place) {
    for lines in SIZES {
        let title = format!(
            "{lines} lines of {} bridles at rest: error by the greatest difference of the places of the joints from here",
            lines / 3
        );
        let mut table = Table::new(&title, &["places, m"]);
        let file = place.write("bridles.toml", &here(lines / 3));
        let said = output(place.run(&file).arg("--json"));
        let said: serde_json::Value = serde_json::from_str(&said).unwrap();
        let exact = joints(&said);
        let residual = said["residual_n"].as_f64().unwrap();
        table.add(
            None,
            "with its analyses",
            &[0.0],
            place.cost(&place.run(&file)),
        );
        if place.has(Peer::MoorPy) {
            let file = place.write("bridles.txt", &moorpy(lines / 3));
            for tolerance in TOLERANCES_M {
                let mut command = place.script("bridles.py");
                command.arg(&file).arg(tolerance);
                let text = output(&mut command);
                let rows = text.lines().filter(|row| !row.starts_with("inside"));
                let mut off = 0.0_f64;
                for (row, joint) in rows.zip(&exact) {
                    let numbers = row
                        .split_whitespace()
                        .map(|word| word.parse::<f64>().unwrap());
                    let squares = numbers.zip(joint).map(|(a, b)| (a - b).powi(2));
                    off = off.max(squares.sum::<f64>().sqrt());
                }
                let setting = format!("tolerance {tolerance} m");
                table.add(Some(Peer::MoorPy), setting, &[off], place.cost(&command));
            }
        }
        table.remark(format!("Here no point is off balance by more than {residual:.0e} N; lines are closed forms, as in MoorPy. Analyses: stability, tensions, clearances."));
        table.remark("MoorDyn and CableDyn come to rest with divided lines: another problem.");
        table.print();
    }
}

/// Places of the free points.
fn joints(said: &serde_json::Value) -> Vec<[f64; 3]> {
    let points = said["points"].as_array().unwrap().iter();
    let free = points.filter(|point| point["held"] == "free");
    let coordinate = |point: &serde_json::Value, axis: usize| point["position_m"][axis].as_f64();
    free.map(|point| [0, 1, 2].map(|axis| coordinate(point, axis).unwrap()))
        .collect()
}

/// Where a bridle is held: above, and its two anchors.
fn held(number: usize, count: usize) -> [[f64; 3]; 3] {
    let (sin, cos) = (TAU * number as f64 / count as f64).sin_cos();
    let at = |beside: f64, z: f64| [300.0 * cos - beside * sin, 300.0 * sin + beside * cos, z];
    [at(0.0, 0.0), at(-40.0, -200.0), at(40.0, -200.0)]
}

/// The system here.
fn here(count: usize) -> String {
    let mut text = format!(
        "[system]\ntitle = \"Bridles\"\n[environment]\ngravity_m_per_s2 = 9.80665\nwater_density_kg_per_m3 = 1025.0\n\
         [materials.wire]\nmass_kg_per_m = {MASS_KG_PER_M:?}\ndiameter_m = {DIAMETER_M:?}\nea_n = {EA_N:?}\n"
    );
    for k in 0..count {
        text += &format!("[points.j{k}]\nkind = \"free\"\nmass_kg = {JOINT_KG:?}\n");
        for (end, at) in held(k, count).iter().enumerate() {
            text += &format!("[points.h{k}-{end}]\nkind = \"fixed\"\nposition_m = {at:?}\n");
        }
    }
    for k in 0..count {
        for (end, length) in [UPPER_M, LOWER_M, LOWER_M].iter().enumerate() {
            text += &format!(
                "[[lines]]\nname = \"l{k}-{end}\"\nfrom = \"j{k}\"\nto = \"h{k}-{end}\"\nmaterial = \"wire\"\nlength_m = {length:?}\n"
            );
        }
    }
    text
}

/// The file of the script.
fn moorpy(count: usize) -> String {
    let mut text = format!("line_type {DIAMETER_M} {MASS_KG_PER_M} {EA_N}\n");
    for k in 0..count {
        let (sin, cos) = (TAU * k as f64 / count as f64).sin_cos();
        let [radius, z] = BEGIN_M;
        text += &format!(
            "point free {} {} {z} {JOINT_KG}\n",
            radius * cos,
            radius * sin
        );
        for [x, y, z] in held(k, count) {
            text += &format!("point fixed {x} {y} {z} 0\n");
        }
        let joint = 4 * k + 1;
        for (end, length) in (1..).zip([UPPER_M, LOWER_M, LOWER_M]) {
            // From the lower end, as MoorPy has its lines.
            let [a, b] = if end == 1 {
                [joint, joint + 1]
            } else {
                [joint + end, joint]
            };
            text += &format!("line {a} {b} {length}\n");
        }
    }
    text
}
