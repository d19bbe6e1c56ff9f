//! A ship as a rigid body at the end of a line: its tangent, free decay against closed forms, energy.

use std::f64::consts::TAU;

use nalgebra::{Matrix6, Vector6};
use seacable::case;
use seacable::dynamics::March;
use seacable::dynamics::generalized_alpha::GeneralizedAlpha;
use seacable::numerics::{BlockBand, V3};
use seacable::scene::{self, Scene};
use seacable::ship::coupled::forcing::Forcing;
use seacable::ship::coupled::moored_ship::{MooredShip, ShipBody};
use seacable::solve::{
    AcceptedStep, ExplicitRhs, Factors, Kinematics, Progressing, Residual, State,
};
use seacable::statics::equilibrium::EquilibriumSearch;

/// A chain from an anchor on the bed, 10 m down, to a fairlead at (x, 0, 0), without drag.
fn chain(x: f64, weight: f64, segments: usize) -> Scene {
    let text = format!(
        "[case]\ntitle = \"moored\"\n[seabed]\ndepth_m = 10.0\n\
         [materials.chain]\ndiameter_m = 0.02\nmass_kg_per_m = {weight:?}\nwet_weight_kg_per_m = {weight:?}\nea_n = 4.0e7\n\
         added_mass_normal = 0.0\n\
         [[line]]\nname = \"chain\"\nmaterial = \"chain\"\nlength_m = 100.0\nsegments = {segments}\n\
         [ends.a]\nname = \"anchor\"\nkind = \"anchor\"\nposition_m = [0.0, 0.0, -10.0]\n\
         [ends.b]\nname = \"ship\"\nkind = \"fixed\"\nposition_m = [{x:?}, 0.0, 0.0]\n"
    );
    let case = case::parse(&text, "moored")
        .map_err(|all| all[0].to_string())
        .unwrap();
    scene::build(&case, 1).unwrap()
}

fn rest(line: &Scene) -> State {
    let mut state = line.initial_state();
    EquilibriumSearch::default()
        .run(line, 0.0, &mut state)
        .unwrap();
    state
}

/// A ship of this mass, held up by stiff water, its fairlead at an arm; its load balances the line at rest.
fn ship(line: &Scene, state: &State, mass: f64, arm: V3) -> ShipBody {
    let last = line.nodes() - 1;
    let pull = line.end_force(last, state);
    let turn = arm.cross(&pull);
    let inertia = mass * 200.0;
    ShipBody {
        mass: Matrix6::from_diagonal(&Vector6::new(
            mass,
            1.5 * mass,
            2.0 * mass,
            inertia,
            inertia,
            inertia,
        )),
        damping: Matrix6::zeros(),
        restoring: Matrix6::from_diagonal(&Vector6::new(
            0.0,
            0.0,
            4.0 * mass,
            2.0 * inertia,
            2.0 * inertia,
            0.01 * inertia,
        )),
        load: -Vector6::new(pull.x, pull.y, pull.z, turn.x, turn.y, turn.z),
        forcing: Forcing::default(),
        origin: state.x[last] - arm,
        arm,
        length: 25.0,
    }
}

fn march(
    moored: &MooredShip,
    rho: f64,
    state: &mut State,
    time: (f64, f64),
    mut see: impl FnMut(f64, &State),
) {
    moored.accelerate(0.0, state);
    let mut method = GeneralizedAlpha::new(moored.nodes(), rho, 1e-10, 30);
    let march = March {
        duration: time.0,
        step: time.1,
    };
    march
        .run(&mut method, moored, state, &mut |i: AcceptedStep<'_>| {
            see(i.time, i.state);
            Progressing::Continue
        })
        .unwrap();
}

/// Moves the ship and its fairlead by a shift, and the line with it as a straight stretch would go.
fn shifted(moored: &MooredShip, state: &State, shift: V3) -> State {
    let mut state = state.clone();
    let last = moored.nodes() - 3;
    for i in 0..=last {
        let share = i as f64 / last as f64;
        state.x[i] += shift * share;
    }
    state.x[last + 1] += shift;
    state
}

#[test]
fn the_tangent_is_the_derivative() {
    let line = chain(97.0, 20.0, 12);
    let at_rest = rest(&line);
    let body = ship(&line, &at_rest, 4e5, V3::new(-20.0, 1.0, 2.0));
    let moored = MooredShip::new(line, body).unwrap();
    let mut state = moored.at_rest(&at_rest);
    let n = moored.nodes();
    let wave = |i: usize, k: f64| {
        V3::new(
            (k + i as f64).sin(),
            (2.0 * k + i as f64).cos(),
            (k * i as f64).sin(),
        )
    };
    for i in 1..n {
        state.x[i] += wave(i, 1.0) * 0.05;
        state.v[i] = wave(i, 2.0);
        state.a[i] = wave(i, 3.0);
    }
    let c = Factors {
        mass: 0.7,
        damping: 1.3,
        stiffness: 1.0,
    };
    let mut r = vec![V3::zeros(); n];
    let mut tangent = BlockBand::new(n);
    tangent.widen();
    moored.linearise(0.0, &state, c, &mut r, &mut tangent);
    let direction: Vec<V3> = (0..n)
        .map(|i| if i == 0 { V3::zeros() } else { wave(i, 0.4) })
        .collect();
    let h = 1e-6;
    let moved = |sign: f64| {
        let mut s = state.clone();
        let mut r = vec![V3::zeros(); n];
        for (i, along) in direction.iter().enumerate().skip(1) {
            s.x[i] += along * (sign * h * c.stiffness);
            s.v[i] += along * (sign * h * c.damping);
            s.a[i] += along * (sign * h * c.mass);
        }
        moored.residual(0.0, &s, &mut r);
        r
    };
    let (plus, minus) = (moved(1.0), moved(-1.0));
    for i in 1..n {
        let mut by_tangent = tangent.diag[i] * direction[i] + tangent.lower[i] * direction[i - 1];
        if i + 1 < n {
            by_tangent += tangent.upper[i] * direction[i + 1];
        }
        if i >= 2 {
            by_tangent += tangent.far_lower[i] * direction[i - 2];
        }
        if i + 2 < n {
            by_tangent += tangent.far_upper[i] * direction[i + 2];
        }
        let by_difference = (plus[i] - minus[i]) / (2.0 * h);
        let scale = by_difference.norm().max(1e3);
        assert!(
            (by_tangent - by_difference).norm() < 1e-4 * scale,
            "{i}: {by_tangent:?} {by_difference:?}"
        );
    }
}

#[test]
fn a_ship_at_rest_stays_at_rest() {
    let line = chain(97.0, 20.0, 25);
    let at_rest = rest(&line);
    let body = ship(&line, &at_rest, 4e5, V3::new(-20.0, 1.0, 2.0));
    let moored = MooredShip::new(line, body).unwrap();
    let mut state = moored.at_rest(&at_rest);
    let before = moored.tension(&state);
    march(&moored, 0.4, &mut state, (200.0, 0.1), |_, _| ());
    assert!(
        moored.motion(&state).norm() < 1e-5,
        "{}",
        moored.motion(&state)
    );
    assert!((moored.tension(&state) / before - 1.0).abs() < 1e-5);
}

#[test]
fn surge_swings_with_the_stiffness_of_the_line() {
    // Period 2 pi sqrt(m / k), k from two equilibria of the same line a little apart.
    let line = chain(97.0, 20.0, 40);
    let at_rest = rest(&line);
    let pull = |x: f64| {
        let line = chain(x, 20.0, 40);
        line.end_force(line.nodes() - 1, &rest(&line)).x
    };
    let k = (pull(96.95) - pull(97.05)) / 0.1;
    let mass = 4e6;
    let mut body = ship(&line, &at_rest, mass, V3::zeros());
    body.restoring[(2, 2)] = 1e3 * mass;
    let moored = MooredShip::new(line, body).unwrap();
    let mut state = shifted(&moored, &moored.at_rest(&at_rest), V3::x() * 0.01);
    let period = TAU * (mass / k).sqrt();
    let mut crossings: Vec<f64> = Vec::new();
    let mut before: Option<(f64, f64)> = None;
    march(
        &moored,
        0.0,
        &mut state,
        (3.2 * period, period / 400.0),
        |t, s| {
            let x = moored.motion(s)[0];
            if let Some((t0, x0)) = before
                && x0 > 0.0
                && x <= 0.0
            {
                crossings.push(t0 + (t - t0) * x0 / (x0 - x));
            }
            before = Some((t, x));
        },
    );
    let measured = (crossings[2] - crossings[0]) / 2.0;
    assert!(
        (measured / period - 1.0).abs() < 5e-3,
        "{measured} {period}"
    );
}

#[test]
fn energy_is_kept_without_damping_and_what_damping_takes_adds_up() {
    let line = chain(97.0, 20.0, 20);
    let at_rest = rest(&line);
    let mut body = ship(&line, &at_rest, 4e5, V3::new(-20.0, 1.0, 2.0));
    body.restoring[(2, 2)] = 4e5;
    let out = |damping: f64, body: &ShipBody| {
        let mut body = body.clone();
        body.damping = body.mass * damping;
        // In the air over the bed, so that nothing is lost to it.
        let moored = MooredShip::new(line_without_bed(), body).unwrap();
        let mut state = moored.at_rest(&rest(&line_without_bed()));
        state.v[moored.nodes() - 2] = V3::new(0.2, 0.3, 0.0);
        let f = moored.nodes() - 3;
        state.v[f] = V3::new(0.2, 0.3, 0.0);
        let kinetic = 0.5 * 4e5 * 0.2 * 0.2;
        let start = moored.energy(&state);
        let (mut lost, mut worst, mut last) = (0.0, 0.0_f64, None);
        march(&moored, 1.0, &mut state, (60.0, 0.01), |t, s| {
            let power = moored.dissipation(s);
            if let Some((t0, p0)) = last {
                lost += 0.5 * (t - t0) * (power + p0);
            }
            last = Some((t, power));
            worst = worst.max((start - moored.energy(s) - lost).abs());
        });
        (worst / kinetic, lost / kinetic)
    };
    let (free, nothing) = out(0.0, &body);
    assert!(free < 1e-2 && nothing == 0.0, "{free}");
    let (damped, lost) = out(0.05, &body);
    assert!(damped < 1e-2 && lost > 0.3, "{damped} {lost}");
}

fn line_without_bed() -> Scene {
    let mut line = chain(97.0, 20.0, 20);
    line.elements.bed = None;
    line
}
