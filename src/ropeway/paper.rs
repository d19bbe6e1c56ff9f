//! The model behind the tables of the Tianjin paper: the bare rope's catenary with the sag of the working state, and the whole
//! cargo added to the vertical force at one end.
//!
//! The text reads as if the 7 m of sag were those of the loaded rope. The tables say otherwise: they come out to the
//! printed digits from `sag = a (cosh(l/2a) - 1)`, H = w a, L = 2a sinh(l/2a), `Tmax = sqrt(H² + (wL/2 + Q)²)`.

use super::bare::{Bare, Gap};
use super::{Trouble, search};

/// What the tables print.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tabled {
    /// The bare rope.
    pub rope: Bare,
    /// Greatest end tension \[N\].
    pub max_tension_n: f64,
}

/// The state with the least of these greatest tensions: "minimum tension" of table 5.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Least {
    /// The tension \[N\].
    pub tension_n: f64,
    /// Sag of the bare rope then \[m\].
    pub sag_m: f64,
}

/// A bare rope with the whole cargo at the end that carries more.
#[must_use]
pub fn tabled(rope: Bare, cargo_n: f64) -> Tabled {
    let (v_a, v_b) = rope.vertical_n();
    Tabled {
        rope,
        max_tension_n: rope.horizontal_n.hypot(v_a.max(v_b) + cargo_n),
    }
}

/// The pull that makes the greatest tension least.
///
/// # Errors
/// Those of [`Bare::with_pull`].
pub fn least(gap: Gap, weight_n_per_m: f64, cargo_n: f64) -> Result<Least, Trouble> {
    let at = |log_pull: f64| {
        let rope = Bare::with_pull(gap, weight_n_per_m, log_pull.exp())?;
        Ok::<_, Trouble>(tabled(rope, cargo_n))
    };
    // A rope this slack carries its length, one this tight its pull: the least lies between.
    let scale = (weight_n_per_m * gap.chord_m()).ln();
    let most = (weight_n_per_m * gap.chord_m() + cargo_n).ln() + 3.0;
    let pull = search::least((scale - 3.0, most), |log_pull| {
        Ok(at(log_pull)?.max_tension_n.ln())
    })?;
    let found = at(pull)?;
    Ok(Least {
        tension_n: found.max_tension_n,
        sag_m: found.rope.sag_m(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn table_5_comes_out_to_the_printed_digits() {
        // Span; H, Tmax, L, least tension and its sag as printed, with half a unit of their last digits.
        let table = [
            (80.0, 2488.8, 2840.8, (81.6, 0.05), 1725.5, (24.4, 0.05)),
            (60.0, 1410.5, 1826.0, (62.13, 0.0051), 1404.2, (17.8, 0.05)),
            (40.0, 639.7, 1149.12, (43.1, 0.05), 1085.5, (11.34, 0.005)),
        ];
        for (span_m, h, t, length, low, sag) in table {
            let gap = Gap {
                span_m,
                rise_m: 0.0,
            };
            let found = tabled(Bare::with_sag(gap, 21.56, 7.0).unwrap(), 490.0);
            assert!((found.rope.horizontal_n - h).abs() < 0.051, "{found:?}");
            assert!((found.max_tension_n - t).abs() < 0.02, "{found:?}");
            assert!((found.rope.length_m() - length.0).abs() < length.1);
            let least = least(gap, 21.56, 490.0).unwrap();
            assert!((least.tension_n - low).abs() < 0.05, "{least:?}");
            assert!((least.sag_m - sag.0).abs() < sag.1, "{least:?}");
        }
    }

    #[test]
    fn without_cargo_the_least_tension_is_the_known_one() {
        let gap = Gap {
            span_m: 80.0,
            rise_m: 0.0,
        };
        let least = least(gap, 21.56, 0.0).unwrap();
        assert!((least.tension_n / (0.754_44 * 21.56 * 80.0) - 1.0).abs() < 1e-5);
    }
}
