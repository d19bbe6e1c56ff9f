//! Numerical errors of a run, estimated by companions: runs with other time steps, and on other meshes. Time error and mesh
//! error are kept apart; model error is what a validation table shows.

use std::sync::atomic::{AtomicBool, Ordering};

use super::companions::{Companions, Evidence};
use super::compute::Computed;
use super::refinable::Refinable;
use super::requested_statistics::{RequestedStatistic, StatisticSource};
use super::unsettled_range::unsettled_range;
use super::{History, Profile, Quantity, QuantityId, Subject, energy_balance, line_statistics};
use crate::case::{ChannelId, ChannelQuantity, LineQuantity, Statistic};
use crate::numerics::interpolation::linear_clamped;
use crate::numerics::richardson::{self, OBSERVED, PRESUMED, UNLIKE};

/// The single numbers of a run with their estimated errors.
#[derive(Debug, Clone, Default)]
pub struct ErrorEstimates {
    /// The single numbers; errors are absent where they are not estimated.
    pub summary: Vec<Quantity>,
    /// Errors of the root mean square displacements, line by line and node by node \[m\], time and mesh together.
    pub rms: Vec<Vec<f64>>,
    /// How the errors are estimated, in words.
    pub method: String,
    /// The pairs of runs by which errors of curves are told.
    pub curves: Vec<HistoryPair>,
    /// What the user should know.
    pub warnings: Vec<String>,
}

/// The histories of the nearest pair of runs that shows an error.
#[derive(Debug, Clone)]
pub struct HistoryPair {
    histories: [History; 2],
    /// The error by the difference.
    factor: f64,
}

impl HistoryPair {
    /// Of a finer and a coarser run, whose difference times a factor is the error.
    #[must_use]
    pub const fn new(histories: [History; 2], factor: f64) -> Self {
        Self { histories, factor }
    }

    fn of_evidence(evidence: &Evidence<'_>) -> Self {
        let histories = evidence.near.map(|run| run.record.history.clone());
        Self::new(histories, evidence.presumed(1.0))
    }

    /// The error of what is taken of a history, by its difference in the pair.
    pub fn error(&self, taken: impl Fn(&History) -> Option<f64>) -> Option<f64> {
        let [fine, coarse] = &self.histories;
        Some(self.factor * (taken(fine)? - taken(coarse)?).abs())
    }
}

/// The single numbers without errors.
pub fn without_errors(run: &Computed) -> ErrorEstimates {
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

/// Runs the companions and estimates the errors of all single numbers. Where too many results do not approach each other from
/// companion to companion, dearer ones nearer to the run are computed in their place.
pub fn estimate(case: &dyn Refinable, run: &Computed, cancel: &AtomicBool) -> ErrorEstimates {
    let companions = Companions::of_run(case, run, cancel);
    let estimates = by_companions(case, run, &companions);
    if companions.can_be_nearer() && !cancel.load(Ordering::Relaxed) && is_in_doubt(&estimates) {
        return by_companions(case, run, &companions.beside_the_run());
    }
    estimates
}

/// Share of the results that may be not settled before companions nearer to the run are computed.
const DOUBTFUL: f64 = 0.2;

fn is_in_doubt(estimates: &ErrorEstimates) -> bool {
    let summary = &estimates.summary;
    let ordered = || summary.iter().filter(|q| !counts_nodes(q));
    let unsettled = ordered().filter(|q| q.unsettled.is_some()).count();
    unsettled as f64 > DOUBTFUL * ordered().count() as f64
}

fn counts_nodes(q: &Quantity) -> bool {
    matches!(&q.id, QuantityId::Statistic { of, .. } if of.counts_nodes())
}

pub(super) fn by_companions(
    case: &dyn Refinable,
    run: &Computed,
    companions: &Companions<'_>,
) -> ErrorEstimates {
    let mut warnings = Vec::new();
    let mut told = |what: &str, evidence: Result<_, String>| {
        let warning = |why| {
            format!("the {what} error is not estimated, its companion run did not finish: {why}")
        };
        evidence.map_err(|why| warnings.push(warning(why))).ok()
    };
    let time = companions.time().and_then(|time| told("time", time));
    let mesh = companions.mesh().and_then(|mesh| told("mesh", mesh));
    estimates_by(case, run, [time.as_ref(), mesh.as_ref()], warnings)
}

/// The errors of all single numbers by what shows the error in time and that of the mesh.
fn estimates_by(
    case: &dyn Refinable,
    run: &Computed,
    evidence: [Option<&Evidence<'_>>; 2],
    mut warnings: Vec<String>,
) -> ErrorEstimates {
    let [time, mesh] = evidence;
    let energy = |growth| with_errors(evidence, growth, run, |c| c.record.energy.clone());
    let growth = energy_balance::time_error_growth(&energy(1.0));
    let mut statistics = with_errors(evidence, growth, run, statistics);
    limit_resolution(&mut statistics, case, run);
    let lists = [
        statistics,
        with_errors(evidence, growth, run, |c| c.curves.clone()),
        with_errors([None, mesh], growth, run, |c| c.modes.clone()),
        energy(growth),
    ];
    warnings.extend(energy_balance::growth_warning(growth));
    let lines = run.record.profiles.iter().enumerate();
    ErrorEstimates {
        summary: lists.concat(),
        rms: lines
            .map(|line| rms_error(line, evidence, growth))
            .collect(),
        method: describe(case, time, mesh),
        curves: evidence
            .into_iter()
            .flatten()
            .map(HistoryPair::of_evidence)
            .collect(),
        warnings,
    }
}

/// The statistics of a run, without errors; those that cannot be taken are left out.
fn statistics(run: &Computed) -> Vec<Quantity> {
    let channels = &run.record.history.channels;
    let quantity = |(wanted, number): &(RequestedStatistic, Option<f64>)| {
        let of = match wanted.of {
            StatisticSource::Channel(index) => Subject::Channel(channels.get(index)?.id.clone()),
            StatisticSource::Line(number, quantity) => {
                let line = run.record.profiles.get(number)?;
                Subject::along(quantity, &line.line)
            }
        };
        let id = QuantityId::new(of, wanted.statistic, wanted.window).numbered(wanted.nth);
        Some(Quantity::new(id, (*number)?))
    };
    run.record.statistics.iter().filter_map(quantity).collect()
}

/// Share of the largest number in the same unit below which a difference is rounding.
const ROUNDING: f64 = 1e-9;

/// What reads numbers from a computation.
type Numbers = fn(&Computed) -> Vec<Quantity>;

/// The same numbers of the runs that show an error.
struct EvidentNumbers<'a> {
    evidence: &'a Evidence<'a>,
    run: &'a [Quantity],
    near: [Vec<Quantity>; 2],
    far: Option<[Vec<Quantity>; 2]>,
    /// The quotient of differences that is usual among them.
    usual: f64,
}

impl<'a> EvidentNumbers<'a> {
    fn read(evidence: &'a Evidence<'a>, run: &'a [Quantity], of: Numbers) -> Self {
        let mut numbers = Self {
            evidence,
            run,
            near: evidence.near.map(of),
            far: evidence.far.map(|far| far.map(of)),
            usual: 0.0,
        };
        let ordered = run.iter().filter(|q| !counts_nodes(q));
        let differences = ordered.filter_map(|q| Some((q.value, numbers.differences(q)?)));
        numbers.usual = richardson::usual_quotient(differences);
        numbers
    }

    /// A number in the nearest pair.
    fn near(&self, q: &Quantity) -> Option<[f64; 2]> {
        pair(&self.near, q)
    }

    fn far(&self, q: &Quantity) -> Option<[f64; 2]> {
        pair(self.far.as_ref()?, q)
    }

    /// The differences of a number in the nearest pair and in the next, where both have it.
    fn differences(&self, q: &Quantity) -> Option<[f64; 2]> {
        Some([self.near_difference(q)?, self.far_difference(q)?])
    }

    fn near_difference(&self, q: &Quantity) -> Option<f64> {
        Some(difference(q, self.near(q)?, self.evidence.near))
    }

    fn far_difference(&self, q: &Quantity) -> Option<f64> {
        Some(difference(q, self.far(q)?, self.evidence.far?))
    }

    fn error(&self, q: &Quantity) -> Option<f64> {
        let near = self.off_floor(q, &self.near, self.evidence.near)?;
        let (far, runs) = (self.far.as_ref(), self.evidence.far);
        let far = far
            .zip(runs)
            .and_then(|(far, runs)| self.off_floor(q, far, runs));
        Some(match far {
            Some(far) => self.evidence.refinement.observed([near, far], self.usual),
            None => self.evidence.presumed(near),
        })
    }

    /// The difference of a number between two runs. Where it or one of them rests on a floor, as the tension of a slack line on zero however
    /// slack it is, that they agree says nothing: there the greatest difference of the same channel's other numbers counts as well.
    fn off_floor(
        &self,
        q: &Quantity,
        numbers: &[Vec<Quantity>; 2],
        runs: [&Computed; 2],
    ) -> Option<f64> {
        let between = |q: &Quantity| Some(difference(q, pair(numbers, q)?, runs));
        let own = between(q)?;
        if !rests_at_zero(q) || !(q.value == 0.0 || pair(numbers, q)?.contains(&0.0)) {
            return Some(own);
        }
        let of_channel = self.run.iter().filter(|other| is_of_same_channel(q, other));
        Some(of_channel.filter_map(between).fold(own, f64::max))
    }

    /// The values of the companions where they do not approach each other by more than rounding.
    fn unsettled(&self, q: &Quantity) -> Option<[f64; 4]> {
        let differences = self.differences(q)?;
        if !richardson::is_unsettled(q.value, differences) {
            return None;
        }
        let unit = q.unit();
        let same_unit = self.run.iter().filter(|other| other.unit() == unit);
        let largest = same_unit.map(|other| other.value.abs()).fold(0.0, f64::max);
        if differences[0] <= ROUNDING * largest {
            return None;
        }
        let ([a, b], [c, d]) = (self.near(q)?, self.far(q)?);
        Some([a, b, c, d])
    }
}

/// A number in both runs of a pair, where both have it.
fn pair([fine, coarse]: &[Vec<Quantity>; 2], q: &Quantity) -> Option<[f64; 2]> {
    Some([value(fine, &q.id)?, value(coarse, &q.id)?])
}

fn value(list: &[Quantity], id: &QuantityId) -> Option<f64> {
    list.iter().find(|q| q.id == *id).map(|q| q.value)
}

/// Difference of a number between two runs; of the last value of a channel the root of the mean square with those shortly before: of a
/// channel that swings the last ones alone may agree by chance.
fn difference(q: &Quantity, [fine, coarse]: [f64; 2], runs: [&Computed; 2]) -> f64 {
    let last = (fine - coarse).abs();
    let Some(id) = last_value_of(&q.id) else {
        return last;
    };
    let [fine, coarse] = runs.map(|run| &run.record);
    let mut channels = fine.history.channels.iter();
    let Some(number) = channels.position(|channel| channel.id == *id) else {
        return last;
    };
    let (mut sum, mut count) = (last * last, 1.0);
    for difference in fine.late.differences(&coarse.late, number) {
        sum += difference * difference;
        count += 1.0;
    }
    f64::sqrt(sum / count)
}

/// The channel that a number is the last value of.
fn last_value_of(id: &QuantityId) -> Option<&ChannelId> {
    match id {
        QuantityId::Statistic {
            of: Subject::Channel(channel),
            statistic: Statistic::Final,
            within: None,
            ..
        } => Some(channel),
        _ => None,
    }
}

/// The numbers of a run with their errors, by the same numbers of the runs that show them; those in time `growth` times what those show.
fn with_errors(
    evidence: [Option<&Evidence<'_>>; 2],
    growth: f64,
    run: &Computed,
    of: Numbers,
) -> Vec<Quantity> {
    let own = of(run);
    let numbers = evidence.map(|by| Some(EvidentNumbers::read(by?, &own, of)));
    let [time, mesh] = &numbers;
    let mut list = own.clone();
    for q in &mut list {
        q.time_error = time.as_ref().and_then(|time| Some(growth * time.error(q)?));
        q.mesh_error = mesh.as_ref().and_then(|mesh| mesh.error(q));
        let unsettled = |by: &Option<EvidentNumbers<'_>>| by.as_ref()?.unsettled(q);
        let others = [unsettled(time), unsettled(mesh)];
        let others: Vec<f64> = others.into_iter().flatten().flatten().collect();
        q.unsettled = unsettled_range(q, &others, run);
    }
    list
}

/// A place along the line has at least the mesh error of a segment, and the tension of a line that goes slack between nodes that of
/// its weight.
fn limit_resolution(list: &mut [Quantity], case: &dyn Refinable, run: &Computed) {
    for quantity in list {
        let mut least = 0.0;
        if let QuantityId::Statistic { of, statistic, .. } = &quantity.id {
            let line = of.line_quantity().map_or("", |(_, line)| line);
            let profile = run.record.profiles.iter().find(|p| p.line == line);
            least = profile.map_or(0.0, |p| line_statistics::resolution(p, *statistic));
            if of.counts_nodes() {
                let lines = run.record.profiles.iter();
                least = lines
                    .map(line_statistics::longest_segment)
                    .fold(least, f64::max);
            }
            if quantity.value == 0.0 && is_least_tension(&quantity.id) {
                least = case.segment_weight(line_of(of));
            }
        }
        let floor = case.least_error(quantity);
        let shown = quantity.mesh_error.map(|error| error.max(least));
        quantity.mesh_error = match (shown, floor) {
            (Some(shown), Some(floor)) => Some(shown.max(floor)),
            (shown, floor) => shown.or(floor),
        };
    }
}

/// Errors of the root mean square displacements of a line by its number: sums of the differences in the nearest pairs, each times its
/// factor.
fn rms_error(
    (line, profile): (usize, &Profile),
    evidence: [Option<&Evidence<'_>>; 2],
    growth: f64,
) -> Vec<f64> {
    let recorded = |evidence: &&Evidence<'_>| {
        let mut profiles = evidence
            .near
            .iter()
            .map(|run| run.record.profiles.get(line));
        profiles
            .all(|profile| profile.is_some_and(|p| p.rms.len() == p.arc.len() && p.arc.len() > 1))
    };
    let evidence = evidence.into_iter().zip([growth, 1.0]);
    let evidence = evidence.filter_map(|(by, growth)| Some((by.filter(recorded)?, growth)));
    let evidence: Vec<_> = evidence.collect();
    if evidence.is_empty() {
        return Vec::new();
    }
    let error = |s: &f64| {
        let each = evidence.iter().map(|(by, growth)| {
            let [fine, coarse] = by.near.map(|run| {
                let profile = &run.record.profiles[line];
                linear_clamped(&profile.arc, &profile.rms, *s)
            });
            growth * by.presumed((fine - coarse).abs())
        });
        each.sum()
    };
    profile.arc.iter().map(error).collect()
}

/// Whether zero is a floor of a number: see [`ChannelQuantity::rests_at_zero`].
fn rests_at_zero(q: &Quantity) -> bool {
    let QuantityId::Statistic { of, statistic, .. } = &q.id else {
        return false;
    };
    let is_value = matches!(
        statistic,
        Statistic::Min | Statistic::Max | Statistic::Final
    );
    is_value
        && match of {
            Subject::Channel(channel) => {
                let last = *statistic == Statistic::Final;
                channel.quantity.rests_at_zero(last)
            }
            Subject::Line(quantity) | Subject::Along(quantity, _) => {
                *quantity == LineQuantity::Tension
            }
            _ => false,
        }
}

/// Whether two numbers are values of the same channel, or along the same line: not times, rates or counts of one of them.
fn is_of_same_channel(one: &Quantity, other: &Quantity) -> bool {
    match (&one.id, &other.id) {
        (QuantityId::Statistic { of: a, .. }, QuantityId::Statistic { of: b, .. }) => {
            a == b && one.unit() == other.unit()
        }
        _ => false,
    }
}

/// The line that a number is of, by its name: of a channel of a system by that of its place, `north|a`; empty of a line by itself.
fn line_of(of: &Subject) -> &str {
    match of {
        Subject::Channel(channel) => channel.place.split('|').next().unwrap_or_default(),
        _ => of.line_quantity().map_or("", |(_, line)| line),
    }
}

/// Whether it is the least tension somewhere or on the whole line.
fn is_least_tension(id: &QuantityId) -> bool {
    let QuantityId::Statistic { of, statistic, .. } = id else {
        return false;
    };
    let is_tension = match of {
        Subject::Channel(channel) => channel.quantity == ChannelQuantity::Tension,
        Subject::Line(quantity) | Subject::Along(quantity, _) => *quantity == LineQuantity::Tension,
        _ => false,
    };
    is_tension && *statistic == Statistic::Min
}

/// How the errors are estimated, in words.
fn describe(
    case: &dyn Refinable,
    time: Option<&Evidence<'_>>,
    mesh: Option<&Evidence<'_>>,
) -> String {
    let order = |evidence: &Evidence<'_>| {
        if evidence.far.is_some() {
            return format!("{OBSERVED} to {UNLIKE} times Richardson by the order observed");
        }
        let order = evidence.refinement.order;
        format!("{PRESUMED} times Richardson, order {order}")
    };
    let time = time.map(|time| format!("time: {}, {}; ", steps(case, time), order(time)));
    let mesh = mesh.map(|mesh| {
        let segments = match (mesh.is_finer, mesh.far.is_some()) {
            (true, _) => "twice the segments",
            (false, true) => "half the segments and a quarter",
            (false, false) => "half the segments",
        };
        let steps = if mesh.is_elsewhere {
            " in longer steps"
        } else {
            ""
        };
        format!(
            "mesh: {segments}{steps} (ratio {:.2}), {}",
            mesh.refinement.ratio,
            order(mesh)
        )
    });
    let crisis = if case.has_crisis() {
        "; no order above 1.5, since a drag coefficient jumps"
    } else {
        ""
    };
    format!(
        "{}{}{crisis}",
        time.unwrap_or_default(),
        mesh.unwrap_or_default()
    )
}

/// By which steps the error in time is told, in words.
fn steps(case: &dyn Refinable, time: &Evidence<'_>) -> String {
    let varies = case.varies_steps();
    let [near, far] = time.ratios;
    let of = |ratio: f64| match varies {
        true => format!("{} times the error allowed in a step", ratio.powi(3)),
        false => format!("steps {ratio} times as long"),
    };
    let place = match time.segment {
        1.0 => "",
        2.0 => " on half the segments",
        _ => " on a quarter of the segments",
    };
    match (time.is_single_step(), time.far.is_some()) {
        (true, _) if varies => "another error allowed in a step".to_owned(),
        (true, _) => "half the step".to_owned(),
        (false, false) => format!("{}{place}", of(near)),
        (false, true) => format!("{}, and {}{place}", of(near), of(far)),
    }
}
