//! What systems of lines in motion cost: `cargo bench --bench motion`. Least of many repeats.
#![expect(clippy::print_stdout, reason = "a bench prints its table")]

use std::hint::black_box;
use std::sync::atomic::AtomicBool;
use std::time::Instant;

use seacable::case::kind;
use seacable::dynamics::AlphaScheme;
use seacable::system::motion::border::Border;
use seacable::system::motion::run::run;
use seacable::system::motion::start::start;
use seacable::system::{SolvedSystem, SystemFile};

const HEAD: &str = "
[system]
title = \"bench\"
[materials.wire]
mass_kg_per_m = 20.0
diameter_m = 0.06
ea_n = 1e8
drag_normal = 1.2
added_mass_normal = 1.0
[solver]
duration_s = 60.0
error_estimate = false
";

fn main() {
    let plain = line(&[("bottom", "top", 130.0, 120)], "");
    let parted = line(
        &[("bottom", "middle", 65.0, 60), ("middle", "top", 65.0, 60)],
        "[points.middle]\nkind = \"free\"\n",
    );
    for (what, text) in [
        ("a line between held ends", &plain),
        ("the same in two parts, with a free point between", &parted),
    ] {
        let Some(cost) = iteration(text) else { return };
        println!("a Newton iteration of {what}: {:.1} ns a node", 1e9 * cost);
    }
    for lines in [1, 10, 100] {
        let Some(cost) = iteration(&star(lines)) else {
            return;
        };
        println!(
            "a Newton iteration of {lines} bridles of three lines: {:.1} ns a node",
            1e9 * cost
        );
    }
    hour();
}

/// Lines from point to point, between a held bottom and top.
fn line(lines: &[(&str, &str, f64, usize)], more: &str) -> String {
    let mut text = format!(
        "{HEAD}[points.top]\nkind = \"fixed\"\nposition_m = [60.0, 0.0, 0.0]\n\
         [points.bottom]\nkind = \"fixed\"\nposition_m = [0.0, 0.0, -100.0]\n{more}"
    );
    for (k, (from, to, length, segments)) in lines.iter().enumerate() {
        text += &format!(
            "[[lines]]\nname = \"l{k}\"\nfrom = \"{from}\"\nto = \"{to}\"\nmaterial = \"wire\"\nlength_m = {length:?}\nsegments = {segments}\n"
        );
    }
    text
}

/// Bridles side by side, each joined to the next.
fn star(count: usize) -> String {
    let mut text = HEAD.to_owned();
    for k in 0..count {
        let y = 30.0 * k as f64;
        text += &format!(
            "[points.t{k}]\nkind = \"fixed\"\nposition_m = [0.0, {y}, 0.0]\n\
             [points.b{k}]\nkind = \"fixed\"\nposition_m = [50.0, {y}, -100.0]\n\
             [points.j{k}]\nkind = \"free\"\nmass_kg = 500.0\n"
        );
        let next = if k + 1 < count {
            format!("j{}", k + 1)
        } else {
            format!("b{k}")
        };
        for (name, from, to, length) in [
            ("upper", format!("j{k}"), format!("t{k}"), 60.0),
            ("lower", format!("b{k}"), format!("j{k}"), 80.0),
            ("across", format!("j{k}"), next, 80.0),
        ] {
            text += &format!(
                "[[lines]]\nname = \"{name}{k}\"\nfrom = \"{from}\"\nto = \"{to}\"\nmaterial = \"wire\"\nlength_m = {length:?}\nsegments = 20\n"
            );
        }
    }
    text
}

fn solved(text: &str) -> Option<SolvedSystem> {
    kind::parse::<SystemFile>(text, "bench.toml").ok()
}

/// Seconds of an iteration by node.
fn iteration(text: &str) -> Option<f64> {
    let begun = start(&solved(text)?, 1.0).ok()?;
    let mut border = Border::new(&begun.system, &begun.state);
    let factors = AlphaScheme::new(0.4).factors(0.05);
    let nodes: usize = begun.state.lines.iter().map(|line| line.x.len()).sum();
    let whole = least(2_000.min(400_000 / nodes), || {
        let _ = black_box(border.solve(&begun.system, 0.0, &begun.state, factors));
    });
    Some(whole / nodes as f64)
}

/// An hour of VolturnUS-S with its fairleads moved, three lines of 50 segments.
fn hour() {
    let text = include_str!("../cases/systems/volturnus.toml")
        .replacen(
            "kind = \"held\"",
            "kind = \"moved\"\namplitude_m = [1.5, 0.0, 1.0]\namplitude_deg = [0.0, 1.5, 0.0]\n\
             period_s = [60.0, 10.0, 10.0, 10.0, 10.0, 10.0]\nphase_deg = [0.0, 0.0, 30.0, 0.0, 90.0, 0.0]\nramp_s = 20.0",
            1,
        )
        .replacen("ea_n =", "drag_normal = 1.11\ndrag_tangential = 0.2\nadded_mass_normal = 0.82\naxial_damping_n_s = 1e7\nea_n =", 1)
        .replacen("repeat_at_deg", "segments = 50\nrepeat_at_deg", 1);
    for step in [0.1, 0.25, 0.5] {
        let more = format!(
            "\n[solver]\nduration_s = 3600.0\ntime_step_s = {step:?}\nerror_estimate = false\n"
        );
        let Some(system) = solved(&format!("{text}{more}")) else {
            return;
        };
        let Some(given) = system.file.solver.clone() else {
            return;
        };
        let mut rate = (0, 0);
        let time = least(3, || {
            if let Ok(run) = run(&system, &given, &AtomicBool::new(false), &mut |_| {}) {
                rate = (run.work.steps, run.work.iterations);
            }
        });
        println!(
            "an hour of VolturnUS-S with moved fairleads in steps of {step} s: {time:.2} s, {} steps, {} iterations",
            rate.0, rate.1
        );
    }
}

/// The least time of a call \[s\].
fn least(repeats: usize, mut call: impl FnMut()) -> f64 {
    let mut best = f64::INFINITY;
    for _ in 0..repeats {
        let clock = Instant::now();
        call();
        best = best.min(clock.elapsed().as_secs_f64());
    }
    best
}
