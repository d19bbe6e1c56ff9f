//! A ship at rest: its loads, every heading in balance, and how far it then lies from its anchor.

use super::hull::HullMatrices;
use super::loads::EnvironmentalLoads;
use super::model::Ship;
use super::mooring::{MooringError, MooringSolution, reach};
use super::stability::{DynamicStability, PlanarDynamics};
use super::yaw_equilibria::{YawEquilibrium, YawEquilibriumError, YawStability, yaw_equilibria};

/// A ship at rest.
#[derive(Debug, Clone, PartialEq)]
pub struct StaticAnalysis {
    /// The words.
    pub ship: Ship,
    /// What acts on it.
    pub loads: EnvironmentalLoads,
    /// Its matrices; absent where the file gives no hull.
    pub hull: Option<HullMatrices>,
    /// Every heading in balance, from -180 to 180 degrees, with the reach of the mooring there; absent where the file
    /// names no mooring.
    pub equilibria: Result<Vec<Equilibrium>, YawEquilibriumError>,
}

/// A heading in balance, and where the ship then lies.
#[derive(Debug, Clone, PartialEq)]
pub struct Equilibrium {
    /// The heading.
    pub yaw: YawEquilibrium,
    /// The mooring line, where the file names one.
    pub reach: Option<Result<MooringSolution, MooringError>>,
    /// The ship's small motions there, linearised; absent without hull or a mooring that reaches.
    pub planar: Option<PlanarDynamics>,
}

impl Equilibrium {
    /// What becomes of a small disturbance there; absent without hull or a mooring that reaches.
    #[must_use]
    pub fn dynamic_stability(&self) -> Option<DynamicStability> {
        self.planar.as_ref()?.dynamic_stability()
    }

    /// Where the mooring point and the ship's centre lie from the anchor, in the axes of the case \[m\]; absent without a
    /// mooring line that reaches.
    #[must_use]
    pub fn offset(&self, arm: f64) -> Option<[(f64, f64); 2]> {
        let reach = self.reach.as_ref()?.as_ref().ok()?;
        let (sin, cos) = self.yaw.force_direction.sin_cos();
        let bow = (reach.distance * cos, reach.distance * sin);
        let (sin, cos) = self.yaw.heading.sin_cos();
        Some([bow, (bow.0 - arm * cos, bow.1 - arm * sin)])
    }
}

impl StaticAnalysis {
    /// Works a ship out. The words are taken as checked.
    #[must_use]
    pub fn new(ship: Ship) -> Self {
        let loads = EnvironmentalLoads::new(&ship);
        let hull = ship.hull.as_ref().map(HullMatrices::of);
        let equilibrium = |yaw: YawEquilibrium| {
            let mooring = ship.mooring.as_ref();
            let reach = mooring.map(|mooring| reach(&ship.particulars, mooring, yaw.pull));
            let held = reach.as_ref().and_then(|reach| reach.as_ref().ok());
            let planar = hull.as_ref().zip(held);
            Equilibrium {
                planar: planar.map(|(hull, reach)| PlanarDynamics::new(hull, &loads, &yaw, reach)),
                reach,
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

    /// The stable heading under the greatest stiffness in yaw: where the ship is most likely found.
    #[must_use]
    pub fn governing(&self) -> Option<&Equilibrium> {
        let equilibria = self.equilibria.as_ref().ok()?;
        let stable = equilibria
            .iter()
            .filter(|s| s.yaw.stability == YawStability::Stable);
        stable.max_by(|a, b| {
            let stiffness = |s: &Equilibrium| s.yaw.yaw_stiffness;
            stiffness(a).total_cmp(&stiffness(b))
        })
    }
}
