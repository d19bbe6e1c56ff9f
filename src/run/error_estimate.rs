//! Numerical errors of a run, estimated by companions: runs with other time steps, and on other meshes. Time error and mesh
//! error are kept apart; model error is what a validation table shows.

use std::sync::atomic::AtomicBool;

use super::companions::{self, Companions};
use super::compute::Computed;
use super::line_statistics;
use super::requested_statistics::{RequestedStatistic, StatisticSource};
use super::{Quantity, QuantityId, Subject};
use crate::case::{Case, ChannelQuantity, LineQuantity, Method, Section, Statistic};
use crate::numerics::interpolation::linear_clamped;
use crate::numerics::richardson::{self, OBSERVED, PRESUMED};

/// The single numbers of a run with their estimated errors.
#[derive(Debug, Clone, Default)]
pub(super) struct ErrorEstimates {
    /// The single numbers; errors are absent where they are not estimated.
    pub(super) summary: Vec<Quantity>,
    /// Error of the root mean square displacements, node by node \[m\], time and mesh together.
    pub(super) rms: Vec<f64>,
    /// How the errors are estimated, in words.
    pub(super) method: String,
    /// What the user should know.
    pub(super) warnings: Vec<String>,
}

/// The single numbers without errors.
pub(super) fn without_errors(run: &Computed) -> ErrorEstimates {
    let lists = [
        statistics(run),
        run.curves.clone(),
        run.modes.clone(),
        run.record.energy.clone(),
    ];
    ErrorEstimates {
        summary: lists.concat(),
        ..ErrorEstimates::default()
    }
}

/// Runs the companions and estimates the errors of all single numbers.
pub(super) fn estimate(case: &Case, run: &Computed, cancel: &AtomicBool) -> ErrorEstimates {
    let (time, mesh) = companions::compute_all(case, run, cancel);
    let (time, mesh) = (time.as_ref(), Some(&mesh));
    let mut warnings = Vec::new();
    let [whole_time, whole_mesh] = [("time", time), ("mesh", mesh)]
        .map(|(what, companions)| companions.filter(|c| is_finished(c, what, &mut warnings)));
    let mut statistics = with_errors(whole_time, whole_mesh, run, statistics);
    limit_resolution(&mut statistics, case, run);
    let lists = [
        statistics,
        with_errors(time, mesh, run, |c| c.curves.clone()),
        with_errors(None, mesh, run, |c| c.modes.clone()),
        with_errors(time, mesh, run, |c| c.record.energy.clone()),
    ];
    ErrorEstimates {
        summary: lists.concat(),
        rms: rms_error(run, [time, mesh]),
        method: describe(case, time, mesh),
        warnings,
    }
}

/// Whether the companion came to its end; a warning where it did not.
fn is_finished(companions: &Companions, what: &str, warnings: &mut Vec<String>) -> bool {
    let failure = companions.failure();
    warnings.extend(failure.map(|why| {
        format!("the {what} error is not estimated, its companion run did not finish: {why}")
    }));
    failure.is_none()
}

/// The statistics of a run, without errors; those that cannot be taken are left out.
fn statistics(run: &Computed) -> Vec<Quantity> {
    let channels = &run.record.history.channels;
    let quantity = |(wanted, number): &(RequestedStatistic, Option<f64>)| {
        let of = match wanted.of {
            StatisticSource::Channel(index) => Subject::Channel(channels.get(index)?.id.clone()),
            StatisticSource::Line(quantity) => Subject::Line(quantity),
        };
        let id = QuantityId::new(of, wanted.statistic, wanted.window).numbered(wanted.nth);
        Some(Quantity::new(id, (*number)?))
    };
    run.record.statistics.iter().filter_map(quantity).collect()
}

/// What reads numbers from a computation.
type Numbers = fn(&Computed) -> Vec<Quantity>;

/// The same numbers of the companions.
struct CompanionNumbers<'a> {
    companions: &'a Companions,
    coarse: Vec<Quantity>,
    coarser: Vec<Quantity>,
    /// The quotient of differences that is usual among them.
    usual: f64,
}

impl<'a> CompanionNumbers<'a> {
    fn read(companions: &'a Companions, run: &[Quantity], of: Numbers) -> Self {
        let mut numbers = Self {
            companions,
            coarse: of(&companions.coarse),
            coarser: companions.coarser.as_ref().map_or_else(Vec::new, of),
            usual: 0.0,
        };
        let three = run.iter().filter_map(|q| numbers.three(q));
        numbers.usual = richardson::usual_quotient(three);
        numbers
    }

    /// The values of a number in the run and both companions, where both have it.
    fn three(&self, q: &Quantity) -> Option<[f64; 3]> {
        Some([
            q.value,
            value(&self.coarse, &q.id)?,
            value(&self.coarser, &q.id)?,
        ])
    }

    fn error(&self, q: &Quantity) -> Option<f64> {
        if let Some(three) = self.three(q) {
            return Some(self.companions.refinement.observed(three, self.usual));
        }
        let coarse = value(&self.coarse, &q.id)?;
        Some(self.companions.presumed(q.value, coarse))
    }

    /// The values of the companions where they and the run's do not approach each other.
    fn unsettled(&self, q: &Quantity) -> Option<[f64; 2]> {
        let [value, coarse, coarser] = self.three(q)?;
        richardson::is_unsettled(value, coarse, coarser).then_some([coarse, coarser])
    }
}

fn value(list: &[Quantity], id: &QuantityId) -> Option<f64> {
    list.iter().find(|q| q.id == *id).map(|q| q.value)
}

/// The numbers of a run with their errors, by the same numbers of the companions.
fn with_errors(
    time: Option<&Companions>,
    mesh: Option<&Companions>,
    run: &Computed,
    of: Numbers,
) -> Vec<Quantity> {
    let mut list = of(run);
    let read = |companions| CompanionNumbers::read(companions, &list, of);
    let (time, mesh) = (time.map(read), mesh.map(read));
    for q in &mut list {
        q.time_error = time.as_ref().and_then(|time| time.error(q));
        q.mesh_error = mesh.as_ref().and_then(|mesh| mesh.error(q));
        let unsettled = |by: &Option<CompanionNumbers<'_>>| by.as_ref()?.unsettled(q);
        let others = [unsettled(&time), unsettled(&mesh)];
        q.unsettled = range(
            q,
            &others.into_iter().flatten().flatten().collect::<Vec<_>>(),
        );
    }
    list
}

/// By how much of itself the range of results that do not approach each other is wider to either side: another one lies between
/// three that scatter in half of the cases only.
const SCATTER: f64 = 0.5;

/// The range that holds a number with its error and the same of companions that do not approach it, with room for another; none
/// without such.
fn range(q: &Quantity, others: &[f64]) -> Option<[f64; 2]> {
    let error = q.error_estimate().filter(|_| !others.is_empty())?;
    let least = others.iter().copied().fold(q.value - error, f64::min);
    let greatest = others.iter().copied().fold(q.value + error, f64::max);
    let room = SCATTER * (greatest - least);
    Some([least - room, greatest + room])
}

/// A place along the line has at least the mesh error of a segment, and the tension of a line that goes slack between nodes that of
/// its weight.
fn limit_resolution(list: &mut [Quantity], case: &Case, run: &Computed) {
    for quantity in list {
        let mut least = 0.0;
        if let QuantityId::Statistic { statistic, .. } = &quantity.id {
            least = line_statistics::resolution(&run.record.profile, *statistic);
            if quantity.value == 0.0 && is_least_tension(&quantity.id) {
                least = segment_weight(case);
            }
        }
        quantity.mesh_error = quantity.mesh_error.map(|error| error.max(least));
    }
}

/// Errors of the root mean square displacements: sums of the differences from the companions, each times its factor.
fn rms_error(run: &Computed, companions: [Option<&Companions>; 2]) -> Vec<f64> {
    let profile = &run.record.profile;
    let others = companions.into_iter().flatten().filter_map(|companions| {
        let other = &companions.coarse.record.profile;
        let recorded = other.rms.len() == other.arc.len() && other.arc.len() > 1;
        recorded.then_some((other, companions))
    });
    let others: Vec<_> = others.collect();
    if others.is_empty() {
        return Vec::new();
    }
    let error = |(s, rms): (&f64, &f64)| {
        let each = others.iter();
        each.map(|(other, by)| by.presumed(*rms, linear_clamped(&other.arc, &other.rms, *s)))
            .sum()
    };
    profile.arc.iter().zip(&profile.rms).map(error).collect()
}

/// Whether it is the least tension somewhere or on the whole line.
fn is_least_tension(id: &QuantityId) -> bool {
    let QuantityId::Statistic { of, statistic, .. } = id else {
        return false;
    };
    let is_tension = match of {
        Subject::Channel(channel) => channel.quantity == ChannelQuantity::Tension,
        Subject::Line(quantity) => *quantity == LineQuantity::Tension,
        _ => false,
    };
    is_tension && *statistic == Statistic::Min
}

/// The least submerged weight of a segment on the line \[N\].
fn segment_weight(case: &Case) -> f64 {
    let water = &case.environment;
    let weight = |section: &Section| {
        let material = case.materials.get(&section.material)?;
        let area = 0.25 * std::f64::consts::PI * material.diameter_m.powi(2);
        let mass = material.mass_kg_per_m - water.water_density_kg_per_m3 * area;
        let length = section.length_m / section.segments as f64;
        Some(length * water.gravity_m_per_s2 * mass.abs())
    };
    let weights = case.line.iter().filter_map(weight);
    weights.reduce(f64::min).unwrap_or(0.0)
}

/// How the errors are estimated, in words.
fn describe(case: &Case, time: Option<&Companions>, mesh: Option<&Companions>) -> String {
    let order = |companions: &Companions| {
        if companions.coarser.is_some() {
            return format!("{OBSERVED} times Richardson by the order observed");
        }
        let order = companions.refinement.order;
        format!("{PRESUMED} times Richardson, order {order}")
    };
    let steps = time.map(|time| {
        let varies = case.solver.time_step_s.is_none() && case.solver.method == Method::Alpha;
        let and = time.coarser.is_some();
        let steps = match (varies, time.is_single_step()) {
            (true, _) if and => "8 and 64 times the error allowed in a step",
            (true, _) => "another error allowed in a step",
            (false, true) => "half the step",
            (false, false) if and => "steps twice and four times as long",
            (false, false) => "steps twice as long",
        };
        format!("time: {steps}, {}; ", order(time))
    });
    let mesh = mesh.map(|mesh| {
        let segments = match (mesh.is_finer, mesh.coarser.is_some()) {
            (true, _) => "twice the segments",
            (false, true) => "half the segments and a quarter",
            (false, false) => "half the segments",
        };
        format!(
            "mesh: {segments} (ratio {:.2}), {}",
            mesh.refinement.ratio,
            order(mesh)
        )
    });
    let crisis = if companions::has_crisis(case) {
        "; no order above 1.5, since a drag coefficient jumps"
    } else {
        ""
    };
    format!(
        "{}{}{crisis}",
        steps.unwrap_or_default(),
        mesh.unwrap_or_default()
    )
}
