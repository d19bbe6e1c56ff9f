//! Bed and surface as bounds on heights: a free point rests on the bed or floats at the surface, a free body rests on the bed. Where the bed
//! slopes, what lies on it moves along it ([`along_bed`](super::along_bed)). The origin of a body that is pinned has no way to go at all.

use std::collections::HashSet;

use nalgebra::DVector;

use super::bed::Bed;
use super::freedoms::{Freedoms, Placement};
use super::network::{Held, Network};
use crate::numerics::V3;

/// What bounds each unknown: nothing but heights and pins.
#[derive(Debug, Clone)]
pub struct Bounds {
    bed: Option<Bed>,
    /// How far below the unknown is what bears on the bed \[m\]; nothing where nothing does.
    below: Vec<Option<f64>>,
    /// Greatest height \[m\].
    most: Vec<f64>,
    /// First unknowns of the bodies that are pinned.
    pins: Vec<usize>,
}

/// The points at ends of lines that float.
fn ends_of_floating_lines(network: &Network) -> HashSet<usize> {
    let floating = network.lines.iter().filter(|line| line.is_buoyant());
    floating.flat_map(|line| [line.from, line.to]).collect()
}

/// What bears on an unknown.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Contact {
    /// Nothing.
    None,
    /// The bed, from below.
    Bed,
    /// The surface: part of the body is out of the water.
    Surface,
    /// A pin: the origin of the body does not move.
    Pin,
}

impl Bounds {
    /// The bounds of a system.
    #[must_use]
    pub fn of_network(network: &Network, freedoms: &Freedoms) -> Self {
        let mut bounds = Self {
            bed: network.bed.clone(),
            below: vec![None; freedoms.count],
            most: vec![f64::INFINITY; freedoms.count],
            pins: Vec::new(),
        };
        let floating = ends_of_floating_lines(network);
        for (number, (point, first)) in network.points.iter().zip(&freedoms.points).enumerate() {
            if let (Held::Free(free), Some(first)) = (&point.held, first) {
                // With an area it sinks into the bed.
                bounds.below[first + 2] = Some(free.below).filter(|_| free.bearing.is_none());
                let bounded = network.density > 0.0 && !network.crossed && !free.always_wet;
                // By its own buoyancy, or at an end of a line that floats, it comes to rest at the surface. Through any other the
                // surface has nothing to do, as for any place within a line.
                if bounded && (free.buoyancy > 0.0 || floating.contains(&number)) {
                    bounds.most[first + 2] = 0.0;
                }
            }
        }
        for (body, first) in network.bodies.iter().zip(&freedoms.bodies) {
            let Some(first) = first else { continue };
            match body.pinned {
                true => bounds.pins.push(*first),
                false => bounds.below[first + 2] = body.bottom,
            }
        }
        bounds
    }

    /// Moves free points and bodies within the bounds.
    pub fn keep(&self, network: &Network, freedoms: &Freedoms, placement: &mut Placement) {
        for (place, first) in placement.points.iter_mut().zip(&freedoms.points) {
            if let Some(first) = first {
                place.z = self.within(first + 2, place);
            }
        }
        for (pose, first) in placement.bodies.iter_mut().zip(&freedoms.bodies) {
            if let Some(first) = first {
                pose.origin.z = self.within(first + 2, &pose.origin);
            }
        }
        placement.carry(network);
    }

    /// Least height of an unknown at a place \[m\].
    fn least(&self, unknown: usize, place: &V3) -> f64 {
        let bears = self.bed.as_ref().zip(self.below[unknown]);
        bears.map_or(f64::NEG_INFINITY, |(bed, below)| bed.z_below(place) + below)
    }

    fn within(&self, unknown: usize, place: &V3) -> f64 {
        place
            .z
            .max(self.least(unknown, place))
            .min(self.most[unknown])
    }

    /// Whether a force presses what is at a place onto the bed: against its normal.
    fn onto_bed(&self, place: &V3, force: [f64; 3]) -> bool {
        let gradient = self.bed.as_ref().map(|bed| bed.gradient(place));
        gradient.is_some_and(|gradient| gradient.dot(&V3::from(force)) < 0.0)
    }

    /// Lets what lies on the bed follow it after a step, where it is not level.
    pub fn follow_bed(&self, freedoms: &Freedoms, contacts: &[Contact], placement: &mut Placement) {
        if self.bed.as_ref().is_none_or(Bed::is_level) {
            return;
        }
        let points = placement.points.iter_mut().zip(&freedoms.points);
        let bodies = placement.bodies.iter_mut().map(|pose| &mut pose.origin);
        for (place, first) in points.chain(bodies.zip(&freedoms.bodies)) {
            let unknown = first.map(|first| first + 2);
            let lies = unknown.filter(|unknown| contacts.get(*unknown) == Some(&Contact::Bed));
            if let Some(unknown) = lies {
                place.z = self.least(unknown, place);
            }
        }
    }

    /// What bears on each unknown where the forces are these.
    #[must_use]
    pub fn contacts(
        &self,
        freedoms: &Freedoms,
        placement: &Placement,
        force: &DVector<f64>,
    ) -> Vec<Contact> {
        let mut contacts = vec![Contact::None; freedoms.count];
        let points = placement.points.iter().zip(&freedoms.points);
        let bodies = placement.bodies.iter().map(|pose| &pose.origin);
        for (place, first) in points.chain(bodies.zip(&freedoms.bodies)) {
            let Some(unknown) = first.map(|first| first + 2) else {
                continue;
            };
            let onto_bed = || self.onto_bed(place, [0, 1, 2].map(|k| force[unknown - 2 + k]));
            if place.z <= self.least(unknown, place) && onto_bed() {
                contacts[unknown] = Contact::Bed;
            } else if place.z >= self.most[unknown] && force[unknown] > 0.0 {
                contacts[unknown] = Contact::Surface;
            }
        }
        for first in &self.pins {
            contacts[*first..first + 3].fill(Contact::Pin);
        }
        contacts
    }
}
