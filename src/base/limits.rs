//! Limits on the work that a file may ask for, checked before it begins. A case comes from anywhere: one number too many
//! must not fill a shared server. Each limit is lifted by its option of the command line, for the one command.

use std::sync::atomic::{AtomicU64, Ordering};

/// A limit, and the option that lifts it.
#[derive(Debug)]
pub struct Limit {
    option: &'static str,
    /// The greatest number allowed unless it is lifted.
    usual: f64,
    /// The greatest number allowed, as the bits of a float.
    greatest: AtomicU64,
}

/// Entries of one table or list of tables in a file: sections, points, materials, published values.
pub static TABLES: Limit = Limit::new("--limit-tables", 1e4);
/// Segments of all lines of a scene.
pub static SEGMENTS: Limit = Limit::new("--limit-segments", 2e5);
/// Time steps of a run, where all are as long as allowed.
pub static STEPS: Limit = Limit::new("--limit-steps", 1e8);
/// Lines of a table to be solved at rest in still water, a few microseconds each.
pub static LINES: Limit = Limit::new("--limit-lines", 5e6);
/// The same in a current, some milliseconds each.
pub static LINES_IN_CURRENT: Limit = Limit::new("--limit-lines", 2e4);
/// Load cases, or points of a variation, each a run of its own.
pub static POINTS: Limit = Limit::new("--limit-points", 1e4);
/// Rows of a history.
pub static ROWS: Limit = Limit::new("--limit-rows", 1e6);

impl Limit {
    const fn new(option: &'static str, greatest: f64) -> Self {
        Self {
            option,
            usual: greatest,
            greatest: AtomicU64::new(greatest.to_bits()),
        }
    }

    /// The greatest number allowed.
    #[must_use]
    pub fn greatest(&self) -> f64 {
        f64::from_bits(self.greatest.load(Ordering::Relaxed))
    }

    /// Lifts the limit, for this process.
    pub fn lift(&self, greatest: f64) {
        self.greatest.store(greatest.to_bits(), Ordering::Relaxed);
    }

    /// The option that lifts it as it is lifted now; nothing where it is as usual.
    fn lifted(&self) -> Option<String> {
        let greatest = self.greatest();
        (greatest.to_bits() != self.usual.to_bits()).then(|| format!("{}={greatest}", self.option))
    }

    /// Whether a number is above the limit; one that is not a number is.
    #[must_use]
    pub fn is_exceeded_by(&self, number: f64) -> bool {
        number.is_nan() || number > self.greatest()
    }

    /// What to do about a number above the limit: the remedy, or the option.
    #[must_use]
    pub fn remedy(&self, remedy: &str, number: f64) -> String {
        format!(
            "{remedy}; {} are allowed, `{} {}` allows these",
            words(self.greatest()),
            self.option,
            words(number)
        )
    }
}

/// The options by which another process computes runs within the limits of this one.
#[must_use]
pub fn lifted() -> Vec<String> {
    let limits = [&TABLES, &SEGMENTS, &STEPS, &POINTS, &ROWS];
    limits.iter().filter_map(|limit| limit.lifted()).collect()
}

/// A count as people write it: in full up to a million, rounded up to two digits beyond.
#[must_use]
pub fn words(count: f64) -> String {
    if count < 1e6 || !count.is_finite() {
        return format!("{count:.0}");
    }
    let scale = 10_f64.powf(count.log10().floor() - 1.0);
    format!("{:e}", (count / scale).ceil() * scale)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_number_above_the_limit_names_the_option_that_allows_it() {
        let limit = Limit::new("--limit-steps", 1e8);
        assert!(!limit.is_exceeded_by(1e8) && limit.is_exceeded_by(f64::NAN));
        assert_eq!(
            limit.remedy("take longer steps", 6.123e13),
            "take longer steps; 1e8 are allowed, `--limit-steps 6.2e13` allows these"
        );
        limit.lift(6.2e13);
        assert!(!limit.is_exceeded_by(6.123e13));
        assert_eq!(words(2000.0), "2000");
    }
}
