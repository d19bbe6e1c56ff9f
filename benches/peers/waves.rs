//! An irregular sea of 100 components, as each program reads it.

use std::f64::consts::{FRAC_PI_2, TAU};

/// Time after which the sea repeats \[s\].
const REPEATS_AFTER_S: f64 = 250.0;
/// Its components are these multiples of the lowest frequency: 0.04 to 0.436 Hz.
const MULTIPLES: std::ops::Range<usize> = 10..110;
const SIGNIFICANT_HEIGHT_M: f64 = 6.0;
const PEAK_PERIOD_S: f64 = 10.0;

/// Time between heights of the sea in MoorDyn \[s\], its default.
const SAMPLE_S: f64 = 0.25;

/// A component by its angular frequency \[rad/s\], amplitude \[m\] and phase at time zero over x = 0 \[rad\].
#[derive(Debug, Clone, Copy)]
struct Component {
    frequency: f64,
    amplitude: f64,
    phase: f64,
}

/// JONSWAP with a peak enhancement of 3.3, without its factor.
fn spectrum(frequency: f64) -> f64 {
    let peak = TAU / PEAK_PERIOD_S;
    let width = if frequency <= peak { 0.07 } else { 0.09 };
    let off = (frequency / peak - 1.0) / width;
    let enhanced = 3.3_f64.powf((-0.5 * off * off).exp());
    enhanced * frequency.powi(-5) * (-1.25 * (peak / frequency).powi(4)).exp()
}

fn components() -> Vec<Component> {
    let frequencies = MULTIPLES.map(|k| TAU * k as f64 / REPEATS_AFTER_S);
    let sum: f64 = frequencies.clone().map(spectrum).sum();
    let mut seed = 1_u64;
    let component = |frequency| {
        // The generator of ANSI C.
        seed = (seed * 1_103_515_245 + 12_345) % (1 << 31);
        let share = spectrum(frequency) / sum;
        Component {
            frequency,
            amplitude: 0.25 * SIGNIFICANT_HEIGHT_M * (2.0 * share).sqrt(),
            phase: TAU * seed as f64 / (1_u64 << 31) as f64,
        }
    };
    frequencies.map(component).collect()
}

/// The table of a system here.
pub(crate) fn here() -> String {
    let all = components();
    let of = |value: fn(&Component) -> f64| all.iter().map(value).collect::<Vec<f64>>();
    format!(
        "\n[[waves]]\nkind = \"components\"\nperiods_s = {:?}\nheights_m = {:?}\nphases_deg = {:?}\n",
        of(|wave| TAU / wave.frequency),
        of(|wave| 2.0 * wave.amplitude),
        of(|wave| wave.phase.to_degrees()),
    )
}

/// MoorDyn's `wave_frequencies.txt`, whose elevations are sines of the phase.
pub(crate) fn frequencies() -> String {
    let row = |wave: &Component| {
        let (sin, cos) = (wave.phase + FRAC_PI_2).sin_cos();
        let [real, imaginary] = [cos, sin].map(|part| wave.amplitude * part);
        format!("{} {real} {imaginary} 0\n", wave.frequency)
    };
    let rows: String = components().iter().map(row).collect();
    format!("0 0 0 0\n{rows}")
}

/// MoorDyn's `wave_elevation.txt`.
pub(crate) fn elevation() -> String {
    let all = components();
    let count = (REPEATS_AFTER_S / SAMPLE_S) as usize;
    let row = |time: f64| {
        let heights = all
            .iter()
            .map(|wave| wave.amplitude * (wave.frequency * time + wave.phase).cos());
        format!("{time} {}\n", heights.sum::<f64>())
    };
    (0..=count).map(|k| row(k as f64 * SAMPLE_S)).collect()
}

/// MoorDyn's `water_grid.txt`: waves run along x and do not vary along y.
pub(crate) fn grid() -> String {
    let block = |places: Vec<f64>| {
        let words: Vec<String> = places.iter().map(ToString::to_string).collect();
        format!("1\n{}\n", words.join(" "))
    };
    let along = (0..=65).map(|k| -850.0 + 20.0 * f64::from(k)).collect();
    let mut up = vec![-200.0, -150.0, -100.0, -80.0, -60.0, -50.0];
    up.extend((0..=10).map(|k| -40.0 + 4.0 * f64::from(k)));
    format!("x\ny\nz\n{}{}{}", block(along), block(vec![0.0]), block(up))
}
