//! seacable: a terminal workbench for marine cables.
//!
//! Data flows one way:
//!
//! ```text
//! case file ──▶ case ──▶ scene ──▶ statics, dynamics ──▶ run ──▶ report, tui, cli
//! (TOML)        typed    nodes,    solvers               results  views of the same run
//!               keys     forces                          with
//!               + units  in SI                           errors
//! ```
//!
//! The floors of the program are crates below `src`; each stands on those above it in this list alone. This crate shows their
//! rooms under one name.
//!
//! * [`numerics`]: block bands, roots, interpolation, statistics; no cable.
//! * [`physics`]: one file a force; no solver.
//! * Base: [`files`], the one way to write a file and to read one; [`visible`], the one way out for text; [`number`]: numbers as
//!   text; [`limits`], [`places`], [`clock`], [`background`], [`crash_log`].
//! * Display: [`table`], [`chart`], [`plain`]: tables and charts in characters, of anything.
//! * Statistics: [`extremes`] of records, [`fatigue`].
//! * [`keys`]: what a file in TOML may say: declarations, tree, edits that keep comments, expressions, diagnostics; no cable.
//! * Model: [`case`](mod@case), the case file: typed keys with units, ranges, defaults and help, and its checks; [`section`], the
//!   cross-section designer: from units, layers and armour to the material of a line; [`line_types`]: chains, wire ropes and fibre
//!   ropes by nominal diameter, from published formulas; [`checks`]: limits of standards; [`published`] numbers; [`templates`] of
//!   new files; [`kinds`]: which kind a file is.
//! * Engine: [`scene`], a case in SI: nodes, segments, forces as elements; [`solve`], what solvers ask of a system, and Newton's
//!   method; [`statics`], [`dynamics`]: equilibrium, quasi-static march, RK4, generalized-alpha; [`line_between_ends`]: a line at
//!   rest as an element of a system; [`modes`]: natural frequencies and mode shapes about the static shape.
//! * Runs: [`run`], a case computed: history, shapes, summary with errors, cost; the store; [`reference`](mod@reference):
//!   published data and how a run compares with them.
//! * Systems: [`system`], systems of lines at rest and in motion: points, bodies, lines; [`ship`]: a ship at single-point mooring:
//!   loads, equilibria, motion; [`ropeway`]: a ropeway between a platform and a ship.
//! * Foreign: [`import`], files of other programs: MoorDyn, MoorPy, MAP++; [`open`]: files of any kind; [`export`]; [`audit`].
//! * Studies: [`study`]: sweeps, seas, effects, hard cases by every method that applies, speed against error, tables of lines;
//!   [`comparison`]: stored runs compared: inputs, results with error bars, curves.
//! * What measures the program: [`laboratory`]: random systems, error bars and accuracies held against the truth.
//! * [`report`]: figures and pages of every result, shared by every view.
//! * [`jobs`]: runs and load cases as processes that outlive the screen.
//! * [`tui`], [`cli`]: the screen and the command line.
//!
//! The chapter [`equations`] states what is solved. Two examples build lines in code: `examples/hanging_line.rs` and
//! `examples/moored_line_in_waves.rs`.
//!
//! Conventions: SI inside, z up with z = 0 at still water, arc length from end A to end B in the
//! order in which the case lists its sections, angles in radians inside and in degrees in files.

pub mod equations;

pub use seacable_base::{background, clock, crash_log, files, limits, number, places, visible};
pub use seacable_cli as cli;
pub use seacable_display::{chart, plain, table};
pub use seacable_engine::{dynamics, line_between_ends, modes, scene, solve, statics};
pub use seacable_foreign::{audit, export, import, open};
pub use seacable_jobs as jobs;
pub use seacable_keys as keys;
pub use seacable_model::{case, checks, kinds, line_types, published, section, templates};
pub use seacable_numerics as numerics;
pub use seacable_physics as physics;
pub use seacable_report as report;
pub use seacable_runs::{reference, run};
pub use seacable_statistics::{extremes, fatigue};
pub use seacable_studies::{comparison, laboratory, study};
pub use seacable_systems::{ropeway, ship, system};
pub use seacable_tui as tui;
