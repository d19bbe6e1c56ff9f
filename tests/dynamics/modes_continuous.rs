//! Natural frequencies of lines that carry a payload or come down on the bed, against the differential equations of the
//! continuous line and against themselves on finer meshes.

use std::f64::consts::{PI, TAU};

use crate::lines::line;
use seacable::modes::{LineModes, ModeKind, of_case};

fn of_kind(found: &LineModes, kind: ModeKind) -> Vec<f64> {
    let modes = found.modes.iter().filter(|m| m.mode.kind == kind);
    modes.map(|m| m.mode.frequency_hz()).collect()
}

/// The root of a function that changes sign once between two numbers.
fn root(f: impl Fn(f64) -> f64, (mut low, mut high): (f64, f64)) -> f64 {
    let sign = f(low) > 0.0;
    for _ in 0..100 {
        let middle = 0.5 * (low + high);
        if (f(middle) > 0.0) == sign {
            low = middle;
        } else {
            high = middle;
        }
    }
    low
}

/// The roots of a function in a range, to the step in which they are looked for.
fn roots(f: impl Fn(f64) -> f64 + Copy, upto: f64, step: f64) -> Vec<f64> {
    let n = (upto / step) as usize;
    let at = |i: usize| step * (i as f64 + 0.5);
    let brackets = (0..n).filter(|i| (f(at(*i)) > 0.0) != (f(at(*i + 1)) > 0.0));
    brackets.map(|i| root(f, (at(i), at(i + 1)))).collect()
}

/// A rope of 100 m with a payload of 500 kg at its foot, in water.
fn hung(segments: usize, ea: f64) -> LineModes {
    let case = line(&format!(
        r#"
        environment.gravity_m_per_s2 = 9.81
        environment.water_density_kg_per_m3 = 1000.0
        materials.rope.ea_n = {ea:?}
        materials.rope.diameter_m = 0.04
        materials.rope.wet_weight_kg_per_m = 1.2
        materials.rope.added_mass_normal = 1.0
        line.segments = {segments}
        ends.b = {{ name = "bob", kind = "payload" }}
        payload = {{ dry_mass_kg = 500.0, wet_mass_kg = 400.0, drag_area_m2 = 1.0, added_mass_kg = 200.0 }}
        "#
    ));
    of_case(&case, 24).unwrap()
}

/// Asserts that errors on meshes twice as fine each fall with the square of the segment, and are small at last.
fn second_order(what: &str, errors: &[f64], last: f64) {
    for pair in errors.windows(2) {
        let order = (pair[0] / pair[1]).log2();
        assert!((order - 2.0).abs() < 0.15, "{what}: {errors:?}");
    }
    assert!(errors[errors.len() - 1] < last, "{what}: {errors:?}");
}

/// `(T y')' + m omega² y = 0` from the payload, `T y' = -M omega² y`, up to the top, where y = 0: the equation of a hung line
/// (in Bessel functions of order zero), integrated by RK4. T goes with the stretched line, along which mass is thinner.
#[test]
fn a_payload_swings_on_its_line() {
    let (w, m) = (1.2 * 9.81, 2.0 + 1000.0 * PI / 4.0 * 0.04_f64.powi(2));
    let (load, mass) = (400.0 * 9.81, 700.0);
    let top = |hz: f64| {
        let omega2 = (TAU * hz).powi(2);
        let steps = 4000;
        let h = 100.0 / f64::from(steps);
        // By unstretched length: y' = q (1 + T/EA) / T.
        let slope = |s: f64, (y, q): (f64, f64)| {
            let t = load + w * s;
            (q * (1.0 + t / 1.0e7) / t, -m * omega2 * y)
        };
        let (mut y, mut q) = (1.0, -mass * omega2);
        for i in 0..steps {
            let s = h * f64::from(i);
            let k1 = slope(s, (y, q));
            let k2 = slope(s + 0.5 * h, (y + 0.5 * h * k1.0, q + 0.5 * h * k1.1));
            let k3 = slope(s + 0.5 * h, (y + 0.5 * h * k2.0, q + 0.5 * h * k2.1));
            let k4 = slope(s + h, (y + h * k3.0, q + h * k3.1));
            y += h / 6.0 * (k1.0 + 2.0 * k2.0 + 2.0 * k3.0 + k4.0);
            q += h / 6.0 * (k1.1 + 2.0 * k2.1 + 2.0 * k3.1 + k4.1);
        }
        y
    };
    let exact = roots(top, 1.2, 0.02);
    let meshes = [20, 40, 80].map(|n| of_kind(&hung(n, 1.0e7), ModeKind::InPlane));
    for (n, exact) in exact.iter().take(4).enumerate() {
        let errors: Vec<f64> = meshes.iter().map(|f| (f[n] / exact - 1.0).abs()).collect();
        // The swing of the payload itself is nearly free of the mesh.
        if n > 0 {
            second_order(&format!("mode {}", n + 1), &errors, 2e-3);
        }
        assert!(errors[2] < 2e-3, "{errors:?}");
    }
}

/// `x tan x = m L / M` with `x = omega L sqrt(m / EA)`: a bar with a mass at its foot.
#[test]
fn a_payload_bounces_on_its_line() {
    let x = root(|x: f64| x * x.tan() - 2.0 * 100.0 / 700.0, (1e-3, 1.5));
    let exact = x / (100.0 * TAU) * (1.0e6_f64 / 2.0).sqrt();
    let bounce = |n: usize| of_kind(&hung(n, 1.0e6), ModeKind::Along)[0];
    let errors = [10, 20, 40].map(|n| (bounce(n) / exact - 1.0).abs());
    second_order("bounce", &errors, 1e-4);
}

/// Where a line comes down on the bed the mesh knows to half a segment, and frequencies in its plane go with that, up and down
/// as it is refined: the error estimate must cover it.
#[test]
fn the_error_estimate_covers_the_place_of_the_touchdown() {
    let on = |segments: usize| {
        let case = line(&format!(
            r#"
            environment.gravity_m_per_s2 = 9.81
            environment.water_density_kg_per_m3 = 1025.0
            seabed = {{ depth_m = 200.0, stiffness_n_per_m3 = 3e5 }}
            materials.rope = {{ diameter_m = 0.16, mass_kg_per_m = 200.0, ea_n = 8e8, added_mass_normal = 1.0, wet_weight_kg_per_m = 179.39 }}
            line = {{ length_m = 652.0, segments = {segments} }}
            ends.a = {{ name = "anchor", kind = "anchor", position_m = [0.0, 0.0, -200.0] }}
            ends.b = {{ name = "ship", kind = "fixed", position_m = [596.0, 0.0, -10.0] }}
            "#
        ));
        of_case(&case, 6).unwrap()
    };
    let fine = of_kind(&on(1280), ModeKind::InPlane);
    for segments in [40, 60, 80, 120, 160] {
        let found = on(segments);
        let within = found
            .modes
            .iter()
            .filter(|m| m.mode.kind == ModeKind::InPlane);
        for (named, exact) in within.zip(&fine) {
            let (reported, frequency) = (named.error_hz.unwrap(), named.mode.frequency_hz());
            let off = (frequency - exact).abs();
            assert!(
                off < 1.5 * reported,
                "{segments}: {frequency} Hz, reported {reported}, off {off}"
            );
            assert!(
                reported < 0.05 * frequency,
                "{segments}: {reported} of {frequency}"
            );
        }
    }
}
