//! The effects of inputs on a result: a tornado chart in characters, the numbers behind it, and CSV.

use super::comparison::result_text;
use super::number::{percent, si};
use super::table::{Align, Cell, CellStyle, Table};
use seacable_model::case::QuantityId;
use seacable_runs::run::Quantity;
use seacable_studies::study::effects::{InputEffect, InputEffects, InputTolerance, VariedInput};

/// Characters of a bar to either side of the middle, at least and at most, and what a line of the chart needs besides.
const HALF: (usize, usize) = (9, 30);
const BESIDES: usize = 61;

/// The effects of all inputs on one result.
#[derive(Debug)]
pub struct TornadoView<'a> {
    effects: &'a InputEffects,
    base: &'a Quantity,
    rows: Vec<(usize, InputEffect<'a>)>,
}

impl<'a> TornadoView<'a> {
    /// The effects on a result; nothing where the case does not have it.
    #[must_use]
    pub fn of_result(effects: &'a InputEffects, id: &QuantityId) -> Option<Self> {
        Some(Self {
            effects,
            base: effects.result(id)?,
            rows: (1..).zip(effects.ranked(id)?).collect(),
        })
    }

    /// Error of the result of the case itself.
    fn error(&self) -> Option<f64> {
        self.base.error_estimate()
    }

    /// The tornado on so many columns: a bar an input, the greatest effect first. To the left of the middle the result falls, to the right
    /// it rises; `-` at the lower value of the input, `+` at the upper one; colons mark the error bar of the result. Inputs without any
    /// effect are in a note.
    #[must_use]
    pub fn chart(&self, width: usize) -> Table {
        let half = (width.saturating_sub(BESIDES) / 2).clamp(HALF.0, HALF.1);
        let greatest = self.rows.iter().map(|(_, effect)| effect.size());
        let greatest = greatest.fold(0.0, f64::max);
        let title = format!("{}: {}", self.base.id, result_text(self.base));
        let moving = self.moving();
        Table::of_records(title, &moving)
            .text("input", |(number, effect)| {
                format!("[{number}] {}", effect.input.path)
            })
            .cell("effect", Align::Right, |(_, effect)| {
                let error = self.error().unwrap_or(0.0);
                Cell::plain(bar(effect.changes, half, greatest, error))
            })
            .cell("greatest", Align::Right, |(_, effect)| self.verdict(effect))
            .build()
            .noted([
                "To the left the result falls, to the right it rises: - with the input at its lower value, + at its upper \
                 one, : within the error bar of the result.",
            ])
            .noted(self.without_effect())
    }

    /// The rows of inputs that have an effect, or of which none could be computed.
    fn moving(&self) -> Vec<(usize, &InputEffect<'a>)> {
        let rows = self.rows.iter().map(|(number, effect)| (*number, effect));
        rows.filter(|(_, effect)| !is_idle(effect)).collect()
    }

    fn without_effect(&self) -> Option<String> {
        let idle = self.rows.iter().filter(|(_, effect)| is_idle(effect));
        let idle: Vec<&str> = idle.map(|(_, effect)| effect.input.path.as_str()).collect();
        (!idle.is_empty()).then(|| format!("Without any effect: {}.", idle.join(", ")))
    }

    /// The greater change by the size of the result.
    fn share(&self, effect: &InputEffect<'_>) -> Option<f64> {
        let changes = effect.changes.iter().flatten().copied();
        let greatest = changes.reduce(|a, b| if b.abs() > a.abs() { b } else { a })?;
        (self.base.value != 0.0).then(|| greatest / self.base.value.abs())
    }

    /// The greater change by the result, or that it is within the error.
    fn verdict(&self, effect: &InputEffect<'_>) -> Cell {
        if effect.changes.iter().all(Option::is_none) {
            return Cell::new("no result", CellStyle::Bad);
        }
        let size = self
            .share(effect)
            .map_or_else(|| si(effect.size(), &self.base.unit()), percent);
        match effect.beyond_error {
            None => Cell::new(format!("{size} ± ?"), CellStyle::Warn),
            Some(false) => Cell::new("within error", CellStyle::Dim),
            Some(true) => Cell::plain(size),
        }
    }

    /// The numbers: values of each input, the result at both of them, its changes.
    #[must_use]
    pub fn table(&self) -> Table {
        let unit = self.base.unit();
        let result = |result: &Result<f64, String>| match result {
            Ok(value) => Cell::plain(si(*value, &unit)),
            Err(_) => Cell::new("no result", CellStyle::Bad),
        };
        let change = |change: Option<f64>| match change {
            Some(change) => Cell::plain(si(change, &unit)),
            None => Cell::none(),
        };
        let moving = self.moving();
        Table::of_records("", &moving)
            .text("input", |(number, effect)| {
                format!("[{number}] {}", varied(effect.input))
            })
            .cell("at the lower", Align::Decimal, |(_, effect)| {
                result(&effect.results[0])
            })
            .cell("at the upper", Align::Decimal, |(_, effect)| {
                result(&effect.results[1])
            })
            .cell("lower - case", Align::Decimal, |(_, effect)| {
                change(effect.changes[0])
            })
            .cell("upper - case", Align::Decimal, |(_, effect)| {
                change(effect.changes[1])
            })
            .build()
            .noted(self.notes())
    }

    fn notes(&self) -> Vec<String> {
        let mut notes = vec![format!(
            "The case itself gives {}. Each result above has an error of about that size, most of which cancels in a \
             change: all are computed on one mesh by one method.",
            result_text(self.base)
        )];
        for (number, effect) in &self.rows {
            for (result, side) in effect.results.iter().zip(["lower", "upper"]) {
                if let Err(why) = result {
                    notes.push(format!("[{number}] at its {side} value: {why}"));
                }
            }
        }
        let skipped = self.effects.skipped.iter();
        let skipped: Vec<String> = skipped
            .map(|input| format!("{} ({})", input.path, input.reason))
            .collect();
        if !skipped.is_empty() {
            notes.push(format!("Not varied: {}.", skipped.join(", ")));
        }
        notes
    }

    /// The same for other programs, every digit kept.
    #[must_use]
    pub fn csv_table(&self) -> Table {
        let number = |value: Option<f64>| {
            Cell::plain(value.map_or_else(String::new, |value| value.to_string()))
        };
        let side = |place: usize| {
            move |row: &(usize, InputEffect<'a>)| {
                number(row.1.results[place].as_ref().ok().copied())
            }
        };
        let changed =
            |place: usize| move |row: &(usize, InputEffect<'a>)| number(row.1.changes[place]);
        let input = |value: fn(&VariedInput) -> f64| {
            move |row: &(usize, InputEffect<'a>)| number(Some(value(row.1.input)))
        };
        Table::of_records("", &self.rows)
            .count("rank", |row| row.0)
            .text("result", |_| self.base.id.to_string())
            .text("unit", |_| self.base.unit())
            .text("input", |row| row.1.input.path.as_str())
            .text("input_unit", |row| row.1.input.unit)
            .cell("input_value", Align::Right, input(|input| input.value))
            .cell("input_low", Align::Right, input(|input| input.ends[0]))
            .cell("input_high", Align::Right, input(|input| input.ends[1]))
            .text("tolerance", |row| tolerance(row.1.input))
            .cell("base", Align::Right, |_| number(Some(self.base.value)))
            .cell("base_error", Align::Right, |_| number(self.error()))
            .cell("low", Align::Right, side(0))
            .cell("high", Align::Right, side(1))
            .cell("low_change", Align::Right, changed(0))
            .cell("high_change", Align::Right, changed(1))
            .cell("verdict", Align::Left, |row| {
                match (is_idle(&row.1), self.error()) {
                    (true, _) => Cell::plain("none"),
                    (_, Some(error)) if row.1.size() <= error => Cell::plain("within error"),
                    _ => Cell::default(),
                }
            })
            .build()
    }
}

/// Whether both results are those of the case itself to the last bit.
fn is_idle(effect: &InputEffect<'_>) -> bool {
    effect.changes.iter().all(|change| *change == Some(0.0))
}

fn tolerance(input: &VariedInput) -> &'static str {
    match input.tolerance {
        InputTolerance::Stated => "stated",
        InputTolerance::Usual => "10 %",
    }
}

/// An input with its values: `payload.drag_area_m2 126.9 .. 141 .. 155.1 m² (10 %)`.
fn varied(input: &VariedInput) -> String {
    let [low, high] = input.ends.map(|end| si(end, ""));
    let unit = if input.unit.is_empty() {
        String::new()
    } else {
        format!(" {}", input.unit)
    };
    let clipped = match input.clipped {
        [false, false] => "",
        [true, false] => ", lower clipped to the key's range",
        [false, true] => ", upper clipped to the key's range",
        [true, true] => ", clipped to the key's range",
    };
    let list = if input.is_list {
        ", all of its list"
    } else {
        ""
    };
    let value = si(input.value, "");
    format!(
        "{} {low} .. {value} .. {high}{unit} ({}{list}{clipped})",
        input.path,
        tolerance(input)
    )
}

/// The bar of an effect.
fn bar(changes: [Option<f64>; 2], half: usize, greatest: f64, error: f64) -> String {
    let mut cells = vec!['.'; 2 * half + 1];
    if greatest <= 0.0 {
        cells[half] = '|';
        return cells.into_iter().collect();
    }
    let length = |size: f64| ((size / greatest * half as f64).round() as usize).min(half);
    let band = length(error.abs());
    for cell in &mut cells[half - band..=half + band] {
        *cell = ':';
    }
    let mut drawn: Vec<(f64, char)> = changes
        .into_iter()
        .zip(['-', '+'])
        .filter_map(|(change, letter)| Some((change.filter(|c| c.is_finite())?, letter)))
        .collect();
    // The shorter one is drawn last, so that both are seen.
    drawn.sort_by(|a, b| b.0.abs().total_cmp(&a.0.abs()));
    for (change, letter) in drawn {
        for step in 1..=length(change.abs()) {
            let place = if change < 0.0 {
                half - step
            } else {
                half + step
            };
            cells[place] = letter;
        }
    }
    cells[half] = '|';
    cells.into_iter().collect()
}

#[cfg(test)]
mod tests {
    use super::bar;

    #[test]
    fn bars_go_both_ways_and_show_the_error() {
        assert_eq!(
            bar([Some(-2.0), Some(2.0)], 14, 2.0, 0.0),
            format!("{}|{}", "-".repeat(14), "+".repeat(14))
        );
        assert_eq!(
            bar([Some(1.0), Some(-1.0)], 14, 2.0, 0.0),
            format!(".......{}|{}.......", "+".repeat(7), "-".repeat(7))
        );
        assert_eq!(
            bar([Some(0.0), None], 14, 2.0, 1.0),
            format!(".......{0}|{0}.......", ":".repeat(7))
        );
        // Both rise: the shorter one lies on the longer.
        assert_eq!(
            bar([Some(2.0), Some(1.0)], 14, 2.0, 0.0),
            format!("{}|{}{}", ".".repeat(14), "+".repeat(7), "-".repeat(7))
        );
        assert_eq!(
            bar([None, None], 14, 0.0, 0.0),
            format!("{0}|{0}", ".".repeat(14))
        );
    }
}
