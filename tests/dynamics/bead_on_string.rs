//! A bead on a taut string of two segments: its natural periods across and along the string by its added masses, in the frequencies of the
//! modes and in time, by both methods.

use std::f64::consts::TAU;

use seacable::case::Case;
use seacable::modes::of_case;
use seacable::numerics::{M3, V3};
use seacable::scene::{self, Scene};

use crate::lines::line;
use crate::march::{alpha, march, rk4};
use crate::period::Period;
use crate::rest::at_rest;

/// Direction of the string, its length unstretched \[m\] and by what it is stretched, its stiffness EA \[N\].
const DIRECTION: [f64; 3] = [1.0 / 3.0, 2.0 / 3.0, -2.0 / 3.0];
const LENGTH: f64 = 100.0;
const STRAIN: f64 = 0.02;
const EA: f64 = 1e6;
/// Mass of the bead with that of the string which goes with it, added mass across and along \[kg\].
const MASS: f64 = 300.0 + 0.5 * LENGTH * 2.0;
const ADDED: [f64; 2] = [700.0, 90.0];

fn string(added_mass: &str) -> Case {
    let b = DIRECTION.map(|axis| axis * LENGTH * (1.0 + STRAIN));
    line(&format!(
        "environment.water_density_kg_per_m3 = 1000.0
         materials.rope.ea_n = {EA:?}
         materials.rope.wet_weight_kg_per_m = 0.0
         line.segments = 2
         clumps = [{{ name = \"bead\", section = \"rope\", at_m = {:?}, mass_kg = 300.0, wet_mass_kg = 0.0, {added_mass} }}]
         ends.b.kind = \"fixed\"
         ends.b.position_m = {b:?}",
        0.5 * LENGTH
    ))
}

fn aligned() -> Case {
    let [across, along] = ADDED;
    string(&format!(
        "added_mass_normal_kg = {across:?}, added_mass_tangential_kg = {along:?}"
    ))
}

/// Frequencies across and along the string \[1/s\]: tension by stretched length on both sides, stiffness by unstretched length.
fn exact() -> [f64; 2] {
    let half = 0.5 * LENGTH;
    let across = 2.0 * EA * STRAIN / (half * (1.0 + STRAIN)) / (MASS + ADDED[0]);
    let along = 2.0 * EA / half / (MASS + ADDED[1]);
    [across, along].map(|square| square.sqrt() / TAU)
}

#[test]
fn modes_have_the_periods_of_the_added_masses() {
    let found = of_case(&aligned(), 3).unwrap();
    let found = found.modes.iter().map(|mode| mode.mode.frequency_hz());
    let [across, along] = exact();
    for (found, exact) in found.zip([across, across, along]) {
        assert!((found / exact - 1.0).abs() < 1e-9, "{found} {exact}");
    }
}

/// What a force moves it by: across and along the string, however that lies.
#[test]
fn a_force_accelerates_it_by_the_mass_in_its_direction() {
    let scene = scene::build(&aligned(), 1).unwrap();
    let found = scene.inverse_mass(1, &at_rest(&scene));
    let d = V3::from(DIRECTION);
    let along = d * d.transpose();
    let exact = (M3::identity() - along) / (MASS + ADDED[0]) + along / (MASS + ADDED[1]);
    assert!(
        (found - exact).norm() < 1e-12 * exact.norm(),
        "{found} {exact}"
    );
}

/// The period of the bead as it swings by this far at first, in this direction, in steps of this share of its period.
fn period(scene: &Scene, direction: V3, (exact, share): (f64, f64), explicit: bool) -> f64 {
    let mut state = at_rest(scene);
    let rest = state.x[1];
    state.x[1] += direction * 1e-3;
    let mut period = Period::default();
    let time = (5.2 / exact, share / exact);
    let mut see = |t: f64, s: &seacable::solve::State| {
        period.see(t, (s.x[1] - rest).dot(&direction));
    };
    match explicit {
        true => march(rk4(scene), scene, &mut state, time, &mut see),
        false => march(alpha(scene, 1.0), scene, &mut state, time, &mut see),
    }
    period.mean()
}

/// By Runge-Kutta of the fourth order, and by the trapezoidal rule, whose period is longer by `(omega h)^2 / 12`.
#[test]
fn it_swings_at_these_periods() {
    let scene = scene::build(&aligned(), 1).unwrap();
    let d = V3::from(DIRECTION);
    let across = d.cross(&V3::z()).normalize();
    for (direction, exact) in [across, d].into_iter().zip(exact()) {
        let by_rk4 = period(&scene, direction, (exact, 1.0 / 400.0), true);
        assert!((by_rk4 * exact - 1.0).abs() < 1e-5, "{by_rk4} {exact}");
        let off = [1.0 / 100.0, 1.0 / 200.0].map(|share| {
            let by_alpha = period(&scene, direction, (exact, share), false);
            by_alpha * exact - 1.0
        });
        let expected = (TAU / 100.0).powi(2) / 12.0;
        assert!((off[0] / expected - 1.0).abs() < 0.05, "{off:?} {expected}");
        assert!((off[0] / off[1] - 4.0).abs() < 0.2, "{off:?}");
    }
}

/// The same mass across and along is that of all directions.
#[test]
fn equal_masses_are_one_mass_whichever_way_it_moves() {
    let of = |added_mass: &str| {
        let found = of_case(&string(added_mass), 3).unwrap();
        let all = found.modes.iter().map(|mode| mode.mode.frequency_hz());
        all.collect::<Vec<_>>()
    };
    let aligned = of("added_mass_normal_kg = 400.0, added_mass_tangential_kg = 400.0");
    let around = of("added_mass_kg = 400.0");
    for (own, other) in aligned.iter().zip(&around) {
        assert!((own / other - 1.0).abs() < 1e-12, "{own} {other}");
    }
}
