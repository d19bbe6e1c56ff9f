//! What the runs of a sweep say together: asked of the file before anything is computed, answered by its stored runs.

use super::CommandError;
use crate::case::{Attachment, Case, CheckInputs, StatisticsInputs};
use crate::checks::resolved::resolved;
use crate::report::number::duration;
use crate::study::seas::{CheckedScene, SeaQuestion, SeaResults, StoredRun};
use crate::study::sweep::{Sweep, SweepOutcomes, SweepResults};
use crate::study::vary::Variation;
use crate::system::SolvedSystem;
use std::collections::BTreeMap;

/// What is asked of the seas of a line.
pub(super) fn of_line(case: &Case) -> Result<SeaQuestion, CommandError> {
    let scene = CheckedScene::of_case(case);
    question(scene, (&case.statistics, &case.checks), &case.files)
}

/// What is asked of the seas of a system.
pub(super) fn of_system(solved: &SolvedSystem) -> Result<SeaQuestion, CommandError> {
    let (scene, file) = (CheckedScene::of_system(solved), &solved.file);
    question(scene, (&file.statistics, &file.checks), &file.files)
}

fn question(
    scene: CheckedScene,
    (statistics, checks): (&StatisticsInputs, &[CheckInputs]),
    files: &BTreeMap<String, Attachment>,
) -> Result<SeaQuestion, CommandError> {
    let checks = resolved(checks, files);
    let checks = checks.map_err(|error| CommandError::Usage(format!("[[checks]]: {error}.")))?;
    for check in &checks {
        if let Some((name, near)) = scene.unknown(check) {
            let near = near.map_or_else(String::new, |near| format!(" Did you mean `{near}`?"));
            let what = format!(
                "[[checks]]: {} holds `{name}`, which is no line, point, body or end.{near}",
                check.name
            );
            return Err(CommandError::Usage(what));
        }
    }
    Ok(SeaQuestion {
        scene,
        statistics: statistics.clone(),
        checks,
    })
}

/// The sweep of some load cases, with all results that are needed.
pub(super) fn sweep(variation: Variation, results: SweepResults, question: &SeaQuestion) -> Sweep {
    let needed = question.rest_names().into_iter().map(|needed| needed.name);
    Sweep {
        variation,
        results,
        needed: needed.collect(),
    }
}

/// What the runs of a sweep say together; of equilibria, which are not stored, only where there are checks.
pub(super) fn answers(
    sweep: &Sweep,
    outcomes: &SweepOutcomes,
    question: &SeaQuestion,
) -> Option<SeaResults> {
    let outcomes = match outcomes {
        SweepOutcomes::Runs(outcomes, _) => outcomes,
        SweepOutcomes::AtRest(outcomes, _) => {
            let names = question.rest_names();
            let of = (names.as_slice(), question);
            let asked = !question.checks.is_empty();
            return asked.then(|| SeaResults::at_rest(&sweep.variation, outcomes, of));
        }
    };
    let stored = outcomes
        .iter()
        .map(|outcome| outcome.as_ref().and_then(StoredRun::of));
    let stored: Vec<Option<StoredRun>> = stored.collect();
    Some(SeaResults::of(&sweep.variation, &stored, question))
}

/// What the runs cost, in words; nothing of equilibria.
pub(super) fn cost(outcomes: &SweepOutcomes) -> Option<String> {
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
