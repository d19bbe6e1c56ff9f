//! A ship at rest: its loads, every heading in balance, and how far it then lies from its anchor.

use super::fishtail::{Fate, Planar};
use super::heading::{Balance, HeadingError, Stands, balances};
use super::hull::Matrices;
use super::loads::Loads;
use super::model::Ship;
use super::mooring::{Reach, ReachError, reach};

/// A ship at rest.
#[derive(Debug, Clone, PartialEq)]
pub struct Rest {
    /// The words.
    pub ship: Ship,
    /// What acts on it.
    pub loads: Loads,
    /// Its matrices; absent where the file gives no hull.
    pub hull: Option<Matrices>,
    /// Every heading in balance, from -180 to 180 degrees, with the reach of the mooring there; absent where the file
    /// names no mooring.
    pub stations: Result<Vec<Station>, HeadingError>,
}

/// A heading in balance, and where the ship then lies.
#[derive(Debug, Clone, PartialEq)]
pub struct Station {
    /// The heading.
    pub balance: Balance,
    /// The mooring line, where the file names one.
    pub reach: Option<Result<Reach, ReachError>>,
    /// The ship's small motions there, linearised; absent without hull or a mooring that reaches.
    pub planar: Option<Planar>,
}

impl Station {
    /// What becomes of a small disturbance there; absent without hull or a mooring that reaches.
    #[must_use]
    pub fn fate(&self) -> Option<Fate> {
        self.planar.as_ref()?.fate()
    }

    /// Where the mooring point and the ship's centre lie from the anchor, in the axes of the case \[m\]; absent without a
    /// mooring line that reaches.
    #[must_use]
    pub fn offset(&self, arm: f64) -> Option<[(f64, f64); 2]> {
        let reach = self.reach.as_ref()?.as_ref().ok()?;
        let (sin, cos) = self.balance.downstream.sin_cos();
        let bow = (reach.distance * cos, reach.distance * sin);
        let (sin, cos) = self.balance.heading.sin_cos();
        Some([bow, (bow.0 - arm * cos, bow.1 - arm * sin)])
    }
}

impl Rest {
    /// Works a ship out. The words are taken as checked.
    #[must_use]
    pub fn new(ship: Ship) -> Self {
        let loads = Loads::new(&ship);
        let hull = ship.hull.as_ref().map(Matrices::of);
        let station = |balance: Balance| {
            let mooring = ship.mooring.as_ref();
            let reach = mooring.map(|mooring| reach(&ship.about, mooring, balance.pull));
            let held = reach.as_ref().and_then(|reach| reach.as_ref().ok());
            let planar = hull.as_ref().zip(held);
            Station {
                planar: planar.map(|(hull, reach)| Planar::new(hull, &loads, &balance, reach)),
                reach,
                balance,
            }
        };
        let stations = balances(&loads).map(|all| all.into_iter().map(station).collect());
        Self {
            ship,
            loads,
            hull,
            stations,
        }
    }

    /// The stable heading under the greatest stiffness in yaw: where the ship is most likely found.
    #[must_use]
    pub fn chosen(&self) -> Option<&Station> {
        let stations = self.stations.as_ref().ok()?;
        let stable = stations
            .iter()
            .filter(|s| s.balance.stands == Stands::Stable);
        stable.max_by(|a, b| {
            let stiffness = |s: &Station| s.balance.yaw_stiffness;
            stiffness(a).total_cmp(&stiffness(b))
        })
    }
}
