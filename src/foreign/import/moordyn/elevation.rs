//! Waves by a history of their elevation (`WaveKin` 3): `wave_elevation.txt` with rows of a time and a height.
//!
//! As MoorDyn v2 has them (source/Waves/WaveGrid.cpp): the history is read off every `dtWave` from time zero to its last time, linearly
//! between its rows and constant before the first; of an odd number of samples the last is left out; the Fourier transform of
//! them is cut above 0.5 Hz, and its components run together towards +x. They repeat after the length of the record.

use std::f64::consts::{PI, TAU};

use super::files::Files;
use crate::import::fault::Fault;
use crate::import::mooring::{Elevation, Given};
use crate::import::words::{Row, Word};
use crate::numerics::fourier::real_spectrum;

/// The name of the file.
const NAME: &str = "wave_elevation.txt";

/// Time between samples where the file is silent \[s\]: that of MoorDyn.
pub const STEP: f64 = 0.25;

/// Greatest number of samples.
const MOST: f64 = 1e6;

/// Frequency above which MoorDyn takes no components \[rad/s\].
pub const HIGHEST: f64 = 0.5 * TAU;

/// Amplitude below which a component is rounding, by the greatest.
const ROUNDING: f64 = 1e-10;

/// The waves of the history beside a file, sampled every `step` \[s\].
///
/// # Errors
/// The file is not there, a row of it is no time and height, or times do not rise.
pub fn elevation(
    files: &Files<'_>,
    at: Word<'_>,
    key: &str,
    step: &Given<f64>,
) -> Result<Elevation, Fault> {
    let name = Word { text: NAME, ..at };
    let span = at.span();
    let text = files.text(name, key).map_err(|fault| Fault {
        span: span.clone(),
        ..fault
    })?;
    let rows = rows(&text).map_err(|(line, problem)| {
        let problem = format!("line {line} of {NAME}: {problem}");
        let remedy = "write a time in s and a height in m on each row, times rising";
        Fault::new(span.clone(), key, problem, remedy)
    })?;
    let samples = samples(&rows, step.value);
    let samples = samples.map_err(|(problem, remedy)| {
        Fault::new(step.span.clone(), "OPTIONS, dtWave", problem, remedy)
    })?;
    Ok(components(&samples, step.value))
}

/// The waves of a history of times \[s\] and heights \[m\] sampled every `step` \[s\]; nothing where no waves are taken by that step.
#[must_use]
pub fn of_rows(rows: &[[f64; 2]], step: f64) -> Option<Elevation> {
    let samples = samples(rows, step).ok()?;
    Some(components(&samples, step))
}

/// Times \[s\] and heights \[m\]; or the line that is wrong, and why.
fn rows(text: &str) -> Result<Vec<[f64; 2]>, (usize, String)> {
    let mut rows: Vec<[f64; 2]> = Vec::new();
    for (number, row) in Row::all(text).enumerate() {
        let line = number + 1;
        let words = row.words();
        let [time, height, ..] = words.as_slice() else {
            if words.is_empty() {
                continue;
            }
            return Err((line, format!("`{}` is no time and height", row.text.trim())));
        };
        let number = |word: &Word<'_>| {
            let given = word.number();
            given.ok_or_else(|| (line, format!("`{}` is not a number", word.text)))
        };
        let now = [number(time)?, number(height)?];
        if let Some(before) = rows.last().filter(|before| now[0] <= before[0]) {
            let problem = format!("the time {} s does not come after {} s", now[0], before[0]);
            return Err((line, problem));
        }
        rows.push(now);
    }
    match rows.len() {
        0 | 1 => Err((1, "there are no two rows".to_owned())),
        _ => Ok(rows),
    }
}

/// The heights every `step` \[s\], an even number; or what is wrong with the step and what would be right.
fn samples(rows: &[[f64; 2]], step: f64) -> Result<Vec<f64>, (String, String)> {
    let last = rows[rows.len() - 1][0];
    let count = (last / step).floor() + 1.0;
    if !(step > 0.0 && (2.0..=MOST).contains(&count)) {
        let problem = format!("a step of {step} s takes no waves from a record of {last} s");
        let remedy = format!("give a step from {} to {last} s", last / MOST);
        return Err((problem, remedy));
    }
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "whole and in range"
    )]
    let count = count as usize / 2 * 2;
    let height = |k: usize| {
        let time = k as f64 * step;
        let next = rows.partition_point(|row| row[0] < time);
        let Some([to, end]) = rows.get(next) else {
            return rows[rows.len() - 1][1];
        };
        let before = next.checked_sub(1).map(|before| rows[before]);
        before.map_or(*end, |[from, begin]| {
            begin + (time - from) / (to - from) * (end - begin)
        })
    };
    Ok((0..count).map(height).collect())
}

/// The components of samples every `step` \[s\].
fn components(samples: &[f64], step: f64) -> Elevation {
    let n = samples.len();
    let spectrum = real_spectrum(&mut samples.to_vec());
    let interval = PI / (step * (n / 2) as f64);
    let component = |k: usize| {
        let twice = if 2 * k == n { 1.0 } else { 2.0 };
        let amplitude = twice * spectrum[k].norm() / n as f64;
        [k as f64 * interval, amplitude, spectrum[k].arg()]
    };
    let all: Vec<[f64; 3]> = (1..spectrum.len()).map(component).collect();
    let greatest = all.iter().map(|one| one[1]).fold(0.0, f64::max);
    let energy = |one: &[f64; 3]| one[1] * one[1];
    let whole: f64 = all.iter().map(energy).sum();
    let kept = all
        .into_iter()
        .filter(|one| one[0] <= HIGHEST && one[1] > ROUNDING * greatest);
    let kept: Vec<[f64; 3]> = kept.collect();
    let left: f64 = kept.iter().map(energy).sum();
    Elevation {
        mean: spectrum[0].re / n as f64,
        period: step * n as f64,
        lost: if whole > 0.0 {
            (1.0 - left / whole).max(0.0)
        } else {
            0.0
        },
        components: kept,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_components_pass_through_the_samples() {
        let height =
            |t: f64| 0.8 * (TAU / 12.0 * t + 0.3).cos() + 0.2 * (TAU / 4.0 * t).sin() + 0.1;
        let rows: Vec<[f64; 2]> = (0..=240)
            .map(|k| 0.1 * f64::from(k))
            .map(|t| [t, height(t)])
            .collect();
        let samples = samples(&rows, 0.5).unwrap();
        assert_eq!(samples.len(), 48);
        let found = components(&samples, 0.5);
        assert_eq!(found.components.len(), 2);
        assert!((found.mean - 0.1).abs() < 1e-14);
        assert!(found.lost < 1e-14);
        for k in 0..48 {
            let t = 0.5 * f64::from(k);
            let waves = found.components.iter();
            let sum: f64 = waves.map(|[w, a, phase]| a * (w * t + phase).cos()).sum();
            assert!((sum + found.mean - height(t)).abs() < 1e-12, "{t}");
        }
    }

    #[test]
    fn rows_that_are_none() {
        let fault = |text: &str| rows(text).unwrap_err();
        assert_eq!(fault("0 1\n1 high\n").0, 2);
        assert_eq!(fault("0 1\n1\n").1, "`1` is no time and height");
        assert_eq!(
            fault("0 1\n\n0 2\n"),
            (3, "the time 0 s does not come after 0 s".to_owned())
        );
    }
}
