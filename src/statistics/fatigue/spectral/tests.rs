use super::*;
use crate::fatigue::component::Measure;
use crate::fatigue::curve::Law;
use crate::fatigue::fixtures::numbers;
use crate::numerics::random::Random;

/// A curve whose x is the range in units of 1 N, with the constant in the logarithm.
fn plain(law: Law) -> FatigueComponent {
    FatigueComponent::new("", law, Measure::TensionRatio, Some(1.0)).unwrap()
}

/// Lines of the fixture: m0 m1 m2 m4, exponent, log10 of the constant of amplitudes, damages by narrow band, Dirlik and
/// Tovo-Benasciutti of FLife.
#[test]
fn as_computed_by_flife() {
    let mut rows = 0;
    for line in include_str!("../fixtures/flife.txt")
        .lines()
        .filter(|l| !l.starts_with('#'))
    {
        let row = numbers(line);
        let moments = TensionMoments::new(row[0], row[1], row[2], row[3]).unwrap();
        let of_ranges = row[5] + row[4] * 2.0_f64.log10();
        let component = plain(Law::new(row[4], of_ranges));
        let found = [
            moments.narrow_band(&component, 0.0).unwrap(),
            moments.dirlik(&component, 0.0).unwrap().unwrap(),
            moments.tovo_benasciutti(&component, 0.0).unwrap(),
        ];
        for (found, expected) in found.iter().zip(&row[6..9]) {
            assert!(
                (found / expected - 1.0).abs() < 1e-9,
                "{found} {expected} of {line}"
            );
        }
        rows += 1;
    }
    assert_eq!(rows, 120);
}

#[test]
fn moments_of_a_flat_band() {
    let frequencies: Vec<f64> = (0..=4000).map(|i| 1.0 + f64::from(i) / 4000.0).collect();
    let moments = TensionMoments::of_spectrum(&frequencies, &vec![3.0; 4001]).unwrap();
    assert!((moments.deviation().powi(2) - 3.0).abs() < 1e-12);
    assert!((moments.crossing_rate() - (7.0_f64 / 3.0).sqrt()).abs() < 1e-7);
    assert!((moments.crest_rate() - (31.0 / 5.0 / (7.0_f64 / 3.0)).sqrt()).abs() < 1e-7);
}

#[test]
fn in_the_narrowest_band_all_agree() {
    let component = plain(Law::new(3.0, 10.0).with_knee(1e6, 5.0));
    let moments = TensionMoments::of_spectrum(&[1.0, 1.0 + 1e-4], &[1e8, 1e8]).unwrap();
    let narrow = moments.narrow_band(&component, 0.0).unwrap();
    let tovo = moments.tovo_benasciutti(&component, 0.0).unwrap();
    assert!((tovo / narrow - 1.0).abs() < 1e-6);
    if let Some(dirlik) = moments.dirlik(&component, 0.0).unwrap() {
        assert!((dirlik / narrow - 1.0).abs() < 0.05, "{dirlik} {narrow}");
    }
}

#[test]
fn whatever_comes_is_finite_or_refused() {
    let mut random = Random::new(19, 0);
    let odd = [
        0.0,
        0.5,
        1.0,
        2.0,
        -1.0,
        1e-320,
        1e150,
        1e308,
        f64::NAN,
        f64::INFINITY,
    ];
    let component = plain(Law::new(3.0, 10.0).with_knee(1e6, 5.0));
    let mut made = 0;
    for turn in 0..20_000 {
        let mut pick = || match turn % 3 {
            0 => odd[(odd.len() as f64 * random.uniform()) as usize],
            _ => random.uniform(),
        };
        let frequencies = [pick(), 1.0 + pick(), 2.0 + pick()];
        let moments = match turn % 2 {
            0 => TensionMoments::new(pick(), pick(), pick(), pick()),
            _ => TensionMoments::of_spectrum(&frequencies, &[pick(), pick(), pick()]),
        };
        let Ok(moments) = moments else { continue };
        made += 1;
        for damage in [
            moments.narrow_band(&component, 0.0),
            moments.tovo_benasciutti(&component, 0.0),
            moments.dirlik(&component, 0.0).map(|d| d.unwrap_or(0.0)),
        ] {
            assert!(
                damage.is_err() || damage.is_ok_and(|d| d.is_finite() && d >= 0.0),
                "{moments:?}"
            );
        }
    }
    assert!(made > 2000, "{made}");
    assert!(
        TensionMoments::of_spectrum(&[1.0], &[1.0]).is_err()
            && TensionMoments::of_spectrum(&[1.0, 2.0], &[1.0]).is_err()
    );
    assert!(TensionMoments::of_spectrum(&[1.0, 2.0], &[0.0, 0.0]).is_err());
}
