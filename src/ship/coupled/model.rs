//! What the equations of a ship and its anchor line are made from: the ship where it rests, the line built and laid.

use nalgebra::Vector6;

use super::CoupledError;
use super::forcing::Forcing;
use super::moored_ship::{MooredShip, ShipBody};
use crate::case;
use crate::numerics::V3;
use crate::scene::{self, Scene};
use crate::ship::model::{CoupledSettings, Mooring};
use crate::ship::mooring::MooringSolution;
use crate::ship::static_analysis::{Equilibrium, StaticAnalysis};
use crate::solve::{Kinematics, State};
use crate::statics::equilibrium::EquilibriumSearch;

/// How far the line sinks into the bed under its own weight \[m\].
const SUNK: f64 = 1e-3;

/// What the equations of ship and line are made from.
#[derive(Debug, Clone, Copy)]
pub struct CoupledModel<'a> {
    /// The ship at rest.
    pub statics: &'a StaticAnalysis,
    /// Its words on the run.
    pub settings: &'a CoupledSettings,
    /// The heading at which it lies.
    pub equilibrium: &'a Equilibrium,
    /// The line that holds it.
    pub mooring: &'a Mooring,
    /// The line's reach there.
    pub reach: &'a MooringSolution,
}

impl<'a> CoupledModel<'a> {
    /// Of a file that says everything needed.
    ///
    /// # Errors
    /// [`CoupledError::Missing`].
    pub fn of(statics: &'a StaticAnalysis) -> Result<Self, CoupledError> {
        let missing = CoupledError::Missing;
        let settings = statics.ship.coupled.as_ref();
        let equilibrium = statics.governing();
        let equilibrium = equilibrium.ok_or(missing("there is no stable heading to begin from"))?;
        let reach = equilibrium
            .reach
            .as_ref()
            .and_then(|reach| reach.as_ref().ok());
        Ok(Self {
            statics,
            settings: settings.ok_or(missing("the file has no [coupled]"))?,
            equilibrium,
            mooring: statics
                .ship
                .mooring
                .as_ref()
                .ok_or(missing("the file has no [mooring]"))?,
            reach: reach.ok_or(missing("the mooring line does not reach the ship"))?,
        })
    }

    /// From the ship's reference point to its fairlead \[m\].
    #[must_use]
    pub fn arm(&self) -> V3 {
        let height = self.mooring.fairlead_z_m;
        V3::new(self.statics.loads.arm, 0.0, height)
    }

    /// The line, of so many segments, at rest with its fairlead shifted \[m\].
    ///
    /// # Errors
    /// [`CoupledError::Line`].
    pub fn line(&self, segments: usize, shift: &V3) -> Result<(Scene, State), CoupledError> {
        let failed = |why: String| CoupledError::Line(why);
        let case = case::parse(&self.line_text(segments, shift), "anchor line")
            .map_err(|all| failed(all.first().map_or_else(String::new, ToString::to_string)))?;
        let scene = scene::build(&case, 1).map_err(|error| failed(error.to_string()))?;
        let mut state = scene.initial_state();
        EquilibriumSearch::default()
            .run(&scene, 0.0, &mut state)
            .map_err(|error| failed(error.to_string()))?;
        Ok((scene, state))
    }

    fn line_text(&self, segments: usize, shift: &V3) -> String {
        let (particulars, mooring, settings) =
            (&self.statics.ship.particulars, self.mooring, self.settings);
        let balance = &self.equilibrium.yaw;
        let (sin, cos) = (balance.force_direction - balance.heading).sin_cos();
        let arm = self.arm();
        let (x, y) = (
            arm.x - self.reach.distance * cos,
            arm.y - self.reach.distance * sin,
        );
        let ship = arm + shift;
        format!(
            "[case]\ntitle = \"anchor line\"\n\
             [environment]\ngravity_m_per_s2 = {:?}\nwater_density_kg_per_m3 = {:?}\n\
             [seabed]\ndepth_m = {:?}\nstiffness_n_per_m3 = {:?}\n\
             [materials.line]\ndiameter_m = {:?}\nmass_kg_per_m = {:?}\nwet_weight_kg_per_m = {:?}\nea_n = {:?}\n\
             drag_normal = {:?}\ndrag_tangential = {:?}\nadded_mass_normal = {:?}\n\
             [[line]]\nname = \"line\"\nmaterial = \"line\"\nlength_m = {:?}\nsegments = {segments}\n\
             [ends.a]\nname = \"anchor\"\nkind = \"anchor\"\nposition_m = [{x:?}, {y:?}, {:?}]\n\
             [ends.b]\nname = \"ship\"\nkind = \"fixed\"\nposition_m = [{:?}, {:?}, {:?}]\n",
            particulars.gravity_m_per_s2,
            particulars.water_density_kg_per_m3,
            mooring.depth_m,
            // As hard as the flat bed of the closed form, nearly: the line sinks in by a millimetre.
            mooring.wet_weight_kg_per_m * particulars.gravity_m_per_s2
                / (settings.line_diameter_m * SUNK),
            settings.line_diameter_m,
            settings.line_mass_kg_per_m,
            mooring.wet_weight_kg_per_m,
            mooring.ea_n,
            settings.drag_normal,
            settings.drag_tangential,
            settings.added_mass_normal,
            mooring.length_m,
            -mooring.depth_m,
            ship.x,
            ship.y,
            ship.z,
        )
    }

    /// Ship and line as one system, with the line at rest where the ship lies.
    ///
    /// # Errors
    /// [`CoupledError`].
    pub fn system(
        &self,
        segments: usize,
        forcing: Forcing,
    ) -> Result<(MooredShip, State), CoupledError> {
        let (scene, state) = self.line(segments, &V3::zeros())?;
        let moored = self.moored(scene, &state, forcing)?;
        Ok((moored, state))
    }

    /// The ship on a line, its weight and trim balanced with the line at rest as given.
    ///
    /// # Errors
    /// [`CoupledError`].
    pub fn moored(
        &self,
        scene: Scene,
        rest: &State,
        forcing: Forcing,
    ) -> Result<MooredShip, CoupledError> {
        let missing = CoupledError::Missing("the file has no [hull]");
        let hull = self.statics.hull.as_ref().ok_or(missing)?;
        let arm = self.arm();
        let pull = scene.end_force(scene.nodes() - 1, rest);
        let turn = arm.cross(&pull);
        // What holds the ship in the plane are wind, current and drift; the water holds up what the line pulls down.
        let load = -Vector6::new(0.0, 0.0, pull.z, turn.x, turn.y, 0.0);
        let body = ShipBody {
            mass: hull.mass,
            damping: hull.damping,
            restoring: hull.restoring,
            load,
            forcing,
            place: V3::zeros(),
            arm,
            length: 0.5 * self.statics.ship.particulars.length_m,
        };
        Ok(MooredShip::new(scene, body)?)
    }

    /// Wind, current and drift in time, along the heading at rest.
    #[must_use]
    pub fn flows(&self) -> Forcing {
        Forcing {
            flows: Some((self.statics.loads.clone(), self.equilibrium.yaw.heading)),
            ..Forcing::default()
        }
    }
}
