//! The model of a ship and its anchor line: the ship at its governing equilibrium, the line built and in equilibrium.

use nalgebra::Vector6;

use super::CoupledError;
use super::forcing::Forcing;
use super::moored_ship::{MooredShip, ShipBody};
use crate::case::{Case, DragCoefficient, End, EndKind, Ends, Material, Seabed, Section};
use crate::numerics::V3;
use crate::scene::{self, Scene};
use crate::ship::hull::HullMatrices;
use crate::ship::model::{CoupledSettings, Mooring};
use crate::ship::mooring::MooringSolution;
use crate::ship::static_analysis::{MooredEquilibrium, StaticAnalysis};
use crate::solve::{Kinematics, State};
use crate::statics::equilibrium::EquilibriumSearch;

/// Penetration of the line into the seabed under its own weight \[m\].
const PENETRATION: f64 = 1e-3;

/// A ship at its governing equilibrium, and its anchor line.
#[derive(Debug, Clone, Copy)]
pub struct CoupledModel<'a> {
    /// Static analysis of the ship.
    pub statics: &'a StaticAnalysis,
    /// Settings of the coupled analysis.
    pub settings: &'a CoupledSettings,
    /// The governing equilibrium.
    pub equilibrium: &'a MooredEquilibrium,
    /// The mooring line.
    pub mooring: &'a Mooring,
    /// Its solution at the equilibrium.
    pub line: &'a MooringSolution,
}

impl<'a> CoupledModel<'a> {
    /// The model of a ship with all inputs.
    ///
    /// # Errors
    /// [`CoupledError::Missing`].
    pub fn of(statics: &'a StaticAnalysis) -> Result<Self, CoupledError> {
        let missing = CoupledError::Missing;
        let settings = statics.ship.coupled.as_ref();
        let equilibrium = statics.governing();
        let equilibrium =
            equilibrium.ok_or(missing("there is no stable equilibrium to start from"))?;
        let line = equilibrium
            .line
            .as_ref()
            .and_then(|line| line.as_ref().ok());
        Ok(Self {
            statics,
            settings: settings.ok_or(missing("the file has no [coupled]"))?,
            equilibrium,
            mooring: statics
                .ship
                .mooring
                .as_ref()
                .ok_or(missing("the file has no [mooring]"))?,
            line: line.ok_or(missing("the mooring line has no solution"))?,
        })
    }

    /// Fairlead from the ship's reference point \[m\].
    #[must_use]
    pub fn arm(&self) -> V3 {
        let height = self.mooring.fairlead_z_m;
        V3::new(self.statics.loads.arm, 0.0, height)
    }

    /// Hang-off point of the rope from the ship's reference point \[m\].
    #[must_use]
    pub fn hang_off(&self) -> V3 {
        let motion = self.statics.ship.motion.as_ref();
        V3::from(motion.map_or([0.0; 3], |motion| motion.hang_point_m))
    }

    /// Matrices of the hull.
    ///
    /// # Errors
    /// [`CoupledError::Missing`].
    pub fn hull(&self) -> Result<&HullMatrices, CoupledError> {
        let missing = CoupledError::Missing("the file has no [hull]");
        self.statics.hull.as_ref().ok_or(missing)
    }

    /// The line, of so many segments, in equilibrium with its fairlead displaced by `offset` \[m\].
    ///
    /// # Errors
    /// [`CoupledError::Line`].
    pub fn line_at_rest(
        &self,
        segments: usize,
        offset: &V3,
    ) -> Result<(Scene, State), CoupledError> {
        let failed = CoupledError::Line;
        let case = self.line_case(segments, offset);
        let scene = scene::build(&case, 1).map_err(|error| failed(error.to_string()))?;
        let mut state = scene.initial_state();
        EquilibriumSearch::default()
            .run(&scene, 0.0, &mut state)
            .map_err(|error| failed(error.to_string()))?;
        Ok((scene, state))
    }

    /// The line from the anchor to the fairlead displaced by `offset` \[m\], in axes along the equilibrium heading.
    fn line_case(&self, segments: usize, offset: &V3) -> Case {
        const LINE: &str = "line";
        let (particulars, mooring) = (&self.statics.ship.ship, self.mooring);
        let yaw = &self.equilibrium.yaw;
        let (sin, cos) = (yaw.force_direction - yaw.heading).sin_cos();
        let arm = self.arm();
        let (x, y) = (
            arm.x - self.line.distance * cos,
            arm.y - self.line.distance * sin,
        );
        let ends = Ends {
            a: End::new("anchor", EndKind::Anchor, Some([x, y, -mooring.depth_m])),
            b: End::fixed("ship", (arm + offset).into()),
        };
        let mut case = Case::new("anchor line", ends);
        case.environment.gravity_m_per_s2 = particulars.gravity_m_per_s2;
        case.environment.water_density_kg_per_m3 = particulars.water_density_kg_per_m3;
        // Nearly rigid, as the seabed of the catenary: the line penetrates it by a millimetre.
        let stiffness_n_per_m3 = mooring.wet_weight_kg_per_m * particulars.gravity_m_per_s2
            / (self.settings.line_diameter_m * PENETRATION);
        case.seabed = Some(Seabed {
            stiffness_n_per_m3,
            ..Seabed::level(mooring.depth_m)
        });
        case.materials.insert(LINE.to_owned(), self.line_material());
        case.line = vec![Section::new(LINE, LINE, mooring.length_m, segments)];
        case
    }

    fn line_material(&self) -> Material {
        let (mooring, settings) = (self.mooring, self.settings);
        Material {
            wet_weight_kg_per_m: Some(mooring.wet_weight_kg_per_m),
            drag_normal: DragCoefficient::Constant(settings.drag_normal),
            drag_tangential: DragCoefficient::Constant(settings.drag_tangential),
            added_mass_normal: settings.added_mass_normal,
            ..Material::new(
                settings.line_diameter_m,
                settings.line_mass_kg_per_m,
                mooring.ea_n,
            )
        }
    }

    /// Ship and line as one system, with the equilibrium of the line.
    ///
    /// # Errors
    /// [`CoupledError`].
    pub fn system(
        &self,
        segments: usize,
        forcing: Forcing,
    ) -> Result<(MooredShip, State), CoupledError> {
        let (scene, state) = self.line_at_rest(segments, &V3::zeros())?;
        let moored = self.moored_ship(scene, &state, forcing)?;
        Ok((moored, state))
    }

    /// The ship on a line, with weight and trim that balance the line in this equilibrium.
    ///
    /// # Errors
    /// [`CoupledError`].
    pub fn moored_ship(
        &self,
        scene: Scene,
        rest: &State,
        forcing: Forcing,
    ) -> Result<MooredShip, CoupledError> {
        let hull = self.hull()?;
        let arm = self.arm();
        let pull = scene.end_force(scene.nodes() - 1, rest);
        let moment = arm.cross(&pull);
        // Wind, current and drift balance the line in the horizontal plane, buoyancy in the others.
        let load = -Vector6::new(0.0, 0.0, pull.z, moment.x, moment.y, 0.0);
        let body = ShipBody {
            mass: hull.mass,
            damping: hull.damping,
            restoring: hull.restoring,
            load,
            forcing,
            origin: V3::zeros(),
            arm,
            length: 0.5 * self.statics.ship.ship.length_m,
        };
        Ok(MooredShip::new(scene, body)?)
    }

    /// Wind, current and drift in axes along the equilibrium heading.
    #[must_use]
    pub fn environment(&self) -> Forcing {
        Forcing {
            environment: Some((self.statics.loads.clone(), self.equilibrium.yaw.heading)),
            ..Forcing::default()
        }
    }
}
