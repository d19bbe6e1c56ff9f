//! A system at rest that is computed again on other meshes, to tell its errors by.

use std::sync::atomic::AtomicBool;

use super::system_at_rest::SystemAtRest;
use crate::case::{ChannelQuantity, QuantityId, Subject};
use crate::run::Quantity;
use crate::run::accuracy::searchable::Searchable;
use crate::run::companions::CompanionRefinement;
use crate::run::computation::Computation;
use crate::run::compute::Computed;
use crate::run::refinable::Refinable;
use crate::system::discretised::segments;
use crate::system::errors_at_rest::ErrorsAtRest;
use crate::system::{SolvedSystem, quantities};

/// A system at rest with where it rests.
pub(super) struct RefinableRest<'a> {
    of: &'a SystemAtRest,
    solved: &'a SolvedSystem,
    rounding: ErrorsAtRest,
}

impl<'a> RefinableRest<'a> {
    /// One that was computed; nothing before.
    pub(super) fn new(of: &'a SystemAtRest) -> Option<Self> {
        let solved = of.found()?;
        let rounding = ErrorsAtRest::by_rounding(&solved.network, &solved.rest);
        Some(Self {
            of,
            solved,
            rounding,
        })
    }

    /// The same with segments so many times as long.
    fn on_mesh(&self, segment: f64) -> SystemAtRest {
        let own = self.of.segments().into_iter();
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "a count of segments, bounded by the file"
        )]
        let divided = own.map(|own| (own as f64 / segment).ceil() as usize);
        let divided: Vec<usize> = divided.collect();
        // The segments of a line are any number of them.
        (self.of.with_segments(&divided)).unwrap_or_else(|_| self.of.clone())
    }
}

impl Refinable for RefinableRest<'_> {
    fn companion(&self, place: CompanionRefinement, cancel: &AtomicBool) -> Computed {
        self.on_mesh(place.segment).compute(None, cancel, None)
    }

    fn method_order(&self) -> Option<f64> {
        None
    }

    fn has_crisis(&self) -> bool {
        let lines = self.solved.network.lines.iter();
        let mut divided = lines.filter_map(|line| line.discretised.as_ref());
        divided.any(|line| line.case().has_crisis())
    }

    fn is_explicit(&self) -> bool {
        false
    }

    fn varies_steps(&self) -> bool {
        false
    }

    fn segments(&self, coarsening: usize) -> usize {
        let system = self.on_mesh(coarsening as f64);
        let meshed = system
            .meshed()
            .map(|(_, line)| segments(&system.file, line) * line.repeat_at_deg.len().max(1));
        meshed.sum()
    }

    fn has_single_segment(&self) -> bool {
        self.of.segments().contains(&1)
    }

    fn named(&self) -> Option<&[String]> {
        self.of.companions.as_deref()
    }

    fn segment_weight(&self, name: &str) -> f64 {
        let lines = &self.solved.network.lines;
        let line = lines.iter().find(|line| line.name == name);
        let case = line.and_then(|line| line.discretised.as_ref());
        case.map_or(0.0, |line| line.case().segment_weight(name))
    }

    /// Of closed forms the rounding; of a length on the bed half a segment.
    fn least_error(&self, q: &Quantity) -> Option<f64> {
        let QuantityId::Statistic {
            of: Subject::Channel(channel),
            ..
        } = &q.id
        else {
            return None;
        };
        let network = &self.solved.network;
        if channel.quantity == ChannelQuantity::OnBed {
            let line = network.line(&channel.place)?;
            return Some(quantities::bed_resolution(self.solved, line));
        }
        if channel.quantity == ChannelQuantity::Tension {
            let line = channel.place.split('|').next()?;
            return self.rounding.lines[network.line(line)?];
        }
        let turn = ChannelQuantity::ANGLES.contains(&channel.quantity);
        if let Some(body) = network.body(&channel.place) {
            let [place, angle] = self.rounding.bodies[body]?;
            return Some(if turn { angle.to_degrees() } else { place });
        }
        self.rounding.points[network.point(&channel.place)?]
    }
}
