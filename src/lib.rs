//! seacable: a terminal workbench for marine cables.
//!
//! The map of the house. Data flows one way:
//!
//! ```text
//! case file ──▶ case ──▶ scene ──▶ statics, dynamics ──▶ run ──▶ report, tui, cli
//! (TOML)        words    numbers   solvers               what    views of the same run
//!               + units  in SI                           came out
//! ```
//!
//! * [`case`]: the file format: fields with units, ranges, defaults and help; checks; edits that keep comments.
//! * [`physics`]: one file a force; knows no solver.
//! * [`scene`]: a case made ready to compute: nodes, segments, ends, loads, in SI.
//! * [`numerics`]: block bands, roots, interpolation, statistics; knows no cable.
//! * [`solve`]: the trait between physics and numerics, and the one Newton loop.
//! * [`statics`], [`dynamics`]: equilibrium, quasi-static march, RK4, generalized-alpha.
//! * [`modes`]: natural frequencies and mode shapes about the static shape.
//! * [`run`]: a case computed: history, shapes, summary with errors, cost; jobs on threads; the store.
//! * [`section`]: the cross-section designer: from units, layers and armour to the material of a line.
//! * [`ship`]: a ship at single-point mooring: what acts on it, and where it rests.
//! * [`kinds`]: which of these a file is.
//! * [`reference`](mod@reference): published data and how a run is held against it.
//! * [`study`]: hard cases, computed by every method that applies and judged.
//! * [`report`]: tables and charts as text, shared by every view.
//! * [`files`]: the one way to write a file; [`visible`]: the one way out for text.
//! * [`tui`], [`cli`]: the screen and the command line.
//!
//! Conventions: SI inside, z up with z = 0 at still water, arc length from end A to end B in the
//! order in which the case lists its sections, angles in radians inside and in degrees in files.

pub mod case;
pub mod cli;
pub mod dynamics;
pub mod files;
pub mod kinds;
pub mod modes;
pub mod numerics;
pub mod physics;
pub mod reference;
pub mod report;
pub mod ropeway;
pub mod run;
pub mod scene;
pub mod section;
pub mod ship;
pub mod solve;
pub mod statics;
pub mod study;
pub mod tui;
pub mod visible;
