//! What the runs of a sweep say together, as tables: the verdict of the checks, the greatest tensions of the seas, the life of the lines.

use std::collections::BTreeSet;

use serde_json::{Value, json};

use super::number::duration;
use super::table::{Align, Cell, CellStyle, Table};
use seacable_base::number::{digits, range as range_text, si, with_error};
use seacable_model::case::{CheckKind, GreatestMethod, StatisticsInputs};
use seacable_model::checks::utilisation::{Utilisation, UtilisationVerdict};
use seacable_studies::study::seas::{
    CheckResult, CheckRow, PlaceLoads, RecordedSeries, SeaGroup, SeaResults,
};

/// The rows that are printed of a check's places; all stand in checks.csv.
const MOST_PLACES: usize = 40;

/// The results of the seas, and how they were asked for.
#[derive(Debug, Clone, Copy)]
pub struct SeasView<'a> {
    /// The results.
    pub results: &'a SeaResults,
    /// How they are summed up.
    pub statistics: &'a StatisticsInputs,
}

/// A sea with the loads at the place of its greatest tension.
struct SeaRow<'a> {
    number: usize,
    sea: &'a SeaGroup,
    loads: Option<&'a PlaceLoads>,
}

/// The life at a place.
struct LifeRow<'a> {
    check: &'a CheckResult,
    row: &'a CheckRow,
    years: f64,
}

impl SeasView<'_> {
    /// All tables, the verdict first.
    #[must_use]
    pub fn tables(&self) -> Vec<Table> {
        let verdict = (!self.results.checks.is_empty()).then(|| self.verdict());
        verdict
            .into_iter()
            .chain([self.seas()])
            .chain(self.lives())
            .collect()
    }

    /// A row for each check: its verdict, and what governs it.
    #[must_use]
    pub fn verdict(&self) -> Table {
        let checks = self.results.checks.iter();
        let checks = checks.filter(|check| check.verdict().is_some());
        let checks: Vec<(usize, &CheckResult)> = checks.enumerate().collect();
        let table = Table::of_records("Verdict", &checks)
            .text("check", |(number, check)| {
                format!("{} [{}]", check.check.name, number + 1)
            })
            .cell("verdict", Align::Left, |(_, check)| verdict_cell(check))
            .cell("used", Align::Decimal, |(_, check)| {
                governing(check, |row| Cell::plain(share(row.used.value)))
            })
            .cell("numerical", Align::Decimal, |(_, check)| {
                governing(check, |row| Cell::plain(numerical(&row.used)))
            })
            .cell("sample", Align::Left, |(_, check)| {
                governing(check, |row| Cell::plain(sample(&row.used)))
            })
            .cell("place", Align::Left, |(_, check)| {
                governing(check, |row| Cell::plain(row.place.clone()))
            });
        let table = match self.results.is_of_one_load_case() {
            true => table,
            false => table
                .cell("sea", Align::Right, |(_, check)| {
                    governing(check, |row| match row.sea {
                        Some(sea) => Cell::plain((sea + 1).to_string()),
                        None => Cell::plain("all"),
                    })
                })
                .cell("load case", Align::Right, |(_, check)| {
                    governing(check, |row| number(row.load_case.map(|case| case + 1)))
                }),
        };
        table
            .cell("time", Align::Right, |(_, check)| {
                governing(check, |row| {
                    row.time
                        .map_or_else(Cell::none, |time| Cell::plain(duration(time)))
                })
            })
            .build()
            .noted(self.verdict_notes(&checks))
    }

    /// What a reader must know of the verdict.
    fn verdict_notes(&self, checks: &[(usize, &CheckResult)]) -> Vec<String> {
        let percent = 100.0 * self.statistics.confidence;
        let mut notes = vec![format!(
            "Used is the share of the limit, 1 at the limit. A check passes or fails where that holds with both errors, the numerical one and the interval of the sample at {percent} %; else it is not settled."
        )];
        if self.is_by_spectrum() {
            notes.push("Of quick looks the numerical error is that of the mesh; how far a linear look is from runs in time is in no verdict.".to_owned());
        }
        notes.extend(checks.iter().filter_map(|(number, result)| {
            let check = &result.check;
            let words = format!("[{}] {}: {}.", number + 1, check.name, check.clause);
            (!check.clause.is_empty()).then_some(words)
        }));
        notes.extend(self.not_compared().map(|why| format!("{why}.")));
        let of_one = self.results.is_of_one_load_case();
        notes.extend(self.for_none(match of_one {
            true => "Not for this load case",
            false => "No load case is for",
        }));
        notes.extend(self.weights().filter(|_| !of_one).map(str::to_owned));
        if !self.results.checks.is_empty() {
            notes.push("Check rules of standards against your edition.".to_owned());
        }
        notes
    }

    /// The checks that are for none of the load cases, after these words.
    fn for_none(&self, words: &str) -> Option<String> {
        let checks = self.results.checks.iter();
        let idle = checks.filter(|check| check.verdict().is_none());
        let idle: Vec<&str> = idle.map(|check| check.check.name.as_str()).collect();
        (!idle.is_empty()).then(|| format!("{words}: {}.", idle.join(", ")))
    }

    /// What could not be compared, by check, and why.
    fn not_compared(&self) -> impl Iterator<Item = String> {
        self.results.checks.iter().flat_map(|check| {
            let why = check.missing.iter();
            why.map(|why| format!("{}: {why}", check.check.name))
        })
    }

    /// Says where seas are weighted alike.
    fn weights(&self) -> Option<&'static str> {
        let fatigue = self.results.checks.iter();
        let fatigue = fatigue
            .filter(|check| check.check.kind == CheckKind::Fatigue)
            .count()
            > 0;
        let known = self
            .results
            .seas
            .iter()
            .all(|sea| sea.probability.is_some());
        (fatigue && !known)
            .then_some("The load cases have no probabilities: all seas weigh alike in the fatigue.")
    }

    /// A row for each sea: the place of its greatest tension, and what it does there; the rest stands in seas.csv.
    #[must_use]
    pub fn seas(&self) -> Table {
        let all = self.results.seas.iter().enumerate();
        let rows: Vec<SeaRow<'_>> = all
            .map(|(number, sea)| SeaRow {
                number,
                sea,
                loads: greatest_tension(&self.results.loads[number]),
            })
            .collect();
        let probabilities = rows.iter().any(|row| row.sea.probability.is_some());
        let of = |row: &SeaRow<'_>, read: &dyn Fn(&PlaceLoads) -> String| {
            row.loads
                .map_or_else(Cell::none, |loads| Cell::plain(read(loads)))
        };
        let hours = self.statistics.hours;
        let is_random = rows.iter().any(|row| {
            let greatest = row.loads.map(|loads| loads.greatest);
            greatest.is_some_and(|greatest| greatest.estimate.sample.is_some())
        });
        let by_spectrum = self.is_by_spectrum();
        let head = match is_random || by_spectrum {
            true => format!("greatest of {hours} h"),
            false => "greatest".to_owned(),
        };
        Table::of_records("Tension by sea", &rows)
            .count("sea", |row| row.number + 1)
            .text("settings", |row| row.sea.words())
            .when(probabilities, |table| {
                table.cell("p", Align::Decimal, |row| {
                    let known = row.sea.probability;
                    known.map_or_else(Cell::none, |p| Cell::plain(format!("{p:.4}")))
                })
            })
            .cell("place", Align::Left, |row| {
                of(row, &|loads| loads.place.clone())
            })
            .cell("mean", Align::Decimal, |row| {
                of(row, &|l| si(l.mean.value, l.series.unit()))
            })
            .cell(&head, Align::Decimal, |row| {
                of(row, &|l| {
                    let greatest = l.greatest.estimate;
                    with_error(greatest.value, greatest.numerical, l.series.unit())
                })
            })
            .when(is_random, |table| {
                table.cell("sample", Align::Left, |row| {
                    of(row, &|l| {
                        interval(l.greatest.estimate.sample, l.series.unit())
                    })
                })
            })
            .build()
            .noted([self.values_by_sea(&rows, is_random)])
            .noted(self.missing_load_cases())
    }

    /// How many load cases have no results, if any.
    fn missing_load_cases(&self) -> Option<String> {
        let missing: usize = self.results.without.iter().sum();
        (missing > 0).then(|| match self.statistics.until_settled {
            true => format!(
                "{missing} load cases were not needed or have no results. Looks after 5, 10, 20, ... seeds of a sea; their intervals hold at all looks together."
            ),
            false => format!("{missing} load cases have no results and are left out."),
        })
    }

    /// What the values of the table of seas are.
    fn values_by_sea(&self, rows: &[SeaRow<'_>], is_random: bool) -> String {
        let hours = self.statistics.hours;
        match is_random {
            _ if self.is_by_spectrum() => format!(
                "The place of the greatest tension of each sea, and there: the mean, and the most probable greatest value of {hours} h of a normal process with the spectrum of a quick look, each with the error of the mesh. What is not linear is in neither. All places stand in the CSV."
            ),
            true => {
                let methods = rows
                    .iter()
                    .filter_map(|row| Some(row.loads?.greatest.method.name()));
                let methods: BTreeSet<&str> = methods.collect();
                format!(
                    "The place of the greatest tension of each sea, and there: the mean, the most probable greatest value of {hours} h with its numerical error, its interval of the sample. Found by {}: Gumbel's law takes the extremes of the runs over all their steps, the others the peaks of the rows. All places stand in seas.csv.",
                    methods.into_iter().collect::<Vec<_>>().join(" and ")
                )
            }
            false => "The place of the greatest tension, the mean there, and the greatest value with its numerical error. All places stand in seas.csv.".to_owned(),
        }
    }

    /// Life by each check of fatigue, place by place.
    fn lives(&self) -> Option<Table> {
        let years = self.statistics.service_years;
        let rows = self.results.checks.iter();
        let rows = rows.filter(|check| check.check.kind == CheckKind::Fatigue);
        let rows = rows.flat_map(|check| {
            check
                .rows
                .iter()
                .map(move |row| LifeRow { check, row, years })
        });
        let mut rows: Vec<LifeRow<'_>> = rows.collect();
        if rows.is_empty() {
            return None;
        }
        let all = rows.len();
        rows.sort_by(|a, b| b.row.load.value.total_cmp(&a.row.load.value));
        rows.truncate(MOST_PLACES);
        let damage = |value: f64| format!("{value:.3e}");
        let table = Table::of_records("Fatigue", &rows)
            .text("check", |row| row.check.check.name.clone())
            .text("place", |row| row.row.place.clone())
            .cell("damage in service", Align::Right, |row| Cell::plain(damage(row.row.load.value)))
            .cell("numerical", Align::Right, |row| match row.row.load.numerical {
                Some(error) => Cell::plain(damage(error)),
                None => Cell::plain("not known"),
            })
            .cell("sample", Align::Left, |row| match row.row.load.sample {
                Some([low, high]) if low == high => Cell::plain("none"),
                Some([low, high]) if high.is_finite() => {
                    Cell::plain(format!("{} to {}", damage(low), damage(high)))
                }
                _ => Cell::plain("not known"),
            })
            .cell("life", Align::Decimal, |row| match row.row.load.value > 0.0 {
                true => Cell::plain(life(row.years / row.row.load.value)),
                false => Cell::plain("no damage"),
            })
            .build()
            .noted([format!(
                "Damage of {years} years by the probabilities of the seas, {} and Miner's sum; life is until a damage of 1, without the factor of the check.",
                match self.is_by_spectrum() {
                    true => "Dirlik's law of the ranges of a spectrum",
                    false => "rainflow cycles",
                }
            )])
            .noted((all > MOST_PLACES).then(|| format!("The {MOST_PLACES} greatest of {all}; all stand in checks.csv.")));
        Some(table)
    }

    /// A row for each check, sea and place, with every digit.
    #[must_use]
    pub fn checks_table(&self) -> Table {
        let checks = self.results.checks.iter();
        let rows = checks.flat_map(|check| check.rows.iter().map(move |row| (check, row)));
        let rows: Vec<(&CheckResult, &CheckRow)> = rows.collect();
        let ends = |ends: Option<[f64; 2]>, place: usize| {
            Cell::plain(ends.map_or_else(String::new, |ends| ends[place].to_string()))
        };
        let whole = |value: Option<usize>| {
            Cell::plain(value.map_or_else(String::new, |value| (value + 1).to_string()))
        };
        Table::of_records("", &rows)
            .text("check", |(check, _)| check.check.name.clone())
            .text("verdict", |(_, row)| row.used.verdict().word())
            .cell("sea", Align::Right, |(_, row)| whole(row.sea))
            .text("place", |(_, row)| row.place.clone())
            .cell("used", Align::Right, |(_, row)| {
                Cell::plain(row.used.value.to_string())
            })
            .cell("used, numerical low", Align::Right, |(_, row)| {
                ends(row.used.numerical, 0)
            })
            .cell("used, numerical high", Align::Right, |(_, row)| {
                ends(row.used.numerical, 1)
            })
            .cell("used, sample low", Align::Right, |(_, row)| {
                ends(row.used.sample, 0)
            })
            .cell("used, sample high", Align::Right, |(_, row)| {
                ends(row.used.sample, 1)
            })
            .cell("load", Align::Right, |(_, row)| {
                Cell::plain(row.load.value.to_string())
            })
            .cell("limit", Align::Right, |(_, row)| {
                Cell::plain(row.limit.to_string())
            })
            .text("unit", |(_, row)| row.unit)
            .cell("load case", Align::Right, |(_, row)| whole(row.load_case))
            .cell("time_s", Align::Right, |(_, row)| {
                Cell::plain(row.time.map_or_else(String::new, |time| time.to_string()))
            })
            .text("by", |(_, row)| {
                row.method.map_or("", |method| method.name())
            })
            .text("clause", |(check, _)| check.check.clause.clone())
            .build()
    }

    /// A row for each sea and place of a tension, with every digit.
    #[must_use]
    pub fn seas_table(&self) -> Table {
        let seas = self
            .results
            .seas
            .iter()
            .zip(&self.results.loads)
            .enumerate();
        let rows = seas
            .flat_map(|(number, (sea, loads))| loads.iter().map(move |loads| (number, sea, loads)));
        let rows: Vec<(usize, &SeaGroup, &PlaceLoads)> = rows.collect();
        let plain = |value: Option<f64>| {
            Cell::plain(value.map_or_else(String::new, |value| value.to_string()))
        };
        Table::of_records("", &rows)
            .count("sea", |(number, ..)| number + 1)
            .text("settings", |(_, sea, _)| sea.words())
            .text("condition", |(_, sea, _)| sea.condition.name())
            .cell("probability", Align::Right, |(_, sea, _)| {
                plain(sea.probability)
            })
            .count("runs", |(_, sea, _)| sea.load_cases.len())
            .text("of", |(_, _, loads)| series_word(loads.series))
            .text("place", |(_, _, loads)| loads.place.clone())
            .text("unit", |(_, _, loads)| loads.series.unit())
            .cell("seconds", Align::Right, |(_, _, loads)| {
                plain(Some(loads.duration))
            })
            .cell("mean", Align::Right, |(_, _, loads)| {
                plain(Some(loads.mean.value))
            })
            .cell("mean, numerical error", Align::Right, |(_, _, loads)| {
                plain(loads.mean.numerical)
            })
            .cell("deviation", Align::Right, |(_, _, loads)| {
                plain(Some(loads.deviation))
            })
            .cell("greatest", Align::Right, |(_, _, l)| {
                plain(Some(l.greatest.estimate.value))
            })
            .cell("greatest, low", Align::Right, |(_, _, l)| {
                plain(l.greatest.estimate.sample.map(|s| s[0]))
            })
            .cell("greatest, high", Align::Right, |(_, _, l)| {
                plain(l.greatest.estimate.sample.map(|s| s[1]))
            })
            .cell("greatest, numerical error", Align::Right, |(_, _, l)| {
                plain(l.greatest.estimate.numerical)
            })
            .cell("greatest seen", Align::Right, |(_, _, l)| {
                plain(Some(l.greatest.seen))
            })
            .cell("least", Align::Right, |(_, _, l)| {
                plain(Some(l.least.estimate.value))
            })
            .cell("least seen", Align::Right, |(_, _, l)| {
                plain(Some(l.least.seen))
            })
            .text("by", |(_, _, loads)| loads.greatest.method.name())
            .build()
    }

    /// Whether the loads are those of quick looks.
    fn is_by_spectrum(&self) -> bool {
        let mut loads = self.results.loads.iter().flatten();
        loads.any(|loads| loads.greatest.method == GreatestMethod::Spectrum)
    }

    /// Whether any sea has several runs.
    #[must_use]
    pub fn has_seeds(&self) -> bool {
        let mut seas = self.results.seas.iter();
        seas.any(|sea| sea.load_cases.len() > 1)
    }

    /// Whether load cases say more together than each by itself: there are checks, or seeds.
    #[must_use]
    pub fn is_asked_for(&self) -> bool {
        self.has_seeds() || !self.results.checks.is_empty()
    }

    /// The worst verdict in a word, a row for each check, sea and place, and what could not be compared.
    #[must_use]
    pub fn checks_json(&self) -> Value {
        json!({
            "verdict": self.worst().map(UtilisationVerdict::word),
            "rows": self.checks_table().to_json(),
            "missing": self.not_compared().collect::<Vec<_>>(),
        })
    }

    /// The worst verdict of all checks; nothing where there are none with load cases.
    #[must_use]
    pub fn worst(&self) -> Option<UtilisationVerdict> {
        self.results
            .checks
            .iter()
            .filter_map(CheckResult::verdict)
            .max()
    }
}

/// The verdict of a check, what does not pass in colour.
fn verdict_cell(check: &CheckResult) -> Cell {
    check.verdict().map_or_else(Cell::none, |verdict| {
        let style = match verdict {
            UtilisationVerdict::Passes => return Cell::plain(verdict.word()),
            UtilisationVerdict::Open => CellStyle::Warn,
            UtilisationVerdict::Fails => CellStyle::Bad,
        };
        Cell::new(verdict.word(), style)
    })
}

/// A cell of the row that governs a check.
fn governing(check: &CheckResult, read: impl FnOnce(&CheckRow) -> Cell) -> Cell {
    check.governing().map_or_else(Cell::none, read)
}

/// The loads at the place of the greatest tension.
fn greatest_tension(loads: &[PlaceLoads]) -> Option<&PlaceLoads> {
    let tensions = loads
        .iter()
        .filter(|loads| loads.series == RecordedSeries::Tension);
    let value = |loads: &&PlaceLoads| loads.greatest.estimate.value;
    tensions.max_by(|a, b| value(a).total_cmp(&value(b)))
}

/// What a series is called in a table.
pub(super) const fn series_word(series: RecordedSeries) -> &'static str {
    match series {
        RecordedSeries::Tension => "tension",
        RecordedSeries::Uplift => "uplift",
        RecordedSeries::Offset => "offset",
        RecordedSeries::Height => "height",
        RecordedSeries::BedClearance => "height above the bed",
    }
}

fn number(value: Option<usize>) -> Cell {
    value.map_or_else(Cell::none, |value| Cell::plain(value.to_string()))
}

/// A share to a thousandth, or that it has no bound.
fn share(value: f64) -> String {
    match value.is_finite() {
        true => format!("{value:.3}"),
        false => "beyond".to_owned(),
    }
}

/// The numerical error of a share, to either side the larger one.
fn numerical(used: &Utilisation) -> String {
    match used.numerical {
        Some([low, high]) => {
            let error = f64::max(high - used.value, used.value - low);
            match error {
                error if error < 5e-4 => "below 0.001".to_owned(),
                error => share(error),
            }
        }
        None => "not known".to_owned(),
    }
}

fn sample(used: &Utilisation) -> String {
    match used.sample {
        Some([low, high]) if low == high => "none".to_owned(),
        Some([low, high]) if high.is_finite() => format!("{} to {}", share(low), share(high)),
        Some([low, _]) => format!("above {}", share(low)),
        None => "none".to_owned(),
    }
}

fn interval(ends: Option<[f64; 2]>, unit: &str) -> String {
    match ends {
        Some([low, high]) if high.is_finite() => range_text(low, high, unit),
        Some([low, _]) => format!("above {}", si(low, unit)),
        None => "none".to_owned(),
    }
}

/// A life in years, or that it exceeds all plans.
fn life(years: f64) -> String {
    match years {
        years if years > 1e6 => "over 1e6 years".to_owned(),
        years => format!("{} years", digits(years, 3)),
    }
}
