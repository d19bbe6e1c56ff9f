//! Three chains with moved fairleads, in still water and in waves: this program, MoorDyn and CableDyn.

use std::path::PathBuf;
use std::process::Command;

use crate::chains::{self, LINE_HERE, Sea};
use crate::histories::{History, errors, printed, stored};
use crate::place::{Peer, Place, output};
use crate::table::Table;

/// Segments of a line for the histories that count as true.
const FINE: usize = 200;
/// Steps for these \[s\], in MoorDyn and in CableDyn.
const FINE_STEP_S: f64 = 0.002;
const FINE_STEP_CABLE_DYN_S: f64 = 0.01;

/// Segments of a line, calls or rows of the motion \[s\], and keys of the solver.
type SettingHere = (usize, f64, &'static str);
/// Segments, the largest stable step \[s\] that divides the calls, and calls \[s\].
type SettingMoorDyn = (usize, f64, f64);
/// Segments and steps, which are the calls \[s\].
type SettingCableDyn = (usize, f64);

struct Scene {
    title: &'static str,
    sea: Sea,
    here: &'static [SettingHere],
    moordyn: &'static [SettingMoorDyn],
    cable_dyn: &'static [SettingCableDyn],
}

const HEADS: [&str; 2] = ["end B, %", "end A, %"];
const COARSE_STEPS: &str = "time_step_s = 0.25";

pub(crate) fn in_waves(place: &Place) {
    let scene = Scene {
        title: "Three chains in waves: 120 s, fairleads moved 3 m in 12 s, 100 components of JONSWAP, Hs 6 m, Tp 10 s",
        sea: Sea::Grid,
        here: &[
            (50, 0.1, ""),
            (20, 0.1, ""),
            (20, 0.1, COARSE_STEPS),
            (100, 0.1, COARSE_STEPS),
        ],
        moordyn: &[(50, 0.01, 0.1), (100, 0.005, 0.1)],
        cable_dyn: &[],
    };
    let (mut table, exact) = scene.compute(place);
    if let Some(exact) = exact {
        let mut command = moordyn(place, (50, 0.01, 0.1), Sea::Summed);
        let text = output(&mut command);
        let cost = place.cost_once(&command);
        table.add(
            Some(Peer::MoorDyn),
            "50 segments, steps 10 ms, waves at the nodes, one run",
            &ends(errors(&printed(&text), &exact)),
            cost,
        );
    }
    table.remark(
        "CableDyn: its library takes no waves of a deck (CableDyn_InitDeck fails with BAD_INPUT).",
    );
    table.remark("MoorPy has no motion in time.");
    table.print();
}

pub(crate) fn in_still_water(place: &Place) {
    let scenes = [
        Scene {
            title: "Three chains in still water: 120 s, fairleads moved 3 m in 12 s, calls each 0.1 s",
            sea: Sea::Still,
            here: &[
                (50, 0.1, ""),
                (20, 0.1, ""),
                (20, 0.1, COARSE_STEPS),
                (100, 0.1, COARSE_STEPS),
            ],
            moordyn: &[(50, 0.01, 0.1), (100, 0.005, 0.1)],
            cable_dyn: &[(50, 0.1), (20, 0.1)],
        },
        Scene {
            title: "The same, calls each 0.5 s",
            sea: Sea::Still,
            here: &[
                (50, 0.5, ""),
                (20, 0.5, ""),
                (20, 0.5, COARSE_STEPS),
                (100, 0.5, COARSE_STEPS),
            ],
            moordyn: &[(50, 0.01, 0.5)],
            cable_dyn: &[(50, 0.5), (20, 0.5)],
        },
    ];
    for scene in scenes {
        let (mut table, _) = scene.compute(place);
        table.remark("MoorPy has no motion in time.");
        table.print();
    }
}

/// Errors at end B and end A.
fn ends([a, b]: [f64; 2]) -> [f64; 2] {
    [b, a]
}

impl Scene {
    /// Its rows, and MoorDyn's converged history.
    fn compute(&self, place: &Place) -> (Table, Option<History>) {
        let mut table = Table::new(self.title, &HEADS);
        let exact = self.add_here(place, &mut table);
        let mut converged = None;
        if place.has(Peer::MoorDyn) {
            let history = self.add_moordyn(place, &mut table);
            let apart = ends(errors(&history, &exact));
            table.remark(apart_by(Peer::MoorDyn, apart));
            converged = Some(history);
        }
        if place.has(Peer::CableDyn) && !self.cable_dyn.is_empty() {
            let history = self.add_cable_dyn(place, &mut table);
            let apart = ends(errors(&history, &exact));
            table.remark(apart_by(Peer::CableDyn, apart));
        }
        (table, converged)
    }

    fn add_here(&self, place: &Place, table: &mut Table) -> History {
        let write = |name: &str, segments, call_s, solver: &str| -> PathBuf {
            let text = chains::here(segments, call_s, self.sea, solver);
            place.write(&format!("{name}.toml"), &text)
        };
        let history = |file: &PathBuf| {
            let stored_in = file.with_extension("run");
            output(place.run(file).arg("--out").arg(&stored_in));
            stored(&stored_in, LINE_HERE)
        };
        let id = format!("{:?}{}", self.sea, self.here[0].1);
        let fine = write(&format!("fine{id}"), FINE, 0.02, "step_tolerance = 1e-8");
        let exact = history(&fine);
        for (number, (segments, call_s, solver)) in self.here.iter().enumerate() {
            let file = write(&format!("here{id}{number}"), *segments, *call_s, solver);
            let found = errors(&history(&file), &exact);
            let settings = if solver.is_empty() {
                "default settings".to_owned()
            } else {
                solver.replace("time_step_s = ", "steps ") + " s"
            };
            let setting = format!("{segments} segments, {settings}");
            let cost = place.cost(&place.run(&file));
            table.add(None, setting, &ends(found), cost);
        }
        exact
    }

    fn add_moordyn(&self, place: &Place, table: &mut Table) -> History {
        let fine = (FINE, FINE_STEP_S, FINE_STEP_S);
        let name = format!("moordyn-fine-{:?}", self.sea);
        let exact = printed(&place.kept(&name, &mut moordyn(place, fine, self.sea)));
        for setting in self.moordyn {
            let (segments, step_s, call_s) = *setting;
            let mut command = moordyn(place, *setting, self.sea);
            let found = errors(&printed(&output(&mut command)), &exact);
            let waves = if self.sea == Sea::Grid {
                ", waves on a grid"
            } else {
                ""
            };
            let name = format!(
                "{segments} segments, steps {} ms, calls {call_s} s{waves}",
                1e3 * step_s
            );
            let cost = place.cost(&command);
            table.add(Some(Peer::MoorDyn), name, &ends(found), cost);
        }
        exact
    }

    fn add_cable_dyn(&self, place: &Place, table: &mut Table) -> History {
        let fine = (FINE, FINE_STEP_CABLE_DYN_S);
        let exact = printed(&place.kept("cable_dyn-fine", &mut cable_dyn(place, fine)));
        for setting in self.cable_dyn {
            let (segments, step_s) = *setting;
            let mut command = cable_dyn(place, *setting);
            let found = errors(&printed(&output(&mut command)), &exact);
            let name = format!("{segments} segments, steps {step_s} s");
            let cost = place.cost(&command);
            table.add(Some(Peer::CableDyn), name, &ends(found), cost);
        }
        exact
    }
}

fn apart_by(peer: Peer, [b, a]: [f64; 2]) -> String {
    let name = peer.name();
    format!(
        "Converged histories of {name} and here differ by {b:.3} % at end B and {a:.3} % at end A."
    )
}

/// The command that runs the chains in MoorDyn, in a folder of their own.
fn moordyn(place: &Place, (segments, step_s, call_s): SettingMoorDyn, sea: Sea) -> Command {
    let folder = format!("moordyn{segments}-{step_s}-{call_s}-{sea:?}");
    let write = |name: &str, text: &str| place.write(&format!("{folder}/{name}"), text);
    match sea {
        Sea::Still => {}
        Sea::Grid => {
            write("wave_elevation.txt", &crate::waves::elevation());
            write("water_grid.txt", &crate::waves::grid());
        }
        Sea::Summed => {
            write("wave_frequencies.txt", &crate::waves::frequencies());
        }
    }
    let file = write("chains.dat", &chains::moordyn(segments, step_s, sea));
    let table = write("motion.txt", &chains::moordyn_motion(call_s));
    let mut command = place.script("march.py");
    command.args([file, table]);
    command.args([chains::calls_a_row(call_s).to_string(), "1".to_owned()]);
    command
}

/// The command that runs the chains in CableDyn.
fn cable_dyn(place: &Place, (segments, step_s): SettingCableDyn) -> Command {
    let name = format!("cable_dyn{segments}-{step_s}");
    let file = place.write(&format!("{name}.dat"), &chains::cable_dyn(segments, step_s));
    let table = place.write(&format!("{name}.txt"), &chains::cable_dyn_motion(step_s));
    let mut command = place.script("cable_dyn.py");
    command.args([file, table]);
    command.arg(chains::calls_a_row(step_s).to_string());
    command
}
