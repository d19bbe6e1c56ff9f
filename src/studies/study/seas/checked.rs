//! How much of the limit of a check the seas use.

use super::loads::{Extreme, PlaceLoads};
use super::records::RecordedSeries;
use super::scene::CheckedScene;
use crate::case::{CheckAnalysis, CheckCondition, CheckInputs, CheckKind, GreatestMethod};
use crate::checks::resolved::Check;
use crate::checks::utilisation::{Estimate, Utilisation, UtilisationVerdict};

/// How much of a limit is used at a place.
#[derive(Debug, Clone, PartialEq)]
pub struct CheckRow {
    /// The sea, by its place in the list; nothing of what all seas do together.
    pub sea: Option<usize>,
    /// The place.
    pub place: String,
    /// The load that is compared, in the unit of the limit.
    pub load: Estimate,
    /// The limit.
    pub limit: f64,
    /// Their unit; empty for a number alone.
    pub unit: &'static str,
    /// The share that is used.
    pub used: Utilisation,
    /// The load case of the most extreme value that was seen, by its place in the list.
    pub load_case: Option<usize>,
    /// Its time \[s\].
    pub time: Option<f64>,
    /// How the extreme was found; nothing of fatigue.
    pub method: Option<GreatestMethod>,
}

/// A check with what all seas make of it.
#[derive(Debug, Clone, PartialEq)]
pub struct CheckResult {
    /// The check.
    pub check: Check,
    /// A row for each place in each sea.
    pub rows: Vec<CheckRow>,
    /// What could not be compared, and why, each once.
    pub missing: Vec<String>,
    /// The seas in which something could not be compared.
    pub open_seas: Vec<usize>,
}

impl CheckResult {
    /// Notes that something could not be compared in a sea.
    pub(super) fn lacks(&mut self, sea: usize, why: &str) {
        if !self.missing.iter().any(|known| known == why) {
            self.missing.push(why.to_owned());
        }
        if self.open_seas.last() != Some(&sea) {
            self.open_seas.push(sea);
        }
    }

    /// The row that governs: the greatest share.
    #[must_use]
    pub fn governing(&self) -> Option<&CheckRow> {
        let share = |row: &&CheckRow| row.used.value;
        self.rows
            .iter()
            .max_by(|a, b| share(a).total_cmp(&share(b)))
    }

    /// The worst that any row says; nothing without rows. What could not be compared leaves it open.
    #[must_use]
    pub fn verdict(&self) -> Option<UtilisationVerdict> {
        let worst = self.rows.iter().map(|row| row.used.verdict()).max();
        let open = (!self.missing.is_empty()).then_some(UtilisationVerdict::Open);
        worst.max(open)
    }
}

/// Whether a check is for load cases in a condition.
#[must_use]
pub(super) fn is_for(check: &Check, condition: CheckCondition, scene: &CheckedScene) -> bool {
    let analysis = match check.inputs.analysis {
        CheckAnalysis::Any => true,
        CheckAnalysis::Dynamic => scene.is_dynamic,
        CheckAnalysis::QuasiStatic => !scene.is_dynamic,
    };
    analysis && [CheckCondition::Any, condition].contains(&check.inputs.condition)
}

/// The series that a check reads; none for what is not read of records by place.
#[must_use]
pub(super) const fn series(kind: CheckKind) -> &'static [RecordedSeries] {
    match kind {
        CheckKind::SafetyFactor | CheckKind::PartialFactors | CheckKind::LeastTension => {
            &[RecordedSeries::Tension]
        }
        CheckKind::Uplift => &[RecordedSeries::Uplift],
        CheckKind::Offset => &[RecordedSeries::Offset],
        CheckKind::BedClearance => &[RecordedSeries::Height, RecordedSeries::BedClearance],
        CheckKind::SurfaceClearance => &[RecordedSeries::Height],
        CheckKind::BendRadius | CheckKind::Fatigue => &[],
    }
}

/// A load with the limit that it is held to.
struct CheckedLoad<'a> {
    load: Estimate,
    limit: f64,
    /// Where and when the load was seen.
    extreme: &'a Extreme,
    /// Whether the limit is the least that is allowed.
    is_least: bool,
}

impl<'a> CheckedLoad<'a> {
    fn most(load: Estimate, limit: f64, extreme: &'a Extreme) -> Self {
        Self {
            load,
            limit,
            extreme,
            is_least: false,
        }
    }

    fn least(load: Estimate, limit: f64, extreme: &'a Extreme) -> Self {
        Self {
            is_least: true,
            ..Self::most(load, limit, extreme)
        }
    }

    /// The share of the limit that is used. A limit of zero is kept, and nothing of it used, by all on its side.
    fn used(&self) -> Utilisation {
        let limit = self.limit;
        self.load.utilisation(|value| match self.is_least {
            true if value > 0.0 => limit / value,
            true => f64::INFINITY,
            false if limit > 0.0 => value / limit,
            false if value <= 0.0 => 0.0,
            false => f64::INFINITY,
        })
    }
}

/// How much of the limit of a check a sea uses at a place.
///
/// # Errors
/// A strength or a depth that is not stated.
pub(super) fn compared(
    check: &Check,
    sea: usize,
    loads: &PlaceLoads,
    scene: &CheckedScene,
) -> Result<CheckRow, String> {
    let held = held(check, loads, scene)?;
    Ok(CheckRow {
        sea: Some(sea),
        place: loads.place.clone(),
        used: held.used(),
        load: held.load,
        limit: held.limit,
        unit: loads.series.unit(),
        load_case: Some(held.extreme.load_case),
        time: held.extreme.time,
        method: Some(held.extreme.method),
    })
}

/// The load of a check at a place, and its limit.
fn held<'a>(
    check: &Check,
    loads: &'a PlaceLoads,
    scene: &CheckedScene,
) -> Result<CheckedLoad<'a>, String> {
    let inputs = &check.inputs;
    let (greatest, least) = (&loads.greatest, &loads.least);
    let length = inputs.limit_m.unwrap_or(0.0);
    Ok(match check.kind {
        CheckKind::SafetyFactor => {
            let load = scaled(&greatest.estimate, inputs.factor.unwrap_or(1.0));
            CheckedLoad::most(load, strength(inputs, loads, scene)?, greatest)
        }
        CheckKind::PartialFactors => {
            let load = by_partial_factors(inputs, loads);
            CheckedLoad::most(load, strength(inputs, loads, scene)?, greatest)
        }
        CheckKind::LeastTension => {
            let limit = match inputs.limit_n {
                Some(limit) => limit,
                None => strength(inputs, loads, scene)?,
            };
            CheckedLoad::least(least.estimate, limit, least)
        }
        CheckKind::Uplift => {
            CheckedLoad::most(greatest.estimate, inputs.limit_n.unwrap_or(0.0), greatest)
        }
        CheckKind::Offset => CheckedLoad::most(greatest.estimate, length, greatest),
        CheckKind::BedClearance if loads.series == RecordedSeries::BedClearance => {
            CheckedLoad::least(least.estimate, length, least)
        }
        CheckKind::BedClearance => {
            let depth = scene.depth;
            let depth = depth.ok_or("the sea bed is not level, or there is none")?;
            CheckedLoad::least(shifted(&least.estimate, 1.0, depth), length, least)
        }
        CheckKind::SurfaceClearance => {
            CheckedLoad::least(shifted(&greatest.estimate, -1.0, 0.0), length, greatest)
        }
        CheckKind::BendRadius | CheckKind::Fatigue => {
            return Err("it is not read of records by place".to_owned());
        }
    })
}

/// The share of the breaking load at a place that counts as its strength \[N\].
fn strength(inputs: &CheckInputs, loads: &PlaceLoads, scene: &CheckedScene) -> Result<f64, String> {
    let stated = scene.strengths.get(&loads.place).copied();
    let load = inputs.break_load_n.or(stated).ok_or_else(|| {
        let line = super::subject::subject(&loads.place);
        format!("no breaking load is stated for {line}: add break_load_n to its material or to the check")
    })?;
    Ok(inputs.strength_share.unwrap_or(1.0) * load)
}

/// Mean and dynamic part by factors of their own: `g_mean T_mean + g_dyn (T_mpm - T_mean)` (DNV-OS-E301, Ch.2 Sec.2). The errors of the
/// mean enter by the difference of the factors, and are added to those of the greatest value.
fn by_partial_factors(inputs: &CheckInputs, loads: &PlaceLoads) -> Estimate {
    let mean_factor = inputs.mean_factor.unwrap_or(1.0);
    let dynamic = inputs.dynamic_factor.unwrap_or(1.0);
    let (mean, greatest) = (&loads.mean, &loads.greatest.estimate);
    let load = |greatest: f64| mean_factor * mean.value + dynamic * (greatest - mean.value);
    let apart = (mean_factor - dynamic).abs();
    let half = mean.sample.map_or(0.0, |[low, high]| 0.5 * (high - low));
    let numerical = greatest.numerical.zip(mean.numerical);
    Estimate {
        value: load(greatest.value),
        numerical: numerical.map(|(greatest, mean)| dynamic * greatest + apart * mean),
        sample: greatest
            .sample
            .map(|[low, high]| [load(low) - apart * half, load(high) + apart * half]),
    }
}

fn scaled(load: &Estimate, factor: f64) -> Estimate {
    Estimate {
        value: factor * load.value,
        numerical: load.numerical.map(|error| factor * error),
        sample: load.sample.map(|ends| ends.map(|end| factor * end)),
    }
}

/// A load with another sign and another zero.
fn shifted(load: &Estimate, sign: f64, by: f64) -> Estimate {
    let of = |value: f64| sign * value + by;
    let ordered = |[a, b]: [f64; 2]| [f64::min(a, b), f64::max(a, b)];
    Estimate {
        value: of(load.value),
        numerical: load.numerical,
        sample: load.sample.map(|ends| ordered(ends.map(of))),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::TomlNode;
    use crate::case::rule_sets;
    use crate::checks::resolved::resolved;

    fn estimate(value: f64, numerical: f64, sample: f64) -> Estimate {
        Estimate {
            value,
            numerical: Some(numerical),
            sample: Some([value - sample, value + sample]),
        }
    }

    fn extreme(estimate: Estimate) -> Extreme {
        Extreme {
            estimate,
            method: GreatestMethod::Gumbel,
            seen: estimate.value,
            load_case: 3,
            time: Some(71.5),
        }
    }

    fn tension() -> PlaceLoads {
        PlaceLoads {
            series: RecordedSeries::Tension,
            place: "chain@120|b".to_owned(),
            mean: estimate(2e6, 1e4, 2e4),
            deviation: 1e5,
            greatest: extreme(estimate(3e6, 5e4, 2e5)),
            least: extreme(estimate(1e6, 5e4, 2e5)),
            duration: 3600.0,
        }
    }

    fn scene() -> CheckedScene {
        CheckedScene {
            strengths: [("chain@120|b".to_owned(), 8e6)].into(),
            is_dynamic: true,
            depth: Some(200.0),
            ..CheckedScene::default()
        }
    }

    /// The only check of a set of rules with this rule.
    fn check(rule: &str) -> Check {
        let head = "[rules]\ntitle = \"t\"\nedition = \"e\"\nsource = \"s\"\n[[checks]]\nname = \"n\"\nclause = \"c\"\n";
        let text = format!("{head}{rule}");
        assert!(TomlNode::parse(&text).is_ok());
        let set = rule_sets::parse(&text, "mine").unwrap();
        resolved(&set.checks, &Default::default())
            .unwrap()
            .remove(0)
    }

    fn near(found: f64, wanted: f64) {
        assert!(
            (found - wanted).abs() < 1e-12 * wanted.abs().max(1.0),
            "{found} {wanted}"
        );
    }

    #[test]
    fn a_safety_factor_is_on_the_greatest_tension() {
        let check = check("kind = \"safety-factor\"\nfactor = 1.67\n");
        let row = compared(&check, 0, &tension(), &scene()).unwrap();
        near(row.used.value, 1.67 * 3.0 / 8.0);
        near(row.used.both[1], 1.67 * (3.0 + 0.05 + 0.2) / 8.0);
        assert_eq!(row.used.verdict(), UtilisationVerdict::Passes);
        assert_eq!((row.load_case, row.time), (Some(3), Some(71.5)));
    }

    #[test]
    fn partial_factors_are_on_the_mean_and_on_what_is_above_it() {
        let rule = "kind = \"partial-factors\"\nmean_factor = 1.3\ndynamic_factor = 1.75\nstrength_share = 0.95\n";
        let row = compared(&check(rule), 0, &tension(), &scene()).unwrap();
        near(row.used.value, (1.3 * 2.0 + 1.75) / (0.95 * 8.0));
        let numerical = 1.75 * 0.05 + 0.45 * 0.01;
        near(
            row.used.numerical.unwrap()[1],
            (1.3 * 2.0 + 1.75 + numerical) / 7.6,
        );
        let sample = 1.75 * 0.2 + 0.45 * 0.02;
        near(
            row.used.sample.unwrap()[0],
            (1.3 * 2.0 + 1.75 - sample) / 7.6,
        );
        near(
            row.used.both[1],
            (1.3 * 2.0 + 1.75 + numerical + sample) / 7.6,
        );
    }

    #[test]
    fn lower_limits_are_used_up_from_above() {
        let row = compared(
            &check("kind = \"least-tension\"\nlimit_n = 5e5\n"),
            0,
            &tension(),
            &scene(),
        );
        let row = row.unwrap();
        near(row.used.value, 0.5);
        near(row.used.both[1], 0.5 / 0.75);
        let height = PlaceLoads {
            series: RecordedSeries::Height,
            place: "clump".to_owned(),
            least: extreme(estimate(-195.0, 0.5, 1.0)),
            ..tension()
        };
        let bed = "kind = \"bed-clearance\"\nof = [\"clump\"]\nlimit_m = 4.0\n";
        let row = compared(&check(bed), 0, &height, &scene()).unwrap();
        near(row.used.value, 4.0 / 5.0);
        assert_eq!(row.used.verdict(), UtilisationVerdict::Open);
    }

    #[test]
    fn a_limit_of_zero_is_kept_or_passed() {
        let used = |value: f64| {
            let uplift = PlaceLoads {
                series: RecordedSeries::Uplift,
                greatest: extreme(Estimate::exact(value)),
                ..tension()
            };
            let check = check("kind = \"uplift\"\nlimit_n = 0.0\n");
            compared(&check, 0, &uplift, &scene()).unwrap().used
        };
        assert_eq!(
            (used(0.0).value, used(0.0).verdict()),
            (0.0, UtilisationVerdict::Passes)
        );
        assert_eq!(used(-5.0).verdict(), UtilisationVerdict::Passes);
        assert_eq!(used(5.0).verdict(), UtilisationVerdict::Fails);
    }

    #[test]
    fn a_check_without_its_strength_or_depth_says_what_to_state() {
        let unknown = CheckedScene {
            is_dynamic: true,
            ..CheckedScene::default()
        };
        let check = check("kind = \"safety-factor\"\nfactor = 2.0\n");
        let why = compared(&check, 0, &tension(), &unknown).unwrap_err();
        assert!(
            why.contains("break_load_n") && why.contains("chain@120"),
            "{why}"
        );
    }

    #[test]
    fn rules_are_for_their_condition_and_their_analysis() {
        let rule = |condition: &str, analysis: &str| {
            check(&format!(
                "kind = \"safety-factor\"\nfactor = 2.0\ncondition = \"{condition}\"\nanalysis = \"{analysis}\"\n"
            ))
        };
        let intact = CheckCondition::Intact;
        assert!(is_for(&rule("any", "any"), intact, &scene()));
        assert!(is_for(&rule("intact", "dynamic"), intact, &scene()));
        assert!(!is_for(&rule("intact", "quasi-static"), intact, &scene()));
        assert!(!is_for(&rule("line-lost", "dynamic"), intact, &scene()));
    }

    #[test]
    fn what_could_not_be_compared_leaves_a_check_open() {
        let check = check("kind = \"safety-factor\"\nfactor = 1.0\n");
        let row = compared(&check, 0, &tension(), &scene()).unwrap();
        let mut result = CheckResult {
            check,
            rows: vec![row],
            missing: Vec::new(),
            open_seas: Vec::new(),
        };
        assert_eq!(result.verdict(), Some(UtilisationVerdict::Passes));
        result.missing.push("nothing".to_owned());
        assert_eq!(result.verdict(), Some(UtilisationVerdict::Open));
    }
}
