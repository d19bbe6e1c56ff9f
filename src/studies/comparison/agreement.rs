//! Whether two results agree within their error bars.

use crate::run::Quantity;

/// Whether a result agrees with that of another run.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Agreement {
    /// The error bars do not overlap.
    Differ,
    /// The error bars overlap.
    WithinErrors,
    /// At least one is not settled, and its range overlaps with the other's error bar.
    NotSettled,
    /// The values differ and at least one has no error bar.
    NoErrors,
    /// The same number.
    Equal,
}

impl Agreement {
    /// All of them, the gravest first.
    pub const ALL: [Self; 5] = [
        Self::Differ,
        Self::NotSettled,
        Self::NoErrors,
        Self::WithinErrors,
        Self::Equal,
    ];

    /// The words for it.
    #[must_use]
    pub const fn words(self) -> &'static str {
        match self {
            Self::Differ => "differ",
            Self::WithinErrors => "within errors",
            Self::NotSettled => "not settled",
            Self::NoErrors => "no error bar",
            Self::Equal => "equal",
        }
    }
}

/// Share of a value below which differences are rounding and the tolerance of Newton's method, whatever the error bars.
const ROUNDING: f64 = 1e-9;

/// A result less that of another run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ResultChange {
    /// Difference of the values, in the unit of the result.
    pub absolute: f64,
    /// Error of the difference: both errors together, which holds however they are correlated; absent where one is not
    /// estimated.
    pub error: Option<f64>,
    /// Difference by the size of the other's value; absent where that is zero.
    pub relative: Option<f64>,
    /// Whether they agree.
    pub agreement: Agreement,
}

/// The range in which a result lies by its estimated error; absent without an estimate.
#[must_use]
pub fn error_bar(quantity: &Quantity) -> Option<[f64; 2]> {
    let bar = |error: f64| [quantity.value - error, quantity.value + error];
    quantity
        .unsettled
        .or_else(|| quantity.error_estimate().map(bar))
}

/// Whether a value lies outside of the error bar of a result by more than rounding; absent where the result has no error bar, is not
/// settled, or the value is not finite.
#[must_use]
pub fn is_beyond_error(quantity: &Quantity, value: f64) -> Option<bool> {
    let bar = error_bar(quantity).filter(|_| quantity.unsettled.is_none() && value.is_finite());
    let rounding = ROUNDING * quantity.value.abs();
    bar.map(|[least, greatest]| value < least - rounding || value > greatest + rounding)
}

/// A result less that of another run.
#[must_use]
pub fn change(from: &Quantity, to: &Quantity) -> ResultChange {
    let absolute = to.value - from.value;
    let errors = from.error_estimate().zip(to.error_estimate());
    ResultChange {
        absolute,
        error: errors.map(|(a, b)| a + b),
        relative: (from.value != 0.0).then(|| absolute / from.value.abs()),
        agreement: agreement(from, to),
    }
}

fn agreement(from: &Quantity, to: &Quantity) -> Agreement {
    let unsettled = from.unsettled.is_some() || to.unsettled.is_some();
    if from.value == to.value && from.unsettled == to.unsettled {
        return Agreement::Equal;
    }
    let rounding = ROUNDING * from.value.abs().max(to.value.abs());
    match error_bar(from).zip(error_bar(to)) {
        Some((a, b)) if a[1] + rounding < b[0] || b[1] + rounding < a[0] => Agreement::Differ,
        Some(_) if unsettled => Agreement::NotSettled,
        Some(_) => Agreement::WithinErrors,
        None => Agreement::NoErrors,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn quantity(value: f64, error: Option<f64>) -> Quantity {
        Quantity {
            time_error: error,
            ..Quantity::new("z_m[end].final".parse().unwrap(), value)
        }
    }

    #[test]
    fn bars_that_overlap_agree() {
        let of = |a, b| change(&a, &b).agreement;
        let exact = quantity(1.0, Some(0.0));
        assert_eq!(of(exact.clone(), exact.clone()), Agreement::Equal);
        assert_eq!(
            of(exact.clone(), quantity(1.5, Some(0.6))),
            Agreement::WithinErrors
        );
        assert_eq!(
            of(exact.clone(), quantity(1.5, Some(0.4))),
            Agreement::Differ
        );
        assert_eq!(of(exact.clone(), quantity(1.5, None)), Agreement::NoErrors);
        let range = Quantity {
            unsettled: Some([0.5, 3.0]),
            ..quantity(1.0, None)
        };
        assert_eq!(of(exact, range.clone()), Agreement::NotSettled);
        assert_eq!(of(range, quantity(4.0, Some(0.1))), Agreement::Differ);
    }

    #[test]
    fn nothing_is_relative_to_zero() {
        let zero = quantity(0.0, Some(0.0));
        assert_eq!(change(&zero, &quantity(2.0, None)).relative, None);
        let negative = change(&quantity(-2.0, None), &quantity(-1.0, None));
        assert_eq!((negative.absolute, negative.relative), (1.0, Some(0.5)));
    }

    proptest! {
        /// Who is first changes signs, not the verdict; and bars agree when the difference is at most both errors.
        #[test]
        fn the_verdict_is_symmetric(
            a in -1e6..1e6f64, b in -1e6..1e6f64, ea in 0.0..1e6f64, eb in 0.0..1e6f64,
        ) {
            let (from, to) = (quantity(a, Some(ea)), quantity(b, Some(eb)));
            let (there, back) = (change(&from, &to), change(&to, &from));
            prop_assert_eq!(there.agreement, back.agreement);
            prop_assert_eq!(there.absolute, -back.absolute);
            let slack = 1e-9 * (a.abs() + b.abs() + ea + eb);
            if (there.absolute.abs() - (ea + eb)).abs() > slack {
                let apart = there.absolute.abs() > ea + eb;
                prop_assert_eq!(there.agreement == Agreement::Differ, apart);
            }
        }
    }
}
