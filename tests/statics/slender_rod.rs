//! A second method for the umbilical: the finite element of Lin, Guo, Niu and Zhang 2016 (eqs 10 to 15), Garrett's slender rod
//! with cubic shapes and quadratic tension, in the vertical plane. The paper's own agrees with OrcaFlex within about 5 % in
//! shape and almost fully in tension; here it is held against the lumped line.

use std::f64::consts::FRAC_PI_4;

use nalgebra::{DMatrix, DVector};
use seacable::case::{self, edit};
use seacable::scene;
use seacable::statics::equilibrium::EquilibriumSearch;

const WAVE: &str = include_str!("../../cases/umbilical/steep_wave.toml");

// Its inputs, as the file has them.
const G: f64 = 9.80665;
const WATER: f64 = 1025.0;
const DEPTH: f64 = 178.0;
const EA: f64 = 3.02e8;
const EI: f64 = 2860.0;

const ELEMENTS: usize = 55;
/// Length of an element \[m\].
const LENGTH: f64 = 220.0 / ELEMENTS as f64;
/// Unknowns of a node: x, z, x', z', and the tension less EI times curvature squared.
const NODE: usize = 5;
/// Unknowns: those of the nodes, then the tension in the middle of each element.
const UNKNOWNS: usize = NODE * (ELEMENTS + 1) + ELEMENTS;

/// Places and weights of Gauss's rule of five points on 0 to 1.
const GAUSS: [(f64, f64); 5] = [
    (0.046_910_077_030_668, 0.118_463_442_528_095),
    (0.230_765_344_947_158, 0.239_314_335_249_683),
    (0.5, 0.284_444_444_444_444),
    (0.769_234_655_052_842, 0.239_314_335_249_683),
    (0.953_089_922_969_332, 0.118_463_442_528_095),
];

/// Weight in water per length \[N/m\] and `1/2 rho C_D D` \[kg/m²\] at arc length s, floats spread by eqs (20) and (21).
fn load(s: f64, float: f64) -> (f64, f64) {
    let (cable, filled) = (0.0941_f64, 0.75);
    if (20.0..60.0).contains(&s) {
        let volume = FRAC_PI_4 * (float * float - cable * cable) * filled;
        let weight = (12.5 + volume * (400.0 - WATER)) * G;
        let width = float * filled + 1.2 * cable * (1.0 - filled);
        (weight, 0.5 * WATER * width)
    } else {
        (12.5 * G, 0.5 * WATER * 1.2 * cable)
    }
}

/// Morison's drag per length on a rod of slope r' at height z (eq. 9 at rest).
fn drag(slope: [f64; 2], z: f64, half: f64) -> [f64; 2] {
    let speed = 1.0 + (0.3 - 1.0) * (-z).clamp(0.0, DEPTH) / DEPTH;
    let length = slope[0].hypot(slope[1]);
    let t = slope.map(|part| part / length);
    let across = [speed - speed * t[0] * t[0], -speed * t[0] * t[1]];
    let size = across[0].hypot(across[1]);
    across.map(|part| half * size * part)
}

/// Hermite's cubics and their first two derivatives by arc length, and the quadratics of the tension, at xi in 0 to 1.
fn shapes(x: f64) -> ([f64; 4], [f64; 4], [f64; 4], [f64; 3]) {
    let l = LENGTH;
    (
        [
            1.0 - 3.0 * x * x + 2.0 * x * x * x,
            l * (x - 2.0 * x * x + x * x * x),
            3.0 * x * x - 2.0 * x * x * x,
            l * (x * x * x - x * x),
        ],
        [
            6.0 * (x * x - x) / l,
            1.0 - 4.0 * x + 3.0 * x * x,
            6.0 * (x - x * x) / l,
            3.0 * x * x - 2.0 * x,
        ],
        [
            (12.0 * x - 6.0) / (l * l),
            (6.0 * x - 4.0) / l,
            (6.0 - 12.0 * x) / (l * l),
            (6.0 * x - 2.0) / l,
        ],
        [
            1.0 - 3.0 * x + 2.0 * x * x,
            4.0 * x * (1.0 - x),
            x * (2.0 * x - 1.0),
        ],
    )
}

/// Unknowns of an element: x and z of its four shapes, and its three tensions.
fn unknowns(e: usize) -> ([[usize; 2]; 4], [usize; 3]) {
    let n = NODE * e;
    let middle = NODE * (ELEMENTS + 1) + e;
    (
        [[n, n + 1], [n + 2, n + 3], [n + 5, n + 6], [n + 7, n + 8]],
        [n + 4, middle, n + 9],
    )
}

/// A vector interpolated by the shapes.
fn sum(by: [f64; 4], at: [[usize; 2]; 4], y: &DVector<f64>) -> [f64; 2] {
    [0, 1].map(|j| (0..4).map(|l| by[l] * y[at[l][j]]).sum())
}

/// Residual and tangent of eqs (12) and (13) without inertia, as in eq. (14).
fn assemble(y: &DVector<f64>, float: f64) -> (DVector<f64>, DMatrix<f64>) {
    let mut r = DVector::zeros(UNKNOWNS);
    let mut k = DMatrix::zeros(UNKNOWNS, UNKNOWNS);
    for e in 0..ELEMENTS {
        let (at, tension) = unknowns(e);
        let (weight, half) = load((e as f64 + 0.5) * LENGTH, float);
        for (x, share) in GAUSS {
            let h = share * LENGTH;
            let (a, a1, a2, p) = shapes(x);
            let (slope, bend, z) = (sum(a1, at, y), sum(a2, at, y), sum(a, at, y)[1]);
            let lambda: f64 = (0..3).map(|m| p[m] * y[tension[m]]).sum();
            let pull = drag(slope, z, half);
            let q = [pull[0], pull[1] - weight];
            let strained = 0.5 * (slope[0] * slope[0] + slope[1] * slope[1] - 1.0) - lambda / EA;
            // Derivatives of the drag by the slope, by differences.
            let by = [0, 1].map(|j| {
                let moved = |step: f64| {
                    let mut slope = slope;
                    slope[j] += step;
                    drag(slope, z, half)
                };
                let (above, below) = (moved(1e-6), moved(-1e-6));
                [0, 1].map(|i| (above[i] - below[i]) / 2e-6)
            });
            for l in 0..4 {
                for j in 0..2 {
                    r[at[l][j]] +=
                        h * (EI * a2[l] * bend[j] + lambda * a1[l] * slope[j] - a[l] * q[j]);
                    for n in 0..4 {
                        k[(at[l][j], at[n][j])] +=
                            h * (EI * a2[l] * a2[n] + lambda * a1[l] * a1[n]);
                        for i in 0..2 {
                            k[(at[l][i], at[n][j])] -= h * a[l] * by[j][i] * a1[n];
                        }
                    }
                    for m in 0..3 {
                        let mixed = h * p[m] * a1[l] * slope[j];
                        k[(at[l][j], tension[m])] += mixed;
                        k[(tension[m], at[l][j])] += mixed;
                    }
                }
            }
            for m in 0..3 {
                r[tension[m]] += h * p[m] * strained;
                for n in 0..3 {
                    k[(tension[m], tension[n])] -= h * p[m] * p[n] / EA;
                }
            }
        }
    }
    // Hinged ends: places are held, slopes are free.
    for end in [0, NODE * ELEMENTS] {
        for held in [end, end + 1] {
            r[held] = 0.0;
            k.row_mut(held).fill(0.0);
            k.column_mut(held).fill(0.0);
            k[(held, held)] = 1.0;
        }
    }
    (r, k)
}

/// Newton's iteration of eq. (14), to its end.
fn solve(mut y: DVector<f64>, float: f64) -> DVector<f64> {
    for _ in 0..30 {
        let (residual, tangent) = assemble(&y, float);
        let step = tangent.lu().solve(&-residual).unwrap();
        let far = (0..=ELEMENTS).map(|i| step[NODE * i].hypot(step[NODE * i + 1]));
        let far = far.fold(0.0, f64::max);
        y += step * (5.0 / far.max(5.0));
        if far < 1e-8 {
            return y;
        }
    }
    panic!("no convergence");
}

/// Tension at a node: the multiplier and EI times curvature squared, the mean of both sides.
fn tension(y: &DVector<f64>, node: usize) -> f64 {
    let before = node.checked_sub(1).map(|e| (e, 1.0));
    let after = (node < ELEMENTS).then_some((node, 0.0));
    let sides: Vec<f64> = before
        .into_iter()
        .chain(after)
        .map(|(e, x)| {
            let bend = sum(shapes(x).2, unknowns(e).0, y);
            bend[0] * bend[0] + bend[1] * bend[1]
        })
        .collect();
    y[NODE * node + 4] + EI * sides.iter().sum::<f64>() / sides.len() as f64
}

#[test]
fn the_papers_finite_element_agrees_with_the_lumped_line() {
    for float in [0.30, 0.35, 0.40] {
        let text = edit::set(WAVE, "modules.buoyant.diameter_m", &format!("{float:?}")).unwrap();
        let case = case::parse(&text, "steep_wave.toml").unwrap();
        let scene = scene::build(&case, 1).unwrap();
        let mut state = scene.initial_state();
        EquilibriumSearch::default()
            .run(&scene, 0.0, &mut state)
            .unwrap();
        let tensions = scene.tensions(&state);
        let every = scene.line.segments.len() / ELEMENTS;
        // Bent aside, so that it is the element that finds the shape.
        let mut start = DVector::zeros(UNKNOWNS);
        for i in 0..=ELEMENTS {
            let s = i as f64 / ELEMENTS as f64;
            let aside = 3.0 * (std::f64::consts::PI * s).sin();
            let (first, last) = (
                every * i.min(ELEMENTS - 1),
                every * (i.min(ELEMENTS - 1) + 1),
            );
            let along = (state.x[last] - state.x[first]).normalize();
            let n = NODE * i;
            (start[n], start[n + 1]) = (state.x[every * i].x + aside, state.x[every * i].z);
            (start[n + 2], start[n + 3]) = (along.x, along.z);
            start[n + 4] = tensions[every * i];
        }
        for e in 0..ELEMENTS {
            start[NODE * (ELEMENTS + 1) + e] =
                0.5 * (start[NODE * e + 4] + start[NODE * (e + 1) + 4]);
        }
        let y = solve(start, float);
        let (mut off, mut pull): (f64, f64) = (0.0, 0.0);
        for i in 0..=ELEMENTS {
            let (x, n) = (state.x[every * i], NODE * i);
            off = off.max((y[n] - x.x).hypot(y[n + 1] - x.z));
            pull = pull.max((tension(&y, i) / tensions[every * i] - 1.0).abs());
        }
        println!("floats of {float} m: {off:.4} m apart, tension by {pull:.5}");
        // The paper's two programs: about 5 % in shape.
        assert!(off < 0.03, "{float}: {off} m");
        assert!(pull < 5e-3, "{float}: {pull}");
    }
}
