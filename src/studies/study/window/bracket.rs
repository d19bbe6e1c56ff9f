//! The greatest of some values of a key at which the checks of a sea pass, by bisection.

use crate::checks::utilisation::UtilisationVerdict;

/// What is known of the limiting value of one sea, by places among the values tried, which rise.
#[derive(Debug, Clone, PartialEq)]
pub struct LimitBracket {
    count: usize,
    /// The place of the greatest value known to pass.
    pub passes: Option<usize>,
    /// The place of the least value known not to pass, with what was said there.
    pub fails: Option<(usize, UtilisationVerdict)>,
}

impl LimitBracket {
    /// Among so many values.
    #[must_use]
    pub const fn new(count: usize) -> Self {
        Self {
            count,
            passes: None,
            fails: None,
        }
    }

    /// The places to try next: first both ends, then the middle; none when it is found.
    #[must_use]
    pub fn next(&self) -> Vec<usize> {
        match (self.passes, self.fails) {
            (None, None) if self.count > 1 => vec![0, self.count - 1],
            (None, None) => (0..self.count).collect(),
            (Some(passes), Some((fails, _))) if fails > passes + 1 => vec![(passes + fails) / 2],
            _ => Vec::new(),
        }
    }

    /// Takes what was said of a value. What is not settled counts as not passed.
    pub fn take(&mut self, place: usize, verdict: UtilisationVerdict) {
        match verdict {
            UtilisationVerdict::Passes => self.passes = self.passes.max(Some(place)),
            verdict => {
                if self.fails.is_none_or(|(known, _)| place < known) {
                    self.fails = Some((place, verdict));
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The bracket of a limit between places, and how many were tried.
    fn sought(limit: f64) -> (LimitBracket, usize) {
        let mut bracket = LimitBracket::new(33);
        let mut tries = 0;
        loop {
            let next = bracket.next();
            if next.is_empty() {
                return (bracket, tries);
            }
            for place in next {
                tries += 1;
                let passes = place as f64 <= limit;
                bracket.take(
                    place,
                    if passes {
                        UtilisationVerdict::Passes
                    } else {
                        UtilisationVerdict::Fails
                    },
                );
            }
        }
    }

    #[test]
    fn the_limit_lies_between_neighbours() {
        for limit in [0.0, 5.5, 16.0, 31.2] {
            let (bracket, tries) = sought(limit);
            let (passes, fails) = (bracket.passes.unwrap(), bracket.fails.unwrap().0);
            assert_eq!(fails, passes + 1);
            assert!(
                passes as f64 <= limit && limit < fails as f64,
                "{bracket:?}"
            );
            assert_eq!(tries, 2 + 5);
        }
    }

    #[test]
    fn beyond_both_ends_nothing_is_bisected() {
        let (below, tries) = sought(-1.0);
        assert_eq!((below.passes, tries), (None, 2));
        let (above, tries) = sought(50.0);
        assert_eq!((above.fails, tries), (None, 2));
    }

    #[test]
    fn what_is_not_settled_is_not_passed_and_says_so() {
        let mut bracket = LimitBracket::new(5);
        bracket.take(0, UtilisationVerdict::Passes);
        bracket.take(4, UtilisationVerdict::Open);
        assert_eq!(bracket.fails, Some((4, UtilisationVerdict::Open)));
        assert_eq!(bracket.next(), [2]);
        assert_eq!(LimitBracket::new(1).next(), [0]);
    }
}
