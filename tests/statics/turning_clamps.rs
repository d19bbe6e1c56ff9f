//! A line at rest whose clamps turn with what holds them: its moments and their stiffness against central differences, and the
//! reactions of all of it in balance.

use seacable::case::{Case, Current, DragCoefficient, End, Ends, Material, OneOrMany, Section};
use seacable::line_between_ends::{ClampedEquilibrium, LineBetweenEnds, LineEquilibrium};
use seacable::numerics::V3;

const A: [f64; 3] = [0.0, 0.0, -20.0];
const B: [f64; 3] = [14.0, 3.0, -12.0];

/// An umbilical clamped at both ends, in a current where it is asked for.
fn umbilical(current: bool) -> LineBetweenEnds {
    let mut ends = Ends {
        a: End::fixed("a", A),
        b: End::fixed("b", B),
    };
    ends.a.clamp_elevation_deg = Some(10.0);
    ends.b.clamp_elevation_deg = Some(60.0);
    let mut case = Case::new("umbilical", ends);
    let material = Material {
        ei_n_m2: 2e3,
        drag_normal: DragCoefficient::Constant(1.2),
        ..Material::new(0.1, 20.0, 1e7)
    };
    case.materials.insert("m".into(), material);
    case.line = vec![Section::new("line", "m", 18.0, 24)];
    case.current = current.then_some(Current {
        speed_m_per_s: Some(OneOrMany::One(0.8)),
        direction_deg: OneOrMany::One(70.0),
        depth_m: None,
        file: None,
    });
    LineBetweenEnds::new(&case).unwrap()
}

/// Directions by elevation and azimuth \[rad\].
fn directions() -> [V3; 2] {
    let of = |azimuth: f64, elevation: f64| {
        let (sin, cos) = elevation.sin_cos();
        V3::new(cos * azimuth.cos(), cos * azimuth.sin(), sin)
    };
    [of(0.4, 0.1), of(-0.2, 1.0)]
}

fn solve(line: &mut LineBetweenEnds, ends: [V3; 2], directions: [V3; 2]) -> LineEquilibrium {
    line.turn_clamps(&directions.map(Some));
    line.solve(ends[0], ends[1]).unwrap()
}

fn clamped(found: &LineEquilibrium) -> &ClampedEquilibrium {
    found.clamped.as_deref().unwrap()
}

/// The forces on both ends and on both directions.
fn forces(found: &LineEquilibrium) -> [V3; 4] {
    let [a, b] = clamped(found).force_n_m;
    [found.force_a_n, found.force_b_n, a, b]
}

#[test]
fn the_stiffness_of_clamps_is_that_of_central_differences() {
    for current in [false, true] {
        let mut line = umbilical(current);
        let (ends, directions) = ([A.into(), B.into()], directions());
        let here = solve(&mut line, ends, directions);
        let stiffness = clamped(&here).stiffness;
        for (with, row) in stiffness.iter().zip(&here.stiffness_n_per_m) {
            assert_eq!(with[..2], row[..]);
        }
        let scale = [0, 1, 2, 3].map(|row: usize| {
            stiffness[row]
                .iter()
                .map(nalgebra::Matrix::amax)
                .fold(0.0, f64::max)
        });
        for j in 0..4 {
            for k in 0..3 {
                let h = 1e-5;
                let moved = |by: f64| {
                    let (mut ends, mut directions) = (ends, directions);
                    let mut step = V3::ith(k, by);
                    if j < 2 {
                        ends[j] += step;
                    } else {
                        // A direction turns; it does not grow.
                        let d = directions[j - 2];
                        step -= d * d.dot(&step);
                        directions[j - 2] = (d + step).normalize();
                    }
                    forces(&solve(&mut line.clone(), ends, directions))
                };
                let (ahead, behind) = (moved(h), moved(-h));
                let along = match j {
                    0..2 => V3::ith(k, 1.0),
                    _ => V3::ith(k, 1.0) - directions[j - 2] * directions[j - 2][k],
                };
                for i in 0..4 {
                    let slope = (ahead[i] - behind[i]) / (2.0 * h);
                    let error = (slope - stiffness[i][j] * along).norm();
                    assert!(
                        error < 1e-5 * scale[i],
                        "{i} {j} {k}: {error} of {}",
                        scale[i]
                    );
                }
            }
        }
        if !current {
            for i in 0..4 {
                for j in 0..4 {
                    let across = stiffness[i][j] - stiffness[j][i].transpose();
                    assert!(across.amax() < 1e-7 * scale[i].max(scale[j]));
                }
            }
        }
    }
}

/// Forces and moments of both ends hold the weight of the line, about any point.
#[test]
fn reactions_of_a_clamped_line_are_in_balance() {
    let mut line = umbilical(false);
    let ends = [V3::from(A), V3::from(B)];
    let directions = directions();
    let found = solve(&mut line, ends, directions);
    let [a, b, on_a, on_b] = forces(&found);
    let (scene, state) = line.scene_and_state();
    let mut force = -(a + b);
    let mut moment = -(ends[0].cross(&a) + ends[1].cross(&b));
    moment -= directions[0].cross(&on_a) + directions[1].cross(&on_b);
    for (place, weight) in state.x.iter().zip(&scene.line.weight) {
        let load = V3::z() * -*weight;
        force += load;
        moment += place.cross(&load);
    }
    assert!(force.norm() < 1e-6 * a.norm(), "{force}");
    assert!(moment.norm() < 1e-6 * ends[1].cross(&b).norm(), "{moment}");
}

/// Turned about the vertical with what holds it, the line turns as a whole; mirrored and reversed likewise.
#[test]
fn a_clamped_line_is_invariant() {
    let (ends, directions) = ([V3::from(A), V3::from(B)], directions());
    let found = forces(&solve(&mut umbilical(false), ends, directions));
    let turn = nalgebra::Rotation3::from_axis_angle(&V3::z_axis(), 1.1);
    let mirror = nalgebra::Matrix3::from_diagonal(&V3::new(1.0, -1.0, 1.0));
    for by in [*turn.matrix(), mirror] {
        let moved = solve(
            &mut umbilical(false),
            ends.map(|x| by * x),
            directions.map(|d| by * d),
        );
        for (found, moved) in found.iter().zip(forces(&moved)) {
            assert!((by * found - moved).norm() < 1e-7 * found.norm());
        }
    }
    let [a, b] = ends;
    let [at_a, at_b] = directions;
    let reversed = forces(&solve(&mut umbilical(false), [b, a], [-at_b, -at_a]));
    for (here, there, sign) in [(0, 1, 1.0), (1, 0, 1.0), (2, 3, -1.0), (3, 2, -1.0)] {
        let apart = found[here] - reversed[there] * sign;
        assert!(apart.norm() < 1e-7 * found[here].norm(), "{here}: {apart}");
    }
}
