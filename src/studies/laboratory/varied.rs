//! Variants of a case, drawn at random: the same scene with other meshes, periods, sizes and masses. What holds for the shipped cases,
//! on which the estimates of errors were chosen, is so held against cases that nobody has seen.

use super::bars::{self, BarSetting};
use crate::case::{Case, TextDigest};
use crate::numerics::random::Random;

/// By what share numbers vary, down and up. A section keeps a segment at least.
const SEGMENTS: [f64; 2] = [0.55, 1.6];
const PERIODS: [f64; 2] = [0.85, 1.25];
const SIZES: [f64; 2] = [0.7, 1.2];
const MASSES: [f64; 2] = [0.95, 1.1];
const STIFFNESSES: [f64; 2] = [0.7, 1.4];
const DURATIONS: [f64; 2] = [0.8, 1.1];

/// The settings of some variants of a case, as [`bars::settings`].
#[must_use]
pub fn settings(name: &str, case: &Case, seed: u64, count: usize) -> Vec<BarSetting> {
    let variants = 1..=count as u64;
    variants
        .flat_map(|number| {
            let name = format!("{name}, variant {number}");
            bars::settings(&name, &varied(case, seed, number))
        })
        .collect()
}

/// The variant of this number of a case, by a seed: the same numbers give the same variant.
#[must_use]
pub fn varied(case: &Case, seed: u64, number: u64) -> Case {
    // Every case has its own stream.
    let title = TextDigest::of_text(&case.case.title).0;
    let mut by = RandomFactors(Random::new(seed ^ title, number));
    let mut case = case.clone();
    let finer = by.factor(SEGMENTS);
    for section in &mut case.line {
        section.segments = ((section.segments as f64 * finer).round() as usize).max(1);
    }
    let (heavier, stiffer) = (by.factor(MASSES), by.factor(STIFFNESSES));
    for material in case.materials.values_mut() {
        material.mass_kg_per_m *= heavier;
        material.ea_n = material.ea_n.map(|ea| ea * stiffer);
    }
    if let Some(payload) = &mut case.payload {
        payload.dry_mass_kg *= heavier;
        payload.wet_mass_kg = payload.wet_mass_kg.map(|mass| mass * heavier);
    }
    let (larger, slower) = (by.factor(SIZES), by.factor(PERIODS));
    for end in [&mut case.ends.a, &mut case.ends.b] {
        end.amplitude_m = end.amplitude_m.map(|amplitude| amplitude * larger);
        end.period_s = end.period_s.map(|period| period * slower);
    }
    if let Some(waves) = &mut case.waves {
        // Waves are lower at most: higher ones may break, or wet what is written to hang in air.
        waves.height_m = waves.height_m.map(|height| height * larger.min(1.0));
        waves.period_s = waves.period_s.map(|period| period * slower);
    }
    case.solver.duration_s *= by.factor(DURATIONS);
    case
}

/// Factors drawn at random.
struct RandomFactors(Random);

impl RandomFactors {
    /// One from a range, evenly by its logarithm.
    fn factor(&mut self, [least, greatest]: [f64; 2]) -> f64 {
        least * (greatest / least).powf(self.0.uniform())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const STEEP_WAVE: &str = include_str!("../../../cases/basics/steep_wave.toml");

    #[test]
    fn a_variant_is_the_same_scene_with_other_numbers() {
        let case = crate::case::parse(STEEP_WAVE, "steep_wave.toml").unwrap();
        let variants = [1, 2].map(|number| varied(&case, 7, number));
        assert_eq!(variants[0], varied(&case, 7, 1));
        assert_ne!(variants[0], variants[1]);
        assert_ne!(variants[0], varied(&case, 8, 1));
        for variant in variants {
            assert_eq!(variant.line.len(), case.line.len());
            for (section, own) in variant.line.iter().zip(&case.line) {
                let finer = section.segments as f64 / own.segments as f64;
                assert!((0.5..1.7).contains(&finer), "{finer}");
            }
            crate::scene::build(&variant, 1).unwrap();
        }
    }
}
