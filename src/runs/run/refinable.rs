//! What is computed again with other steps and on other meshes, to tell its errors by: a case of a line, or a system of lines.

use std::sync::atomic::AtomicBool;

use super::Quantity;
use super::channel_statistics::reads_twice;
use super::companions::CompanionRefinement;
use super::compute::{Computed, Resolution, compute};
use super::requested_statistics::requested;
use crate::case::{self, Case, DragCoefficient, DragLawName, Method, Section};

/// Something with companions.
pub trait Refinable: Sync {
    /// Computes a companion.
    fn companion(&self, place: CompanionRefinement, cancel: &AtomicBool) -> Computed;

    /// The order of its method in time; none at rest.
    fn method_order(&self) -> Option<f64>;

    /// Whether a force of it jumps with the speed, which leaves no method its order.
    fn has_crisis(&self) -> bool;

    /// Whether steps four times as long are not stable.
    fn is_explicit(&self) -> bool;

    /// Whether the error sets the lengths of its steps.
    fn varies_steps(&self) -> bool;

    /// Number of its segments where each is so many times as long.
    fn segments(&self, coarsening: usize) -> usize;

    /// Whether any part of it is a single segment, which has no coarser mesh.
    fn has_single_segment(&self) -> bool;

    /// The companions that its file names, in words.
    fn named(&self) -> Option<&[String]>;

    /// The least submerged weight of a segment of a line, by its name \[N\].
    fn segment_weight(&self, line: &str) -> f64;

    /// What a result errs by at least, whatever its companions say, in its unit: of a closed form, which has no companions, by rounding.
    /// Nothing where companions alone tell.
    fn least_error(&self, _: &Quantity) -> Option<f64> {
        None
    }
}

impl Refinable for Case {
    fn companion(&self, place: CompanionRefinement, cancel: &AtomicBool) -> Computed {
        let mut case = self.clone();
        // Cycles along the line are counted by the run itself.
        case.checks.clear();
        if !reads_output_times(&case) {
            case.output.interval_s = case.solver.duration_s;
        }
        let mut coarsening = place.segment.max(1.0) as usize;
        if super::companions::named(&case).is_some() {
            divide(&mut case, coarsening);
            coarsening = 1;
        }
        if place.segment < 1.0 {
            for section in &mut case.line {
                section.segments *= 2;
            }
        }
        let resolution = Resolution {
            coarsening,
            step_ratio: place.step,
        };
        compute(&case, resolution, None, cancel, None)
    }

    fn method_order(&self) -> Option<f64> {
        self.solver.method.order()
    }

    fn has_crisis(&self) -> bool {
        self.line
            .iter()
            .filter_map(|section| self.materials.get(&section.material))
            .any(|material| {
                material.drag_normal == DragCoefficient::Named(DragLawName::Jia2019Normal)
            })
    }

    fn is_explicit(&self) -> bool {
        self.solver.method == Method::Rk4
    }

    fn varies_steps(&self) -> bool {
        self.solver.time_step_s.is_none() && self.solver.method == Method::Alpha
    }

    fn segments(&self, coarsening: usize) -> usize {
        crate::scene::mesh::segments(self, coarsening)
    }

    fn has_single_segment(&self) -> bool {
        self.line.iter().any(|section| section.segments <= 1)
    }

    fn named(&self) -> Option<&[String]> {
        self.solver.companions.as_deref()
    }

    fn segment_weight(&self, _: &str) -> f64 {
        let water = &self.environment;
        let weight = |section: &Section| {
            let material = self.materials.get(&section.material)?;
            let area = 0.25 * std::f64::consts::PI * material.diameter_m.powi(2);
            let mass = material.mass_kg_per_m - water.water_density_kg_per_m3 * area;
            let length = section.length_m / section.segments as f64;
            Some(length * water.gravity_m_per_s2 * mass.abs())
        };
        let weights = self.line.iter().filter_map(weight);
        weights.reduce(f64::min).unwrap_or(0.0)
    }
}

/// Whether any result is read at output times, not from what lies between steps.
fn reads_output_times(case: &Case) -> bool {
    let statistics = requested(case, &case::channels(case));
    !case.published_curve.is_empty()
        || case.output.response_from_s.is_some()
        || statistics
            .iter()
            .any(|wanted| reads_twice(wanted.statistic))
}

/// Gives every section so many times fewer segments, and explicit steps so many times their length, in the case itself: as a search
/// had them before it made them finer.
fn divide(case: &mut Case, by: usize) {
    for section in &mut case.line {
        section.segments = (section.segments / by).max(1);
    }
    if case.solver.method == Method::Rk4 {
        let step = &mut case.solver.time_step_s;
        *step = step.map(|step| step * by as f64);
    }
}
