//! The page of a sweep: its verdict, its seas, its extremes and its load cases; and the tables that stand in its folder.

use std::path::Path;

use super::chart::Chart;
use super::document::Report;
use super::number::duration;
use super::plain;
use super::seas::SeasView;
use super::table::Table;
use super::variation::VariationView;
use seacable_base::visible;
use seacable_studies::study::seas::{SeaQuestion, SeaResults};
use seacable_studies::study::sweep::{FinerRound, Sweep, SweepError, SweepFolder, SweepOutcomes};

/// Load cases of a table that is printed; of more those that failed are, and all stand in results.csv.
const MOST_ROWS: usize = 100;

/// Lines of a chart.
const CHART_LINES: usize = 18;

/// Columns of the report in the folder.
const REPORT_WIDTH: usize = 80;

/// What is shown of a sweep: the whole of its load cases, or, as `seacable study vary` does, all of its rows and what is varied.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum SweepPage {
    /// What the load cases say together, their extremes, and the rows of short tables.
    #[default]
    Sweep,
    /// A row for each point, whatever their number; what they say together only where it is asked for.
    Variation,
}

/// What a sweep found: its load cases, what they say together, what they cost.
#[derive(Debug, Clone)]
pub struct SweepReport<'a> {
    /// The load cases.
    pub view: VariationView<'a>,
    /// What they say together.
    pub seas: Option<SeasView<'a>>,
    cost: Option<String>,
    /// The load cases that were computed again, in words.
    finer: Option<String>,
    page: SweepPage,
    dir: Option<&'a Path>,
}

/// That there is no verdict by which load cases would be computed again.
fn unused_finer(question: &SeaQuestion) -> Option<String> {
    let unused = question.statistics.finer_runs > 0 && question.checks.is_empty();
    unused.then(|| {
        "`statistics.finer_runs` has no effect: there are no [[checks]] whose verdict finer runs would settle.".to_owned()
    })
}

/// What was computed again, in words; nothing where nothing was.
fn in_words(rounds: &[FinerRound]) -> Option<String> {
    let each = rounds.iter().map(|round| {
        let (count, finer) = (round.load_cases.len(), round.finer);
        format!("{count} with segments and steps divided in {finer}")
    });
    let each: Vec<String> = each.collect();
    (!each.is_empty()).then(|| {
        format!(
            "Load cases whose verdict lay within the numerical error were computed again: {}.",
            each.join(", then ")
        )
    })
}

impl<'a> SweepReport<'a> {
    /// What became of the load cases of a sweep, in this folder if it is stored. Once it has ended, load cases without an outcome were not needed where
    /// seeds are drawn until the checks are settled.
    #[must_use]
    pub fn new(
        (sweep, question): (&'a Sweep, &'a SeaQuestion),
        (outcomes, answers): (&SweepOutcomes, Option<&'a SeaResults>),
        has_ended: bool,
        dir: Option<&'a Path>,
    ) -> Self {
        let statistics = &question.statistics;
        let view = match outcomes {
            SweepOutcomes::Runs(outcomes, ids) => {
                let view = VariationView::of_case(&sweep.variation, outcomes, ids);
                match statistics.until_settled && has_ended {
                    true => view.with_unneeded(outcomes),
                    false => view,
                }
            }
            SweepOutcomes::AtRest(outcomes, names) => {
                VariationView::of_system(&sweep.variation, outcomes, names)
            }
        };
        let seas = answers.map(|results| SeasView {
            results,
            statistics,
        });
        Self {
            view,
            seas,
            cost: cost(outcomes),
            finer: unused_finer(question),
            page: SweepPage::Sweep,
            dir,
        }
    }

    /// The same after rounds in which load cases were computed again.
    #[must_use]
    pub fn with_finer(self, rounds: &[FinerRound]) -> Self {
        Self {
            finer: in_words(rounds).or(self.finer),
            ..self
        }
    }

    /// The same as another page.
    #[must_use]
    pub fn on_page(self, page: SweepPage) -> Self {
        Self { page, ..self }
    }

    /// The tables of the page: what the runs say together, the extremes, the load cases.
    #[must_use]
    pub fn tables(&self, width: usize) -> Vec<Table> {
        let all_rows = self.page == SweepPage::Variation;
        let seas = self.seas.filter(|seas| !all_rows || seas.is_asked_for());
        let mut tables = seas.map(|seas| seas.tables()).unwrap_or_default();
        if !all_rows {
            tables.push(self.view.extremes());
        }
        // Of seeds the sea is what is asked for; each run stands in results.csv.
        let of_seeds = seas.is_some_and(|seas| seas.has_seeds());
        match self.view.points() {
            _ if all_rows => tables.extend(self.view.tables(width)),
            0..=MOST_ROWS if !of_seeds => tables.extend(self.view.tables(width)),
            _ => tables.extend(self.view.failures()),
        }
        if let Some(last) = tables.last_mut() {
            last.notes.extend(self.finer.clone());
            last.notes.extend(self.cost.clone());
            last.notes.extend(self.dir.map(|dir| self.stored_in(dir)));
        }
        tables
    }

    /// The page as a report for pages of so many columns: its tables, and the charts of its results.
    #[must_use]
    pub fn report(&self, width: usize) -> Report {
        let mut report = Report::default();
        self.view.add_head(&mut report);
        for table in self.tables(width) {
            report.table(table);
        }
        for chart in self.charts() {
            report.chart(chart, CHART_LINES);
        }
        self.view.add_inputs(&mut report);
        report
    }

    /// The charts of its results; against seeds, which are no curve, there are none.
    #[must_use]
    pub fn charts(&self) -> Vec<Chart> {
        match self.has_seeds() {
            true => Vec::new(),
            false => self.view.charts(),
        }
    }

    /// Where the sweep is stored, in words.
    fn stored_in(&self, dir: &Path) -> String {
        let dir = visible::path(dir);
        match self.view.has_runs() {
            true => format!(
                "The sweep is {dir}; its table is results.csv, and its runs stand beside it."
            ),
            false => format!("The sweep is {dir}; its table is results.csv."),
        }
    }

    /// Whether any sea has several runs.
    #[must_use]
    pub fn has_seeds(&self) -> bool {
        self.seas.is_some_and(|seas| seas.has_seeds())
    }

    /// Writes the tables of a sweep that has ended, and its page as text, into its folder.
    ///
    /// # Errors
    /// The system refuses.
    pub fn store(&self, folder: &SweepFolder) -> Result<(), SweepError> {
        let [results, seas, checks] = self.csv(folder)?;
        folder.write_results(&results)?;
        match self.seas {
            Some(_) => folder.write_verdict(&seas, &checks, &self.text()),
            None => Ok(()),
        }
    }

    /// Writes the same tables as Parquet files beside their CSV.
    ///
    /// # Errors
    /// The system refuses.
    #[cfg(feature = "parquet")]
    pub fn store_parquet(&self, folder: &SweepFolder) -> Result<(), SweepError> {
        let names = ["results", "seas", "checks"];
        for (name, csv) in names.into_iter().zip(self.csv(folder)?) {
            if !csv.is_empty() {
                let file = super::parquet::of_csv(&csv);
                let file = file.map_err(|error| failed(folder, error))?;
                folder.write_parquet(name, &file)?;
            }
        }
        Ok(())
    }

    /// The tables of results, seas and checks as CSV; the last two empty where runs are not read together.
    fn csv(&self, folder: &SweepFolder) -> Result<[Vec<u8>; 3], SweepError> {
        let csv = |table: &Table| {
            let mut text = Vec::new();
            let written = table.write_csv(&mut text);
            written
                .map(|()| text)
                .map_err(|error| failed(folder, error))
        };
        let results = csv(&self.view.results_table())?;
        Ok(match &self.seas {
            Some(seas) => [
                results,
                csv(&seas.seas_table())?,
                csv(&seas.checks_table())?,
            ],
            None => [results, Vec::new(), Vec::new()],
        })
    }

    /// The page in ASCII, without the cost, which is another at every time.
    fn text(&self) -> String {
        let without_cost = Self {
            cost: None,
            page: SweepPage::Sweep,
            ..self.clone()
        };
        let tables = without_cost.tables(REPORT_WIDTH);
        let texts = tables
            .iter()
            .map(|table| plain::ascii_table(table).to_text(REPORT_WIDTH));
        texts.collect::<Vec<_>>().join("\n")
    }
}

/// Why a table of a folder cannot be written.
fn failed(
    folder: &SweepFolder,
    error: impl Into<Box<dyn std::error::Error + Send + Sync>>,
) -> SweepError {
    SweepError::Io {
        file: folder.dir().to_owned(),
        source: std::io::Error::other(error),
    }
}

/// What the runs cost, in words; nothing of equilibria.
fn cost(outcomes: &SweepOutcomes) -> Option<String> {
    let SweepOutcomes::Runs(outcomes, _) = outcomes else {
        return None;
    };
    let runs = outcomes.iter().flatten().flatten();
    let costs: Vec<_> = runs.map(|run| run.info.cost).collect();
    if costs.is_empty() {
        return None;
    }
    let [mut own, mut companions] = [0.0; 2];
    for cost in &costs {
        own += cost.cpu_s;
        companions += cost.companions_wall_s;
    }
    Some(format!(
        "The {} runs took {} of one core, and the estimates of their errors {} more.",
        costs.len(),
        duration(own),
        duration(companions)
    ))
}
