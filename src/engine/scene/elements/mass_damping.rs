//! Damping of the line proportional to its mass (the mass part of Rayleigh's): `-alpha m v` on every node, v its velocity over ground.
//!
//! m has the halves of the segments that meet there, with floats and modules, and their normal added mass as if all of it were
//! wet, in every direction: a mode of frequency omega across a submerged line is damped by `alpha / (2 omega)` of critical.
//! Point bodies and payloads have none.

use crate::case::Case;
use crate::numerics::{BlockBand, M3, V3};
use crate::scene::element::{At, Element};
use crate::scene::{LumpedLine, mesh};
use crate::solve::{Factors, State};

/// Mass-proportional damping of the segments.
#[derive(Debug, Clone, PartialEq)]
pub struct MassDamping {
    /// alpha of every segment of the line \[1/s\], without the rod of a payload that rotates.
    rates: Vec<f64>,
}

impl MassDamping {
    /// That of a case, where any material has it.
    pub(super) fn of_case(case: &Case, coarsening: usize) -> Option<Self> {
        let of = |section: &crate::case::Section| {
            let material = case.materials.get(&section.material);
            material.map_or(0.0, |material| material.mass_damping_per_s)
        };
        let sections = case.line.iter().enumerate();
        let rates: Vec<f64> = sections
            .flat_map(|(index, section)| {
                let count = mesh::of_section(case, index, coarsening).len();
                std::iter::repeat_n(of(section), count)
            })
            .collect();
        rates
            .iter()
            .any(|rate| *rate > 0.0)
            .then_some(Self { rates })
    }

    /// Damping of half of segment i \[N s/m\].
    fn half(&self, line: &LumpedLine, i: usize) -> f64 {
        let segment = &line.segments[i];
        self.rates[i] * (segment.half_mass + segment.added.normal)
    }

    /// Damping of a node \[N s/m\].
    fn of_node(&self, line: &LumpedLine, node: usize) -> f64 {
        let beside = node.saturating_sub(1)..(node + 1).min(self.rates.len());
        beside.map(|i| self.half(line, i)).sum()
    }

    /// Derivative of the residual of a node by the unstretched length of segment i beside it \[N/m\].
    pub(super) fn by_length(&self, line: &LumpedLine, i: usize, node: usize, state: &State) -> V3 {
        state.v[node] * (self.half(line, i) / line.segments[i].axial.length)
    }
}

impl Element for MassDamping {
    fn add_residual(&self, at: At<'_>, r: &mut [V3]) {
        for i in 0..self.rates.len() {
            let damping = self.half(at.line, i);
            r[i] += at.state.v[i] * damping;
            r[i + 1] += at.state.v[i + 1] * damping;
        }
    }

    fn linearise(&self, at: At<'_>, c: Factors, r: &mut [V3], tangent: &mut BlockBand) {
        self.add_residual(at, r);
        for i in 0..self.rates.len() {
            let block = M3::from_diagonal_element(self.half(at.line, i) * c.damping);
            tangent.diag[i] += block;
            tangent.diag[i + 1] += block;
        }
    }

    fn decay_rate(&self, at: At<'_>, node: usize) -> f64 {
        self.of_node(at.line, node) / at.line.mass[node]
    }

    fn add_dissipation(&self, at: At<'_>, power: &mut f64) {
        for i in 0..self.rates.len() {
            let squares = at.state.v[i].norm_squared() + at.state.v[i + 1].norm_squared();
            *power += self.half(at.line, i) * squares;
        }
    }

    fn add_end_force(&self, at: At<'_>, node: usize, force: &mut V3) {
        *force -= at.state.v[node] * self.of_node(at.line, node);
    }
}
