//! Load cases that differ by the seeds of their waves alone are samples of one sea.

use std::collections::BTreeMap;

use super::scene::CheckedScene;
use crate::case::{CheckCondition, StudyValue};
use crate::study::points::Setting;
use crate::study::vary::Variation;
use crate::system::model::NO_LINE;

/// A sea in one condition of the scene: load cases that differ by their seeds alone.
#[derive(Debug, Clone, PartialEq)]
pub struct Sea {
    /// What is set, without seeds.
    pub settings: Vec<Setting>,
    /// Its load cases, by their places in the list.
    pub load_cases: Vec<usize>,
    /// What is broken.
    pub condition: CheckCondition,
    /// The probability of its load cases together; nothing where probabilities are not known.
    pub probability: Option<f64>,
}

impl Sea {
    /// What is set, in words.
    #[must_use]
    pub fn words(&self) -> String {
        if self.settings.is_empty() {
            return "as in the file".to_owned();
        }
        let short = |setting: &Setting| {
            let key = setting.key.rsplit('.').next().unwrap_or(&setting.key);
            format!("{key} {}", setting.written())
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
pub fn seas(variation: &Variation, scene: &CheckedScene) -> Vec<Sea> {
    let mut seas: Vec<Sea> = Vec::new();
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
            None => seas.push(Sea {
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
