//! A chain at rest for 1,000 places of its fairlead: the library's call and MoorPy's function.

use std::hint::black_box;
use std::time::Instant;

use seacable::statics::catenary::{CatenaryLine, EndOffset, RigidBed, SectionProperties, Solution};

use crate::place::{Cost, Peer, Place, output};
use crate::table::Table;

const PLACES: usize = 1000;
const REPEATS: usize = 20;
/// Horizontal distances \[m\] that the places are spread over, and the height of all of them.
const X_M: [f64; 2] = [760.0, 790.0];
const Z_M: f64 = 186.0;
/// The chain of the VolturnUS-S platform.
const CHAIN: [SectionProperties; 1] = [SectionProperties {
    length_m: 850.0,
    weight_n_per_m: 5844.12,
    ea_n: 3.27e9,
    clump_n: 0.0,
}];
/// Tolerances of MoorPy on the places of the ends \[m\]: its default, and one near rounding.
const TOLERANCES_M: [&str; 2] = ["1e-6", "1e-10"];

pub(crate) fn run(place: &Place) {
    let mut table = Table::new(
        "A chain on the bed at rest, 1,000 places of the fairlead: time of all calls, error of the force by the greatest difference from here",
        &["of H", "of V"],
    );
    let across = |k: usize| X_M[0] + (X_M[1] - X_M[0]) * k as f64 / (PLACES - 1) as f64;
    let lines: Vec<_> = (0..PLACES).map(|k| line(across(k))).collect();
    let rests: Vec<Solution> = lines.iter().map(|line| line.solve().unwrap()).collect();
    let residual = rests.iter().map(|rest| rest.residual).fold(0.0, f64::max);
    let cold = least(|| {
        for line in &lines {
            let _ = black_box(black_box(line).solve());
        }
    });
    table.add(None, "each from nothing", &[residual; 2], of(cold));
    let warm = least(|| {
        let mut before = rests[0].clone();
        for line in &lines {
            before = black_box(line).solve_from(&before).unwrap();
        }
        black_box(before);
    });
    table.add(None, "each from the one before", &[residual; 2], of(warm));
    if place.has(Peer::MoorPy) {
        let rows: String = (0..PLACES)
            .map(|k| format!("{} {Z_M}\n", across(k)))
            .collect();
        let file = place.write("places.txt", &rows);
        for tolerance in TOLERANCES_M {
            let mut command = place.script("catenary.py");
            let [chain] = CHAIN;
            let numbers = [chain.length_m, chain.ea_n, chain.weight_n_per_m];
            command.args(numbers.map(|number| number.to_string()));
            command.arg(tolerance).arg(&file).arg("1");
            let text = output(&mut command);
            let forces = text.lines().filter(|row| !row.starts_with("inside"));
            let mut off = [0.0_f64; 2];
            for (row, rest) in forces.zip(&rests) {
                let numbers = row
                    .split_whitespace()
                    .map(|word| word.parse::<f64>().unwrap());
                let exact = [rest.h_b_n, rest.v_b_n];
                for (k, force) in numbers.enumerate() {
                    off[k] = off[k].max((force / exact[k] - 1.0).abs());
                }
            }
            let setting = format!("tolerance {tolerance} m");
            table.add(Some(Peer::MoorPy), setting, &off, place.cost(&command));
        }
    }
    table.remark("Here the error is the residual of a check in 30 digits, and the time that of calls of the library: no process is started.");
    table.remark("MoorDyn and CableDyn have no function for a line at rest.");
    table.print();
}

fn line(x_m: f64) -> CatenaryLine<'static> {
    CatenaryLine {
        ends: EndOffset { x_m, z_m: Z_M },
        sections: &CHAIN,
        bed: Some(RigidBed::default()),
        surface_above_a_m: None,
    }
}

fn of(seconds: f64) -> Cost {
    Cost {
        process: seconds,
        inside: Some(seconds),
    }
}

/// The least time of a call \[s\].
fn least(mut call: impl FnMut()) -> f64 {
    let time = |_| {
        let clock = Instant::now();
        call();
        clock.elapsed().as_secs_f64()
    };
    (0..REPEATS).map(time).fold(f64::INFINITY, f64::min)
}
