//! Lines of ropes that creep: at rest, in stages of slow stretch, against an equation of their own, and their energy.

use std::sync::atomic::AtomicBool;

use rayon::prelude::*;
use seacable::physics::rope::TensionTable;
use seacable::system::motion::run::{MotionRun, run};
use seacable::system::motion::start::start;

use crate::motion::{channel, moved};
use crate::{HEAD, solved, tensions};

const POLYESTER: &str = include_str!("../../cases/systems/polyester_stages.toml");

/// The polyester line with other words.
fn polyester(changes: &[(&str, &str)]) -> MotionRun {
    let mut text = POLYESTER.to_owned();
    for (from, to) in changes {
        assert!(text.contains(from), "{from}");
        text = text.replace(from, to);
    }
    text = text.replace("[solver]", "[solver]\nerror_estimate = false");
    let system = solved(&text);
    let given = system.file.solver.clone().unwrap();
    let run = run(&system, &given, &AtomicBool::new(false), &mut |_| {}).unwrap();
    assert_eq!(run.failure, None);
    run
}

/// The original curve.
fn original() -> TensionTable {
    let system = solved(POLYESTER);
    let material = &system.file.materials["polyester"];
    material.tension_table().unwrap()
}

/// The shapes of the source's three tests with their parameters, and the tension by the greatest one of each at a place from 0 to 1.
type Shape = (&'static str, f64, fn(f64) -> f64);
const SHAPES: [Shape; 3] = [
    (
        "working_curve = \"linear\"\nworking_curve_ea_n = 1.25e8",
        0.0,
        |s| s,
    ),
    (
        "working_curve = \"quadratic\"\nworking_curve_shape = 1.0\npermanent_strain_ratio = 0.25",
        0.25,
        |s| s * s,
    ),
    (
        "working_curve = \"exponential\"\nworking_curve_shape = 1.5\npermanent_strain_ratio = 0.2",
        0.2,
        |s| ((1.5 * s).exp() - 1.0) / (1.5_f64.exp() - 1.0),
    ),
];

/// The tension of a working curve, as the source states it.
fn working((_, ratio, shape): &Shape, strain: f64, peak: f64, greatest: f64) -> f64 {
    let width = match *ratio > 0.0 {
        true => (1.0 - ratio) * peak,
        false => greatest / 1.25e8,
    };
    greatest * shape(((strain - (peak - width)) / width).max(0.0))
}

const LINEAR: &str = "working_curve = \"linear\"\nworking_curve_ea_n = 1.25e8";

/// At rest a rope has the tension of its curve at its strain; a viscoelastic one its static stiffness.
#[test]
fn ropes_at_rest_follow_their_curves() {
    let original = original();
    for shape in &SHAPES {
        for (e, past) in [
            (0.0148657, 1.3886e6),
            (0.02, 1.3886e6),
            (0.04, 1.3886e6),
            (0.03, 3.5e6),
        ] {
            let text = POLYESTER
                .replace(LINEAR, shape.0)
                .replace("101.48657", &format!("{:?}", 100.0 * (1.0 + e)))
                .replace("1.3886e6", &format!("{past:?}"));
            let found = tensions(&solved(&text), "rope")[1];
            let peak = original.strain_at(past);
            let expected = match e > peak {
                true => original.at(e).tension,
                false => working(shape, e, peak, past),
            };
            assert!(
                (found / expected - 1.0).abs() < 1e-6,
                "{shape:?} {e} {found} {expected}"
            );
        }
    }
}

/// Stages of stretch, after MoorDyn's tests of its Syrope model (tests/syrope.cpp), which hold the tension to the curves within 5 %: here at
/// the end of each hold.
#[test]
fn stages_end_on_the_working_and_original_curves() {
    let original = original();
    SHAPES.par_iter().for_each(|shape| {
        let run = polyester(&[(LINEAR, shape.0)]);
        let found = channel(&run, "tension_n[rope|b]");
        let (e, past) = (0.0148657, 1.3886e6);
        let greatest = original.at(3.0 * e).tension;
        let stages = [
            (30, working(shape, e, original.strain_at(past), past)),
            (90, greatest),
            (150, working(shape, 2.0 * e, 3.0 * e, greatest)),
        ];
        for (row, expected) in stages {
            let off = found[row] / expected - 1.0;
            assert!(off.abs() < 1e-4, "{shape:?} {row}: {off:e}");
        }
        assert!(run.balance.relative_drift() < 1e-3, "{:?}", run.balance);
    });
}

/// A light viscoelastic line between a fixed point and one that moves, against its equation solved by a march of its own:
/// with the slow strain z, `(S + F) z' = K (e - z) - k z + F e'` and `T = k z + S z'`.
#[test]
fn a_moved_line_follows_the_equation_of_its_parts() {
    const EA: f64 = 1.4e8;
    const DYNAMIC: f64 = 4e8;
    const SLOW: f64 = 2e9;
    const FAST: f64 = 1e7;
    let text = format!(
        "{HEAD}[materials.rope]\ndiameter_m = 0.1\nmass_kg_per_m = 1e-4\nwet_weight_kg_per_m = 0.0\nadded_mass_normal = 0.0\nea_n = {EA:?}
        creep_model = \"viscoelastic\"\ndynamic_ea_n = {DYNAMIC:?}\nslow_damping_n_s = {SLOW:?}\nfast_damping_n_s = {FAST:?}
        [points.a]\nkind = \"fixed\"\nposition_m = [0.0, 0.0, -5.0]
        [points.b]\nkind = \"moved\"\nposition_m = [102.0, 0.0, -5.0]\namplitude_m = [0.5, 0.0, 0.0]\nperiod_s = 20.0\nramp_s = 20.0
        [[lines]]\nname = \"rope\"\nfrom = \"a\"\nto = \"b\"\nmaterial = \"rope\"\nlength_m = 100.0\nsegments = 8
        [solver]\nduration_s = 40.0\ntime_step_s = 0.005\nerror_estimate = false\n[output]\ninterval_s = 4.0\n"
    );
    let begun = start(&solved(&text), 1.0).unwrap();
    let point = begun.system.network.point("b").unwrap();
    let motion = begun.system.network.points[point].motion.clone().unwrap();
    let soft = 1.0 / (1.0 / EA - 1.0 / DYNAMIC);
    let strain = |t: f64| {
        let (x, v, _) = motion.at(t);
        (x.x / 100.0 - 1.0, v.x / 100.0)
    };
    let rate = |t: f64, z: f64| {
        let (e, de) = strain(t);
        (DYNAMIC * (e - z) - soft * z + FAST * de) / (SLOW + FAST)
    };
    let run = moved(text.strip_prefix(HEAD).unwrap());
    let found = channel(&run, "tension_n[rope|a]");
    let (mut z, h) = (strain(0.0).0 * EA / soft, 1e-3);
    for step in 0..40_000 {
        let t = f64::from(step) * h;
        if step % 4000 == 0 {
            let expected = soft * z + SLOW * rate(t, z);
            let off = found[step as usize / 4000] / expected - 1.0;
            assert!(off.abs() < 1e-6, "{t}: {off:e}");
        }
        let k1 = rate(t, z);
        let k2 = rate(t + 0.5 * h, z + 0.5 * h * k1);
        let k3 = rate(t + 0.5 * h, z + 0.5 * h * k2);
        let k4 = rate(t + h, z + h * k3);
        z += h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
    }
}

/// A clump on a Syrope rope that creeps from a low mean tension, in heave: both methods agree, and the energy balances.
#[test]
fn both_methods_agree_and_their_energy_balances() {
    let text = |method: &str, model: &str| {
        format!(
            "[materials.rope]\ndiameter_m = 0.06\nmass_kg_per_m = 3.0\ndrag_normal = 1.2\nadded_mass_normal = 1.0\n{model}
            dynamic_ea_n = 6e6\ndynamic_ea_per_tension = 10.0\nslow_damping_n_s = 4e7\nfast_damping_n_s = 5e4\ninitial_mean_tension_n = 2e4
            [points.top]\nkind = \"moved\"\nposition_m = [0.0, 0.0, 0.0]\namplitude_m = [0.4, 0.0, 0.8]\nperiod_s = 7.0\nramp_s = 7.0
            [points.clump]\nkind = \"free\"\nmass_kg = 4000.0\nvolume_m3 = 0.5\nadded_mass_kg = 1000.0\ndrag_area_m2 = 2.0
            [[lines]]\nname = \"rope\"\nfrom = \"top\"\nto = \"clump\"\nmaterial = \"rope\"\nlength_m = 80.0\nsegments = 10
            [solver]\nduration_s = 20.0\n{method}\nerror_estimate = false\n[output]\ninterval_s = 0.5\n"
        )
    };
    for model in [
        "creep_model = \"viscoelastic\"\nea_n = 2.5e6",
        "creep_model = \"syrope\"\nstrain = [0.0, 0.01, 0.02, 0.04]\ntension_n = [0.0, 1.8e4, 4e4, 9e4]\nworking_curve = \"exponential\"
        working_curve_shape = 0.5\npermanent_strain_ratio = 0.2\npast_tension_n = 3e4",
    ] {
        let alpha = moved(&text("time_step_s = 0.005", model));
        let rk4 = moved(&text("method = \"rk4\"", model));
        let name = "tension_n[rope|a]";
        for (row, (a, b)) in channel(&alpha, name).iter().zip(channel(&rk4, name)).enumerate() {
            // Alpha begins without the acceleration that the low mean tension makes.
            assert!(row < 4 || (a / b - 1.0).abs() < 2e-3, "{model} {row} {a} {b}");
        }
        for run in [&alpha, &rk4] {
            assert!(run.balance.relative_drift() < 2e-3, "{:?}", run.balance);
            assert!(run.balance.dissipated() > 0.0);
        }
    }
}

#[test]
fn a_line_that_creeps_cannot_be_paid_out() {
    let text = "[materials.rope]\ndiameter_m = 0.06\nmass_kg_per_m = 3.0\nea_n = 1e7\ncreep_model = \"viscoelastic\"\ndynamic_ea_n = 2e7\n\
         slow_damping_n_s = 4e8\n[points.top]\nkind = \"fixed\"\nposition_m = [0.0, 0.0, 0.0]\n[points.clump]\nkind = \"free\"\nmass_kg = 4000.0\n\
         [[lines]]\nname = \"rope\"\nfrom = \"top\"\nto = \"clump\"\nmaterial = \"rope\"\nlength_m = 80.0\n\
         [[payouts]]\nline = \"rope\"\nrate_m_per_s = 0.5\n[solver]\nduration_s = 5.0\n";
    let found = crate::motion::refused(text);
    assert!(
        found.contains("is not covered for a line that creeps"),
        "{found}"
    );
}
