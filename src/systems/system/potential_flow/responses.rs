//! Loads of the first order on a free body by its responses, those of the body without lines.
//!
//! A body that responds to a wave of unit amplitude by `u(omega)` feels
//!
//! ```text
//! X = (-omega^2 (M + A) + i omega B + C) u
//! ```
//!
//! eq. (4) of the ropeway paper (Military Transportation Institute and Tianjin University, about 2016) without its mooring: M the
//! mass, A and B added mass and damping, C the hydrostatic stiffness at the pose given. Quadratic damping and drag are left out.

use std::f64::consts::TAU;

use nalgebra::{Complex, Matrix6, Vector6};

use super::super::line_physics::LinePhysics;
use super::{ExcitationTable, RadiationTable};
use crate::numerics::V3;
use crate::numerics::interpolation::{interval, share};
use crate::physics::sea::{Rao, Sea};
use crate::scene::rao_file::{self, HeadingRao};
use crate::system::body_loads::body_loads;
use crate::system::motion::body_equation::MovingBody;
use crate::system::network::{Body, Network};

/// Directions that count as one \[rad\].
const SAME: f64 = 1e-9;

/// The loads in the waves of a sea, at their directions and frequencies; nothing where the responses do not cover a direction.
pub(in crate::system) fn excitation(
    (network, body): (&Network, &Body),
    raos: &[HeadingRao],
    radiation: Option<&RadiationTable>,
    sea: &Sea,
) -> Option<ExcitationTable> {
    let floating = Floating::new(network, body, radiation);
    let yaw = body.pose.angles()[2];
    let mut headings: Vec<f64> = Vec::new();
    let mut omega: Vec<f64> = Vec::new();
    for field in sea.fields() {
        headings.push((field.direction() - yaw).rem_euclid(TAU));
        omega.extend(field.at_point(&V3::zeros()).iter().map(|wave| wave.omega));
    }
    headings.sort_by(f64::total_cmp);
    headings.dedup_by(|next, kept| *next - *kept < SAME);
    omega.sort_by(f64::total_cmp);
    omega.dedup();
    let at_heading = |heading: &f64| {
        let rao = rao_file::at_angle(raos, *heading, "").ok()?;
        Some(omega.iter().map(|w| floating.load(&rao, *w)).collect())
    };
    let values: Option<Vec<_>> = headings.iter().map(at_heading).collect();
    Some(ExcitationTable::new(headings, omega.clone(), values?))
}

/// A body afloat without lines, about its origin and along its axes.
struct Floating<'a> {
    /// Mass, with added mass where that does not depend on the frequency.
    mass: Matrix6<f64>,
    damping: Matrix6<f64>,
    stiffness: Matrix6<f64>,
    radiation: Option<&'a RadiationTable>,
}

impl<'a> Floating<'a> {
    fn new(network: &Network, body: &Body, radiation: Option<&'a RadiationTable>) -> Self {
        // Upright as it is given but for its heading: its axes are those of the loads.
        let mut pose = body.pose;
        let [roll, pitch, _] = pose.angles();
        pose.rotation = nalgebra::UnitQuaternion::from_euler_angles(roll, pitch, 0.0);
        let alone = Network {
            gravity: network.gravity,
            density: network.density,
            bodies: vec![Body {
                pose,
                added_mass: match radiation {
                    Some(_) => Matrix6::zeros(),
                    None => body.added_mass,
                },
                ..body.clone()
            }],
            ..Network::default()
        };
        let (_, stiffness) = body_loads(&alone, &alone.bodies[0], &pose, LinePhysics::Plain);
        Self {
            mass: MovingBody::new(&alone, 0, &pose).mass,
            damping: body.damping,
            stiffness,
            radiation,
        }
    }

    /// The load of a wave of unit amplitude.
    fn load(&self, rao: &Rao, omega: f64) -> Vector6<Complex<f64>> {
        let (mut mass, mut damping) = (self.mass, self.damping);
        if let Some(table) = self.radiation {
            let (added, radiated) = table.at(omega);
            mass += added;
            damping += radiated;
        }
        let real = self.stiffness - mass * (omega * omega);
        let imaginary = damping * omega;
        let response = rao.response(omega);
        Vector6::from_fn(|i, _| {
            let row = |j: usize| Complex::new(real[(i, j)], imaginary[(i, j)]) * response[j];
            (0..6).map(row).sum()
        })
    }
}

impl RadiationTable {
    /// Added mass and damping at a frequency \[rad/s\], linear between those of the table and held beyond.
    #[must_use]
    pub fn at(&self, omega: f64) -> (Matrix6<f64>, Matrix6<f64>) {
        let last = self.omega.len() - 1;
        if omega <= self.omega[0] || last == 0 {
            return (self.added[0], self.damping[0]);
        }
        if omega >= self.omega[last] {
            return (self.added[last], self.damping[last]);
        }
        let i = interval(&self.omega, omega);
        let part = share(&self.omega, i, omega);
        let mixed = |all: &[Matrix6<f64>]| all[i] + (all[i + 1] - all[i]) * part;
        (mixed(&self.added), mixed(&self.damping))
    }
}
