use super::*;
use crate::numerics::random::Random;

const STRESS: &str = r#"
[curve]
title = "Chain 84 mm"
kind = "stress"
m = 3.0
k = 6.0e10
diameter_m = 0.084
component = "chain"
"#;

fn cycles(text: &str, range: f64) -> f64 {
    read_curve(text)
        .unwrap()
        .cycles_to_failure(range, 1e6)
        .unwrap()
}

#[test]
fn a_stress_curve() {
    let range = 100e6 * chain_area(0.084);
    assert!((cycles(STRESS, range) / 6e4 - 1.0).abs() < 1e-12);
    assert_eq!(read_curve(STRESS).unwrap().title(), "Chain 84 mm");
    let amplitude = format!("{STRESS}range = \"amplitude\"\n");
    assert!((cycles(&amplitude, range) / 48e4 - 1.0).abs() < 1e-12);
    let knee = format!("{STRESS}knee = {{ cycles = 1e4, m = 5.0 }}\n");
    assert!(cycles(&knee, range) > 6e4, "the range lies beyond the knee");
    let thick = "thickness = { thickness_m = 0.1, reference_m = 0.025, exponent = 0.25 }";
    let factor = 4.0_f64.powf(0.25);
    let found = cycles(&format!("{STRESS}{thick}\n"), range);
    assert!((found * factor.powi(3) / 6e4 - 1.0).abs() < 1e-12);
}

#[test]
fn a_tension_curve_by_its_logarithm() {
    let text = "[curve]\nkind = \"tension\"\nm = 4.09\nlog_k = 3.2\nmean_slope = 2.79\nreference_strength_n = 5e6\n";
    let expected = 10.0_f64.powf(3.2 - 2.79 * 0.2 + 4.09);
    assert!((cycles(text, 5e5) / expected - 1.0).abs() < 1e-12);
}

#[test]
fn a_published_curve() {
    let text = "[curve]\nlibrary = \"dnv-studless-chain\"\ndiameter_m = 0.084\n";
    let own = cycles(STRESS, 1e6);
    assert!((cycles(text, 1e6) / own - 1.0).abs() < 1e-12);
}

#[test]
fn errors_say_what_would_be_right() {
    let message = |text: &str| read_curve(text).unwrap_err().to_string();
    assert!(message("[curve]\nm = 3.0").contains("needs kind"));
    assert!(message("[curve]\nkind = \"stress\"\nm = 3.0").contains("k or its logarithm log_k"));
    assert!(message("[curve]\nkind = \"stress\"\nm = 3.0\nk = 1e11").contains("nominal_area_m2"));
    assert!(
        message("[curve]\nkind = \"tension\"\nm = 3.0\nk = 1e3").contains("reference strength")
    );
    assert!(message("[curve]\nkind = \"bending\"").contains("tension"));
    assert!(message("[curve]\nslope = 3").contains("unknown field"));
    assert!(message("").contains("curve"));
    assert!(message("[curve").contains("cannot be read"));
    assert!(message("[curve]\nlibrary = \"none\"").contains("api-studless-chain"));
    assert!(message("[curve]\nlibrary = \"api-studlink-chain\"\nm = 3").contains("library and m"));
    assert!(message(&STRESS.replace("k = 6.0e10", "k = 1\nlog_k = 0")).contains("k and log_k"));
    assert!(message(&STRESS.replace("m = 3.0", "m = nan")).contains("from 0.1 to 50"));
    assert!(message(&STRESS.replace("6.0e10", "-1.0")).contains("constant k is -1"));
    assert!(message(&STRESS.replace("0.084", "0.0")).contains("diameter"));
    let thick = format!(
        "{STRESS}thickness = {{ thickness_m = inf, reference_m = 0.025, exponent = 0.25 }}"
    );
    assert!(message(&thick).contains("thickness in m is inf"));
}

/// Whatever numbers a file has, it is refused or gives lives that are numbers.
#[test]
fn whatever_a_file_holds() {
    let mut random = Random::new(17, 0);
    let odd = [
        "0", "-1", "nan", "inf", "-inf", "1e308", "1e-320", "3.0", "0.1", "1e7", "\"a\"", "[]",
    ];
    let keys = [
        "m",
        "k",
        "log_k",
        "mean_slope",
        "reference_strength_n",
        "nominal_area_m2",
        "diameter_m",
    ];
    let mut read = 0;
    for turn in 0..4000 {
        let mut pick = |n: usize| (n as f64 * random.uniform()) as usize;
        let mut text = format!("[curve]\nkind = \"{}\"\n", ["stress", "tension"][turn % 2]);
        for key in keys {
            let value = match pick(3) {
                0 => continue,
                1 => "5.0",
                _ => odd[pick(odd.len())],
            };
            text.push_str(&format!("{key} = {value}\n"));
        }
        if let Ok(component) = read_curve(&text) {
            read += 1;
            for range in [0.0, 1.0, 1e5, 1e300] {
                if let Ok(one) = component.cycle_damage(range, 1.0) {
                    assert!(
                        one.damage.is_finite()
                            && one.exponent.is_finite()
                            && one.mean_slope.is_finite()
                    );
                }
            }
        }
    }
    assert!(read > 20, "{read}");
}
