//! The page of quick looks at the seas of a sweep: verdict and seas as of runs in time, what the looks cannot see, and how far they are
//! from the runs of the seas that were sampled.

use super::number::duration;
use super::seas::{SeasView, series_word};
use super::table::{Align, Cell, Table};
use seacable_base::number::si;
use seacable_model::case::StatisticsInputs;
use seacable_studies::study::seas::{Difference, QuickSeas, RecordedSeries};

/// The looks, and the runs that they are held against.
#[derive(Debug, Clone, Copy)]
pub struct QuickView<'a> {
    /// The looks.
    pub looks: &'a QuickSeas,
    /// How loads are summed up.
    pub statistics: &'a StatisticsInputs,
    /// How they differ from runs in time, where seas were sampled.
    pub differences: &'a [Difference],
    /// Seconds of one core that the runs of the sampled seas took.
    pub runs_cost_s: f64,
}

impl QuickView<'_> {
    /// Loads and checks of the looks.
    #[must_use]
    pub fn seas(&self) -> SeasView<'_> {
        SeasView {
            results: &self.looks.results,
            statistics: self.statistics,
        }
    }

    /// All tables, the verdict first.
    #[must_use]
    pub fn tables(&self) -> Vec<Table> {
        let mut tables = self.seas().tables();
        match self.differences.is_empty() {
            true => {
                if let Some(last) = tables.last_mut() {
                    last.notes.extend(self.notes());
                }
            }
            false => tables.push(self.differences()),
        }
        tables
    }

    /// The loads of the sampled seas by runs in time, and by how much the looks differ.
    #[must_use]
    pub fn differences(&self) -> Table {
        let rows: Vec<&Difference> = self.differences.iter().collect();
        let table = Table::of_records("Quick looks beside runs in time", &rows)
            .text("sea and place", place)
            .cell("mean", Align::Decimal, |row| {
                Cell::plain(si(row.in_time.mean.value, row.quick.series.unit()))
            })
            .cell("quick", Align::Decimal, |row| {
                let size = row.in_time.mean.value.abs();
                let by = (row.quick.mean.value - row.in_time.mean.value) / size;
                Cell::plain(percent(by))
            })
            .cell("deviation", Align::Decimal, |row| {
                Cell::plain(si(row.in_time.deviation, row.quick.series.unit()))
            })
            .cell("quick", Align::Decimal, |row| {
                Cell::plain(percent(of_deviation(row)))
            })
            .cell("greatest", Align::Decimal, |row| {
                let greatest = row.in_time.greatest.estimate.value;
                Cell::plain(si(greatest, row.quick.series.unit()))
            })
            .cell("quick", Align::Decimal, |row| {
                Cell::plain(percent(of_greatest(row)))
            })
            .build();
        table.noted(self.notes())
    }

    /// What the looks cannot see, how far they are from runs in time, and what they cost.
    fn notes(&self) -> Vec<String> {
        let looks = self.looks;
        let without = looks.without.iter();
        let without =
            without.map(|(sea, why)| format!("Sea {} has no quick look: {why}.", sea + 1));
        let warnings = looks.warnings.iter().map(|(warning, seas)| {
            let seas: Vec<String> = seas.iter().map(|sea| (sea + 1).to_string()).collect();
            format!("Seas {}: {warning}.", seas.join(", "))
        });
        let differences = match self.differences.is_empty() {
            true => "How far the looks are from runs in time is not known: --sampled 2 runs two of the seas in time as well.".to_owned(),
            false => self.summary(),
        };
        let first = std::iter::once(differences);
        let all = first.chain(without).chain(warnings);
        all.chain([self.cost()]).collect()
    }

    /// The greatest differences in words.
    fn summary(&self) -> String {
        let worst = |of: &dyn Fn(&Difference) -> f64| {
            let all = self.differences.iter().map(|row| of(row).abs());
            percent(all.filter(|by| by.is_finite()).fold(0.0, f64::max))
        };
        let within = self.differences.iter().filter(|row| {
            let sample = row.in_time.greatest.estimate.sample;
            let value = row.quick.greatest.estimate.value;
            sample.is_some_and(|[low, high]| (low..=high).contains(&value))
        });
        format!(
            "Quick is by how much the look is above the runs; at most {} of a deviation and {} of a greatest value. Of {} greatest values of the looks {} lie within the interval of the sample of the runs.",
            worst(&of_deviation).trim_start_matches('+'),
            worst(&of_greatest).trim_start_matches('+'),
            self.differences.len(),
            within.count()
        )
    }

    /// What the looks cost, beside the runs of the sampled seas.
    fn cost(&self) -> String {
        let looks = self.looks;
        let count = looks.results.seas.len() - looks.without.len();
        let (frequencies, turns) = looks.work;
        let runs = (self.runs_cost_s > 0.0).then(|| {
            let mut seas: Vec<usize> = self.differences.iter().map(|row| row.sea).collect();
            seas.dedup();
            let (a_run, a_look) = (
                self.runs_cost_s / seas.len() as f64,
                looks.cost_s / count as f64,
            );
            format!(
                " The runs in time of {} of them took {}: {:.0} times as much a sea.",
                seas.len(),
                duration(self.runs_cost_s),
                a_run / a_look
            )
        });
        format!(
            "Looks at {count} seas took {} of one core, errors included: {frequencies} frequencies and {turns} turns of drag and response at most.{}",
            duration(looks.cost_s),
            runs.unwrap_or_default()
        )
    }
}

fn place(row: &&Difference) -> String {
    let (sea, place) = (row.sea + 1, &row.quick.place);
    match row.quick.series {
        RecordedSeries::Tension => format!("{sea} {place}"),
        other => format!("{sea} {} {place}", series_word(other)),
    }
}

fn of_deviation(row: &Difference) -> f64 {
    row.quick.deviation / row.in_time.deviation - 1.0
}

fn of_greatest(row: &Difference) -> f64 {
    let in_time = row.in_time.greatest.estimate.value;
    (row.quick.greatest.estimate.value - in_time) / in_time.abs()
}

/// A share as per cent with its sign.
fn percent(share: f64) -> String {
    match share.is_finite() {
        true => format!("{:+.1} %", 100.0 * share),
        false => "-".to_owned(),
    }
}
