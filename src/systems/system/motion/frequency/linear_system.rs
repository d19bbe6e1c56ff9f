//! The linear system of one frequency: complex bands of the lines, condensed onto the joints.

use nalgebra::{Matrix3, Matrix6, Vector6};

use super::super::joint_place::Place;
use super::super::line_ends::LineEnds;
use super::spread::damped_axes;
use super::{Amplitude, Complex};
use crate::numerics::{
    Banded, BlockBand, BlockEnvelope, Condensation, CondensedBeside, M3, SingularBlock,
};
use crate::solve::Factors;
use crate::system::motion::body_equation::rotation_jacobian;
use crate::system::motion::border::Border;
use crate::system::motion::joints::Follows;
use crate::system::motion::moving_system::MovingSystem;
use crate::system::motion::system_state::SystemState;
use crate::system::pose::cross;

/// Tangents by one of acceleration, velocity and position.
#[derive(Debug, Clone)]
pub(super) struct FrequencyTangents {
    /// The bands of the lines.
    pub(super) lines: Vec<BlockBand>,
    /// The matrix of the joints, lines apart.
    pub(super) joints: BlockEnvelope,
}

/// Complex amplitudes of displacements, or of loads: of the nodes of the lines, and of the joints or their rows.
#[derive(Debug, Clone, Default)]
pub(super) struct Amplitudes {
    /// Of the nodes of each line.
    pub(super) lines: Vec<Vec<Amplitude>>,
    /// Of the joints, or of the rows of the unknowns among them.
    pub(super) joints: Vec<Amplitude>,
}

/// The matrices of a system about its mean position, with storage for solving.
pub(super) struct LinearSystem<'a> {
    pub(super) system: &'a MovingSystem,
    pub(super) mean: &'a SystemState,
    /// By acceleration, velocity and position; the second is set anew as the drag is found.
    pub(super) mass: FrequencyTangents,
    pub(super) damping: FrequencyTangents,
    pub(super) stiffness: FrequencyTangents,
    ends: Vec<LineEnds>,
    condensations: Vec<Condensation<Complex>>,
    matrix: BlockEnvelope<Complex>,
    rows: Vec<Amplitude>,
    radiators: Vec<Radiator>,
}

/// A body that radiates waves.
struct Radiator {
    flow: usize,
    /// Rows of its origin and rotation.
    rows: [usize; 2],
    /// From the rates of the unknowns to the velocities that its damping acts on.
    axes: Matrix6<f64>,
}

/// The band of a line at a frequency, by its parts and their factors.
struct DynamicBand<'a> {
    parts: [&'a BlockBand; 3],
    factors: [Complex; 3],
}

impl Banded<Complex> for DynamicBand<'_> {
    fn nodes(&self) -> usize {
        self.parts[0].diag.len()
    }

    fn is_wide(&self) -> bool {
        self.parts[0].is_wide()
    }

    #[inline(always)]
    fn coupling(&self, i: usize, j: usize) -> Matrix3<Complex> {
        let [mass, damping, stiffness] = self.parts.map(|part| part.coupling(i, j));
        let [by_mass, by_damping, by_stiffness] = self.factors;
        Matrix3::from_fn(|r, c| {
            by_mass * mass[(r, c)] + by_damping * damping[(r, c)] + by_stiffness * stiffness[(r, c)]
        })
    }
}

/// What weights mass, damping and stiffness at a frequency \[rad/s\].
fn factors(omega: f64) -> [Complex; 3] {
    [
        Complex::from(-omega * omega),
        Complex::new(0.0, omega),
        Complex::from(1.0),
    ]
}

/// A block or vector as complex numbers.
fn complex(block: &M3) -> Matrix3<Complex> {
    block.map(Complex::from)
}

impl FrequencyTangents {
    /// By these factors at a state.
    pub(super) fn at_state(
        border: &mut Border,
        system: &MovingSystem,
        state: &SystemState,
        c: Factors,
    ) -> Self {
        let found = border.linearise(system, 0.0, state, c);
        Self {
            lines: found.tangents.to_vec(),
            joints: found.matrix.clone(),
        }
    }
}

impl<'a> LinearSystem<'a> {
    /// About a mean position.
    pub(super) fn new(
        border: &mut Border,
        system: &'a MovingSystem,
        mean: &'a SystemState,
    ) -> Self {
        let c = |mass: f64, damping: f64, stiffness: f64| Factors {
            mass,
            damping,
            stiffness,
        };
        let lines = 0..mean.lines.len();
        let ends: Vec<LineEnds> = lines
            .map(|line| LineEnds::of_line(system, mean, line))
            .collect();
        let condensations = mean.lines.iter().zip(&ends).map(|(line, ends)| {
            let plain = Condensation::new(line.x.len());
            match ends.turn() {
                true => plain.with_sides(),
                false => plain,
            }
        });
        Self {
            mass: FrequencyTangents::at_state(border, system, mean, c(1.0, 0.0, 0.0)),
            damping: FrequencyTangents::at_state(border, system, mean, c(0.0, 1.0, 0.0)),
            stiffness: FrequencyTangents::at_state(border, system, mean, c(0.0, 0.0, 1.0)),
            condensations: condensations.collect(),
            ends,
            matrix: BlockEnvelope::new(system.joints.envelope.clone()),
            rows: vec![Amplitude::zeros(); system.joints.envelope.len()],
            radiators: radiators(system, mean),
            system,
            mean,
        }
    }

    /// Added mass beyond that at infinite frequency and damping of the radiated waves at a frequency \[rad/s\], by the rates of the unknowns,
    /// of each body that radiates.
    pub(super) fn radiation(&self, omega: f64) -> Vec<Matrix6<Complex>> {
        let of = |radiator: &Radiator| {
            let flow = &self.system.flows[radiator.flow];
            let Some(retardation) = &flow.retardation else {
                return Matrix6::zeros();
            };
            let (added, damping) = retardation.transformed_back(omega);
            let added = added - retardation.at_infinity;
            let [added, damping] =
                [added, damping].map(|part| radiator.axes.transpose() * part * radiator.axes);
            added.zip_map(&damping, |a, b| Complex::new(-omega * omega * a, omega * b))
        };
        self.radiators.iter().map(of).collect()
    }

    /// The displacements under loads of a frequency \[rad/s\], besides those of the joints that are prescribed, in `given`.
    ///
    /// # Errors
    /// A resonance without damping, or nothing that holds a node: the line, or the number of lines for the joints, with the node.
    pub(super) fn solve(
        &mut self,
        (omega, radiation): (f64, &[Matrix6<Complex>]),
        loads: &Amplitudes,
        given: Option<&[Amplitude]>,
    ) -> Result<Amplitudes, (usize, SingularBlock)> {
        let factors = factors(omega);
        self.matrix.set_to_sum(&[
            (factors[0], &self.mass.joints),
            (factors[1], &self.damping.joints),
            (factors[2], &self.stiffness.joints),
        ]);
        self.rows.copy_from_slice(&loads.joints);
        self.radiate(radiation);
        for line in 0..self.ends.len() {
            let band = DynamicBand {
                parts: [&self.mass, &self.damping, &self.stiffness].map(|part| &part.lines[line]),
                factors,
            };
            let couplings = self.ends[line].couplings(1.0);
            let couplings =
                couplings.map(|both| both.map(|coupling| coupling.as_ref().map(complex)));
            let (loads, condensation) = (&loads.lines[line], &mut self.condensations[line]);
            let condensed = condensation.condense_beside(&band, loads, couplings.as_ref());
            let condensed = condensed.map_err(|singular| (line, singular))?;
            self.join(line, &condensed);
        }
        let lines = self.ends.len();
        self.matrix
            .solve(&mut self.rows)
            .map_err(|singular| (lines, singular))?;
        Ok(self.back(given))
    }

    /// Adds loads on the bodies in the earth's directions.
    pub(super) fn add_body_loads(&self, bodies: &[Vector6<Complex>], loads: &mut Amplitudes) {
        for (body, load) in bodies.iter().enumerate() {
            add_body_load((self.system, self.mean), body, load, loads);
        }
    }

    /// Adds the radiated waves.
    fn radiate(&mut self, radiation: &[Matrix6<Complex>]) {
        for (radiator, matrix) in self.radiators.iter().zip(radiation) {
            for (r, row) in radiator.rows.into_iter().enumerate() {
                for (c, column) in radiator.rows.into_iter().enumerate() {
                    *self.matrix.block(row, column) += matrix.fixed_view::<3, 3>(3 * r, 3 * c);
                }
            }
        }
    }

    /// Adds a condensed line to the rows of its ends and clamps.
    fn join(&mut self, line: usize, condensed: &CondensedBeside<Complex>) {
        let CondensedBeside { blocks, left } = condensed;
        for (i, on) in self.ends[line].places() {
            for (row, lever) in on.parts() {
                let lever = lever.map(|lever| complex(&lever).transpose());
                self.rows[*row] += lever.map_or(left[i], |lever| lever * left[i]);
                for (j, by) in self.ends[line].places() {
                    for (column, moved) in by.parts() {
                        let mut block = blocks[i][j];
                        if let Some(lever) = lever {
                            block = lever * block;
                        }
                        if let Some(moved) = moved {
                            block *= complex(moved);
                        }
                        *self.matrix.block(*row, *column) += block;
                    }
                }
            }
        }
    }

    /// From the rows of the unknowns to all nodes and joints.
    fn back(&self, given: Option<&[Amplitude]>) -> Amplitudes {
        let joints = 0..self.system.joints.roles.len();
        let joints: Vec<Amplitude> = joints.map(|joint| self.joint(joint, given)).collect();
        let lines = self.ends.iter().enumerate().map(|(line, ends)| {
            let nodes = self.mean.lines[line].x.len();
            let mut x = vec![Amplitude::zeros(); nodes];
            let mut moved = [Amplitude::zeros(); 4];
            for (k, place) in ends.places() {
                moved[k] = self.moved(place);
            }
            (x[0], x[nodes - 1]) = (moved[0], moved[1]);
            let turned = ends.turn().then_some([moved[2], moved[3]]);
            self.condensations[line].respond_beside(&mut x, turned.as_ref());
            // What is prescribed of the ends is in the loads of the other nodes already.
            for (node, joint) in [0, nodes - 1].into_iter().zip(self.mean.attached[line]) {
                x[node] = joints[joint];
            }
            x
        });
        Amplitudes {
            lines: lines.collect(),
            joints,
        }
    }

    /// The displacement of a place by the unknowns alone.
    fn moved(&self, place: &Place) -> Amplitude {
        let parts = place.parts().iter();
        parts
            .map(|(row, by)| match by {
                Some(by) => complex(by) * self.rows[*row],
                None => self.rows[*row],
            })
            .sum()
    }

    /// The displacement of a joint; of a place on a body that turns by its origin and rotation.
    fn joint(&self, joint: usize, given: Option<&[Amplitude]>) -> Amplitude {
        let joints = &self.system.joints;
        match joints.follows(joint) {
            Follows::Row(row) => self.rows[row],
            Follows::Nothing => given.map_or_else(Amplitude::zeros, |given| given[joint]),
            Follows::Body(body, at) => {
                let motion = self.system.body(self.mean, body);
                let rotation = joints.rotations[body];
                let turned =
                    rotation_jacobian(&motion.pose.rotation, &self.mean.joints.x[rotation]);
                let by_turn = cross(&motion.pose.arm(&at)) * turned;
                self.joint(joints.bodies[body], given)
                    - complex(&by_turn) * self.joint(rotation, given)
            }
        }
    }
}

/// Adds a load on a body in the earth's directions \[N, N m\].
pub(super) fn add_body_load(
    (system, mean): (&MovingSystem, &SystemState),
    body: usize,
    load: &Vector6<Complex>,
    loads: &mut Amplitudes,
) {
    let joints = &system.joints;
    let (origin, rotation) = (joints.bodies[body], joints.rotations[body]);
    if let Some(row) = joints.row(origin) {
        loads.joints[row] += load.fixed_rows::<3>(0);
    }
    if let Some(row) = joints.row(rotation) {
        let pose = system.body(mean, body).pose;
        let along = rotation_jacobian(&pose.rotation, &mean.joints.x[rotation]).transpose();
        loads.joints[row] += complex(&along) * load.fixed_rows::<3>(3);
    }
}

/// The bodies that radiate waves, with the axes of their damping.
fn radiators(system: &MovingSystem, mean: &SystemState) -> Vec<Radiator> {
    let flows = system.flows.iter().enumerate();
    let radiating = flows.filter(|(_, flow)| flow.retardation.is_some());
    let found = radiating.filter_map(|(number, flow)| {
        let joints = [
            system.joints.bodies[flow.body],
            system.joints.rotations[flow.body],
        ];
        let rows = [system.joints.row(joints[0])?, system.joints.row(joints[1])?];
        let axes = damped_axes(system, mean, flow.body);
        Some(Radiator {
            flow: number,
            rows,
            axes,
        })
    });
    found.collect()
}
