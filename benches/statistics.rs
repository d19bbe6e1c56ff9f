//! Statistics of a stored run by part: CPU time of one core for 23 channels of 3 h in steps of 0.1 s, least of several repeats. Run with
//! `cargo bench --bench statistics`.
#![expect(
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "a bench prints its table and may stop at a fault"
)]

use std::f64::consts::TAU;
use std::fs;
use std::hint::black_box;

use rustix::time::{ClockId, clock_gettime};
use seacable::extremes::convergence::MeanEstimate;
use seacable::extremes::greatest::{GreatestQuestion, PeakSample};
use seacable::extremes::moments::mean_crossing_rate;
use seacable::extremes::spectrum::welch;
use seacable::extremes::threshold::{ThresholdChoice, ThresholdSearch};
use seacable::extremes::{IntervalMethod, Statistic};
use seacable::numerics::random::Random;
use seacable::numerics::statistics::Statistics;
use seacable::run::store::{channel_rows, write_history};
use seacable::run::{Channel, History};

const CHANNELS: u32 = 23;
const ROWS: u32 = 108_000;
const STEP: f64 = 0.1;
const REPEATS: usize = 5;

fn main() {
    let channels: Vec<Vec<f64>> = (0..CHANNELS).map(tension).collect();
    let mut whole = 0.0;
    let mut row = |part: &str, seconds: f64| {
        whole += seconds;
        println!("{part:<38} {:>8.1}", 1e3 * seconds);
    };
    println!("{:<38} {:>8}", "part", "CPU ms");
    row("reading", reading(&channels));
    let each = |part: &dyn Fn(&[f64])| least(|| channels.iter().for_each(|values| part(values)));
    row(
        "moments",
        each(&|values| {
            black_box(Statistics::of_values(values));
            black_box(mean_crossing_rate(values, STEP)).unwrap();
        }),
    );
    row(
        "mean with its error",
        each(&|values| drop(black_box(MeanEstimate::of_record(values)))),
    );
    row(
        "spectrum",
        each(&|values| drop(black_box(welch(values, STEP, None)))),
    );
    row("peaks", each(&|values| drop(black_box(peaks(values)))));
    let samples: Vec<PeakSample> = channels.iter().map(|values| peaks(values)).collect();
    let each = |part: &dyn Fn(&PeakSample)| least(|| samples.iter().for_each(part));
    row("Weibull, both figures", each(&weibull));
    row(
        "search for a threshold",
        each(&|sample| drop(black_box(search(sample)))),
    );
    let above: Vec<PeakSample> = samples.iter().map(above_threshold).collect();
    row(
        "Pareto, both figures",
        least(|| above.iter().for_each(pareto)),
    );
    println!("{:<38} {:>8.1}", "whole", 1e3 * whole);
    let peaks: usize = samples.iter().map(|sample| sample.peaks.len()).sum();
    println!("{} peaks a channel", peaks / samples.len());
}

/// A tension of waves near 10 s with part of its square, as drag brings it: peaks of a tail of its own.
fn tension(number: u32) -> Vec<f64> {
    let mut random = Random::new(u64::from(number), 0);
    let waves: Vec<[f64; 3]> = (0..60)
        .map(|_| {
            let period = random.between(6.0, 14.0);
            [
                TAU / period,
                TAU * random.uniform(),
                random.between(500.0, 2000.0),
            ]
        })
        .collect();
    let drag = random.between(0.0, 1.0);
    let at = |row: u32| {
        let time = STEP * f64::from(row);
        let sum = waves
            .iter()
            .map(|[omega, phase, a]| a * (omega * time + phase).sin());
        let force: f64 = sum.sum();
        5e4 + force + drag * force * force.abs() / 1e4
    };
    (0..ROWS).map(at).collect()
}

/// Reading the file of a stored run.
fn reading(channels: &[Vec<f64>]) -> f64 {
    let named = channels.iter().enumerate().map(|(number, values)| Channel {
        values: values.clone(),
        ..Channel::new(
            format!("tension_n[s{number}|s{}]", number + 1)
                .parse()
                .unwrap(),
        )
    });
    let history = History {
        time: (0..ROWS).map(|row| STEP * f64::from(row)).collect(),
        channels: named.collect(),
    };
    let dir = tempfile::tempdir().unwrap();
    fs::write(
        dir.path().join("history.csv"),
        write_history(&history).unwrap(),
    )
    .unwrap();
    let rows = || channel_rows(dir.path(), 0.0, |_| true).unwrap();
    assert_eq!(rows().values, channels);
    least(|| drop(black_box(rows())))
}

fn peaks(values: &[f64]) -> PeakSample {
    PeakSample::global_maxima(values, STEP).unwrap()
}

fn question(statistic: Statistic, method: IntervalMethod) -> GreatestQuestion {
    GreatestQuestion {
        statistic,
        hours: 3.0,
        level: 0.95,
        method,
    }
}

fn weibull(sample: &PeakSample) {
    for statistic in [Statistic::MostProbable, Statistic::Expected] {
        let question = question(statistic, IntervalMethod::Conditional);
        black_box(sample.by_weibull(&question)).unwrap();
    }
}

fn search(sample: &PeakSample) -> ThresholdChoice {
    let (statistic, count) = (Statistic::MostProbable, 3.0 * sample.rate());
    ThresholdChoice::search(&sample.peaks, statistic, count, &ThresholdSearch::default()).unwrap()
}

fn above_threshold(sample: &PeakSample) -> PeakSample {
    sample.above(search(sample).best().unwrap().fit.threshold)
}

fn pareto(sample: &PeakSample) {
    for statistic in [Statistic::MostProbable, Statistic::Expected] {
        let question = question(statistic, IntervalMethod::ProfileLikelihood);
        black_box(sample.by_pareto(&question)).unwrap();
    }
}

/// Least CPU time of several repeats \[s\].
fn least(mut f: impl FnMut()) -> f64 {
    let once = |_| {
        let start = cpu_time();
        f();
        cpu_time() - start
    };
    (0..REPEATS).map(once).fold(f64::INFINITY, f64::min)
}

/// CPU time of the process \[s\].
fn cpu_time() -> f64 {
    let t = clock_gettime(ClockId::ProcessCPUTime);
    t.tv_sec as f64 + 1e-9 * t.tv_nsec as f64
}
