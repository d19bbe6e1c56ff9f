//! Drag of clumps across and along the line that carries them, as buoyancy modules and cylinders around a line have it.
//!
//! `F = 1/2 rho ( (C A)_n |u_n| u_n + (C A)_t |u_t| u_t )`, u the velocity of the water relative to the clump, its parts across and along
//! the direction of the line there ([`NodeDirection`]): the law of the line itself, so that a row of modules drags as a pipe of the same
//! area by length. Mass and weight of such clumps are those of any other.

use crate::case::Case;
use crate::numerics::lanes;
use crate::numerics::{BlockBand, M3, V3};
use crate::physics::NodeDirection;
use crate::physics::drag::{Drag, DragProperties};
use crate::scene::LumpedLine;
use crate::scene::element::{At, Element};
use crate::solve::{Factors, State};

/// The clumps with drag across and along the line.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::scene) struct ClumpDrag {
    clumps: Vec<Aligned>,
}

/// A clump that is aligned with the line.
#[derive(Debug, Clone, PartialEq)]
struct Aligned {
    /// Its number among the bodies on the line.
    number: usize,
    /// Its node.
    node: usize,
    drag: DragProperties,
}

/// Drag on a clump, with what its derivatives are built from.
struct DragOnClump {
    direction: NodeDirection,
    /// Velocity of the water relative to the clump \[m/s\].
    u: V3,
    /// Drag as if it were submerged, twice side by side.
    full: Drag<lanes::Two>,
    /// Submerged fraction, and its derivative by the position of the clump \[1/m\].
    wet: (f64, V3),
}

impl DragOnClump {
    /// The force as if it were submerged \[N\].
    fn full_force(&self) -> V3 {
        lanes::vector(&self.full.force, 0)
    }

    /// The force \[N\].
    fn force(&self) -> V3 {
        self.full_force() * self.wet.0
    }
}

impl ClumpDrag {
    /// Those of a case on its line, its clumps at these nodes; nothing where none is aligned.
    pub(super) fn of_case(case: &Case, line: &LumpedLine, nodes: &[usize]) -> Option<Self> {
        let half = 0.5 * case.environment.water_density_kg_per_m3;
        let number = |k: usize| {
            // Bodies are in the order of their nodes, those at one node in the order of the case.
            let first = line.bodies.partition_point(|hung| hung.node < nodes[k]);
            first + nodes[..k].iter().filter(|node| **node == nodes[k]).count()
        };
        let clumps: Vec<Aligned> = (case.clumps.iter().enumerate())
            .filter(|(_, clump)| clump.has_aligned_drag())
            .map(|(k, clump)| Aligned {
                number: number(k),
                node: nodes[k],
                drag: DragProperties::of_body(
                    half * clump.drag_area_normal_m2,
                    half * clump.drag_area_tangential_m2,
                ),
            })
            .collect();
        (!clumps.is_empty()).then_some(Self { clumps })
    }

    /// Drag of the clumps at a node \[N\].
    pub(in crate::scene) fn at_node(&self, line: &LumpedLine, node: usize, state: &State) -> V3 {
        let here = self.clumps.iter().filter(|clump| clump.node == node);
        here.map(|clump| clump.at(line, state).force()).sum()
    }
}

impl Aligned {
    fn at(&self, line: &LumpedLine, state: &State) -> DragOnClump {
        let node = self.node;
        let direction = line.direction_at(node, state);
        let u = line.water_at(node, state) - state.v[node];
        DragOnClump {
            full: self.drag.drag(&direction.d, [&u, &u], 1.0, None),
            wet: line.body_submergence(self.number, state),
            direction,
            u,
        }
    }

    /// Subtracts the tangent of the force.
    fn subtract_tangent(&self, at: At<'_>, on: &DragOnClump, c: Factors, tangent: &mut BlockBand) {
        let (node, x) = (self.node, &at.state.x[self.node]);
        let (share, wet_by_place) = on.wet;
        let d = lanes::twice(&on.direction.d);
        let by_velocity = lanes::block(&on.full.matrix(&d), 0) * share;
        let by_direction = lanes::block(&on.full.by_direction(&d), 0) * (share * c.stiffness);
        let [before, own, after] = on.direction.by_positions().map(|by| by_direction * by);
        let mut gradient = at.line.current.flow(x).1;
        if let Some(flow) = at.state.wave_flow.get(node) {
            gradient += flow.gradient;
        }
        let of_water = M3::from_diagonal_element(c.damping) - gradient * c.stiffness;
        let of_surface = on.full_force() * wet_by_place.transpose() * c.stiffness;
        tangent.diag[node] += by_velocity * of_water - of_surface - own;
        if node > 0 {
            tangent.lower[node] -= before;
        }
        if node + 1 < at.line.line_nodes {
            tangent.upper[node] -= after;
        }
    }
}

impl Element for ClumpDrag {
    fn add_residual(&self, at: At<'_>, r: &mut [V3]) {
        for clump in &self.clumps {
            r[clump.node] -= clump.at(at.line, at.state).force();
        }
    }

    fn linearise(&self, at: At<'_>, c: Factors, r: &mut [V3], tangent: &mut BlockBand) {
        for clump in &self.clumps {
            let on = clump.at(at.line, at.state);
            r[clump.node] -= on.force();
            clump.subtract_tangent(at, &on, c, tangent);
        }
    }

    fn decay_rate(&self, at: At<'_>, node: usize) -> f64 {
        let here = self.clumps.iter().filter(|clump| clump.node == node);
        let drag = here.map(|clump| clump.drag.greatest(0.0)).sum::<f64>();
        if drag == 0.0 {
            return 0.0;
        }
        let speed = (at.line.water_at(node, at.state) - at.state.v[node]).norm();
        2.0 * drag * speed / at.line.mass[node]
    }

    fn add_dissipation(&self, at: At<'_>, power: &mut f64) {
        for clump in &self.clumps {
            let force = clump.at(at.line, at.state).force();
            *power -= force.dot(&at.state.v[clump.node]);
        }
    }

    fn add_water_drag_power(&self, at: At<'_>, power: &mut f64) {
        for clump in &self.clumps {
            let on = clump.at(at.line, at.state);
            *power += on.force().dot(&(on.u + at.state.v[clump.node]));
        }
    }

    fn add_end_force(&self, at: At<'_>, node: usize, force: &mut V3) {
        *force += self.at_node(at.line, node, at.state);
    }
}
