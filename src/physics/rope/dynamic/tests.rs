//! The dynamic stiffness and its means, one by one.

use super::*;

fn polyester(reading: StiffnessForm) -> FibreRope {
    FibreRope {
        alpha: 14.469,
        beta: 0.2113,
        gamma: 0.2697,
        strength: 14.715e6,
        reading,
        window: f64::INFINITY,
        shared: false,
    }
}

fn readings() -> [FibreRope; 3] {
    let curve = TensionTable::new(&[0.0, 0.01, 0.05], &[0.0, 1.8e6, 12.0e6]).unwrap();
    [
        StiffnessForm::Secant,
        StiffnessForm::AboutTheMean(StaticElasticity::Linear(12.2 * 14.715e6)),
        StiffnessForm::AboutTheMean(StaticElasticity::TensionTable(curve)),
    ]
    .map(polyester)
}

fn mean_of(rope: &FibreRope, tension: f64) -> MeanState {
    MeanState {
        tension,
        strain: rope.strain_at(tension),
    }
}

/// Zhu, Yin and Shen 2017, sec. 3: Lm from 13.47 to 14.06, stiffness about 17.315 and 17.44 at the two ends.
#[test]
fn stiffness_is_as_printed() {
    let rope = polyester(StiffnessForm::Secant);
    assert!((rope.stiffness(13.47, 0.0) - 17.315).abs() < 1e-3);
    assert!((rope.stiffness(14.06, 0.0) - 17.440).abs() < 1e-3);
}

#[test]
fn tension_is_the_stiffness_times_the_strain() {
    let mean = 2.0e6;
    for strain in [0.004, 0.0078, 0.012] {
        let secant = polyester(StiffnessForm::Secant);
        let tension = secant.in_motion(strain, &mean_of(&secant, mean)).tension;
        let deviation = secant.percent(tension - mean);
        let k = secant.stiffness(secant.percent(mean), deviation);
        assert!((k * secant.strength * strain / tension - 1.0).abs() < 1e-12);
        for about in &readings()[1..] {
            let from = mean_of(about, mean);
            let tension = about.in_motion(strain, &from).tension;
            let k = about.stiffness(about.percent(mean), about.percent(tension - mean));
            let expected = mean + k * about.strength * (strain - from.strain);
            assert!(tension <= 0.0 || (expected / tension - 1.0).abs() < 1e-12);
        }
    }
}

#[test]
fn at_rest_and_in_motion_agree_where_the_tension_is_its_mean() {
    for rope in readings() {
        for tension in [1e5, 2e6, 7e6, 14e6] {
            let mean = mean_of(&rope, tension);
            assert!((rope.at_rest(mean.strain).tension / tension - 1.0).abs() < 1e-9);
            let moving = rope.in_motion(mean.strain, &mean);
            assert!((moving.tension / tension - 1.0).abs() < 1e-9);
            assert!(moving.by_strain > 0.0);
        }
    }
}

#[test]
fn slopes_and_energies_go_with_the_tension() {
    let h = 1e-7;
    for rope in readings() {
        let mean = mean_of(&rope, 2.1e6);
        for i in -3..60 {
            let strain = f64::from(i) * 8e-4 + 1e-4;
            let at = |e: f64| rope.in_motion(e, &mean);
            let here = at(strain);
            let slope = (at(strain + h).tension - at(strain - h).tension) / (2.0 * h);
            assert!(
                (slope / here.by_strain - 1.0).abs() < 1e-5,
                "{rope:?} {strain}"
            );
            let stored = |e: f64| rope.stored_in_motion(e, &mean).0;
            let force = (stored(strain + h) - stored(strain - h)) / (2.0 * h);
            assert!(
                (force - here.tension.max(0.0)).abs() < 50.0,
                "{rope:?} {strain}"
            );
            let rest = |e: f64| rope.at_rest(e);
            let slope = (rest(strain + h).tension - rest(strain - h).tension) / (2.0 * h);
            assert!((slope / rest(strain).by_strain - 1.0).abs() < 1e-5);
            let stored = |e: f64| rope.stored_at_rest(e);
            let force = (stored(strain + h) - stored(strain - h)) / (2.0 * h);
            if strain > h {
                assert!(
                    (force - rest(strain).tension).abs() < 50.0,
                    "{rope:?} {strain}"
                );
                let back = rope.strain_at(rest(strain).tension);
                assert!((back - strain).abs() < 1e-12, "{rope:?} {strain}");
            }
        }
    }
}

#[test]
fn energy_grows_with_the_mean_as_expected() {
    for rope in readings() {
        for strain in [0.003, 0.008, 0.02] {
            let stored = |tension: f64| rope.stored_in_motion(strain, &mean_of(&rope, tension));
            let (m, h) = (2.1e6, 10.0);
            let slope = (stored(m + h).0 - stored(m - h).0) / (2.0 * h);
            let expected = stored(m).1;
            assert!(
                (slope - expected).abs() < 1e-6 * (1.0 + expected.abs()),
                "{rope:?} {strain}"
            );
        }
    }
}

#[test]
fn no_tension_exceeds_the_steepest_slope() {
    for rope in readings() {
        for percent in [0.0, 10.0, 25.0, 49.0] {
            let mean = mean_of(&rope, 0.01 * percent * rope.strength);
            for i in 0..100 {
                let here = rope.in_motion(f64::from(i) * 5e-4, &mean);
                assert!(here.by_strain <= rope.max_stiffness() * (1.0 + 1e-12));
            }
        }
    }
}

/// The average of a rope that is one segment.
fn average_of(rope: &FibreRope, strain: f64, mean: &MeanState) -> RopeAverage {
    let from = match rope.reading {
        StiffnessForm::Secant => 0.0,
        StiffnessForm::AboutTheMean(_) => mean.strain,
    };
    RopeAverage {
        tension: mean.tension,
        strain: strain - from,
    }
}

#[test]
fn a_rope_of_one_segment_shares_its_stiffness_with_itself() {
    for rope in readings() {
        let mean = mean_of(&rope, 2.1e6);
        for i in 1..30 {
            let strain = f64::from(i) * 8e-4;
            let own = rope.in_motion(strain, &mean);
            if own.tension <= 0.0 {
                continue;
            }
            let average = average_of(&rope, strain, &mean);
            let k = rope.shared_stiffness(&average);
            let shared = rope.in_step(strain, Some(&mean), k);
            assert!((shared.tension / own.tension - 1.0).abs() < 1e-12);
            let deviation = rope.percent(own.tension - mean.tension);
            assert!((rope.shared_deviation(&average, k) - deviation).abs() < 1e-9);
            assert!((rope.stiffness(rope.percent(mean.tension), deviation) - k).abs() < 1e-9);
        }
    }
}

#[test]
fn energy_under_a_shared_stiffness_goes_with_tension_and_time() {
    for rope in readings() {
        for strain in [0.003, 0.008, 0.02] {
            // Averages and mean state at a time t [s], at some rates.
            let at = |t: f64| {
                let mean = MeanState {
                    tension: 2.1e6 + 3e4 * t,
                    strain: 0.009 + 2e-4 * t,
                };
                let average = RopeAverage {
                    tension: 2.0e6 + 2e4 * t,
                    strain: 0.001 - 1e-4 * t,
                };
                (mean, average)
            };
            let stored = |strain: f64, t: f64| {
                let (mean, average) = at(t);
                let rates = (at(1.0), at(0.0));
                let mean_rate = MeanState {
                    tension: rates.0.0.tension - rates.1.0.tension,
                    strain: rates.0.0.strain - rates.1.0.strain,
                };
                let average_rate = RopeAverage {
                    tension: rates.0.1.tension - rates.1.1.tension,
                    strain: rates.0.1.strain - rates.1.1.strain,
                };
                let k = rope.shared_stiffness(&average);
                let k_rate = rope.shared_stiffness_rate(&average, &average_rate);
                let tension = rope.in_step(strain, Some(&mean), k).tension;
                let found = rope.stored_in_step(strain, Some((&mean, &mean_rate)), (k, k_rate));
                (found, tension)
            };
            let h = 1e-7;
            let ((_, rate), tension) = stored(strain, 0.0);
            let force = (stored(strain + h, 0.0).0.0 - stored(strain - h, 0.0).0.0) / (2.0 * h);
            assert!((force - tension.max(0.0)).abs() < 50.0, "{rope:?} {strain}");
            let h = 1e-4;
            let slope = (stored(strain, h).0.0 - stored(strain, -h).0.0) / (2.0 * h);
            assert!(
                (slope - rate).abs() < 1e-5 * (1.0 + rate.abs()),
                "{rope:?} {strain} {slope} {rate}"
            );
        }
    }
}
