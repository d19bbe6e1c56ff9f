//! A line at rest between held ends as an element: its end forces against closed forms and published figures, its stiffness
//! against central differences.

use proptest::prelude::*;
use seacable::case::{
    Case, Current, DragCoefficient, End, EndKind, Ends, Material, OneOrMany, Seabed, Section,
};
use seacable::line_between_ends::{LineBetweenEnds, LineEquilibrium, LineError, mesh_error};
use seacable::numerics::{M3, V3};
use seacable::statics::catenary::{CatenaryLine, EndOffset, RigidBed, SectionProperties, Solution};

const GRAVITY: f64 = 10.0;

/// A line of one section, and where its ends are.
#[derive(Debug, Clone)]
struct Given {
    length: f64,
    segments: usize,
    weight: f64,
    ea: f64,
    ei: f64,
    current: Option<[f64; 2]>,
    bed: Option<Seabed>,
    ends: [[f64; 3]; 2],
}

impl Given {
    fn new(length: f64, weight: f64, ea: f64, ends: [[f64; 3]; 2]) -> Self {
        Self {
            length,
            segments: 40,
            weight,
            ea,
            ei: 0.0,
            current: None,
            bed: None,
            ends,
        }
    }

    fn case(&self) -> Case {
        let ends = Ends {
            a: End::fixed("a", self.ends[0]),
            b: End::fixed("b", self.ends[1]),
        };
        let mut case = Case::new("line", ends);
        case.environment.gravity_m_per_s2 = GRAVITY;
        let material = Material {
            wet_weight_kg_per_m: Some(self.weight / GRAVITY),
            drag_normal: DragCoefficient::Constant(1.2),
            drag_tangential: DragCoefficient::Constant(0.0),
            ei_n_m2: self.ei,
            ..Material::new(0.2, (self.weight / GRAVITY).abs().max(1.0), self.ea)
        };
        case.materials.insert("m".into(), material);
        case.line = vec![Section::new("line", "m", self.length, self.segments)];
        case.seabed.clone_from(&self.bed);
        case.current = self.current.map(|[speed, direction]| Current {
            speed_m_per_s: Some(OneOrMany::One(speed)),
            direction_deg: OneOrMany::One(direction),
            depth_m: None,
            file: None,
        });
        case
    }

    fn element(&self) -> LineBetweenEnds {
        LineBetweenEnds::new(&self.case()).unwrap()
    }

    fn solve(&self) -> LineEquilibrium {
        self.element().solve(self.ends[0], self.ends[1]).unwrap()
    }

    fn on_mesh(&self, segments: usize) -> LineEquilibrium {
        let given = Self {
            segments,
            ..self.clone()
        };
        given.solve()
    }

    /// Forces of the closed form on A and B; the line lies in the plane of x and z.
    fn closed_form(&self) -> [V3; 2] {
        let sections = [SectionProperties::new(self.length, self.weight, self.ea)];
        let [a, b] = self.ends;
        let line = CatenaryLine {
            ends: EndOffset {
                x_m: b[0] - a[0],
                z_m: b[2] - a[2],
            },
            sections: &sections,
            bed: self.bed.as_ref().map(|bed| RigidBed {
                below_a_m: a[2] + bed.depth_m,
                friction: bed.friction.unwrap_or(0.0),
                ..RigidBed::default()
            }),
            surface_above_a_m: None,
        };
        let Solution {
            h_a_n,
            v_a_n,
            h_b_n,
            v_b_n,
            ..
        } = line.solve().unwrap();
        [V3::new(h_a_n, 0.0, v_a_n), V3::new(-h_b_n, 0.0, -v_b_n)]
    }
}

fn apart(one: [V3; 2], other: [V3; 2]) -> f64 {
    let at = |i: usize| (one[i] - other[i]).norm();
    at(0).max(at(1))
}

fn greatest(forces: [V3; 2]) -> f64 {
    forces.map(|f| f.norm()).into_iter().fold(0.0, f64::max)
}

fn greatest_stiffness(line: &LineEquilibrium) -> f64 {
    let blocks = line.stiffness_n_per_m.iter().flatten();
    blocks.map(M3::amax).fold(0.0, f64::max)
}

/// `(4 fine - coarse) / 3`.
fn extrapolated(fine: &LineEquilibrium, coarse: &LineEquilibrium) -> [V3; 2] {
    let (fine, coarse) = (fine.forces_n(), coarse.forces_n());
    [0, 1].map(|i| (fine[i] * 4.0 - coarse[i]) / 3.0)
}

#[test]
fn end_forces_converge_to_the_closed_form_with_order_two() {
    for (x, ea) in [(100.0, 1e8), (100.0, 1e6), (40.0, 1e7), (118.0, 1e9)] {
        let given = Given::new(120.0, 500.0, ea, [[0.0, 0.0, -60.0], [x, 0.0, -50.0]]);
        let exact = given.closed_form();
        let [coarse, fine] = [80, 160].map(|segments| given.on_mesh(segments));
        let [off, less] = [&coarse, &fine].map(|line| apart(line.forces_n(), exact));
        assert!((3.8..4.2).contains(&(off / less)), "{x} {ea}: {off} {less}");
        let left = apart(extrapolated(&fine, &coarse), exact) / greatest(exact);
        assert!(left < 1e-6, "{x} {ea}: {left:e}");
        let error = mesh_error(&given.case(), &given.solve()).unwrap();
        let off = apart(given.solve().forces_n(), exact);
        let most = error[0].max(error[1]);
        assert!((off..4.0 * off).contains(&most), "{error:?} {off}");
    }
}

/// A weight that the ends carry together on any mesh, and nothing of the bed's.
#[test]
fn end_forces_carry_the_whole_weight() {
    let mut given = Given::new(120.0, 500.0, 1e8, [[0.0, 0.0, -60.0], [90.0, 20.0, -50.0]]);
    for (ei, segments) in [(0.0, 1), (0.0, 2), (0.0, 7), (1e4, 9)] {
        (given.ei, given.segments) = (ei, segments);
        let [a, b] = given.solve().forces_n();
        let sum = a + b;
        assert!((sum + V3::z() * 6e4).norm() < 1e-3, "{segments}: {sum}");
    }
}

#[test]
fn on_the_bed_the_anchor_carries_what_friction_leaves() {
    let mut given = Given::new(140.0, 500.0, 1e9, [[0.0, 0.0, -60.0], [120.0, 0.0, -10.0]]);
    given.segments = 140;
    for friction in [None, Some(0.5)] {
        given.bed = Some(Seabed {
            friction,
            stiffness_n_per_m3: 1e7,
            ..Seabed::level(60.0)
        });
        let line = given.solve();
        let exact = given.closed_form();
        let off = apart(line.forces_n(), exact) / greatest(exact);
        assert!(
            off < 3e-3,
            "{friction:?}: {off} {:?} {exact:?}",
            line.forces_n()
        );
        assert!(line.on_bed_m > 10.0);
    }
}

/// The first two rows of a table of lines in a uniform current: "lines in current, drag distributed over the stretched line", from
/// the differential equations to 1e-12 of the length; the rows are as in `tests/cases/line_tables.rs`.
#[test]
fn in_a_current_end_forces_agree_with_the_differential_equations() {
    let rows = [
        (
            0.5,
            [69582.943, 12643.173, 10211.738],
            [-70071.387, 19383.703, -219715.257],
        ),
        (
            1.0,
            [88314.288, 49510.348, 34537.822],
            [-92063.689, 71033.798, -240287.132],
        ),
    ];
    for (speed, a, b) in rows {
        let (a, b) = (V3::from(a), V3::from(b));
        let ends = [[-600.0, 0.0, -800.0], [0.0, 0.0, 0.0]];
        let mut given = Given::new(1050.0, 200.0, 1e9, ends);
        given.current = Some([speed, 90.0]);
        let [coarse, fine] = [100, 200].map(|segments| given.on_mesh(segments));
        let off = apart(extrapolated(&fine, &coarse), [a, b]);
        assert!(off < 1e-5 * greatest([a, b]), "{off}");
        given.segments = 100;
        let error = mesh_error(&given.case(), &coarse).unwrap();
        let off = apart(coarse.forces_n(), [a, b]);
        assert!(
            (off..5.0 * off).contains(&error[0].max(error[1])),
            "{error:?} {off}"
        );
    }
}

/// Greatest difference between the stiffness and central differences, and greatest difference between those of two steps, which
/// is large near a kink; both relative to the stiffness. Ends on the bed move along it only.
fn compare(given: &Given) -> Option<(f64, f64)> {
    let mut element = given.element();
    let [a, b] = given.ends;
    let here = element.solve(a, b).ok()?;
    let mut slope = |end: usize, axis: usize, step: f64| {
        let mut forces = |step: f64| {
            let mut ends = [a, b];
            ends[end][axis] += step;
            Some(element.solve(ends[0], ends[1]).ok()?.forces_n())
        };
        let (up, down) = (forces(step)?, forces(-step)?);
        Some([0, 1].map(|i| (up[i] - down[i]) / (2.0 * step)))
    };
    // Slack line has none but what condensation adds to nodes that nothing holds.
    let scale = greatest_stiffness(&here).max(0.1 * given.weight);
    // Slack line heaped on the bed is at rest in any shape, but for rounding.
    let tension = here.tension_n.iter().copied().fold(f64::INFINITY, f64::min);
    let lies = |bed: &Seabed| given.ends.iter().any(|end| end[2] == -bed.depth_m);
    let hangs_over_bed = given.bed.as_ref().is_some_and(|bed| !lies(bed));
    if hangs_over_bed && tension < 1e-6 * given.weight * given.length {
        return None;
    }
    let (mut off, mut noise) = (0.0_f64, 0.0_f64);
    for end in 0..2 {
        let on_bed = given
            .bed
            .as_ref()
            .is_some_and(|bed| given.ends[end][2] == -bed.depth_m);
        // Friction at an anchor that moves turns within millimetres.
        let rough = given.bed.as_ref().is_some_and(|bed| bed.friction.is_some());
        let axes = match (on_bed, rough) {
            (false, _) => 3,
            (true, false) => 2,
            (true, true) => 0,
        };
        for axis in 0..axes {
            let step = 1e-5 * given.length;
            let (coarse, fine) = (slope(end, axis, 2.0 * step)?, slope(end, axis, step)?);
            for i in 0..2 {
                for k in 0..3 {
                    let both = (4.0 * fine[i][k] - coarse[i][k]) / 3.0;
                    off = off.max((here.stiffness_n_per_m[i][end][(k, axis)] - both).abs() / scale);
                    noise = noise.max((coarse[i][k] - fine[i][k]).abs() / scale);
                }
            }
        }
    }
    Some((off, noise))
}

fn given() -> impl Strategy<Value = Given> {
    (
        (20.0..300.0_f64, 2_usize..60),
        (20.0..2000.0_f64, 5.0..9.0_f64, 0.2..1.05_f64),
        (-3.1..3.1_f64, -1.2..1.2_f64),
        (any::<bool>(), 0.1..2.0_f64, 0.0..360.0_f64),
        (any::<bool>(), any::<bool>(), 0.0..0.2_f64),
        (any::<bool>(), 2.0..5.0_f64),
    )
        .prop_map(
            |(
                (length, segments),
                (weight, log_ea, chord),
                (azimuth, elevation),
                current,
                bed,
                ei,
            )| {
                let chord = chord * length;
                let level = chord * elevation.cos();
                let a = [3.0, -2.0, -400.0];
                let b = [
                    a[0] + level * azimuth.cos(),
                    a[1] + level * azimuth.sin(),
                    a[2] + chord * elevation.sin(),
                ];
                let lowest = a[2].min(b[2]);
                Given {
                    segments,
                    ei: if ei.0 { 10_f64.powf(ei.1) } else { 0.0 },
                    current: current.0.then_some([current.1, current.2]),
                    bed: bed.0.then(|| Seabed {
                        friction: bed.1.then_some(0.4),
                        ..Seabed::level(0.001 - lowest + bed.2 * length)
                    }),
                    ..Given::new(length, weight, 10_f64.powf(log_ea), [a, b])
                }
            },
        )
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 100, ..ProptestConfig::default() })]

    /// Lines of every kind: taut, slack, bending, on the bed with friction and without, in a current.
    #[test]
    fn stiffness_is_the_derivative_of_the_forces(given in given()) {
        if let Some((off, noise)) = compare(&given) {
            // Differences that do not agree between themselves say nothing: a kink is near, or positions are rounded.
            prop_assert!(off < 3e-5 + 3.0 * noise, "{off:e} {noise:e}");
        }
    }

    #[test]
    fn stiffness_is_symmetric_without_friction_and_current(mut given in given()) {
        given.current = None;
        if let Some(bed) = &mut given.bed {
            bed.friction = None;
        }
        let Ok(line) = given.element().solve(given.ends[0], given.ends[1]) else {
            return Ok(());
        };
        let k = |row: usize, column: usize| line.stiffness_n_per_m[row / 3][column / 3][(row % 3, column % 3)];
        let entries = || (0..36).map(|n| (n / 6, n % 6));
        let scale = greatest_stiffness(&line);
        // Slack line has but rounding.
        let rounding = 1e-14 * given.ea * given.segments as f64 / given.length + 1e-6 * given.weight.abs();
        for (i, j) in entries() {
            prop_assert!((k(i, j) - k(j, i)).abs() <= 1e-9 * scale + rounding, "{} {}", k(i, j), k(j, i));
        }
    }

    /// Wherever the ends go next, the line is the same as one that starts from the closed form.
    #[test]
    fn warm_and_cold_starts_agree(
        given in given(),
        motions in prop::collection::vec(prop::array::uniform6(-1.0..1.0_f64), 1..6),
        log_size in -4.0..-0.3_f64,
    ) {
        let mut warm = given.element();
        let mut cold = given.element();
        let mut ends = given.ends;
        let (Ok(_), Ok(_)) = (warm.solve(ends[0], ends[1]), cold.solve(ends[0], ends[1])) else {
            return Ok(());
        };
        let size = given.length * 10_f64.powf(log_size);
        for motion in motions {
            for (i, by) in motion.into_iter().enumerate() {
                ends[i / 3][i % 3] += 0.3 * size * by;
            }
            cold.forget();
            let (Ok(one), Ok(other)) = (warm.solve(ends[0], ends[1]), cold.solve(ends[0], ends[1])) else {
                continue;
            };
            // Line in bending may rest in several shapes, slack line on a smooth bed in any.
            let several = given.ei > 0.0 || given.bed.is_some();
            let scale = greatest(other.forces_n()).max(given.weight * given.length);
            prop_assert!(
                several || apart(one.forces_n(), other.forces_n()) < 1e-6 * scale,
                "{:?} {:?}", one.forces_n(), other.forces_n()
            );
        }
    }

    /// Ends anywhere, also out of reach or at one place.
    #[test]
    fn any_place_is_answered_or_refused(
        given in given(),
        places in prop::collection::vec(prop::array::uniform3(-500.0..500.0_f64), 1..5),
    ) {
        let mut element = given.element();
        for place in places {
            for b in [place, given.ends[0]] {
                if let Ok(line) = element.solve(given.ends[0], b) {
                    prop_assert!(greatest(line.forces_n()).is_finite());
                    prop_assert!(line.stiffness_n_per_m.iter().flatten().all(|block| block.iter().all(|k| k.is_finite())));
                }
            }
        }
        prop_assert_eq!(element.solve([f64::NAN; 3], given.ends[1]), Err(LineError::NotFinite));
    }
}

/// The anchor of a line laid on a rough bed: friction turns within millimetres, so that the differences are over hundredths of one.
#[test]
fn stiffness_at_an_anchor_on_a_rough_bed() {
    let ends = [[0.0, 0.0, -60.0], [110.0, 40.0, -10.0]];
    for ei in [0.0, 1e5] {
        let mut given = Given::new(140.0, 500.0, 1e8, ends);
        given.ei = ei;
        given.bed = Some(Seabed {
            friction: Some(0.002),
            ..Seabed::level(60.0)
        });
        let mut element = given.element();
        let line = element.solve(ends[0], ends[1]).unwrap();
        for axis in 0..2 {
            let [up, down] = [1e-5, -1e-5].map(|step| {
                let mut a = ends[0];
                a[axis] += step;
                element.solve(a, ends[1]).unwrap().forces_n()
            });
            for i in 0..2 {
                for k in 0..3 {
                    let slope = (up[i][k] - down[i][k]) / 2e-5;
                    let off = (line.stiffness_n_per_m[i][0][(k, axis)] - slope).abs();
                    assert!(off < 0.5, "{ei} {axis} {i} {k}: {slope} {off}");
                }
            }
        }
    }
}

/// Each kind of line far from kinks: the comparison with differences is then sharp.
#[test]
fn stiffness_by_kind() {
    let hanging = Given::new(120.0, 500.0, 1e8, [[0.0, 0.0, -60.0], [90.0, 40.0, -30.0]]);
    let slack = Given::new(120.0, 500.0, 1e8, [[0.0, 0.0, -60.0], [20.0, 10.0, -55.0]]);
    let taut = Given::new(120.0, 500.0, 1e7, [[0.0, 0.0, -60.0], [110.0, 60.0, -30.0]]);
    let lifted = Given {
        bed: Some(Seabed::level(65.0)),
        ..hanging.clone()
    };
    let on_bed = |friction| Given {
        bed: Some(Seabed {
            friction,
            ..Seabed::level(60.0)
        }),
        ..Given::new(140.0, 500.0, 1e8, [[0.0, 0.0, -60.0], [110.0, 40.0, -10.0]])
    };
    let with_current = |given: Given| Given {
        current: Some([0.8, 70.0]),
        ..given
    };
    let bending = |given: Given| Given { ei: 1e5, ..given };
    let kinds = [
        ("hanging", hanging.clone()),
        ("slack", slack.clone()),
        ("taut", taut.clone()),
        ("U on bed", lifted.clone()),
        ("anchor on bed", on_bed(None)),
        ("anchor on rough bed", on_bed(Some(0.002))),
        ("anchor held by friction", on_bed(Some(1.0))),
        ("hanging in a current", with_current(hanging.clone())),
        ("slack in a current", with_current(slack)),
        ("U on bed in a current", with_current(lifted)),
        (
            "anchor on rough bed in a current",
            with_current(on_bed(Some(0.002))),
        ),
        ("hanging and bending", bending(hanging.clone())),
        ("anchor on bed and bending", bending(on_bed(None))),
        ("bending in a current", with_current(bending(hanging))),
        ("taut in a current", with_current(taut)),
    ];
    for (name, given) in kinds {
        let (off, noise) = compare(&given).unwrap();
        assert!(off < 1e-5 && noise < 1e-3, "{name}: {off:e} {noise:e}");
    }
}

/// A material with a table of tensions over strains.
#[test]
fn stiffness_of_a_table_of_tensions() {
    let ends = [[0.0, 0.0, -60.0], [110.0, 60.0, -30.0]];
    let mut case = Given::new(120.0, 500.0, 1e7, ends).case();
    let material = case.materials.get_mut("m").unwrap();
    material.ea_n = None;
    material.strain = Some(vec![0.0, 0.05, 0.1, 0.2]);
    material.tension_n = Some(vec![0.0, 1e5, 4e5, 2e6]);
    let mut element = LineBetweenEnds::new(&case).unwrap();
    let line = element.solve(ends[0], ends[1]).unwrap();
    let step = 1e-3;
    for axis in 0..3 {
        let [up, down] = [step, -step].map(|by| {
            let mut b = ends[1];
            b[axis] += by;
            element.solve(ends[0], b).unwrap().forces_n()
        });
        for i in 0..2 {
            for k in 0..3 {
                let slope = (up[i][k] - down[i][k]) / (2.0 * step);
                let off = (line.stiffness_n_per_m[i][1][(k, axis)] - slope).abs();
                assert!(
                    off < 1e-5 * greatest_stiffness(&line),
                    "{i} {k} {axis}: {off}"
                );
            }
        }
    }
}

/// A warm start takes two or three iterations for a small motion.
#[test]
fn a_warm_start_takes_few_iterations() {
    let mut given = Given::new(120.0, 500.0, 1e8, [[0.0, 0.0, -60.0], [90.0, 40.0, -30.0]]);
    given.current = Some([0.8, 70.0]);
    let mut element = given.element();
    let [a, mut b] = given.ends;
    element.solve(a, b).unwrap();
    for by in [1e-3, 0.1, 1.0] {
        b[0] += by;
        let line = element.solve(a, b).unwrap();
        assert!(line.iterations <= 5, "{by}: {}", line.iterations);
        assert_eq!((line.position_m.len(), line.tension_n.len()), (41, 41));
        assert_eq!(
            (line.ends_m(), line.unstable_directions),
            ([V3::from(a), V3::from(b)], 0)
        );
        assert_eq!((line.min_bend_radius_m, line.on_bed_m), (None, 0.0));
    }
}

/// Friction resists the way the line was pulled since it was laid; laid again, it is that of the closed form.
#[test]
fn a_line_laid_again_has_the_friction_of_the_closed_form() {
    let mut given = Given::new(140.0, 500.0, 1e8, [[0.0, 0.0, -60.0], [112.0, 0.0, -10.0]]);
    given.bed = Some(Seabed {
        friction: Some(0.2),
        ..Seabed::level(60.0)
    });
    let mut element = given.element();
    element.solve(given.ends[0], [118.0, 0.0, -10.0]).unwrap();
    let pulled_before = element.solve(given.ends[0], given.ends[1]).unwrap();
    element.lay();
    let laid = element.solve(given.ends[0], given.ends[1]).unwrap();
    let fresh = given.solve();
    assert!(apart(laid.forces_n(), fresh.forces_n()) < 1e-6 * greatest(fresh.forces_n()));
    assert!(pulled_before.force_a_n[0].is_finite());
}

#[test]
fn an_end_that_moves_is_refused() {
    let given = Given::new(120.0, 500.0, 1e8, [[0.0; 3], [90.0, 0.0, 0.0]]);
    let mut case = given.case();
    case.ends.b.kind = EndKind::Free;
    let refused = LineBetweenEnds::new(&case).map(|_| ());
    assert_eq!(refused, Err(LineError::NotHeld { key: "ends.b" }));
}
