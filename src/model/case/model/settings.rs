//! How a case is computed: start, solver, output.

use crate::case::fields::{Conditions, of, positive};
use crate::case::schema::{table, words};
use crate::numerics::V3;
use crate::physics::ElasticBed;

const STRAIGHT: Conditions = &[("shape", &["straight"])];

table! {
    /// Where the line is at time zero, at rest.
    #[derive(Debug, Clone, PartialEq)]
    pub struct Start => StartKeys {
        /// How the line lies at time zero: straight and unstretched, in static equilibrium, or as given by the keys below.
        shape: StartShape = StartShape::Equilibrium, "start shape";
        /// Azimuth of a straight line with a free end, from +x towards +y.
        azimuth_deg: f64 = 0.0, "start azimuth", range of(-360.0, 360.0), matters STRAIGHT;
        /// Elevation of a straight line with a free end, positive up.
        elevation_deg: f64 = 0.0, "start elevation", range of(-90.0, 90.0), matters STRAIGHT;
        /// Arc lengths from end A at which a shape is given, from 0 to the whole line; also where the search for an equilibrium begins.
        arc_m: Option<Vec<f64>>, "start arc lengths", range of(0.0, 1e6), absent "not used";
        /// x of the line at the arc lengths given; straight in between.
        x_m: Option<Vec<f64>>, "start x", range of(-1e6, 1e6), absent "not used";
        /// y of the line at the arc lengths given.
        y_m: Option<Vec<f64>>, "start y", range of(-1e6, 1e6), absent "0 everywhere";
        /// z of the line at the arc lengths given.
        z_m: Option<Vec<f64>>, "start z", range of(-1e6, 1e6), absent "not used";
        /// Directory of a stored run of the same line: its shape, its motion and what it remembers are the start.
        from_run: Option<String>, "start from run", absent "not used";
        /// Velocity of the whole line at time zero, but for ends that are held.
        velocity_m_per_s: [f64; 3] = [0.0, 0.0, 0.0], "start velocity", range of(-1e3, 1e3);
    }
}

impl Seabed {
    /// Whether it has friction that holds at rest.
    #[must_use]
    pub fn grips(&self) -> bool {
        let along = self.friction.is_some_and(|friction| friction > 0.0);
        let across = self.friction_lateral.is_some_and(|friction| friction > 0.0);
        self.friction_law == FrictionLaw::Grip && (along || across && self.friction.is_some())
    }

    /// Its slip speed, where its friction goes by the velocity \[m/s\].
    #[must_use]
    pub fn slip_speed(&self) -> Option<f64> {
        (self.friction_law == FrictionLaw::Zhu2017).then_some(self.slip_speed_m_per_s)
    }

    /// Whether it is level.
    #[must_use]
    pub fn is_level(&self) -> bool {
        self.depth_file.is_none() && self.slope_deg == 0.0
    }

    /// Height of a sloping plane at x = y = 0 \[m\] and its unit normal; nothing where it does not slope.
    #[must_use]
    pub fn plane(&self) -> Option<(f64, V3)> {
        ElasticBed::plane(
            (self.depth_m, self.depth_at_m),
            [self.slope_deg, self.slope_azimuth_deg].map(f64::to_radians),
        )
    }
}

impl Start {
    /// Whether it says where the search for an equilibrium begins.
    #[must_use]
    pub fn begins_search(&self) -> bool {
        self.shape == StartShape::Equilibrium && self.arc_m.is_some()
    }

    /// Whether a line begins off its equilibrium, by its shape or its velocity.
    #[must_use]
    pub fn is_off_rest(&self) -> bool {
        self.shape != StartShape::Equilibrium || self.velocity_m_per_s != [0.0; 3]
    }
}

words! {
    /// How the line lies at time zero.
    pub enum StartShape {
        /// Straight and unstretched from end A, in the direction given.
        Straight = "straight",
        /// In static equilibrium.
        Equilibrium = "equilibrium",
        /// As the coordinates along its arc length say.
        Given = "given",
    }
}

table! {
    /// Which solver, and its settings.
    #[derive(Debug, Clone, PartialEq)]
    pub struct Solver => SolverKeys {
        /// Static equilibrium, quasi-static march, explicit Runge-Kutta, implicit generalized-alpha, or the cheaper of the last two.
        method: Method = Method::Alpha, "method";
        /// Simulated time.
        duration_s: f64 = 600.0, "duration", range positive(1e6);
        /// Constant time step. If absent it is chosen, and varies with the error for alpha; the run reports it.
        time_step_s: Option<f64>, "time step", range positive(1e3), absent "chosen by the solver";
        /// Error alpha allows in a step of varying length: in positions by the length L of the longest line, in velocities by 2 sqrt(g L).
        step_tolerance: f64 = 2e-5, "step tolerance", range positive(1.0);
        /// Longest step that alpha takes where its steps vary.
        longest_step_s: Option<f64>, "longest step", range positive(1e3), absent "a twentieth of the shortest forced period";
        /// Spectral radius of generalized-alpha at infinite frequency: 0 damps most, 1 not at all.
        rho_inf: f64 = 0.4, "rho infinity", range of(0.0, 1.0);
        /// Newton iterations a step may take before it is halved.
        max_iterations: usize = 30, "greatest iterations", range of(1.0, 1e4);
        /// Newton stops when no node moves by more than this; across the line by a tenth of what a step may err, where steps vary.
        position_tolerance_m: f64 = 1e-5, "position tolerance", range positive(1.0);
        /// Whether companion runs estimate the time and mesh error of every result.
        error_estimate: bool = true, "error estimate";
        /// `nearest` for dearer companion runs and tighter error bars; or each, from the finest, by what is coarser: `steps` or `mesh`.
        companions: Option<Vec<String>>, "companions", absent "chosen by the solver";
        /// Choose mesh and steps such that 95 % of the results err by less than this share of their channel's range.
        accuracy: Option<f64>, "accuracy", range of(1e-7, 0.5), absent "mesh and steps as set";
        /// Wall time after which the search for an accuracy takes no dearer round.
        budget_s: Option<f64>, "budget", range positive(1e6), absent "60 s";
    }
}

words! {
    /// The solvers.
    #[derive(Default, clap::ValueEnum)]
    pub enum Method {
        /// Static equilibrium by Newton on the nodes.
        Static = "static",
        /// Quasi-static march: equilibrium of weight and drag at each instant, inertia left out.
        Quasi = "quasi",
        /// Explicit Runge-Kutta of order 4.
        Rk4 = "rk4",
        /// Implicit generalized-alpha.
        #[default]
        Alpha = "alpha",
        /// Runge-Kutta or generalized-alpha, whichever is estimated to cost less; the run reports which and why.
        Auto = "auto",
    }
}

impl Method {
    /// Order of its error in the step; nothing of what takes none.
    #[must_use]
    pub fn order(self) -> Option<f64> {
        match self {
            Self::Static => None,
            Self::Quasi | Self::Alpha | Self::Auto => Some(2.0),
            Self::Rk4 => Some(4.0),
        }
    }
}

table! {
    /// What is recorded and how often.
    #[derive(Debug, Clone, PartialEq)]
    pub struct Output => OutputKeys {
        /// Interval of the time history.
        interval_s: f64 = 0.5, "history interval", range positive(1e5);
        /// Interval of the stored line shapes.
        shape_interval_s: f64 = 5.0, "shape interval", range positive(1e6);
        /// Whether the energy is recorded: kinetic, of position and of stretch, bending and bed; of bodies of systems the kinetic alone.
        energy: bool = false, "energy";
        /// Whether the upward pull of the lines on fixed points and held ends is recorded, as uplift_n.
        uplift: bool = false, "uplift of anchors";
        /// Whether the force of the lines on fixed and moved points and held ends is recorded, as force_x_n, force_y_n, force_z_n.
        forces: Option<bool>, "forces on held points", absent "of a line between two ends, not of a system";
        /// From this time on root mean square displacements along lines are taken, about the mean.
        response_from_s: Option<f64>, "response from", range of(0.0, 1e6), absent "not used";
    }
}

table! {
    /// Natural modes about the static shape of a line or about the rest of a system, reported with the results of a run.
    #[derive(Debug, Clone, PartialEq)]
    pub struct Modes => ModesKeys {
        /// How many natural modes, the lowest first.
        count: usize = 10, "modes", range of(1.0, 1000.0);
        /// A frequency, such as that of the waves: the run reports which mode is nearest.
        near_hz: Option<f64>, "near", range positive(1e3), absent "not used";
    }
}

table! {
    /// A sea bed: level, sloping evenly, or with depths over a grid of places; rigid below lines of systems that are closed forms.
    #[derive(Debug, Clone, PartialEq)]
    pub struct Seabed => SeabedKeys {
        /// Depth of the bed below still water, at depth_at_m where it slopes; with depth_file that which waves feel.
        depth_m: f64, "depth", range of(0.0, 2e4);
        /// Where the bed has that depth, x and y; matters on a slope.
        depth_at_m: [f64; 2] = [0.0, 0.0], "place of the depth", range of(-1e6, 1e6);
        /// How steeply the bed rises towards slope_azimuth_deg; negative where it falls. It pushes along its normal.
        slope_deg: f64 = 0.0, "slope", range of(-80.0, 80.0);
        /// Direction in which the bed rises, from +x towards +y.
        slope_azimuth_deg: f64 = 0.0, "slope azimuth", range of(-360.0, 360.0);
        /// CSV file of depths, x_m,y_m,depth_m on a rectangular grid, in the place of level and slope; beyond it its edge.
        depth_file: Option<String>, "file of depths", absent "the bed is level or a plane";
        /// How the depth goes between the places of that file.
        interpolation: BedInterpolation = BedInterpolation::Smooth, "interpolation";
        /// Push of the bed per area of line and depth below it; on lines divided into segments, in motion all.
        stiffness_n_per_m3: f64 = 1.0e5, "stiffness", range positive(1e12);
        /// Push of the bed per area of line and speed into it, in motion; with friction, along the bed as well.
        damping_n_s_per_m3: f64 = 0.0, "damping", range of(0.0, 1e12);
        /// Friction along lines by the weight that the bed bears, and across them unless friction_lateral is given.
        friction: Option<f64>, "friction", range of(0.0, 10.0), absent "no friction";
        /// Friction across lines: on lines divided into segments, in motion all.
        friction_lateral: Option<f64>, "friction across", range of(0.0, 10.0), absent "as along the line";
        /// grip holds at rest and slides beyond; zhu-2017 goes with the velocity and holds nothing.
        friction_law: FrictionLaw = FrictionLaw::Grip, "friction law";
        /// Friction per area of line and distance pulled, before it slides.
        grip_stiffness_n_per_m3: Option<f64>, "grip stiffness", range positive(1e12), absent "as the stiffness";
        /// Below it friction by zhu-2017 is in proportion to the speed.
        slip_speed_m_per_s: f64 = 0.01, "slip speed", range positive(10.0);
    }
}

words! {
    /// How the depth of the bed goes between the places of a grid.
    #[derive(Default)]
    pub enum BedInterpolation {
        /// Bilinear: the slope has kinks at the lines of the grid.
        Bilinear = "bilinear",
        /// By cubic polynomials, with a continuous slope.
        #[default]
        Smooth = "smooth",
    }
}

words! {
    /// How friction of the bed acts.
    #[derive(Default)]
    pub enum FrictionLaw {
        /// Holds at rest by a spring, and is dragged along beyond what friction bears.
        #[default]
        Grip = "grip",
        /// Against the velocity and in proportion to it below a slip speed (Zhu, Yin and Shen 2017, eq. 9); holds nothing.
        Zhu2017 = "zhu-2017",
    }
}
