//! Equations of Zhu, Yin and Shen 2017, term by term, on the line of their section 3.

use seacable::numerics::{M3, V3};
use seacable::physics::bed_friction::{Friction, FrictionContact, FrictionModel};
use seacable::physics::bed_reaction::BedReaction;
use seacable::scene::{self, EndCondition, Scene};

use crate::rest;

const FIXED: &str = include_str!("../../../cases/mooring/hybrid_fixed.toml");
const MOVING: &str = include_str!("../../../cases/mooring/hybrid_moving.toml");

fn built(text: &str) -> Scene {
    scene::build(&seacable::case::parse_keys(text).unwrap(), 1).unwrap()
}

/// A segment of the lower chain, of the polyester, of the upper chain.
const SEGMENTS: [usize; 3] = [30, 100, 150];

/// The tangent in the frame i-btn that is turned by phi and theta, and its matrix.
fn frame(phi: f64, theta: f64) -> M3 {
    let (sp, cp) = phi.sin_cos();
    let (st, ct) = theta.sin_cos();
    M3::new(cp, -sp * ct, sp * st, sp, cp * ct, -cp * st, 0.0, st, ct)
}

/// Eqs 3 and 4: a node has half of the mass and half of the weight in water of each of its two segments.
#[test]
fn a_node_has_half_of_both_its_segments() {
    let scene = built(FIXED);
    let of = |segment: usize| -> (f64, f64) {
        match segment {
            61..141 => (33.8, 8.6911),
            _ => (161.19, 140.235),
        }
    };
    for node in 1..158 {
        let (before, after) = (of(node - 1), of(node));
        let mass = 0.5 * 25.0 * (before.0 + after.0);
        let weight = 0.5 * 25.0 * 9.81 * (before.1 + after.1);
        assert!((scene.line.mass[node] / mass - 1.0).abs() < 1e-12, "{node}");
        assert!((scene.line.weight[node] / weight - 1.0).abs() < 1e-12);
    }
}

/// Eq. 3 and the matrix of sec. 2.1: the added mass is `A P A'`, with none along t in P.
#[test]
fn added_mass_is_across_the_line_in_the_frame_of_the_segment() {
    let scene = built(FIXED);
    for (phi, theta) in [(0.3, -1.1), (-2.0, 0.4), (1.2, 2.9)] {
        let a = frame(phi, theta);
        assert!((a * a.transpose() - M3::identity()).norm() < 1e-14);
        // The columns of A are b, t and n, in the order of the name of the frame.
        let tangent: V3 = a.column(1).into_owned();
        for segment in SEGMENTS {
            let added = scene.line.segments[segment].added;
            let p = M3::from_diagonal(&V3::new(added.normal, 0.0, added.normal));
            let acceleration = V3::new(0.7, -0.2, 1.3);
            let expected = a * p * a.transpose() * acceleration;
            let found = added.force(&tangent, &acceleration);
            assert!((found - expected).norm() < 1e-12 * expected.norm());
        }
    }
}

/// Eq. 5: drag by the components of the velocity in the frame of the segment. The paper has the root of 1 + e, a line of
/// constant volume; here it is 1 + e, a line of constant width: 0.5 % more at most on this one.
#[test]
fn drag_is_by_components_in_the_frame_of_the_segment() {
    let scene = built(FIXED);
    let mut state = rest::at_rest(&scene);
    let velocity = V3::new(0.8, -0.5, 0.3);
    state.v.fill(velocity);
    for (segment, [diameter, normal, along]) in SEGMENTS.into_iter().zip([
        [0.162, 1.333, 0.639],
        [0.223, 1.6, 0.05],
        [0.162, 1.333, 0.639],
    ]) {
        let chord = scene.line.chord(segment, &state);
        let t = chord.tangent;
        let n = t.cross(&V3::y()).normalize();
        let b = t.cross(&n);
        let u = [b, t, n].map(|axis| -velocity.dot(&axis));
        let across = u[0].hypot(u[2]);
        let force = b * (normal * across * u[0])
            + t * (along * u[1].abs() * u[1])
            + n * (normal * across * u[2]);
        let strain = chord.length / 25.0 - 1.0;
        let constant_width = force * (0.5 * 1025.0 * diameter * 25.0 * (1.0 + strain));
        let constant_volume = force * (0.5 * 1025.0 * diameter * 25.0 * (1.0 + strain).sqrt());
        let found = scene.line.drag_on(segment, &chord, &state);
        assert!((found - constant_width).norm() < 1e-10 * found.norm());
        assert!((found - constant_volume).norm() < 5e-3 * found.norm());
    }
}

/// Eq. 7: Hooke's law in the chain.
#[test]
fn the_chain_is_linearly_elastic() {
    let scene = built(FIXED);
    let state = rest::at_rest(&scene);
    for segment in [SEGMENTS[0], SEGMENTS[2]] {
        let chord = scene.line.chord(segment, &state);
        let strain = chord.length / 25.0 - 1.0;
        let found = scene.line.pull(segment, &chord, 0.0, &state).value;
        assert!((found / (6.9174e8 * strain) - 1.0).abs() < 1e-9);
    }
}

/// Eq. 9: friction is mu N against the velocity along the bed, and in proportion to that below the limiting speed.
#[test]
fn friction_is_coulombs_above_the_limiting_speed_and_in_proportion_below() {
    let law = Friction {
        axial: 0.7,
        lateral: 0.7,
        law: FrictionModel::Regularised(0.01),
    };
    let push = BedReaction {
        force: 2e3,
        ..BedReaction::default()
    };
    let along = V3::new(0.6, -0.8, 0.0);
    for speed in [0.002, 0.01, 0.3] {
        // What goes through the bed is not rubbed against.
        let velocity = along * speed + V3::z() * 0.4;
        let contact = FrictionContact {
            normal: &V3::z(),
            push: &push,
            x: &V3::zeros(),
            v: &velocity,
            curved: None,
        };
        let expected = along * (-0.7 * 2e3 * (speed / 0.01_f64).min(1.0));
        let found = law.regularised(&contact, 0.01);
        assert!((found.force - expected).norm() < 1e-9, "{speed}");
        assert_eq!(found.slides, speed > 0.01);
    }
}

/// Eq. 10: the lower end is held, the top has position and velocity of the platform, from the start on.
#[test]
fn the_ends_are_held_and_led() {
    let scene = built(MOVING);
    let prescribed = |end: usize, t: f64| match &scene.line.ends[end] {
        EndCondition::Prescribed(motion) => motion.at(t),
        EndCondition::Free => panic!("end {end} is free"),
    };
    let omega = std::f64::consts::TAU / 10.0;
    for t in [0.0, 1.3, 7.7, 23.0] {
        let (x, v, _) = prescribed(0, t);
        assert_eq!((x, v), (V3::z() * -1500.0, V3::zeros()));
        let (x, v, _) = prescribed(1, t);
        let expected = V3::new(3569.462 + 5.0 * (omega * t).sin(), 0.0, -40.0);
        assert!((x - expected).norm() < 1e-9, "{t}");
        assert!((v - V3::x() * (5.0 * omega * (omega * t).cos())).norm() < 1e-9);
    }
}

/// Sec. 1.3: the rope weighs 170.52 kN in water, 7.39 % of the pretension.
#[test]
fn the_rope_weighs_7_39_percent_of_the_pretension() {
    let scene = built(FIXED);
    let halves: f64 = scene.line.segments[61..141]
        .iter()
        .map(|segment| 2.0 * segment.half_weight)
        .sum();
    assert!((halves / 170.52e3 - 1.0).abs() < 1e-5, "{halves}");
    assert!((100.0 * halves / 2.308e6 - 7.39).abs() < 5e-3);
}

/// Fig. 2: the polyester is nearly straight, and the chains are not: how far each sags from its chord, by that.
#[test]
fn the_polyester_is_nearly_straight() {
    let scene = built(FIXED);
    let state = rest::at_rest(&scene);
    let sag = |from: usize, to: usize| {
        let (a, b) = (state.x[from], state.x[to]);
        let chord = (b - a).normalize();
        let off = |x: &V3| (x - a - chord * chord.dot(&(x - a))).norm();
        state.x[from..=to].iter().map(off).fold(0.0, f64::max) / (b - a).norm()
    };
    assert!(sag(61, 141) < 0.01, "{}", sag(61, 141));
    assert!(sag(0, 61) > 5.0 * sag(61, 141), "{}", sag(0, 61));
}
