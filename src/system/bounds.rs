//! Bed and surface as bounds on heights: a free point rests on the bed or floats at the surface, a free body rests on the bed.

use nalgebra::DVector;

use super::freedoms::{Freedoms, Placement};
use super::network::{Held, Network};

/// The bounds of each unknown \[m\]; infinite for all but heights.
#[derive(Debug, Clone)]
pub struct Bounds {
    least: Vec<f64>,
    most: Vec<f64>,
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
}

impl Bounds {
    /// The bounds of a system.
    #[must_use]
    pub fn of(network: &Network, freedoms: &Freedoms) -> Self {
        let mut bounds = Self {
            least: vec![f64::NEG_INFINITY; freedoms.count],
            most: vec![f64::INFINITY; freedoms.count],
        };
        for (point, first) in network.points.iter().zip(&freedoms.points) {
            if let (Held::Free(_), Some(first)) = (&point.held, first) {
                bounds.least[first + 2] = network.bed_z.unwrap_or(f64::NEG_INFINITY);
                if network.density > 0.0 {
                    bounds.most[first + 2] = 0.0;
                }
            }
        }
        for (body, first) in network.bodies.iter().zip(&freedoms.bodies) {
            if let (Some(first), Some(bed), Some(bottom)) = (first, network.bed_z, body.bottom) {
                bounds.least[first + 2] = bed + bottom;
            }
        }
        bounds
    }

    /// Moves free points and bodies within the bounds.
    pub fn keep(&self, network: &Network, freedoms: &Freedoms, placement: &mut Placement) {
        for (place, first) in placement.points.iter_mut().zip(&freedoms.points) {
            if let Some(first) = first {
                place.z = self.within(first + 2, place.z);
            }
        }
        for (pose, first) in placement.bodies.iter_mut().zip(&freedoms.bodies) {
            if let Some(first) = first {
                pose.origin.z = self.within(first + 2, pose.origin.z);
            }
        }
        placement.carry(network);
    }

    fn within(&self, unknown: usize, z: f64) -> f64 {
        z.max(self.least[unknown]).min(self.most[unknown])
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
        let points = placement.points.iter().map(|place| place.z);
        let bodies = placement.bodies.iter().map(|pose| pose.origin.z);
        let heights = points
            .zip(&freedoms.points)
            .chain(bodies.zip(&freedoms.bodies));
        for (z, first) in heights {
            let Some(unknown) = first.map(|first| first + 2) else {
                continue;
            };
            if z <= self.least[unknown] && force[unknown] < 0.0 {
                contacts[unknown] = Contact::Bed;
            } else if z >= self.most[unknown] && force[unknown] > 0.0 {
                contacts[unknown] = Contact::Surface;
            }
        }
        contacts
    }
}
