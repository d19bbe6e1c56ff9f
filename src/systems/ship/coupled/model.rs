//! A ship and its anchor line as a system: a free body, a line of segments, and their points, in axes along the governing
//! equilibrium heading, about the ship's reference point there.

use super::CoupledError;
use crate::case::Solver;
use crate::case::{
    Attachment, Current, DragCoefficient, Environment, Material, OneOrMany, Output, Seabed,
    WaveKind, Waves,
};
use crate::numerics::V3;
use crate::ship::hull::HullMatrices;
use crate::ship::loads::EnvironmentalLoad;
use crate::ship::model::{CoupledSettings, Hull, Mooring, MotionSettings, SpectrumKind};
use crate::ship::mooring::MooringSolution;
use crate::ship::motion::wave_response::WaveResponse;
use crate::ship::static_analysis::{MooredEquilibrium, StaticAnalysis};
use crate::system::SystemFile;
use crate::system::model::{
    BodyInputs, BodyKind, DriftLoadInputs, HeadingLoadInputs, LineInputs, PointInputs, PointKind,
    SystemWind,
};

/// Penetration of the line into the seabed under its own weight \[m\].
const PENETRATION: f64 = 1e-3;
/// Headings at which the loads of wind, current and drift are given.
const HEADINGS: usize = 180;
/// Spectral radius at infinite frequency: damping enough for a line that snaps taut.
const RHO_INF: f64 = 0.4;

/// Name of the body.
pub(super) const SHIP: &str = "ship";
/// Name of the line, from its anchor to the ship.
pub(super) const LINE: &str = "line";

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
    /// The ship's mass, added mass, damping and restoring.
    pub hull: (&'a Hull, &'a HullMatrices),
}

/// What may vary from one run of a ship and its line to another.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ShipVariant {
    /// Segments of the line.
    pub segments: usize,
    /// Time step \[s\].
    pub step_s: f64,
    /// Simulated time and interval of the records \[s\].
    pub duration_s: f64,
    /// See `duration_s`.
    pub interval_s: f64,
    /// Where the ship is let go: displacement of its reference point \[m\] and yaw \[rad\].
    pub start: (V3, f64),
}

impl<'a> CoupledModel<'a> {
    /// The model of a ship with all inputs.
    ///
    /// # Errors
    /// [`CoupledError::Missing`].
    pub fn of_statics(statics: &'a StaticAnalysis) -> Result<Self, CoupledError> {
        let missing = CoupledError::Missing;
        let ship = &statics.ship;
        let settings = ship.coupled.as_ref();
        if ship.ship.water_density_kg_per_m3 <= 0.0 {
            return Err(missing("there is no water to float in"));
        }
        let equilibrium = statics.governing();
        let equilibrium =
            equilibrium.ok_or(missing("there is no stable equilibrium to start from"))?;
        let line = equilibrium
            .line
            .as_ref()
            .and_then(|line| line.as_ref().ok());
        let hull = ship.hull.as_ref().zip(statics.hull.as_ref());
        Ok(Self {
            statics,
            settings: settings.ok_or(missing("the file has no [coupled]"))?,
            equilibrium,
            mooring: ship
                .mooring
                .as_ref()
                .ok_or(missing("the file has no [mooring]"))?,
            line: line.ok_or(missing("the mooring line has no solution"))?,
            hull: hull.ok_or(missing("the file has no [hull]"))?,
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

    /// The run of the settings with so many segments and this step \[s\].
    #[must_use]
    pub fn variant(&self, segments: usize, step_s: f64) -> ShipVariant {
        let yaw = self.settings.start_yaw_deg.to_radians();
        let arm = self.arm();
        let (sin, cos) = yaw.sin_cos();
        ShipVariant {
            segments,
            step_s,
            duration_s: self.settings.duration_s,
            interval_s: self.settings.step_s,
            // About the fairlead, where the line stays as it is.
            start: (V3::new(arm.x * (1.0 - cos), -arm.x * sin, 0.0), yaw),
        }
    }

    /// Ship and line as a system, in the waves of the motion that responds to them; in still water without.
    #[must_use]
    pub fn system(
        &self,
        variant: &ShipVariant,
        waves: Option<(&MotionSettings, &WaveResponse)>,
    ) -> SystemFile {
        let particulars = &self.statics.ship.ship;
        let mut file = SystemFile {
            environment: Environment {
                gravity_m_per_s2: particulars.gravity_m_per_s2,
                water_density_kg_per_m3: particulars.water_density_kg_per_m3,
                ..Environment::default()
            },
            seabed: Some(Seabed {
                depth_m: self.mooring.depth_m,
                stiffness_n_per_m3: self.bed_stiffness(),
                ..Seabed::default()
            }),
            solver: Some(Solver {
                time_step_s: Some(variant.step_s),
                rho_inf: RHO_INF,
                error_estimate: false,
                ..Solver::over(variant.duration_s)
            }),
            output: Output {
                interval_s: variant.interval_s,
                ..Output::default()
            },
            ..SystemFile::new(&particulars.title)
        };
        file.bodies.insert(SHIP.to_owned(), self.body(variant));
        self.add_line(variant.segments, &mut file);
        for load in &self.statics.loads.each {
            self.add_load(load, &mut file);
        }
        if let Some((settings, response)) = waves {
            add_waves(settings, response, self.settings.ramp_s, &mut file);
        }
        file
    }

    /// The ship: the matrices of its hull, afloat in any pose but for the restoring, and held against the pull of the line down.
    fn body(&self, variant: &ShipVariant) -> BodyInputs {
        let (hull, matrices) = self.hull;
        let particulars = &self.statics.ship.ship;
        let inertia: V3 = V3::from(hull.gyration_m).map(|k| hull.mass_kg * k * k);
        let rows = |matrix: &nalgebra::Matrix6<f64>| matrix.transpose().as_slice().to_vec();
        let pull = self.pull();
        let moment = self.arm().cross(&pull);
        let (offset, yaw) = variant.start;
        BodyInputs {
            kind: BodyKind::Free,
            mass_kg: Some(hull.mass_kg),
            centre_of_gravity_m: hull.centre_m,
            inertia_kg_m2: inertia.as_slice().to_vec(),
            // All restoring is in its matrix.
            volume_m3: hull.mass_kg / particulars.water_density_kg_per_m3,
            centre_of_buoyancy_m: hull.centre_m,
            waterplane_stiffness: rows(&matrices.restoring),
            added_mass: rows(&matrices.added_mass),
            damping: rows(&matrices.damping),
            load_n: [0.0, 0.0, -pull.z],
            moment_n_m: [-moment.x, -moment.y, 0.0],
            start_offset_m: offset.into(),
            start_offset_deg: [0.0, 0.0, yaw.to_degrees()],
            ..BodyInputs::default()
        }
    }

    /// Pull of the line on the ship at the equilibrium \[N\].
    fn pull(&self) -> V3 {
        let (sin, cos) = self.line_direction().sin_cos();
        let (down, along) = self.line.angle.sin_cos();
        -V3::new(along * cos, along * sin, down) * self.line.tension
    }

    /// Direction from the anchor to the fairlead, from the heading \[rad\].
    fn line_direction(&self) -> f64 {
        self.equilibrium.yaw.force_direction - self.equilibrium.yaw.heading
    }

    fn bed_stiffness(&self) -> f64 {
        // Nearly rigid, as the seabed of the catenary: the line penetrates it by a millimetre.
        let gravity = self.statics.ship.ship.gravity_m_per_s2;
        let weight = self.mooring.wet_weight_kg_per_m * gravity;
        weight / (self.settings.line_diameter_m * PENETRATION)
    }

    fn add_line(&self, segments: usize, file: &mut SystemFile) {
        let (mooring, settings) = (self.mooring, self.settings);
        let material = Material {
            wet_weight_kg_per_m: Some(mooring.wet_weight_kg_per_m),
            drag_normal: DragCoefficient::Constant(settings.drag_normal),
            drag_tangential: DragCoefficient::Constant(settings.drag_tangential),
            added_mass_normal: settings.added_mass_normal,
            ..Material::new(
                settings.line_diameter_m,
                settings.line_mass_kg_per_m,
                mooring.ea_n,
            )
        };
        let (sin, cos) = self.line_direction().sin_cos();
        let arm = self.arm();
        let anchor = PointInputs::fixed([
            arm.x - self.line.distance * cos,
            arm.y - self.line.distance * sin,
            -mooring.depth_m,
        ]);
        let fairlead = PointInputs {
            position_m: Some(arm.into()),
            body: Some(SHIP.to_owned()),
            ..PointInputs::of(PointKind::Body)
        };
        file.materials.insert(LINE.to_owned(), material);
        file.points.insert("anchor".to_owned(), anchor);
        file.points.insert("fairlead".to_owned(), fairlead);
        file.lines.push(LineInputs {
            // As in the static analysis.
            still_water: true,
            ..LineInputs::new(
                LINE,
                ["anchor", "fairlead"],
                LINE,
                mooring.length_m,
                segments,
            )
        });
    }

    /// Wind, current or mean drift on the ship, and the flow that makes it.
    fn add_load(&self, load: &EnvironmentalLoad, file: &mut SystemFile) {
        let towards = (load.towards - self.equilibrium.yaw.heading).to_degrees();
        let Some(body) = file.bodies.get_mut(SHIP) else {
            return;
        };
        let Some(speed) = load.speed else {
            body.drift_towards_deg = towards;
            body.drift_loads = headings()
                .map(|heading_deg| {
                    let [surge_n, sway_n, yaw_n_m] = load.from_heading(heading_deg.to_radians());
                    DriftLoadInputs {
                        heading_deg,
                        surge_n,
                        sway_n,
                        yaw_n_m,
                    }
                })
                .collect();
            return;
        };
        let square = (speed * speed).max(f64::MIN_POSITIVE);
        let rows = headings().map(|heading_deg| {
            let of = load.from_heading(heading_deg.to_radians());
            let [surge, sway, yaw] = of.map(|load| load / square);
            HeadingLoadInputs {
                heading_deg,
                surge_n_s2_per_m2: surge,
                sway_n_s2_per_m2: sway,
                yaw_n_s2_per_m: yaw,
            }
        });
        match load.name {
            "wind" => {
                body.wind_loads = rows.collect();
                file.wind = Some(SystemWind {
                    speed_m_per_s: speed,
                    direction_deg: towards,
                });
            }
            _ => {
                body.current_loads = rows.collect();
                file.current = Some(Current {
                    speed_m_per_s: Some(OneOrMany::One(speed)),
                    direction_deg: OneOrMany::One(towards),
                    depth_m: None,
                    file: None,
                });
            }
        }
    }
}

/// Headings around the ship \[deg\].
fn headings() -> impl Iterator<Item = f64> {
    (0..HEADINGS).map(|k| 360.0 * k as f64 / HEADINGS as f64)
}

/// The waves of the motion, and the ship's responses to them.
fn add_waves(
    settings: &MotionSettings,
    response: &WaveResponse,
    ramp_s: f64,
    file: &mut SystemFile,
) {
    let name = "responses.csv";
    let waves = Waves {
        kind: WaveKind::Irregular,
        significant_height_m: settings.significant_height_m,
        peak_period_s: settings.peak_period_s,
        gamma: match settings.spectrum {
            SpectrumKind::Jonswap => settings.gamma,
            SpectrumKind::PiersonMoskowitz => 1.0,
        },
        components: settings.components,
        seed: settings.seed(),
        direction_deg: response.relative_direction.to_degrees(),
        ramp_s,
        ..Waves::default()
    };
    if waves
        .significant_height_m
        .is_none_or(|height| height <= 0.0)
    {
        return;
    }
    file.waves.push(waves);
    let carried = Attachment {
        text: response.table.as_str().into(),
    };
    file.files.insert(name.to_owned(), carried);
    if let Some(body) = file.bodies.get_mut(SHIP) {
        body.response_file = Some(name.to_owned());
    }
}
