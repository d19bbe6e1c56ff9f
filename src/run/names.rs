//! Names of single numbers, as they stand in `summary.csv`.

use crate::case::Statistic;

/// Name of a statistic of a channel, over a window of time \[s\] or a stretch of the line \[m\] when one is given:
/// `tension_n[wire|payload].mean(0..200)`.
#[must_use]
pub fn quantity_name(channel: &str, statistic: Statistic, within: Option<[f64; 2]>) -> String {
    let word = statistic.name();
    match within {
        Some([from, to]) => format!("{channel}.{word}({from}..{to})"),
        None => format!("{channel}.{word}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn channel_statistic_window() {
        let name = |window| quantity_name("tension_n[wire|payload]", Statistic::Mean, window);
        assert_eq!(name(None), "tension_n[wire|payload].mean");
        assert_eq!(
            name(Some([0.0, 200.0])),
            "tension_n[wire|payload].mean(0..200)"
        );
        assert_eq!(
            name(Some([2.5, 20.0])),
            "tension_n[wire|payload].mean(2.5..20)"
        );
    }
}
