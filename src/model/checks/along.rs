//! Where fatigue checks count damage along a line, and of what: the tension at every node, or the stress in the units of its cross-section.

use super::resolved::Check;
use crate::case::{CheckKind, UnitSlip};
use crate::fatigue::component::FatigueComponent;
use crate::fatigue::spot::SpotCounter;
use crate::section::hot_spots::hot_spots;

/// What is known of a line along which damage is counted.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct CountedLine {
    /// What places in each section are called.
    pub names: Vec<String>,
    /// Diameter of each section \[m\], where it is stated.
    pub diameters: Vec<Option<f64>>,
    /// Breaking load of each section \[N\], where it is stated.
    pub strengths: Vec<Option<f64>>,
    /// The nodes at which sections begin, and the last node.
    pub bounds: Vec<usize>,
    /// Whether it has bending stiffness.
    pub bends: bool,
}

/// A place at which cycles are counted, of `by_tension T + by_curvature · κ`.
#[derive(Debug, Clone, PartialEq)]
pub struct CountedSpot {
    /// The check, by its name.
    pub check: String,
    /// What the place is called.
    pub name: String,
    /// Its node.
    pub node: usize,
    /// Layer and unit of the cross-section; empty for the line as a whole.
    pub unit: String,
    /// Angle around the cable \[deg\].
    pub angle_deg: f64,
    /// 1 of a tension, else the stress by tension \[Pa/N\].
    pub by_tension: f64,
    /// Stress by curvature in both planes \[Pa m\].
    pub by_curvature: [f64; 2],
    /// The curve, by its place among the components.
    pub component: usize,
}

/// What is counted along a line.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct AlongPlan {
    /// The places, check by check, node by node.
    pub spots: Vec<CountedSpot>,
    /// The curves.
    pub components: Vec<FatigueComponent>,
    /// What cannot be counted, and why, each once.
    pub missing: Vec<String>,
}

impl CountedLine {
    fn sections_at(&self, node: usize) -> impl Iterator<Item = usize> + '_ {
        let stretches = self.bounds.windows(2).enumerate();
        let beside = stretches.filter(move |(_, ends)| (ends[0]..=ends[1]).contains(&node));
        beside.map(|(section, _)| section)
    }

    /// The least of what the sections beside a node have.
    fn least_at(&self, node: usize, of: &[Option<f64>]) -> Option<f64> {
        let beside = self.sections_at(node);
        let found: Option<Vec<f64>> = beside.map(|section| *of.get(section)?).collect();
        found?.into_iter().reduce(f64::min)
    }

    fn name_at(&self, node: usize) -> Option<&str> {
        let section = self.sections_at(node).next()?;
        self.names.get(section).map(String::as_str)
    }
}

impl AlongPlan {
    /// Of the checks that count along a line.
    #[must_use]
    pub fn of_checks(checks: &[Check], line: &CountedLine) -> Self {
        let mut plan = Self::default();
        for check in checks.iter().filter(|check| check.is_along()) {
            let counted = match check.section {
                Some(_) => plan.add_units(check, line),
                None => plan.add_tensions(check, line),
            };
            if let Err(why) = counted {
                plan.lacks(check, &why);
            }
        }
        plan
    }

    fn lacks(&mut self, check: &Check, why: &str) {
        let why = format!("{}: {why}", check.name);
        if !self.missing.contains(&why) {
            self.missing.push(why);
        }
    }

    fn held<'a>(check: &Check, line: &'a CountedLine) -> Vec<(usize, &'a str)> {
        let last = line.bounds.last().copied().unwrap_or(0);
        let named = (0..=last).filter_map(|node| Some((node, line.name_at(node)?)));
        named.filter(|(_, name)| check.holds_for(name)).collect()
    }

    fn add_tensions(&mut self, check: &Check, line: &CountedLine) -> Result<(), String> {
        for (node, name) in Self::held(check, line) {
            let diameter = line.least_at(node, &line.diameters);
            let strength = line.least_at(node, &line.strengths);
            let component = check.component(diameter, strength)?;
            SpotCounter::check(&component).map_err(|why| why.to_string())?;
            self.spots.push(CountedSpot {
                check: check.name.clone(),
                name: name.to_owned(),
                node,
                unit: String::new(),
                angle_deg: 0.0,
                by_tension: 1.0,
                by_curvature: [0.0; 2],
                component: self.components.len(),
            });
            self.components.push(component);
        }
        Ok(())
    }

    fn add_units(&mut self, check: &Check, line: &CountedLine) -> Result<(), String> {
        let held = Self::held(check, line);
        if held.is_empty() {
            return Ok(());
        }
        if !line.bends {
            return Err(
                "the line has no bending stiffness; give its material `ei_n_m2`".to_owned(),
            );
        }
        let design = check.design()?.ok_or("its cross-section is not at hand")?;
        let wanted = |name: &str| {
            let units = check.inputs.units.as_ref();
            units.is_none_or(|units| units.iter().any(|unit| unit == name))
        };
        let slip = check.inputs.slip.unwrap_or(UnitSlip::None);
        let spots = hot_spots(&design, slip, &wanted);
        if spots.is_empty() {
            return Err(
                "no unit that it names has a known area and stiffness in the cross-section"
                    .to_owned(),
            );
        }
        let component = check.component_of_stress()?;
        for (node, name) in held {
            self.spots.extend(spots.iter().map(|spot| CountedSpot {
                check: check.name.clone(),
                name: name.to_owned(),
                node,
                unit: match spot.layer == spot.unit {
                    true => spot.unit.clone(),
                    false => format!("{} {}", spot.layer, spot.unit),
                },
                angle_deg: spot.angle.to_degrees(),
                by_tension: spot.by_tension,
                by_curvature: spot.by_curvature,
                component: self.components.len(),
            }));
        }
        self.components.push(component);
        Ok(())
    }
}

impl Check {
    /// Whether it counts damage along the lines.
    #[must_use]
    pub fn is_along(&self) -> bool {
        self.kind == CheckKind::Fatigue && (self.inputs.along || self.section.is_some())
    }
}
