//! Waves by their frequencies at the nodes, which have no dynamic pressure in `MoorDyn`, and the history of their elevation that has it.

use std::f64::consts::TAU;

use super::finding::{AuditFinding, Topic};
use crate::import::moordyn::elevation::{HIGHEST, STEP, of_rows};
use crate::import::mooring::{Elevation, Mooring, ProgramSetting, WaveComponent};
use crate::number::digits;

/// `WaveKin` of waves that are summed at the nodes.
const BY_FREQUENCIES: f64 = 7.0;
/// Most samples of a history times components that are tried.
const MOST_WORK: f64 = 1e7;
/// Most periods of the slowest wave after which a history may repeat.
const MOST_PERIODS: u32 = 1000;
/// Difference of a frequency from a whole multiple, by the lowest, that is rounding.
const ROUNDING: f64 = 1e-7;
/// Difference of the waves that were read back, by their greatest height, up to which they are the same.
const SAME: f64 = 1e-6;

/// Rods that lack the pressure of the waves on their ends (`SpectrumKinWrapper::getWaveKin` in `source/Waves.hpp` of `MoorDyn`, version 2.7, and
/// `Rod::doRHS`).
#[must_use]
pub fn find(mooring: &Mooring) -> Option<AuditFinding> {
    let waves = mooring.sea.waves.as_ref()?;
    let setting = mooring.setting("wavekin").and_then(ProgramSetting::number);
    let rods = mooring.rods.iter().filter(|rod| !rod.is_joint());
    let ids: Vec<&str> = rods.map(|rod| rod.id.as_str()).collect();
    if setting != Some(BY_FREQUENCIES) || ids.is_empty() {
        return None;
    }
    let what = format!(
        "waves by frequencies at the nodes (WaveKin 7) have no dynamic pressure in MoorDyn 2.7, which so leaves out the push of the waves along rods, on their ends: {}",
        ids.join(", ")
    );
    let remedy = match as_history(&waves.value) {
        Ok(history) => format!(
            "give the elevation of the same waves over a grid (WaveKin 3), which has the pressure: wave_elevation.txt of {} s and dtWave {}, of which they were read back",
            digits(history.period, 8),
            digits(history.step, 8)
        ),
        Err(why) => format!("none that was tried: {why}"),
    };
    Some(AuditFinding::new(Topic::Setting, "WaveKin", what, remedy).at(&waves.span))
}

/// A history of elevation.
struct ElevationHistory {
    period: f64,
    step: f64,
}

/// The history of these waves by which `MoorDyn` has the same, or why there is none.
fn as_history(waves: &[WaveComponent]) -> Result<ElevationHistory, &'static str> {
    if waves.iter().any(|wave| wave.direction != 0.0) {
        return Err(
            "waves by a history of their elevation (WaveKin 3) run towards +x, and these do not",
        );
    }
    if waves.iter().any(|wave| wave.frequency > HIGHEST) {
        return Err("a history of their elevation (WaveKin 3) has no waves above 0.5 Hz");
    }
    let period = common_period(waves)
        .ok_or("a history of their elevation (WaveKin 3) does not repeat with these frequencies")?;
    let samples = 2.0 * (0.5 * period / STEP).ceil();
    if samples * waves.len() as f64 > MOST_WORK {
        return Err("a history of their elevation (WaveKin 3) is too long");
    }
    let step = period / samples;
    let times = (0..).map(|k| f64::from(k) * step);
    let times = times.take_while(|time| *time < period + 0.5 * step);
    let rows: Vec<[f64; 2]> = times.map(|time| [time, height(waves, time)]).collect();
    let is_same = of_rows(&rows, step).is_some_and(|read| is_read_back(waves, &read, period));
    match is_same {
        true => Ok(ElevationHistory { period, step }),
        false => Err("a history of their elevation (WaveKin 3) was read back as other waves"),
    }
}

/// The elevation at the origin \[m\].
fn height(waves: &[WaveComponent], time: f64) -> f64 {
    let heights = waves.iter();
    heights
        .map(|wave| wave.amplitude * (wave.frequency * time + wave.phase).cos())
        .sum()
}

/// The shortest time \[s\] after which all waves repeat; nothing where that is too long.
fn common_period(waves: &[WaveComponent]) -> Option<f64> {
    let lowest = waves
        .iter()
        .map(|wave| wave.frequency)
        .fold(f64::INFINITY, f64::min);
    let bases = (1..=MOST_PERIODS).map(|periods| lowest / f64::from(periods));
    let is_multiple = |frequency: f64, base: f64| {
        let multiple = frequency / base;
        (multiple - multiple.round()).abs() <= ROUNDING * multiple
    };
    let mut common =
        bases.filter(|base| waves.iter().all(|wave| is_multiple(wave.frequency, *base)));
    common.next().map(|base| TAU / base)
}

/// Whether waves that were read of a history are these, between its samples too.
fn is_read_back(waves: &[WaveComponent], read: &Elevation, period: f64) -> bool {
    const TIMES: u32 = 37;
    let greatest: f64 = waves.iter().map(|wave| wave.amplitude).sum();
    (0..TIMES).all(|k| {
        let time = period * f64::from(k) / f64::from(TIMES);
        let found = read.components.iter();
        let found: f64 = found
            .map(|[w, a, phase]| a * (w * time + phase).cos())
            .sum();
        (found + read.mean - height(waves, time)).abs() <= SAME * greatest
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn wave(frequency: f64, direction: f64) -> WaveComponent {
        WaveComponent {
            frequency,
            amplitude: 1.5,
            phase: 0.4,
            direction,
        }
    }

    #[test]
    fn a_history_is_proposed_where_it_has_the_same_waves() {
        let history = as_history(&[wave(0.6, 0.0), wave(0.9, 0.0)]).unwrap();
        assert!((history.period / (TAU / 0.3) - 1.0).abs() < 1e-12);
        assert!(history.step <= STEP);
        for (waves, why) in [
            ([wave(0.6, 0.0), wave(0.9, 1.0)], "towards +x"),
            ([wave(0.6, 0.0), wave(3.3, 0.0)], "above 0.5 Hz"),
            (
                [wave(0.6, 0.0), wave(0.6 * 2f64.sqrt(), 0.0)],
                "does not repeat",
            ),
        ] {
            let found = as_history(&waves).err().unwrap();
            assert!(found.contains(why), "{found}");
        }
    }
}
