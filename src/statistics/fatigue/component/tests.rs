use super::*;

fn close(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-12 * b.abs()
}

fn chain(law: Law) -> FatigueComponent {
    let area = chain_area(0.1);
    FatigueComponent::new(
        "chain",
        law,
        Measure::Stress { nominal_area: area },
        Some(1e7),
    )
    .unwrap()
}

#[test]
fn a_stress_of_100_mpa() {
    let component = chain(Law::new(3.0, 6.0e10_f64.log10()));
    let range = 100e6 * chain_area(0.1);
    assert!(close(
        component.cycles_to_failure(range, 0.0).unwrap(),
        6.0e4
    ));
    let amplitude = component.clone().with_range_kind(RangeKind::Amplitude);
    assert!(close(
        amplitude.cycles_to_failure(range, 0.0).unwrap(),
        8.0 * 6.0e4
    ));
    let doubled = component.with_range_factor(2.0).unwrap();
    assert!(close(
        doubled.cycles_to_failure(range, 0.0).unwrap(),
        6.0e4 / 8.0
    ));
}

#[test]
fn a_wire_rope_by_its_mean_load() {
    let law = Law::new(4.09, 3.20).falling_with_mean(2.79);
    let rope = FatigueComponent::new("rope", law, Measure::TensionRatio, Some(5e6)).unwrap();
    let expected = 10.0_f64.powf(3.20 - 2.79 * 0.3) / 0.1_f64.powf(4.09);
    assert!(close(
        rope.cycles_to_failure(0.5e6, 1.5e6).unwrap(),
        expected
    ));
    let at_rest = rope.cycles_to_failure(0.5e6, 0.0).unwrap();
    assert_eq!(rope.cycles_to_failure(0.5e6, -1e5).unwrap(), at_rest);
    let above = rope.cycles_to_failure(0.5e6, 5e6).unwrap_err();
    assert!(above.to_string().contains("reaches the reference strength"));
}

#[test]
fn slopes_are_those_of_differences() {
    let knee = Law::new(3.0, 11.0)
        .with_knee(1e7, 5.0)
        .falling_with_mean(2.0);
    let component = chain(knee);
    for (range, mean) in [(4e6, 2e6), (1e5, 4e6), (4e5, 0.0)] {
        let at = component.cycle_damage(range, mean).unwrap();
        let log = |range: f64, mean: f64| component.cycle_damage(range, mean).unwrap().damage.ln();
        let by_range =
            (log(range * 1.001, mean) - log(range * 0.999, mean)) / (1.001_f64 / 0.999).ln();
        assert!((by_range - at.exponent).abs() < 1e-9, "{by_range} {at:?}");
        if mean > 0.0 {
            let by_mean = (log(range, mean + 10.0) - log(range, mean - 10.0)) / 20.0;
            assert!(
                (by_mean - at.mean_slope).abs() < 1e-5 * by_mean,
                "{by_mean} {at:?}"
            );
        }
    }
}

#[test]
fn both_slopes_meet_at_the_knee() {
    let component = chain(Law::new(3.0, 11.0).with_knee(1e6, 5.0));
    let range = 10.0_f64.powf((11.0 - 6.0) / 3.0) * 1e6 * chain_area(0.1);
    for factor in [1.0 - 1e-9, 1.0, 1.0 + 1e-9] {
        let cycles = component.cycles_to_failure(range * factor, 0.0).unwrap();
        assert!((cycles / 1e6 - 1.0).abs() < 1e-7);
    }
    let tenth = component.cycles_to_failure(0.1 * range, 0.0).unwrap();
    assert!((tenth / 1e11 - 1.0).abs() < 1e-9);
}

#[test]
fn no_range_does_no_damage() {
    let at_zero = chain(Law::new(3.0, 11.0).with_knee(1e6, 5.0))
        .cycle_damage(0.0, 1e5)
        .unwrap();
    assert_eq!((at_zero.damage, at_zero.exponent), (0.0, 5.0));
}

#[test]
fn bad_numbers_are_refused() {
    let law = Law::new(3.0, 2.5);
    let ratio = Measure::TensionRatio;
    assert!(matches!(
        FatigueComponent::new("", law, ratio, None),
        Err(CurveError::NoStrength { .. })
    ));
    for strength in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(FatigueComponent::new("", law, ratio, Some(strength)).is_err());
        let measure = Measure::Stress {
            nominal_area: strength,
        };
        assert!(FatigueComponent::new("", law, measure, None).is_err());
    }
    for bad in [
        Law::new(0.0, 1.0),
        Law::new(f64::NAN, 1.0),
        Law::new(3.0, 101.0),
    ] {
        assert!(bad.checked().is_err());
    }
    assert!(law.with_knee(0.0, 5.0).checked().is_err());
    assert!(law.with_knee(1e6, f64::INFINITY).checked().is_err());
    let component = FatigueComponent::new("", law, ratio, Some(1.0)).unwrap();
    assert!(
        component.cycle_damage(-1.0, 0.0).is_err()
            && component.cycle_damage(1.0, f64::NAN).is_err()
    );
    assert!(matches!(
        component.cycle_damage(1e200, 0.0),
        Err(CurveError::Overflow { .. })
    ));
}
