//! Stepping the value of a field with the arrow keys: a number by about a hundredth of it, a word to the next one.

use super::edit::set;
use super::notice::info;
use crate::case::fields::ValueType;
use crate::facade::FieldRow;
use crate::msg::Effect;
use crate::state::AppState;

/// A number is stepped by a power of ten between a two-hundredth and a twentieth of it.
const PART: f64 = 20.0;

/// The step of a number that is zero.
const FROM_ZERO: f64 = 0.1;

/// Steps the value under the cursor up or down, by so many steps.
pub fn step_value(state: &mut AppState, steps: f64) -> Vec<Effect> {
    let Some(editor) = state.editor() else {
        return Vec::new();
    };
    let Some(row) = editor.current_field() else {
        return Vec::new();
    };
    // From the step before this one, which may not be checked yet.
    let (path, value) = (row.path.clone(), stepped(row, editor.value(row), steps));
    let is_computed = row.computed.is_some();
    match value {
        Some(value) => set(state, &path, &value),
        None if is_computed => info(
            state,
            "This value is computed from parameters: step those, or Enter edits its expression.",
        ),
        None => info(state, "This value cannot be stepped; Enter edits it."),
    }
}

/// The value some steps further; nothing where there is no such thing.
fn stepped(row: &FieldRow, now: &str, steps: f64) -> Option<String> {
    match row.field.kind {
        ValueType::Choice(words) => next_word(words, now, steps),
        ValueType::Boolean => next_word(&["false", "true"], now, steps),
        ValueType::Integer => {
            let value: f64 = now.parse().ok()?;
            Some(format!("{}", value + steps * step(value).max(1.0)))
        }
        _ => {
            let value: f64 = now.parse().ok()?;
            let step = step(value);
            // On the grid of the step, so that no digits gather behind it.
            let next = ((value / step).round() + steps) * step;
            let decimals = (-step.log10().round()).max(0.0);
            let decimals = if decimals > 9.0 {
                return Some(format!("{next:e}"));
            } else {
                decimals as usize
            };
            Some(if next.abs() >= 1e7 {
                format!("{next:e}")
            } else {
                format!("{next:.decimals$}")
            })
        }
    }
}

/// The step of a number.
fn step(value: f64) -> f64 {
    if value == 0.0 || !value.is_finite() {
        return FROM_ZERO;
    }
    10_f64.powf((value.abs() / PART).log10().floor())
}

fn next_word(words: &[&str], now: &str, steps: f64) -> Option<String> {
    let at = words.iter().position(|word| *word == now)?;
    let next = if steps > 0.0 {
        at + 1
    } else {
        at + words.len() - 1
    };
    Some(words[next % words.len()].to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_step_is_a_small_round_part_of_the_number() {
        for (value, expected) in [
            (0.45, 0.01),
            (1326.0, 10.0),
            (300.0, 10.0),
            (141.0, 1.0),
            (9.4e8, 1e7),
            (0.0, 0.1),
            (-5.0, 0.1),
        ] {
            let found = step(value);
            assert!((found / expected - 1.0).abs() < 1e-12, "{value}: {found}");
        }
    }

    #[test]
    fn words_go_round() {
        let words = ["static", "quasi", "rk4"];
        assert_eq!(next_word(&words, "rk4", 1.0).unwrap(), "static");
        assert_eq!(next_word(&words, "static", -1.0).unwrap(), "rk4");
        assert!(next_word(&words, "other", 1.0).is_none());
    }
}
