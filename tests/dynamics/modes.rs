//! Natural frequencies and mode shapes against closed forms, a dense solver, and themselves on other meshes and turned.

use std::f64::consts::{PI, TAU};

use nalgebra::DMatrix;
use proptest::prelude::*;
use seacable::case::Case;
use seacable::modes::{LineModes, ModeKind, ModePencil, WkbMedium, lowest, of_case};
use seacable::numerics::{BlockBand, V3};
use seacable::solve::{Factors, Kinematics, Residual};

use crate::lines::line;

fn frequencies(found: &LineModes) -> Vec<f64> {
    found.modes.iter().map(|m| m.mode.frequency_hz()).collect()
}

fn of_kind(found: &LineModes, kind: ModeKind) -> Vec<f64> {
    let modes = found.modes.iter().filter(|m| m.mode.kind == kind);
    modes.map(|m| m.mode.frequency_hz()).collect()
}

/// Asserts that errors fall with the square of the segment.
fn second_order(what: &str, errors: &[f64]) {
    for pair in errors.windows(2) {
        let order = (pair[0] / pair[1]).log2();
        assert!((order - 2.0).abs() < 0.1, "{what}: {errors:?}");
    }
}

const STRING_TENSION: f64 = 2.0e4;

/// 100 m of weightless string between 102 m apart, 2 kg/m, with as much added mass again.
fn string(segments: usize) -> Case {
    line(&format!(
        "environment.water_density_kg_per_m3 = 1000.0
         materials.rope.ea_n = 1.0e6
         materials.rope.wet_weight_kg_per_m = 0.0
         materials.rope.diameter_m = {}
         materials.rope.added_mass_normal = 1.0
         line.segments = {segments}
         ends.b.kind = \"fixed\"
         ends.b.position_m = [102.0, 0.0, 0.0]",
        (2.0 / (1000.0 * PI / 4.0_f64)).sqrt()
    ))
}

#[test]
fn a_taut_string() {
    // T = EA 2 %; twice 2 kg/m on 100 m, spread over 102 m.
    let mass = 2.0 * 2.0 * 100.0 / 102.0;
    let exact = |n: f64| n / (2.0 * 102.0) * (STRING_TENSION / mass).sqrt();
    let errors: Vec<f64> = [25, 50, 100]
        .into_iter()
        .map(|segments| {
            let found = of_case(&string(segments), 8).unwrap();
            for kind in [ModeKind::InPlane, ModeKind::OutOfPlane] {
                let all = of_kind(&found, kind);
                assert_eq!(all.len(), 4, "{kind:?}");
                for (n, frequency) in all.iter().enumerate() {
                    let n = n as f64 + 1.0;
                    // The lumped string itself: 2 N sin(n pi / 2N) for n pi.
                    let lumped = 2.0 * segments as f64 * (n * PI / (2.0 * segments as f64)).sin();
                    let expected = exact(n) * lumped / (n * PI);
                    assert!(
                        (frequency / expected - 1.0).abs() < 1e-9,
                        "{n}: {frequency}"
                    );
                }
            }
            for (i, named) in found.modes.iter().enumerate() {
                assert_eq!(named.mode.half_waves, i / 2 + 1);
                let off = (named.mode.frequency_hz() - exact((i / 2 + 1) as f64)).abs();
                assert!((named.error_hz.unwrap() / off - 1.0).abs() < 0.1);
            }
            (frequencies(&found)[6] / exact(4.0) - 1.0).abs()
        })
        .collect();
    second_order("string", &errors);
}

#[test]
fn along_a_string_it_stretches() {
    // Stretched by a tenth, the first mode along the string follows three across it, each in two directions.
    let case = line(
        "line.segments = 40
         materials.rope.wet_weight_kg_per_m = 0.0
         ends.b.kind = \"fixed\"
         ends.b.position_m = [110.0, 0.0, 0.0]",
    );
    let found = of_case(&case, 8).unwrap();
    let along = of_kind(&found, ModeKind::Along);
    // sqrt(EA / m) / 2 L of the unstretched length, on the lumped line.
    let exact = 40.0 * 2.0 / PI * (PI / 80.0).sin() * (1.0e6_f64 / 2.0).sqrt() / 200.0;
    assert!((along[0] / exact - 1.0).abs() < 1e-9, "{along:?} {exact}");
}

#[test]
fn a_hanging_chain() {
    /// Zeros of the Bessel function J0.
    const ZEROS: [f64; 4] = [
        2.404_825_557_695_773,
        5.520_078_110_286_311,
        8.653_727_912_911_013,
        11.791_534_439_014_28,
    ];
    let exact = |n: usize| ZEROS[n] / 2.0 * (9.81_f64 / 100.0).sqrt() / TAU;
    let on = |segments: usize| {
        let case = line(&format!(
            "materials.rope.ea_n = 1e10
             environment.gravity_m_per_s2 = 9.81
             line.segments = {segments}"
        ));
        of_case(&case, 8).unwrap()
    };
    let found = on(400);
    for kind in [ModeKind::InPlane, ModeKind::OutOfPlane] {
        for (n, frequency) in of_kind(&found, kind).iter().enumerate() {
            let off = (frequency / exact(n) - 1.0).abs();
            assert!(off < 3e-5 * (n as f64 + 1.0).powi(2), "{n}: {frequency}");
        }
    }
    let errors = [50, 100, 200].map(|n| (frequencies(&on(n))[0] / exact(0) - 1.0).abs());
    second_order("hanging chain", &errors);
    // The foot moves most, and mode n stands still at n - 1 places.
    let last = &found.modes[7].mode;
    assert_eq!(last.half_waves, 4);
    assert!((last.shape.last().unwrap().norm() - 1.0).abs() < 1e-12);
}

/// A beam of 10 m, EI = 100 N m², 2 kg/m, without weight.
fn beam(segments: usize, ends: &str) -> Case {
    line(&format!(
        "line.length_m = 10.0
         line.segments = {segments}
         materials.rope.wet_weight_kg_per_m = 0.0
         materials.rope.ei_n_m2 = 100.0
         start.shape = \"straight\"
         {ends}"
    ))
}

#[test]
fn euler_bernoulli_beams() {
    let free = "";
    let pinned = "ends.b.kind = \"fixed\"\nends.b.position_m = [10.0, 0.0, 0.0]";
    let clamped =
        format!("{pinned}\nends.a.clamp_elevation_deg = 0.0\nends.b.clamp_elevation_deg = 0.0");
    let cantilever = format!("{free}ends.a.clamp_elevation_deg = 0.0");
    let roots: [(&str, &str, [f64; 3]); 3] = [
        ("pinned", pinned, [PI, 2.0 * PI, 3.0 * PI]),
        (
            "clamped",
            &clamped,
            [
                4.730_040_744_862_704,
                7.853_204_624_095_838,
                10.995_607_838_001_671,
            ],
        ),
        (
            "cantilever",
            &cantilever,
            [
                1.875_104_068_711_961,
                4.694_091_132_974_175,
                7.854_757_438_237_613,
            ],
        ),
    ];
    for (name, ends, roots) in roots {
        let exact = roots.map(|b| (b / 10.0_f64).powi(2) * (100.0_f64 / 2.0).sqrt() / TAU);
        let on = |segments| {
            let found = of_case(&beam(segments, ends), 6).unwrap();
            of_kind(&found, ModeKind::InPlane)
        };
        let meshes = [20, 40, 80].map(on);
        for n in 0..3 {
            let errors: Vec<f64> = meshes
                .iter()
                .map(|m| (m[n] / exact[n] - 1.0).abs())
                .collect();
            second_order(name, &errors);
            assert!(errors[2] < 3e-3, "{name}, mode {}: {errors:?}", n + 1);
        }
    }
}

/// Irvine 1981, sec. 3.2: a cable of small sag, in-plane modes that stretch it from
/// `tan(W/2) = W/2 - (4 / lambda²) (W/2)³`, `W = omega L sqrt(m/H)`.
fn symmetric_root(lambda2: f64) -> f64 {
    let f =
        |w: f64| (w / 2.0).sin() - (w / 2.0).cos() * (w / 2.0 - 4.0 / lambda2 * (w / 2.0).powi(3));
    // The first root lies between the taut string, pi, and the inextensible cable, 2.86 pi.
    let (mut low, mut high) = (PI * 0.999, 2.99 * PI);
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if (f(middle) > 0.0) == (f(low) > 0.0) {
            low = middle;
        } else {
            high = middle;
        }
    }
    low
}

#[test]
fn a_cable_of_small_sag() {
    for ea in [2.0e5, 2.0e6, 2.0e7] {
        // 100 m level with a sag of about 1/100 once loaded: 2 kg/m, H about 2400 N.
        let sag = 1.0 / 100.0;
        let h = 2.0 * 9.81 * 100.0 / (8.0 * sag);
        let length = 100.0 * (1.0 + 8.0 / 3.0 * sag * sag) / (1.0 + h / ea);
        let case = line(&format!(
            "environment.gravity_m_per_s2 = 9.81
             materials.rope.ea_n = {ea:.1}
             line.length_m = {length}
             line.segments = 200
             ends.b.kind = \"fixed\"
             ends.b.position_m = [100.0, 0.0, 0.0]"
        ));
        let found = of_case(&case, 8).unwrap();
        let h = found.lines[0].scene.end_force(0, &found.lines[0].rest).x;
        let mass = 2.0 * length / 100.0;
        let load = mass * 9.81 * 100.0 / h;
        let lambda2 = load * load * ea / h / (1.0 + load * load / 8.0);
        let string = (h / mass).sqrt() / 100.0 / TAU;
        let expected = |w: f64| w * string;
        let (within, out) = (
            of_kind(&found, ModeKind::InPlane),
            of_kind(&found, ModeKind::OutOfPlane),
        );
        for (n, frequency) in out.iter().enumerate() {
            assert!((frequency / expected(PI * (n + 1) as f64) - 1.0).abs() < 2e-3);
        }
        let (symmetric, antisymmetric) = (expected(symmetric_root(lambda2)), expected(2.0 * PI));
        for exact in [symmetric, antisymmetric] {
            let nearest = within
                .iter()
                .map(|f| (f / exact - 1.0).abs())
                .fold(1.0, f64::min);
            assert!(
                nearest < 2e-3,
                "EA {ea}: {within:?} {exact} of lambda2 {lambda2}"
            );
        }
        // Beyond lambda² = 4 pi² the symmetric mode is the higher one, and the modes cross.
        assert_eq!(symmetric > antisymmetric, lambda2 > 4.0 * PI * PI);
    }
}

/// All eigenvalues of a small line from its dense matrices, by another route: `L^-1 K L^-T` with `M = L L'`.
fn dense(case: &Case) -> (Vec<f64>, Vec<f64>) {
    let found = of_case(case, 12).unwrap();
    let (scene, nodes) = (&found.lines[0].scene, found.lines[0].scene.nodes());
    let matrix = |mass: f64, stiffness: f64| {
        let mut residual = vec![V3::zeros(); nodes];
        let mut band = BlockBand::new(nodes);
        if scene.is_pentadiagonal() {
            band.widen();
        }
        let factors = Factors {
            mass,
            damping: 0.0,
            stiffness,
        };
        scene.linearise(0.0, &found.lines[0].rest, factors, &mut residual, &mut band);
        let free = scene.free();
        let (from, n) = (free.start, 3 * free.len());
        DMatrix::from_fn(n, n, |r, c| {
            let (i, j, at) = (from + r / 3, from + c / 3, (r % 3, c % 3));
            match j as isize - i as isize {
                0 => band.diag[i][at],
                1 => band.upper[i][at],
                -1 => band.lower[i][at],
                2 if scene.is_pentadiagonal() => band.far_upper[i][at],
                -2 if scene.is_pentadiagonal() => band.far_lower[i][at],
                _ => 0.0,
            }
        })
    };
    let factor = matrix(1.0, 0.0).cholesky().unwrap().l();
    let inner = factor
        .clone()
        .solve_lower_triangular(&matrix(0.0, 1.0))
        .unwrap();
    let whole = factor.solve_lower_triangular(&inner.transpose()).unwrap();
    let mut all: Vec<f64> = ((&whole + whole.transpose()) * 0.5)
        .symmetric_eigenvalues()
        .iter()
        .copied()
        .collect();
    all.sort_by(f64::total_cmp);
    let ours = found.modes.iter().map(|m| m.mode.eigenvalue).collect();
    (ours, all)
}

#[test]
fn a_dense_solver_finds_the_same() {
    let catenary =
        "ends.b.kind = \"fixed\"\nends.b.position_m = [60.0, 20.0, -30.0]\nline.segments = 14";
    let on_bed = "ends.b.kind = \"fixed\"\nends.b.position_m = [60.0, 0.0, -30.0]\nseabed.depth_m = 35.0\nline.segments = 20";
    let stiff = format!("{catenary}\nmaterials.rope.ei_n_m2 = 500.0\nmaterials.rope.ea_n = 1e8");
    for changes in [catenary, on_bed, &stiff] {
        let (ours, all) = dense(&line(changes));
        assert_eq!(ours.len(), 12);
        for (mine, exact) in ours.iter().zip(&all) {
            // Line that lies slack on the bed moves freely: eigenvalues of nothing.
            let off = (mine - exact).abs();
            assert!(
                off < 1e-7 * exact + 1e-16 * all[all.len() - 1],
                "{changes}: {mine} {exact}"
            );
        }
    }
}

#[test]
fn every_mode_of_a_short_line_can_be_had() {
    let case = line("line.segments = 3");
    let found = of_case(&case, 100).unwrap();
    assert_eq!(found.modes.len(), 9);
    // From the fundamental swing to the axial modes, each orthogonal to the others.
    let mut pencil = ModePencil::new(&found.lines[0].scene, &found.lines[0].rest);
    let pairs = lowest(&mut pencil, 100).unwrap();
    for (i, a) in pairs.iter().enumerate() {
        for (j, b) in pairs.iter().enumerate() {
            let product = pencil.mass_product(&a.vector, &b.vector);
            assert!((product - f64::from(u8::from(i == j))).abs() < 1e-8);
        }
        let rayleigh = pencil.stiffness_product(&a.vector);
        assert!((rayleigh / a.value - 1.0).abs() < 1e-9);
    }
}

#[test]
fn an_unstable_equilibrium_has_a_mode_that_grows() {
    // A rod stood on its clamped foot, too tall for its weight: the Euler-Greenhill height is (7.837 EI / w)^(1/3).
    let rod = |ei: f64| {
        let case = line(&format!(
            "environment.gravity_m_per_s2 = 9.81
             line.length_m = 10.0
             line.segments = 40
             materials.rope.ei_n_m2 = {ei:.3}
             start.shape = \"straight\"
             start.elevation_deg = 90.0
             ends.a.clamp_elevation_deg = 90.0"
        ));
        of_case(&case, 2).unwrap().modes[0].mode.eigenvalue
    };
    let critical = 2.0 * 9.81 * 1000.0 / 7.837;
    assert!(rod(1.05 * critical) > 0.0);
    assert!(rod(0.95 * critical) < 0.0);
}

#[test]
fn nothing_moves_and_is_refused() {
    let case = line(
        "line.segments = 1
         ends.b.kind = \"fixed\"
         ends.b.position_m = [100.5, 0.0, 0.0]",
    );
    let error = of_case(&case, 3).unwrap_err().to_string();
    assert!(error.contains("more segments"), "{error}");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn turned_and_moved_the_line_has_the_same_modes(
        azimuth in 0.0..TAU, x in -500.0..500.0, y in -500.0..500.0, far in 40.0..95.0_f64, deep in 5.0..30.0_f64,
        ei in prop::sample::select(vec![0.0, 300.0]),
    ) {
        let with = |angle: f64, dx: f64, dy: f64| {
            let bottom = -deep;
            let (bx, by) = (dx + far * angle.cos(), dy + far * angle.sin());
            let case = line(&format!(
                "line.segments = 24
                 materials.rope.ei_n_m2 = {ei:?}
                 ends.a.position_m = [{dx:?}, {dy:?}, 0.0]
                 ends.b.kind = \"fixed\"
                 ends.b.position_m = [{bx:?}, {by:?}, {bottom:?}]"));
            of_case(&case, 8).unwrap()
        };
        let (plain, turned) = (with(0.0, 0.0, 0.0), with(azimuth, x, y));
        for (a, b) in plain.modes.iter().zip(&turned.modes) {
            let (f, g) = (a.mode.frequency_hz(), b.mode.frequency_hz());
            prop_assert!((f / g - 1.0).abs() < 1e-7, "{f} {g}");
            prop_assert_eq!(a.mode.kind, b.mode.kind);
        }
    }

    #[test]
    fn never_a_number_that_is_none(
        segments in 1..12_usize, far in 1.0..140.0, deep in -60.0..60.0, ei in prop::sample::select(vec![0.0, 1.0, 1e5]),
        wet in -5.0..5.0, count in 1..40_usize,
    ) {
        let case = line(&format!(
            "line.segments = {segments}
             materials.rope.ei_n_m2 = {ei:?}
             materials.rope.wet_weight_kg_per_m = {wet:?}
             ends.b.kind = \"fixed\"
             ends.b.position_m = [{far:?}, 0.0, {deep:?}]"));
        if let Ok(found) = of_case(&case, count) {
            for named in &found.modes {
                prop_assert!(named.mode.frequency_hz().is_finite());
                prop_assert!(named.mode.shape.iter().all(|p| p.iter().all(|c| c.is_finite())));
                prop_assert!((-1e-9..=1.0 + 1e-9).contains(&named.mode.out_of_plane));
            }
        }
    }
}

#[test]
fn an_inclined_cable() {
    // Irvine 1981, sec. 2.6 and 3.2: a shallow cable between points at different heights rings as a level one along its chord,
    // under the weight across the chord and the tension at the middle.
    let (slope, chord) = (30.0_f64.to_radians(), 100.0);
    for ea in [1.0e8, 1.0e10] {
        let pull = 1.0e5;
        let across = 2.0 * 9.81 * slope.cos();
        let sag = across * chord / (8.0 * pull);
        let length = chord * (1.0 + 8.0 / 3.0 * sag * sag) / (1.0 + pull / ea);
        let case = line(&format!(
            "environment.gravity_m_per_s2 = 9.81
             materials.rope.ea_n = {ea:.1}
             line.length_m = {length}
             line.segments = 200
             ends.b.kind = \"fixed\"
             ends.b.position_m = [{}, 0.0, {}]",
            chord * slope.cos(),
            chord * slope.sin()
        ));
        let found = of_case(&case, 6).unwrap();
        let tension = found.lines[0].scene.tensions(&found.lines[0].rest)[100];
        let mass = 2.0 * length / chord;
        let load = mass * 9.81 * slope.cos() * chord / tension;
        let lambda2 = load * load * ea / tension / (1.0 + load * load / 8.0);
        let string = (tension / mass).sqrt() / chord / TAU;
        let within = of_kind(&found, ModeKind::InPlane);
        for exact in [symmetric_root(lambda2) * string, TAU * string] {
            let off = within.iter().map(|f| (f / exact - 1.0).abs());
            let nearest = off.fold(1.0, f64::min);
            assert!(nearest < 1e-3, "{ea}: {within:?} {exact} lambda² {lambda2}");
        }
    }
}

#[test]
fn a_beam_under_tension() {
    // Hinged at both ends: m omega² = EI k⁴ + T k², k = n pi / L, exactly.
    let on = |segments: usize| {
        of_case(
            &line(&format!(
                "materials.rope.wet_weight_kg_per_m = 0.0
                 materials.rope.ei_n_m2 = 2.0e4
                 materials.rope.ea_n = 1.0e7
                 line.segments = {segments}
                 ends.b.kind = \"fixed\"
                 ends.b.position_m = [100.1, 0.0, 0.0]"
            )),
            8,
        )
        .unwrap()
    };
    let exact = |n: usize| {
        let (k, mass) = (n as f64 * PI / 100.1, 2.0 * 100.0 / 100.1);
        ((2.0e4 * k.powi(4) + 1.0e4 * k * k) / mass).sqrt() / TAU
    };
    let found = on(200);
    for kind in [ModeKind::InPlane, ModeKind::OutOfPlane] {
        for (n, frequency) in of_kind(&found, kind).iter().enumerate() {
            // The bend is felt over unstretched lengths, a thousandth shorter.
            assert!(
                (frequency / exact(n + 1) - 1.0).abs() < 2e-3,
                "{n}: {frequency}"
            );
        }
    }
    let errors = [25, 50, 100].map(|n| frequencies(&on(n))[6] / frequencies(&on(400))[6] - 1.0);
    second_order("beam under tension", &errors.map(f64::abs));
    let medium = WkbMedium::of_line_at_rest(&found.lines[0].scene, &found.lines[0].rest).unwrap();
    for n in 1..5 {
        assert!((medium.frequency_hz(n).unwrap() / exact(n) - 1.0).abs() < 1e-3);
    }
}

#[test]
fn wkb_theory_nears_the_modes_of_an_upright_line_as_they_rise() {
    // 100 m upright under 500 N at its foot and 2462 N at its head.
    let case = line(
        "environment.gravity_m_per_s2 = 9.81
         materials.rope.ea_n = 1.0e9
         line.segments = 800
         ends.a.position_m = [0.0, 0.0, 100.000148]
         ends.b.kind = \"fixed\"
         ends.b.position_m = [0.0, 0.0, 0.0]",
    );
    let found = of_case(&case, 16).unwrap();
    let medium = WkbMedium::of_line_at_rest(&found.lines[0].scene, &found.lines[0].rest).unwrap();
    assert!((medium.tension[800] - 500.0).abs() < 10.0);
    let all = of_kind(&found, ModeKind::InPlane);
    let off: Vec<f64> = all
        .iter()
        .enumerate()
        .map(|(n, f)| (medium.frequency_hz(n + 1).unwrap() / f - 1.0).abs())
        .collect();
    assert!(
        off[0] < 2e-2 && off[3] < 2e-3 && off[3] < 0.2 * off[0],
        "{off:?}"
    );
}
