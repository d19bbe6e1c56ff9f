//! Fatigue along a line while it is computed: cycles are counted at every node as the steps come, so that no history of the nodes is kept.

use serde::{Deserialize, Serialize};

use crate::case::{Case, Method};
use crate::checks::along::{AlongPlan, CountedLine};
use crate::checks::resolved::{Check, resolved};
use crate::fatigue::spot::SpotCounter;
use crate::scene::Scene;
use crate::solve::State;

/// The damage at a place along a line, as `fatigue.csv` has it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct FatigueSpot {
    /// The check, by its name.
    pub check: String,
    /// The line or its section.
    pub line: String,
    /// Unstretched arc length from end A \[m\].
    pub arc_m: f64,
    /// Layer and unit of the cross-section; empty for the line as a whole.
    pub unit: String,
    /// Angle around the cable, from bending in the vertical plane at the start \[deg\].
    pub angle_deg: f64,
    /// The time counted \[s\].
    pub duration_s: f64,
    /// Miner's sum of that time.
    pub damage: f64,
    /// Number of cycles, halves as 0.5.
    pub cycles: f64,
    /// Greatest range \[N\], or \[Pa\] of a unit.
    pub greatest_range: f64,
    /// d(damage) / d(range) \[1/N\], or \[1/Pa\] of a unit.
    pub damage_by_range: f64,
    /// 1 of a tension; of a unit its stress by tension \[Pa/N\].
    pub by_tension: f64,
    /// Stress of a unit by curvature \[Pa m\].
    pub by_curvature: f64,
}

/// Counts cycles along one line.
#[derive(Debug, Clone)]
pub struct AlongCount {
    plan: AlongPlan,
    counters: Vec<SpotCounter>,
    /// Why a place is not counted on.
    refused: Option<String>,
    /// From when on \[s\].
    from: f64,
    /// Tension \[N\] and curvature in two planes \[1/m\] at the nodes.
    tension: Vec<f64>,
    curvature: Vec<[f64; 2]>,
}

impl AlongCount {
    /// Of a plan for a line of so many nodes, from a time on \[s\].
    #[must_use]
    pub fn new(plan: AlongPlan, nodes: usize, from: f64) -> Self {
        Self {
            counters: vec![SpotCounter::default(); plan.spots.len()],
            refused: None,
            from,
            tension: vec![0.0; nodes],
            curvature: vec![[0.0; 2]; nodes],
            plan,
        }
    }

    /// Of a case of a line; nothing where no check counts along it, or the line is at rest.
    #[must_use]
    pub fn of_case(case: &Case, scene: &Scene) -> Option<Self> {
        if case.solver.method == Method::Static {
            return None;
        }
        // A set or a curve that cannot be read is refused where checks are resolved for a verdict.
        let checks = resolved(&case.checks, &case.files).ok()?;
        if !checks.iter().any(Check::is_along) {
            return None;
        }
        let materials = case
            .line
            .iter()
            .map(|section| case.materials.get(&section.material));
        let materials: Vec<_> = materials.collect();
        let line = CountedLine {
            names: case
                .line
                .iter()
                .map(|section| section.name.clone())
                .collect(),
            diameters: materials.iter().map(|of| Some((*of)?.diameter_m)).collect(),
            strengths: materials.iter().map(|of| (*of)?.break_load_n).collect(),
            bounds: scene.labels.joints.iter().map(|joint| joint.node).collect(),
            bends: scene.elements.flexure.is_some(),
        };
        let plan = AlongPlan::of_checks(&checks, &line);
        Some(Self::new(plan, scene.line_nodes(), case.statistics.from_s))
    }

    /// Takes in an accepted step; does not allocate.
    pub fn step(&mut self, scene: &Scene, time: f64, state: &State) {
        if time < self.from * (1.0 - 1e-12) || self.plan.spots.is_empty() {
            return;
        }
        for (node, tension) in self.tension.iter_mut().enumerate() {
            *tension = scene.tension_at(node, state);
        }
        if let Some(flexure) = &scene.elements.flexure {
            flexure.curvatures(&scene.line, state, &mut self.curvature);
        }
        for (spot, counter) in self.plan.spots.iter().zip(&mut self.counters) {
            let (tension, [first, second]) = (self.tension[spot.node], self.curvature[spot.node]);
            let value = spot.by_tension * tension
                + spot.by_curvature[0] * first
                + spot.by_curvature[1] * second;
            let component = &self.plan.components[spot.component];
            if self.refused.is_none()
                && let Err(why) = counter.push(component, time, value)
            {
                self.refused = Some(format!("{}: {why}", spot.check));
            }
        }
    }

    /// What is counted so far.
    #[must_use]
    pub fn counters(&self) -> &[SpotCounter] {
        &self.counters
    }

    /// Continues from what was counted so far, which is of as many places.
    pub fn restore(&mut self, counters: &[SpotCounter]) {
        self.counters.clone_from_slice(counters);
    }

    /// The damage at every place, and what could not be counted, in words; `arc` is that of the nodes \[m\].
    #[must_use]
    pub fn finish(self, arc: &[f64]) -> (Vec<FatigueSpot>, Vec<String>) {
        let mut missing = self.plan.missing;
        missing.extend(self.refused.clone());
        if self.refused.is_some() {
            return (Vec::new(), missing);
        }
        let mut found = Vec::with_capacity(self.counters.len());
        for (spot, counter) in self.plan.spots.into_iter().zip(self.counters) {
            match counter.finish(&self.plan.components[spot.component]) {
                Ok((damage, duration_s)) if duration_s > 0.0 => found.push(FatigueSpot {
                    arc_m: arc[spot.node],
                    check: spot.check,
                    line: spot.name,
                    unit: spot.unit,
                    angle_deg: spot.angle_deg,
                    duration_s,
                    damage: damage.sum,
                    cycles: damage.cycles,
                    greatest_range: damage.greatest_range,
                    damage_by_range: damage.range_slope,
                    by_tension: spot.by_tension,
                    by_curvature: spot.by_curvature[0].hypot(spot.by_curvature[1]),
                }),
                Ok(_) => {}
                Err(why) => {
                    let why = format!("{}: {why}", spot.check);
                    if !missing.contains(&why) {
                        missing.push(why);
                    }
                }
            }
        }
        (found, missing)
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;
    use std::f64::consts::TAU;

    use super::*;
    use crate::case::{self, Attachment, CheckInputs, CheckKind, UnitSlip, kind};
    use crate::numerics::V3;
    use crate::scene::build;
    use crate::section::CrossSection;

    const SECTION: &str = include_str!("../../../cases/umbilical/section.toml");
    const CURVE: &str = "[curve]\ntitle = \"wire\"\nkind = \"stress\"\nm = 3.0\nlog_k = 12.0\nnominal_area_m2 = 0.01\n";
    const LINE: &str = r#"
        case.title = "bent"
        materials.umbilical = { diameter_m = 0.094, mass_kg_per_m = 19.6, ea_n = 3.0e8, ei_n_m2 = 2860.0 }
        line = [{ name = "umbilical", material = "umbilical", length_m = 20.0, segments = 20 }]
        ends.a = { name = "a", kind = "fixed", position_m = [0.0, 0.0, -50.0] }
        ends.b = { name = "b", kind = "fixed", position_m = [19.0, 0.0, -50.0] }
        solver = { duration_s = 100.0 }
    "#;

    /// Damage along a line that is bent to arcs of a circle: curvature `peak cos(2 pi t)` in a plane at an angle to the vertical, and a
    /// constant tension.
    fn damage(peak: f64, plane: f64, slip: UnitSlip) -> Vec<FatigueSpot> {
        let case = case::parse(LINE, "bent.toml").unwrap();
        let scene = build(&case, 1).unwrap();
        let file = |text: &str| Attachment { text: text.into() };
        let files = BTreeMap::from([
            ("s.toml".to_owned(), file(SECTION)),
            ("c.toml".to_owned(), file(CURVE)),
        ]);
        let inputs = CheckInputs {
            kind: Some(CheckKind::Fatigue),
            section: Some("s.toml".to_owned()),
            curve: Some("c.toml".to_owned()),
            units: Some(vec!["outer-armour".to_owned()]),
            slip: Some(slip),
            ..CheckInputs::default()
        };
        let checks = resolved(&[inputs], &files).unwrap();
        let line = CountedLine {
            names: vec!["umbilical".to_owned()],
            diameters: vec![None],
            strengths: vec![None],
            bounds: vec![0, 20],
            bends: true,
        };
        let plan = AlongPlan::of_checks(&checks, &line);
        assert!(plan.missing.is_empty(), "{:?}", plan.missing);
        let mut count = AlongCount::new(plan, scene.line_nodes(), 0.0);
        let mut state = scene.initial_state();
        for step in 0..=50 * 40 {
            let time = f64::from(step) / 40.0;
            // The discrete curvature is the sine of the angle between neighbours by their length.
            let turn = (peak * (TAU * time).cos()).asin();
            let (mut place, mut angle) = (V3::zeros(), -10.0 * turn);
            for node in &mut state.x {
                *node = place;
                let sideways = angle.sin();
                place +=
                    1.001 * V3::new(angle.cos(), sideways * plane.sin(), sideways * plane.cos());
                angle += turn;
            }
            count.step(&scene, time, &state);
        }
        let (found, missing) = count.finish(&scene.line.arc);
        assert!(missing.is_empty(), "{missing:?}");
        found
    }

    #[test]
    fn a_harmonic_curvature_of_known_amplitude_gives_the_damage_by_hand() {
        let design = kind::parse_stored::<CrossSection>(SECTION, "s.toml").unwrap();
        let armour = design.layout.helices().last().unwrap();
        let wire = &armour.elements[0];
        let youngs = wire.ea / wire.area.unwrap();
        let stuck = wire.radius + armour.pitch_radius * armour.angle.cos().powi(2);
        for (slip, lever) in [(UnitSlip::Full, wire.radius), (UnitSlip::None, stuck)] {
            // In the vertical plane, across it, and between two of the angles.
            for (plane, off) in [(0.0_f64, 0.0), (90.0, 0.0), (11.25, 11.25)] {
                let found = damage(0.02, plane.to_radians(), slip);
                let at = found.iter().filter(|spot| spot.arc_m == 10.0);
                let worst = at.max_by(|a, b| a.damage.total_cmp(&b.damage)).unwrap();
                let amplitude = youngs * lever * 0.02 * f64::to_radians(off).cos();
                let range = 2.0 * amplitude / 1e6;
                let by_hand = 50.0 * range.powi(3) / 1e12;
                assert!(
                    (worst.damage / by_hand - 1.0).abs() < 5e-3,
                    "{plane} deg: {by_hand} by hand, {worst:?}"
                );
                assert!((worst.cycles - 50.0).abs() < 1.0 && worst.duration_s == 50.0);
                // A hinge does not bend.
                assert!(
                    found
                        .iter()
                        .filter(|spot| spot.arc_m == 0.0)
                        .all(|spot| spot.damage < 1e-9 * by_hand)
                );
            }
        }
    }

    #[test]
    fn what_cannot_be_counted_is_said() {
        let case = case::parse(LINE, "bent.toml").unwrap();
        let check = |curve: &str, section: Option<&str>| {
            let inputs = CheckInputs {
                kind: Some(CheckKind::Fatigue),
                along: true,
                curve: Some(curve.to_owned()),
                section: section.map(str::to_owned),
                ..CheckInputs::default()
            };
            let text = Attachment {
                text: SECTION.into(),
            };
            let files = BTreeMap::from([("s.toml".to_owned(), text)]);
            let checks = resolved(&[inputs], &files).unwrap();
            let line = CountedLine {
                names: vec!["umbilical".to_owned()],
                diameters: vec![Some(case.materials["umbilical"].diameter_m)],
                strengths: vec![None],
                bounds: vec![0, 20],
                bends: false,
            };
            AlongPlan::of_checks(&checks, &line)
        };
        let plan = check("dnv-studless-chain", None);
        assert_eq!((plan.spots.len(), plan.missing.len()), (21, 0));
        for (curve, section, why) in [
            ("api-studlink-chain", None, "reference strength"),
            ("dnv-b1-seawater-cp", Some("s.toml"), "ei_n_m2"),
            ("none", None, "no published curve"),
        ] {
            let plan = check(curve, section);
            assert!(
                plan.spots.is_empty() && plan.missing[0].contains(why),
                "{:?}",
                plan.missing
            );
        }
    }
}
