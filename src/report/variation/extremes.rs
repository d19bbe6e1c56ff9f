//! The least and the greatest of every result over the points of a variation.

use super::{OutcomeColumn, ResultView, VariationView};
use seacable_base::number::si;
use seacable_display::table::{Align, Cell, Table};

/// A result over all points that have it.
struct ResultExtremes<'a> {
    of: &'a OutcomeColumn,
    least: (usize, &'a ResultView),
    greatest: (usize, &'a ResultView),
    mean: f64,
    count: usize,
}

impl VariationView<'_> {
    /// A row a result: its least and greatest value with their points, and its mean, by the probabilities of the points where they are known.
    #[must_use]
    pub fn extremes(&self) -> Table {
        let places = 0..self.results.len();
        let rows: Vec<ResultExtremes<'_>> =
            places.filter_map(|place| self.extremes_of(place)).collect();
        let weighted = self.variation.probability.is_some();
        let mean = if weighted {
            "mean by probability"
        } else {
            "mean"
        };
        let all = self.outcomes.len();
        let missing = rows.iter().any(|row| row.count < all);
        Table::of_records("Extremes", &rows)
            .text("result", |row| row.of.name.clone())
            .cell("least", Align::Decimal, |row| {
                Cell::plain(row.least.1.text.clone())
            })
            .count("point", |row| row.least.0 + 1)
            .cell("greatest", Align::Decimal, |row| {
                Cell::plain(row.greatest.1.text.clone())
            })
            .count("point", |row| row.greatest.0 + 1)
            .cell(mean, Align::Decimal, |row| {
                Cell::plain(si(row.mean, &row.of.unit))
            })
            .build()
            .noted(missing.then(|| format!("Of the points that have results, not all {all}.")))
    }

    fn extremes_of(&self, place: usize) -> Option<ResultExtremes<'_>> {
        let points = self.outcomes.iter().enumerate();
        let found: Vec<(usize, &ResultView)> = points
            .filter_map(|(point, outcome)| Some((point, outcome.result(place)?)))
            .collect();
        let by_value =
            |a: &&(usize, &ResultView), b: &&(usize, &ResultView)| a.1.value.total_cmp(&b.1.value);
        let weight = |point: usize| match &self.variation.probability {
            Some(probability) => probability[point],
            None => 1.0,
        };
        let (sum, weights) = found
            .iter()
            .fold((0.0, 0.0), |(sum, all), (point, result)| {
                let weight = weight(*point);
                (sum + weight * result.value, all + weight)
            });
        Some(ResultExtremes {
            of: &self.results[place],
            least: *found.iter().min_by(by_value)?,
            greatest: *found.iter().max_by(by_value)?,
            mean: sum / weights,
            count: found.len(),
        })
    }
}
