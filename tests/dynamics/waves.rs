//! Snaps and vibrations that are known in closed form, of a bar or string and of the chain of lumps that stands for
//! it. The lumps are met to the error of the time steps, bar and string to the error of the mesh, both stated.
//!
//! Sources: Timoshenko, "Vibration problems in engineering", for bars and strings; Schrödinger, Annalen der
//! Physik 349 (1914) 916, for the chain of masses and springs, whose velocities are Bessel functions.

use std::f64::consts::PI;

use crate::march::{alpha, march, rk4};
use crate::period::Period;
use crate::rest::{at_rest, build};
use seacable::numerics::V3;
use seacable::solve::State;

const G: f64 = 9.80665;

/// Bessel function of the first kind, order 1: `1/pi` times the integral of cos(a - x sin a) from 0 to pi, by the
/// trapezoidal rule, which is exact to rounding for a periodic integrand.
fn j1(x: f64) -> f64 {
    let n = 120;
    let at = |i: i32| {
        let a = PI * f64::from(i) / f64::from(n);
        (a - x * a.sin()).cos()
    };
    let inner: f64 = (1..n).map(at).sum();
    (inner + 0.5 * (at(0) + at(n))) / f64::from(n)
}

/// Integral of J1(x)/x from 0 to `end`, by Simpson's rule.
fn stopped_chain(end: f64) -> f64 {
    let n = 2 * (end * 10.0).ceil().max(1.0) as i32;
    let h = end / f64::from(n);
    let at = |i: i32| {
        let x = f64::from(i) * h;
        if x == 0.0 { 0.5 } else { j1(x) / x }
    };
    let sum: f64 = (0..n / 2)
        .map(|k| at(2 * k) + 4.0 * at(2 * k + 1) + at(2 * k + 2))
        .sum();
    sum * h / 3.0
}

const STOPPED: &str = r#"
    environment.gravity_m_per_s2 = 0.0
    line.segments = 40
    start = { shape = "straight", elevation_deg = 0.0 }
"#;

/// A line that moves along itself at speed v, its end stopped: the tension at the stop is `v sqrt(EA m)` (bar
/// theory). The lumped line is a chain; there it is `v sqrt(EA m)` times the integral of J1(x)/x up to
/// `x = 2 sqrt(EA/m) t / l`: rises within one segment, overshoots by 8 % on any mesh, and settles at 1.
#[test]
fn a_stopped_line_snaps_by_bar_theory() {
    let scene = build(STOPPED);
    let (v, c, l) = (3.0, f64::sqrt(1e6 / 2.0), 100.0 / 40.0);
    let bar = v * f64::sqrt(1e6 * 2.0);
    let moving = || {
        let mut state = scene.initial_state();
        state.v[1..].fill(V3::x() * v);
        state
    };
    let first = |state: &State| {
        scene.line.segments[0]
            .axial
            .tension(&scene.line.chord(0, state))
            .value
    };
    // Half the way of the front to the far end; the fastest waves are still on the way.
    let (duration, h) = (0.5 * 100.0 / c, 0.05 * l / c);
    let mut peak = 0.0_f64;
    march(
        rk4(&scene),
        &scene,
        &mut moving(),
        (duration, h),
        |t, state| {
            let x = 2.0 * c * t / l;
            // RK4 turns the phase of the fastest wave (2 c h / l = 0.1 a step) by 0.1⁵/120 a step.
            let tolerance = bar * (t / h * 0.1_f64.powi(5) / 120.0 + 1e-9);
            let off = first(state) - bar * stopped_chain(x);
            assert!(off.abs() <= tolerance, "x = {x}: off by {off} N of {bar} N");
            peak = peak.max(first(state));
        },
    );
    // The overshoot is where J1 first vanishes, x = 3.8317, and is flat there.
    assert!(
        (peak / (bar * stopped_chain(3.8317)) - 1.0).abs() < 1e-3,
        "{}",
        peak / bar
    );
    for rho in [0.0, 0.4] {
        let (mut peak, mut energy) = (0.0_f64, 0.0_f64);
        march(
            alpha(&scene, rho),
            &scene,
            &mut moving(),
            (duration, l / c),
            |_, state| {
                peak = peak.max(first(state));
                energy = energy.max(scene.energy(state));
            },
        );
        // One step a segment: the steps overshoot like the lumps do, by 8 % once more at most.
        assert!(
            (1.0..1.16).contains(&(peak / bar)),
            "rho = {rho}: {}",
            peak / bar
        );
        let before = 0.5 * v * v * scene.line.mass[1..].iter().sum::<f64>();
        assert!(
            energy <= before * (1.0 + 1e-9),
            "rho = {rho}: {energy} J from {before} J"
        );
    }
}

/// A bob that runs into its slack, weightless line at speed v: T = v sqrt(EA/L M).
#[test]
fn a_bob_on_a_slack_line_snaps_by_its_energy() {
    let scene = build(
        r#"
        environment.gravity_m_per_s2 = 0.0
        line.segments = 1
        ends.b = { name = "bob", kind = "payload" }
        payload = { dry_mass_kg = 1000.0, volume_m3 = 0.0, drag_area_m2 = 0.0, added_mass_kg = 0.0 }
        start = { shape = "straight", elevation_deg = 0.0 }
        "#,
    );
    let (mass, k, v) = (1100.0, 1e6 / 100.0, 2.0);
    let omega = f64::sqrt(k / mass);
    let expected = v * f64::sqrt(k * mass);
    let slack = || {
        let mut state = scene.initial_state();
        state.x[1].x = 97.0;
        state.v[1].x = v;
        state
    };
    let mut peak = 0.0_f64;
    let tension = |state: &State| {
        scene.line.segments[0]
            .axial
            .tension(&scene.line.chord(0, state))
            .value
    };
    for h in [0.02 / omega, 0.1 / omega] {
        // The step in which the line comes taut has the wrong stiffness for a part of it, an impulse error of
        // k v h²/2 at most; the top of the sine is met to (omega h / 2)²/2.
        let tolerance = (omega * h).powi(2);
        let time = (1.5 + 3.0 / omega, h);
        march(rk4(&scene), &scene, &mut slack(), time, |_, s| {
            peak = peak.max(tension(s));
        });
        assert!(
            (peak / expected - 1.0).abs() < tolerance,
            "{peak} {expected}"
        );
        peak = 0.0;
        march(alpha(&scene, 0.4), &scene, &mut slack(), time, |_, s| {
            peak = peak.max(tension(s));
        });
        assert!(
            (peak / expected - 1.0).abs() < tolerance,
            "{peak} {expected}"
        );
        peak = 0.0;
    }
}

/// Lowest frequency of a taut string, `omega = pi/L sqrt(T/m)`; of n lumps on it, `2 n/L sqrt(T/m) sin(pi/2n)`, with
/// m per stretched length.
#[test]
fn a_taut_string_has_its_first_frequency() {
    let n = 20;
    let scene = build(
        r#"
        environment.gravity_m_per_s2 = 0.0
        line.segments = 20
        ends.b = { name = "post", kind = "fixed", position_m = [101.0, 0.0, 0.0] }
        start.shape = "straight"
        "#,
    );
    let (tension, length, mass) = (1e4_f64, 101.0, 2.0 / 1.01);
    let wave = (tension / mass).sqrt();
    let string = PI / length * wave;
    let lumped = 2.0 * n as f64 / length * wave * (0.5 * PI / n as f64).sin();
    let mut state = scene.initial_state();
    // An amplitude of 1 cm raises the tension by EA (pi a / 2 L)², 2.4e-6 of it.
    let amplitude = 0.01;
    for i in 1..n {
        state.v[i].y = amplitude * lumped * (PI * i as f64 / n as f64).sin();
    }
    let mut period = Period::default();
    let h = 0.4 * scene.explicit_limit().0;
    march(rk4(&scene), &scene, &mut state, (30.0, h), |t, s| {
        period.see(t, s.x[n / 2].y);
    });
    let measured = 2.0 * PI / period.mean();
    let stiffened = 1e6 / tension * (0.5 * PI * amplitude / length).powi(2);
    assert!(
        (measured / lumped - 1.0).abs() < stiffened,
        "{measured} {lumped}"
    );
    let mesh = (0.5 * PI / n as f64).powi(2) / 6.0;
    assert!(
        (measured / string - 1.0).abs() < mesh + stiffened,
        "{measured} {string}"
    );
}

/// Generalized-alpha gives a string's first mode its predicted period and decay over some
/// ten cycles.
#[test]
fn a_taut_string_swings_with_the_period_and_decay_of_the_method() {
    let n = 20;
    let scene = build(
        r#"
        environment.gravity_m_per_s2 = 0.0
        line.segments = 20
        ends.b = { name = "post", kind = "fixed", position_m = [101.0, 0.0, 0.0] }
        start.shape = "straight"
        "#,
    );
    let wave = (1e4_f64 / (2.0 / 1.01)).sqrt();
    let omega = 2.0 * n as f64 / 101.0 * wave * (0.5 * PI / n as f64).sin();
    for (rho, share) in [(0.4, 0.05), (0.0, 0.05), (0.4, 0.1), (1.0, 0.1)] {
        let h = share * 2.0 * PI / omega;
        let made =
            seacable::dynamics::numerical_damping::NumericalDamping::of_oscillator(rho, omega, h);
        let mut state = scene.initial_state();
        for i in 1..n {
            state.v[i].y = 1e-3 * omega * (PI * i as f64 / n as f64).sin();
        }
        let (mut period, mut energy) = (Period::default(), Vec::new());
        march(
            alpha(&scene, rho),
            &scene,
            &mut state,
            (200.5 * h, h),
            |t, s| {
                period.see(t, s.x[n / 2].y);
                energy.push(s.x[n / 2].y.powi(2) * omega * omega + s.v[n / 2].y.powi(2));
            },
        );
        let longer = period.mean() * omega / (2.0 * PI) - 1.0;
        assert!(
            (longer / made.elongation - 1.0).abs() < 0.05,
            "{rho} {share}: {longer} {made:?}"
        );
        let (early, late) = (energy[20], energy[180]);
        let decay = -0.5 * (late / early).ln() / (160.0 * h * omega) * (1.0 + made.elongation);
        assert!(
            (decay - made.damping).abs() < 0.05 * made.damping + 1e-5,
            "{rho} {share}: {decay} {made:?}"
        );
    }
}

const LOADED: &str = r#"
    line.segments = 10
    ends.b = { name = "bob", kind = "payload" }
    payload = { dry_mass_kg = 1000.0, volume_m3 = 0.0, drag_area_m2 = 0.0, added_mass_kg = 0.0 }
"#;

/// Root of a rising function between two bounds.
fn root(f: impl Fn(f64) -> f64, mut low: f64, mut high: f64) -> f64 {
    for _ in 0..80 {
        let middle = 0.5 * (low + high);
        if f(middle) < 0.0 {
            low = middle;
        } else {
            high = middle;
        }
    }
    0.5 * (low + high)
}

/// A payload bouncing on its line: `x tan x = m L / M`, `omega = x/L sqrt(EA/m)`; lumped, with x = n phi,
/// `2 tan(phi/2) tan(n phi) = m l / M`, `omega = 2/l sqrt(EA/m) sin(phi/2)` (both from the same separation of
/// variables). Lumping changes x by no more than x²/12n² of it, and omega by x²/24n² more.
#[test]
fn a_payload_bounces_on_its_line() {
    let scene = build(LOADED);
    let (c, n) = (f64::sqrt(1e6 / 2.0), 10.0);
    let x = root(|x| x * x.tan() - 0.2, 1e-9, 1.5);
    let bar = x / 100.0 * c;
    let phi = root(|p| 2.0 * (0.5 * p).tan() * (n * p).tan() - 0.02, 1e-9, 0.15);
    let lumped = 0.2 * c * (0.5 * phi).sin();
    let mut state = at_rest(&scene);
    let still = state.x[10].z;
    for i in 1..=10 {
        state.v[i].z = 0.2 * (i as f64 * phi).sin();
    }
    let mut period = Period::default();
    march(rk4(&scene), &scene, &mut state, (60.0, 0.002), |t, s| {
        period.see(t, s.x[10].z - still);
    });
    let measured = 2.0 * PI / period.mean();
    // Motion along a taut line is linear: only RK4's phase error (omega h)⁴/120 and the crossings are left.
    assert!(
        (measured / lumped - 1.0).abs() < (lumped * 0.002).powi(2),
        "{measured} {lumped}"
    );
    assert!(
        (measured / bar - 1.0).abs() < x * x / (8.0 * n * n),
        "{measured} {bar}"
    );
}

/// The top of a loaded line moves by A sin(omega t). Lumped: `u_j = C (cos((n-j) phi) - r sin((n-j) phi))` with
/// `r = M omega² l / (EA sin phi)` and u_0 = A; as a bar, phi = k l and `r = M omega² / (EA k)`.
#[test]
fn a_line_driven_at_its_top_follows_the_standing_wave() {
    let (m, ea, n, l, a) = (1000.0, 1e6, 10, 10.0, 0.05);
    for period in [2.5, 1.2] {
        let scene = build(&format!(
            "{LOADED}\nends.a = {{ kind = \"moving\", amplitude_m = [0.0, 0.0, {a}], period_s = {period} }}"
        ));
        let omega: f64 = 2.0 * PI / period;
        let wave = |phi: f64, slope: f64| {
            let r = m * omega * omega / (ea * slope);
            let shape =
                move |j: usize| ((n - j) as f64 * phi).cos() - r * ((n - j) as f64 * phi).sin();
            move |j: usize| a * shape(j) / shape(0)
        };
        let kl = omega * l * f64::sqrt(2.0 / ea);
        let phi = 2.0 * (0.5 * kl).asin();
        let (lumped, bar) = (wave(phi, phi.sin() / l), wave(kl, kl / l));
        let mut state = at_rest(&scene);
        let still = state.clone();
        for i in 1..=n {
            state.v[i].z = omega * lumped(i);
        }
        let h = 0.005;
        let mut worst = 0.0_f64;
        march(
            rk4(&scene),
            &scene,
            &mut state,
            (10.0 * period, h),
            |t, s| {
                for i in 0..=n {
                    let u = s.x[i].z - still.x[i].z;
                    worst = worst.max((u - lumped(i) * (omega * t).sin()).abs());
                }
            },
        );
        // RK4: an error of (omega h)⁵/120 of the largest amplitude a step, in velocity omega times that, which the
        // bounce of the payload (3 rad/s) makes up to omega/3 times as large. Statics may leave a force of 1e-8 of
        // the gross weight at every node; the line then swings about where it would be by the stretch of it.
        let left = 2.0 * 1e-8 * 1200.0 * G * n as f64 * 100.0 / ea;
        let steps = 10.0 * period / h;
        let largest = (0..=n).map(|j| lumped(j).abs()).fold(0.0, f64::max);
        let tolerance = (1.0 + omega / 3.0) * largest * steps * (omega * h).powi(5) / 120.0 + left;
        assert!(worst < tolerance, "{period} s: {worst} m, {tolerance} m");
        // Lumping: the wave number is off by (k l)²/24 of it over n segments, r by twice (k l)²/8 at most.
        let gain = lumped(n) / bar(n) - 1.0;
        let mesh = kl * kl * (n as f64 * kl / 24.0 + 0.25) * (1.0 + (bar(n) / a).abs());
        assert!(gain.abs() < mesh, "{period} s: {gain} {mesh}");
    }
}
