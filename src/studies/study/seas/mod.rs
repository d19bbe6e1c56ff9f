//! What the stored runs of a sweep say together: each sea by the records of its seeds, checks by the greatest share of their limits,
//! fatigue by the probabilities of the seas.
//!
//! Load cases that differ by their seeds alone are samples of one [`SeaGroup`]. Two errors go through everything and are never added
//! to one: that of the sample, which more seeds make smaller, and the numerical one of the runs.

mod at_rest;
mod checked;
mod fatigue;
mod grouping;
mod least_along;
mod loads;
mod looks;
mod one_run;
mod question;
mod quick;
mod records;
mod scene;
mod subject;

use std::path::PathBuf;

use rayon::prelude::*;

pub use at_rest::RestName;
pub use checked::{CheckResult, CheckRow};
pub use fatigue::{SeaDamage, of_service};
pub use grouping::{SeaGroup, is_of_one_sea, seas};
pub use loads::{Extreme, PlaceLoads};
pub use looks::Look;
pub use quick::{Difference, QuickSeas, SeaLook, SeaLookOutcome, look_at_seas};
pub use records::{RecordedSeries, SeaRunRecord};
pub use scene::CheckedScene;

use crate::case::{CheckKind, StatisticsInputs};
use crate::checks::resolved::Check;
use crate::checks::utilisation::{Estimate, UtilisationVerdict};
use crate::run::Quantity;
use crate::study::points::PointOutcome;
use crate::study::vary::Variation;
use crate::study::vary::system::SystemOutcome;
use fatigue::SeaFatigue;
use subject::subject;

/// A stored run of a load case: where it is, and its results.
#[derive(Debug, Clone, PartialEq)]
pub struct StoredLoadCase {
    /// Its directory.
    pub dir: PathBuf,
    /// Its results.
    pub summary: Vec<Quantity>,
}

/// What is asked of the seas.
#[derive(Debug, Clone, PartialEq)]
pub struct SeaQuestion {
    /// What checks need to know of the scene.
    pub scene: CheckedScene,
    /// How results are summed up.
    pub statistics: StatisticsInputs,
    /// The checks.
    pub checks: Vec<Check>,
}

/// What the runs of a sweep say together.
#[derive(Debug, Clone, PartialEq)]
pub struct SeaResults {
    /// The seas.
    pub seas: Vec<SeaGroup>,
    /// Loads at the places of each sea.
    pub loads: Vec<Vec<PlaceLoads>>,
    /// Load cases of each sea that have no results.
    pub without: Vec<usize>,
    /// The checks.
    pub checks: Vec<CheckResult>,
}

/// What one sea says.
struct OneSea {
    loads: Vec<PlaceLoads>,
    without: usize,
    rows: Vec<Vec<Result<CheckRow, String>>>,
    fatigue: Vec<SeaFatigue>,
}

impl SeaResults {
    /// Of the stored runs of a variation, by load case; seas side by side on the caller's threads. A sea is read, summed up and let
    /// go, so that memory holds the records of as many seas as there are threads.
    #[must_use]
    pub fn of_runs(
        variation: &Variation,
        runs: &[Option<StoredLoadCase>],
        question: &SeaQuestion,
    ) -> Self {
        let seas = seas(variation, &question.scene);
        let each = seas.par_iter().enumerate();
        let each = each.map(|(number, sea)| question.one(number, sea, runs));
        Self::together(seas.clone(), each.collect(), question)
    }

    /// Of the equilibria of a system, with the results of [`SeaQuestion::rest_names`] last.
    #[must_use]
    pub fn at_rest(
        variation: &Variation,
        outcomes: &[Option<SystemOutcome>],
        (names, question): (&[RestName], &SeaQuestion),
    ) -> Self {
        let seas = seas(variation, &question.scene);
        let each = seas.iter().enumerate();
        let each = each.map(|(number, sea)| question.one_at_rest(number, sea, outcomes, names));
        Self::together(seas.clone(), each.collect(), question)
    }

    fn together(seas: Vec<SeaGroup>, each: Vec<OneSea>, question: &SeaQuestion) -> Self {
        let checks = question.checks.iter().enumerate();
        let checks = checks.map(|(place, check)| {
            let mut result = CheckResult {
                check: check.clone(),
                rows: Vec::new(),
                missing: Vec::new(),
                open_seas: Vec::new(),
            };
            for (sea, one) in each.iter().enumerate() {
                for row in &one.rows[place] {
                    match row {
                        Ok(row) => result.rows.push(row.clone()),
                        Err(why) => result.lacks(sea, why),
                    }
                }
            }
            if check.kind == CheckKind::Fatigue {
                let of = each.iter().map(|one| &one.fatigue[place]);
                add_fatigue(&mut result, &seas, &of.collect::<Vec<_>>(), question);
            }
            result
        });
        let checks = checks.collect();
        let (loads, without) = each.into_iter().map(|one| (one.loads, one.without)).unzip();
        Self {
            seas,
            loads,
            without,
            checks,
        }
    }
}

impl StoredLoadCase {
    /// Of what became of a load case; nothing where it has no stored results.
    #[must_use]
    pub fn of_outcome(outcome: &PointOutcome) -> Option<Self> {
        let run = outcome.as_ref().ok()?;
        Some(Self {
            dir: run.dir.clone()?,
            summary: run.summary.clone(),
        })
    }
}

impl SeaQuestion {
    /// Whether more seeds of a sea would settle nothing: none of its checks is open, or those that are have failed elsewhere in it or lie
    /// within the numerical error of the runs.
    #[must_use]
    pub fn is_settled(
        &self,
        number: usize,
        sea: &SeaGroup,
        runs: &[Option<StoredLoadCase>],
    ) -> bool {
        let found = self.one(number, sea, runs);
        found.rows.iter().all(|rows| {
            let of = |wanted: UtilisationVerdict| {
                rows.iter()
                    .flatten()
                    .filter(move |row| row.used.verdict() == wanted)
            };
            let fails = of(UtilisationVerdict::Fails).next().is_some();
            fails || of(UtilisationVerdict::Open).all(|row| row.used.needs_finer_runs())
        })
    }

    /// The results of a system at rest that the checks need.
    #[must_use]
    pub fn rest_names(&self) -> Vec<RestName> {
        match self.checks.is_empty() {
            true => Vec::new(),
            false => at_rest::names(&self.scene, &self.checks, &self.scene.bodies),
        }
    }

    fn one_at_rest(
        &self,
        number: usize,
        sea: &SeaGroup,
        outcomes: &[Option<SystemOutcome>],
        names: &[RestName],
    ) -> OneSea {
        let found = sea.load_cases.iter().filter_map(|&load_case| {
            let point = outcomes.get(load_case)?.as_ref()?.as_ref().ok()?;
            let first = point.results.len().checked_sub(names.len())?;
            Some(at_rest::loads(names, &point.results[first..], load_case))
        });
        let found: Vec<Vec<PlaceLoads>> = found.collect();
        let without = sea.load_cases.len() - found.len();
        let loads = found.into_iter().next().unwrap_or_default();
        let incomplete = self.incomplete(number, sea, sea.load_cases.len() - without);
        let rows = self.checks.iter();
        let rows = rows.map(|check| {
            let mut own = self.rows(check, (number, sea), &loads, &[]);
            let is_for = checked::is_for(check, sea.condition, &self.scene);
            own.extend(incomplete.clone().filter(|_| is_for).map(Err));
            own
        });
        OneSea {
            without,
            rows: rows.collect(),
            fatigue: vec![SeaFatigue::new(); self.checks.len()],
            loads,
        }
    }

    fn one(&self, number: usize, sea: &SeaGroup, runs: &[Option<StoredLoadCase>]) -> OneSea {
        let read = sea.load_cases.iter().filter_map(|&load_case| {
            let run = runs.get(load_case)?.as_ref()?;
            SeaRunRecord::read(load_case, &run.dir, &run.summary, self.statistics.from_s).ok()
        });
        let read: Vec<SeaRunRecord> = read.collect();
        let loads = self.loads(&read);
        let incomplete = self.incomplete(number, sea, read.len());
        let (mut rows, mut fatigue) = (Vec::new(), Vec::new());
        for check in &self.checks {
            let mut own = self.rows(check, (number, sea), &loads, &read);
            let is_for = checked::is_for(check, sea.condition, &self.scene);
            own.extend(incomplete.clone().filter(|_| is_for).map(Err));
            let damages = match is_for && check.kind == CheckKind::Fatigue {
                true => fatigue::of_sea(&read, check, &self.scene),
                false => SeaFatigue::new(),
            };
            if is_for && check.kind == CheckKind::Fatigue && damages.is_empty() {
                own.push(Err(match check.is_along() {
                    true => NOTHING_COUNTED.to_owned(),
                    false => nothing_recorded(check, RecordedSeries::Tension),
                }));
            }
            rows.push(own);
            fatigue.push(damages);
        }
        OneSea {
            without: sea.load_cases.len() - read.len(),
            rows,
            fatigue,
            loads,
        }
    }

    /// Why a sea with so many results says less than it should: a run that failed may have been the worst.
    fn incomplete(&self, number: usize, sea: &SeaGroup, read: usize) -> Option<String> {
        let wanted = match self.statistics.until_settled {
            true => sea.load_cases.len().min(Look::FIRST.runs),
            false => sea.load_cases.len(),
        };
        let missing = wanted.saturating_sub(read);
        let sea = number + 1;
        (missing > 0).then(|| format!("{missing} load cases of sea {sea} have no results"))
    }

    /// Loads of tensions, and of what checks ask for.
    fn loads(&self, runs: &[SeaRunRecord]) -> Vec<PlaceLoads> {
        let Some(first) = runs.first() else {
            return Vec::new();
        };
        let is_asked = |series: RecordedSeries| {
            let mut kinds = self.checks.iter().map(|check| checked::series(check.kind));
            series == RecordedSeries::Tension || kinds.any(|of| of.contains(&series))
        };
        let asked = RecordedSeries::ALL
            .into_iter()
            .filter(|series| is_asked(*series));
        let places = asked.flat_map(|series| {
            let places: Vec<&str> = first.places(series).collect();
            places.into_iter().map(move |place| (series, place))
        });
        let random = self.scene.is_random;
        places
            .filter_map(|place| loads::loads_at(runs, place, &self.statistics, random))
            .collect()
    }

    fn rows(
        &self,
        check: &Check,
        (number, sea): (usize, &SeaGroup),
        loads: &[PlaceLoads],
        runs: &[SeaRunRecord],
    ) -> Vec<Result<CheckRow, String>> {
        if !checked::is_for(check, sea.condition, &self.scene) {
            return Vec::new();
        }
        let mut rows = least_along::rows(check, number, runs, self);
        let series = checked::series(check.kind);
        let is_of_line = |place: &str| {
            let mut lines = self.scene.lines.iter();
            lines.any(|line| least_along::place(check, line).as_deref() == Some(place))
        };
        let is_held = |loads: &PlaceLoads| match loads.series {
            RecordedSeries::BedClearance => is_of_line(&loads.place),
            _ => check.inputs.stretch_m.is_none() && check.holds_for(subject(&loads.place)),
        };
        let held = loads
            .iter()
            .filter(|loads| series.contains(&loads.series) && is_held(loads));
        rows.extend(held.map(|loads| checked::compared(check, number, loads, &self.scene)));
        match series.first() {
            Some(series) if rows.is_empty() && !loads.is_empty() => {
                rows.push(Err(nothing_recorded(check, *series)));
            }
            _ => {}
        }
        rows.extend(not_along_lines(check, &self.scene).map(Err));
        rows
    }
}

/// What a check of a stretch of lines names that is none.
fn not_along_lines<'a>(
    check: &'a Check,
    scene: &'a CheckedScene,
) -> impl Iterator<Item = String> + 'a {
    let names = check.inputs.of.iter().flatten();
    let names = names.filter(|_| check.inputs.stretch_m.is_some());
    names
        .filter(|name| !scene.is_line(name))
        .map(|name| format!("{name} is no line, and a stretch is one of lines"))
}

/// Why a check along the lines has no row in a sea.
const NOTHING_COUNTED: &str = "no damage is counted along the lines; the warnings of the runs say why, and runs of an older version are to be computed anew";

/// Why a check has no row in a sea.
fn nothing_recorded(check: &Check, series: RecordedSeries) -> String {
    let of = match &check.inputs.of {
        Some(of) => format!(" of {}", of.join(", ")),
        None => String::new(),
    };
    match series {
        _ if check.kind == CheckKind::BedClearance && check.inputs.stretch_m.is_some() => {
            format!(
                "no height along a line{of} is recorded: a quick look has none, a bed is needed, and the line must reach so far"
            )
        }
        RecordedSeries::Uplift => {
            format!("no force on an anchor{of} is recorded: add `uplift = true` to [output]")
        }
        _ => format!("nothing{of} that it could compare is recorded"),
    }
}

/// The damage of the years of service at every place, by the probabilities of the seas that the check is for; alike where none are known.
fn add_fatigue(
    result: &mut CheckResult,
    seas: &[SeaGroup],
    damages: &[&SeaFatigue],
    question: &SeaQuestion,
) {
    let counted: Vec<(f64, &SeaFatigue)> = seas
        .iter()
        .zip(damages)
        .filter(|(_, damages)| !damages.is_empty())
        .map(|(sea, damages)| (sea.probability.unwrap_or(1.0), *damages))
        .collect();
    let all: f64 = counted.iter().map(|(share, _)| share).sum();
    let Some((_, first)) = counted.first() else {
        return;
    };
    let factor = result.check.inputs.factor.unwrap_or(1.0);
    // Of the units of a cross-section the one that governs at each place along the line.
    let mut before: Option<&str> = None;
    for place in first.keys() {
        let parts = counted.iter().map(|(share, damages)| {
            let damage = damages.get(place).cloned();
            let damage = damage
                .unwrap_or_else(|| Err(format!("{} is not recorded in all seas", place.name)));
            damage.map(|damage| (share / all, damage))
        });
        let parts: Result<Vec<_>, String> = parts.collect();
        match parts {
            Err(why) if !result.missing.contains(&why) => result.missing.push(why),
            Err(_) => {}
            Ok(parts) => {
                let load = of_service(&parts, question.statistics.service_years);
                // Motions that are not drawn at random have no sample.
                let load = Estimate {
                    sample: load.sample.filter(|_| question.scene.is_random),
                    ..load
                };
                let row = CheckRow {
                    sea: None,
                    place: place.name.clone(),
                    load,
                    limit: 1.0 / factor,
                    unit: "",
                    used: load.utilisation(|damage| damage * factor),
                    load_case: None,
                    time: None,
                    method: None,
                };
                let governing = result.rows.last_mut();
                match governing.filter(|_| before == Some(place.along.as_str())) {
                    Some(known) if row.used.value > known.used.value => *known = row,
                    Some(_) => {}
                    None => result.rows.push(row),
                }
                before = Some(&place.along);
            }
        }
    }
}
