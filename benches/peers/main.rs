//! This program and its peers side by side: CPU time against error, both sides in one run.
//!
//! Peers are MoorDyn, MoorPy and CableDyn, each a Python package at a cheap setting. A time is the least of repeats. It is that of the whole
//! process, with the start of Python and the import of packages; beside it stands what the calls take inside that process, without the
//! import. How many times slower a peer is takes the latter, against the whole process here. Runs here are written to memory where
//! there is a disk of it.
//!
//! Errors in motion are root mean square differences of the tensions at the ends of a line from the program's own history on four times
//! as many segments in much shorter steps, by its peak: what mesh, steps and calls cost, and no difference of the models. What the
//! converged histories differ by is stated too.
//!
//! Needs Python with the packages `moordyn`, `moorpy` and `cabledyn`, named by `PEERS_PYTHON`: `cargo bench --bench peers`. A package that
//! is missing is left out. `SEACABLE_BINARY` names another build of the program, and arguments name the scenes to run.
#![expect(
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "a bench prints its table and may stop at a fault"
)]

mod bridles;
mod catenary;
mod chains;
mod histories;
mod lines;
mod lowering_and_mooring;
mod moved;
mod place;
mod table;
mod waves;

use place::Place;

/// A scene: its name, and what computes it and prints its rows.
type Scene = (&'static str, fn(&Place));

const SCENES: [Scene; 5] = [
    ("lines", lowering_and_mooring::run),
    ("waves", moved::in_waves),
    ("still", moved::in_still_water),
    ("catenary", catenary::run),
    ("bridles", bridles::run),
];

fn main() {
    let Ok(python) = std::env::var("PEERS_PYTHON") else {
        println!(
            "not run: PEERS_PYTHON names no Python with the packages moordyn, moorpy, cabledyn"
        );
        return;
    };
    let place = Place::new(&python);
    place.introduce();
    let asked: Vec<String> = std::env::args().skip(1).collect();
    let asked = |name: &str| {
        let mut names = asked
            .iter()
            .filter(|word| !word.starts_with('-'))
            .peekable();
        names.peek().is_none() || names.any(|word| word == name)
    };
    for (name, scene) in SCENES {
        if asked(name) {
            scene(&place);
        }
    }
}
