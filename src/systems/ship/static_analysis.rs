//! Static analysis of a moored ship: environmental loads, yaw equilibria, mooring line and dynamic stability at each.

use super::hull::HullMatrices;
use super::loads::EnvironmentalLoads;
use super::model::Ship;
use super::mooring::{MooringError, MooringSolution, solve_mooring};
use super::stability::{DynamicStability, PlanarDynamics};
use super::yaw_equilibria::{YawEquilibrium, YawEquilibriumError, YawStability, yaw_equilibria};

/// The static analysis of a ship.
#[derive(Debug, Clone, PartialEq)]
pub struct StaticAnalysis {
    /// The ship as read from its file.
    pub ship: Ship,
    /// Environmental loads.
    pub loads: EnvironmentalLoads,
    /// Mass, damping and restoring matrices; absent without `[hull]`.
    pub hull: Option<HullMatrices>,
    /// Every equilibrium, by ascending heading.
    pub equilibria: Result<Vec<MooredEquilibrium>, YawEquilibriumError>,
}

/// An equilibrium of ship and mooring.
#[derive(Debug, Clone, PartialEq)]
pub struct MooredEquilibrium {
    /// Heading, loads and static stability.
    pub yaw: YawEquilibrium,
    /// The mooring line at the pull of this heading; absent without `[mooring]`.
    pub line: Option<Result<MooringSolution, MooringError>>,
    /// Linearised surge, sway and yaw; absent without `[hull]` or a mooring solution.
    pub dynamics: Option<PlanarDynamics>,
}

impl MooredEquilibrium {
    /// Dynamic stability; absent without `[hull]` or a mooring solution.
    #[must_use]
    pub fn dynamic_stability(&self) -> Option<DynamicStability> {
        self.dynamics.as_ref()?.stability()
    }

    /// Positions of the mooring point and of the ship's centre from the anchor, in global axes \[m\]; absent without a
    /// mooring solution.
    #[must_use]
    pub fn positions(&self, arm: f64) -> Option<[(f64, f64); 2]> {
        let line = self.line.as_ref()?.as_ref().ok()?;
        let (sin, cos) = self.yaw.force_direction.sin_cos();
        let bow = (line.distance * cos, line.distance * sin);
        let (sin, cos) = self.yaw.heading.sin_cos();
        Some([bow, (bow.0 - arm * cos, bow.1 - arm * sin)])
    }
}

impl StaticAnalysis {
    /// Analyses a ship that has passed validation.
    #[must_use]
    pub fn new(ship: Ship) -> Self {
        let loads = EnvironmentalLoads::new(&ship);
        let hull = ship.hull.as_ref().map(HullMatrices::of_hull);
        let equilibrium = |yaw: YawEquilibrium| {
            let mooring = ship.mooring.as_ref();
            let line = mooring.map(|mooring| solve_mooring(&ship.ship, mooring, yaw.pull));
            let solved = line.as_ref().and_then(|line| line.as_ref().ok());
            let planar = hull.as_ref().zip(solved);
            MooredEquilibrium {
                dynamics: planar.map(|(hull, line)| PlanarDynamics::new(hull, &loads, &yaw, line)),
                line,
                yaw,
            }
        };
        let equilibria =
            yaw_equilibria(&loads).map(|all| all.into_iter().map(equilibrium).collect());
        Self {
            ship,
            loads,
            hull,
            equilibria,
        }
    }

    /// The governing equilibrium: the statically stable one of greatest yaw stiffness.
    #[must_use]
    pub fn governing(&self) -> Option<&MooredEquilibrium> {
        let equilibria = self.equilibria.as_ref().ok()?;
        let stable = equilibria
            .iter()
            .filter(|one| one.yaw.stability == YawStability::Stable);
        stable.max_by(|a, b| {
            let stiffness = |one: &MooredEquilibrium| one.yaw.yaw_stiffness;
            stiffness(a).total_cmp(&stiffness(b))
        })
    }
}
