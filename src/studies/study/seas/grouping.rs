//! Load cases that differ by the seeds of their waves alone are samples of one sea.

use std::collections::BTreeMap;

use super::scene::CheckedScene;
use crate::case::fields::in_words;
use crate::case::{CheckCondition, StudyValue};
use crate::study::points::Setting;
use crate::study::vary::Variation;
use crate::system::model::NO_LINE;

/// A sea in one condition of the scene: load cases that differ by their seeds alone.
#[derive(Debug, Clone, PartialEq)]
pub struct SeaGroup {
    /// What is set, without seeds.
    pub settings: Vec<Setting>,
    /// Its load cases, by their places in the list.
    pub load_cases: Vec<usize>,
    /// What is broken.
    pub condition: CheckCondition,
    /// The probability of its load cases together; nothing where probabilities are not known.
    pub probability: Option<f64>,
}

impl SeaGroup {
    /// What is set, in words.
    #[must_use]
    pub fn words(&self) -> String {
        if self.settings.is_empty() {
            return "as in the file".to_owned();
        }
        let short = |setting: &Setting| {
            let key = setting.key.rsplit('.').next().unwrap_or(&setting.key);
            let (name, unit) = in_words(key);
            let unit = unit.map(|unit| format!(" {unit}")).unwrap_or_default();
            format!("{name} {}{unit}", setting.written())
        };
        self.settings
            .iter()
            .map(short)
            .collect::<Vec<_>>()
            .join(", ")
    }
}

/// Whether load cases that differ by this key are of the same sea: a seed draws another sample of it, and an estimate of errors
/// changes nothing.
#[must_use]
pub fn is_of_one_sea(key: &str) -> bool {
    key.rsplit('.').next() == Some("seed") || key == "solver.error_estimate"
}

/// The seas of a variation, in the order of their first load cases.
#[must_use]
pub fn seas(variation: &Variation, scene: &CheckedScene) -> Vec<SeaGroup> {
    let mut seas: Vec<SeaGroup> = Vec::new();
    let mut known: BTreeMap<String, usize> = BTreeMap::new();
    for (index, point) in variation.points.iter().enumerate() {
        let settings = point
            .settings
            .iter()
            .filter(|setting| !is_of_one_sea(&setting.key));
        let settings: Vec<Setting> = settings.cloned().collect();
        let probability = variation.probability.as_ref().map(|all| all[index]);
        let words: Vec<String> = settings.iter().map(Setting::as_override).collect();
        let place = *known.entry(words.join("\n")).or_insert(seas.len());
        match seas.get_mut(place) {
            Some(sea) => {
                sea.load_cases.push(index);
                sea.probability = sea.probability.zip(probability).map(|(a, b)| a + b);
            }
            None => seas.push(SeaGroup {
                condition: condition(&settings, scene),
                settings,
                load_cases: vec![index],
                probability,
            }),
        }
    }
    seas
}

/// What is broken with these settings.
fn condition(settings: &[Setting], scene: &CheckedScene) -> CheckCondition {
    let lost = settings
        .iter()
        .find(|setting| setting.key == "damage.lost_line");
    match lost.map(|setting| &setting.value) {
        Some(StudyValue::Word(word)) if word != NO_LINE => return CheckCondition::LineLost,
        Some(_) if scene.condition == CheckCondition::LineLost => return CheckCondition::Intact,
        _ => {}
    }
    let breaks = settings.iter().any(|setting| {
        let key = setting.key.rsplit('.').next();
        matches!(key, Some("break_s" | "break_n"))
    });
    if breaks {
        CheckCondition::Transient
    } else {
        scene.condition
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::load_cases::{LoadCaseKey, LoadCases};
    use crate::case::{StudyValue, field_at};
    use crate::study::points::BaseCase;

    #[test]
    fn load_cases_that_differ_by_their_seeds_are_one_sea() {
        let key = |path: &str| LoadCaseKey {
            path: path.to_owned(),
            field: field_at(&path.split('.').collect::<Vec<_>>()).unwrap(),
        };
        let row = |height: f64, seed: f64| [height, seed].map(StudyValue::Number).to_vec();
        let load_cases = LoadCases {
            keys: vec![key("waves.significant_height_m"), key("waves.seed")],
            rows: vec![row(2.0, 1.0), row(4.0, 1.0), row(2.0, 2.0), row(4.0, 2.0)],
            probability: Some(vec![0.3, 0.2, 0.3, 0.2]),
        };
        let variation = Variation::of_load_cases(BaseCase::new("", "c.toml"), load_cases);
        let found = seas(&variation, &CheckedScene::default());
        assert_eq!(found.len(), 2);
        assert_eq!(found[0].load_cases, [0, 2]);
        assert_eq!(found[0].words(), "significant height 2 m");
        assert!((found[1].probability.unwrap() - 0.4).abs() < 1e-15);
        assert!(
            found
                .iter()
                .all(|sea| sea.condition == CheckCondition::Intact)
        );
    }

    #[test]
    fn a_line_that_is_lost_or_breaks_is_a_condition_of_its_own() {
        let set =
            |key: &str, word: &str| vec![Setting::new(key, StudyValue::Word(word.to_owned()))];
        let intact = CheckedScene::default();
        let lost = CheckedScene {
            condition: CheckCondition::LineLost,
            ..CheckedScene::default()
        };
        assert_eq!(
            condition(&set("damage.lost_line", "a"), &intact),
            CheckCondition::LineLost
        );
        assert_eq!(
            condition(&set("damage.lost_line", NO_LINE), &lost),
            CheckCondition::Intact
        );
        assert_eq!(
            condition(&set("lines.a.break_s", "3"), &intact),
            CheckCondition::Transient
        );
        assert_eq!(condition(&[], &lost), CheckCondition::LineLost);
    }
}
