//! The line: materials, sections, floats.

use super::one_or_many::OneOrMany;
use crate::case::TomlNode;
use crate::case::fields::ValueType::{self, Name, NumberOrChoice, NumberOrTriple};
use crate::case::fields::{of, positive};
use crate::case::schema::{FromDefault, KeyValue, table, words};

const NORMAL_DRAG: ValueType = NumberOrChoice(&["jia-2019-normal"]);
const TANGENTIAL_DRAG: ValueType = NumberOrChoice(&["jia-2019-tangential"]);

table! {
    /// What a stretch of line is made of.
    #[derive(Debug, Clone, PartialEq)]
    pub struct Material => MaterialKeys {
        /// Outer diameter, which drag, buoyancy and added mass refer to.
        diameter_m: f64, "diameter", range positive(10.0);
        /// Mass in air per unstretched length.
        mass_kg_per_m: f64, "mass", range positive(1e6);
        /// Weight in water, as mass per unstretched length; negative floats.
        wet_weight_kg_per_m: Option<f64>, "wet weight", range of(-1e6, 1e6), absent "mass less displaced water";
        /// Tension per strain.
        ea_n: Option<f64>, "axial stiffness EA", range positive(1e13), unless strain;
        /// Strains of a table in the place of ea_n, rising from 0; straight on beyond the last.
        strain: Option<Vec<f64>>, "table of strains", range of(0.0, 10.0), absent "tension is EA times strain";
        /// Tensions at those strains, rising from 0.
        tension_n: Option<Vec<f64>>, "table of tensions", range of(0.0, 1e13), absent "tension is EA times strain";
        /// How the tension goes between the rows of the table.
        tension_interpolation: TensionInterpolation = TensionInterpolation::Smooth, "table interpolation";
        /// Stiffness of a fibre rope that goes with its past tension: through the origin, or about the mean state.
        dynamic_stiffness: DynamicStiffness = DynamicStiffness::None, "dynamic stiffness";
        /// alpha of EA by breaking load = alpha + beta Lm - gamma La, in motion.
        dynamic_alpha: Option<f64>, "alpha", range positive(1e4), absent "not used";
        /// beta, by the mean of the past tension Lm in percent of the breaking load.
        dynamic_beta: f64 = 0.0, "beta", range of(0.0, 1e3);
        /// gamma, by the deviation La of the tension from its mean in percent of the breaking load.
        dynamic_gamma: f64 = 0.0, "gamma", range of(0.0, 1e3);
        /// Time over which the past tension is averaged.
        mean_window_s: Option<f64>, "window of the mean", range positive(1e6), absent "all of the past";
        /// Whether each segment has the dynamic stiffness of its own tension, or all of a rope have that of its average.
        stiffness_scope: StiffnessScope = StiffnessScope::Segment, "scope of the stiffness";
        /// Slow part of a fibre rope beside its fast part: one static curve, or the working curves of the Syrope model.
        creep_model: CreepModel = CreepModel::None, "creep";
        /// Stiffness of the fast part, which motion meets, at no mean tension.
        dynamic_ea_n: Option<f64>, "dynamic stiffness EA", range positive(1e13), absent "not used";
        /// By how much that stiffness grows with the mean tension: newtons per newton.
        dynamic_ea_per_tension: f64 = 0.0, "growth of dynamic EA", range of(0.0, 1e4);
        /// Tension per strain rate of the slow part: the greater, the slower the rope creeps.
        slow_damping_n_s: Option<f64>, "slow damping", range positive(1e16), absent "not used";
        /// Tension per strain rate of the fast part.
        fast_damping_n_s: f64 = 0.0, "fast damping", range of(0.0, 1e13);
        /// Shape of the curves on which a Syrope rope is unloaded, between no tension and the greatest mean tension so far.
        working_curve: WorkingCurveShape = WorkingCurveShape::Linear, "working curve";
        /// k of that shape: of a quadratic curve `s (k s + 1 - k)`, of an exponential one `(exp(k s) - 1) / (exp(k) - 1)`.
        working_curve_shape: Option<f64>, "working curve shape", range of(-50.0, 50.0), absent "not used";
        /// Strain of a working curve without tension by its greatest strain. Give this or working_curve_ea_n.
        permanent_strain_ratio: Option<f64>, "permanent strain ratio", range of(0.0, 0.99), absent "by working_curve_ea_n";
        /// Stiffness of a working curve from end to end. Give this or permanent_strain_ratio.
        working_curve_ea_n: Option<f64>, "working curve EA", range positive(1e13), absent "by permanent_strain_ratio";
        /// Greatest mean tension of the past, from which a Syrope rope was unloaded.
        past_tension_n: f64 = 0.0, "greatest past tension", range of(0.0, 1e12);
        /// Mean tension that a motion begins with; the rope then creeps from there to its rest.
        initial_mean_tension_n: Option<f64>, "initial mean tension", range of(0.0, 1e12), absent "the tension at rest";
        /// Moment per curvature; 0 for ropes and chains. What bends also bears compression.
        ei_n_m2: f64 = 0.0, "bending stiffness EI", range of(0.0, 1e12);
        /// Tension per strain rate. Give this or axial_damping_ratio.
        axial_damping_n_s: Option<f64>, "axial damping", range of(0.0, 1e13), absent "no axial damping";
        /// Fraction of critical of a segment's highest axial mode. Give this or axial_damping_n_s.
        axial_damping_ratio: Option<f64>, "axial damping ratio", range of(0.0, 10.0), absent "no axial damping";
        /// Rayleigh's alpha: each node is slowed by alpha times its velocity and its mass with floats and normal added mass.
        mass_damping_per_s: f64 = 0.0, "mass damping", range of(0.0, 100.0);
        /// Coefficient on the diameter, or a law of the Reynolds number by name.
        drag_normal: DragCoefficient = 0.0, "normal drag", kind NORMAL_DRAG, range of(0.0, 100.0);
        /// Coefficient on the width below, or a law of the Reynolds number by name.
        drag_tangential: DragCoefficient = 0.0, "tangential drag", kind TANGENTIAL_DRAG, range of(0.0, 100.0);
        /// What tangential drag refers to: the diameter D, or the perimeter pi D.
        drag_tangential_width: DragWidth = DragWidth::Diameter, "tangential drag width";
        /// Drag coefficient times width, across the line, of what is spread along it beside its own normal drag: floats, fairings.
        attached_drag_width_m: f64 = 0.0, "drag of attachments", range of(0.0, 1e3);
        /// Coefficient on the displaced volume, across the line.
        added_mass_normal: f64 = 1.0, "normal added mass", range of(0.0, 100.0);
        /// Coefficient on the displaced volume, along the line.
        added_mass_tangential: f64 = 0.0, "tangential added mass", range of(0.0, 100.0);
        /// Minimum breaking load; the run warns where the tension comes to more.
        break_load_n: Option<f64>, "breaking load", range positive(1e12), absent "not used";
        /// Smallest radius it may be bent to; the run warns where it is bent more sharply.
        min_bend_radius_m: Option<f64>, "least bending radius", range positive(1e5), absent "not used";
    }
    tables {
        /// The bore of a pipe, for the tension of its wall; absent means that none is computed.
        bore: Option<Bore>;
    }
}

table! {
    /// The bore of a pipe and its content, which is part of the material's mass_kg_per_m and wet_weight_kg_per_m.
    #[derive(Debug, Clone, PartialEq)]
    pub struct Bore => BoreKeys {
        /// Inner diameter of the pipe.
        diameter_m: f64, "bore", range positive(10.0);
        /// Density of the content, for its pressure over depth; its mass is part of mass_kg_per_m already, and not added.
        content_density_kg_per_m3: f64 = 0.0, "content density", range of(0.0, 2e4);
        /// Inner pressure over the atmosphere's, at pressure_height_m.
        pressure_pa: f64 = 0.0, "inner pressure", range of(-1e5, 1e9);
        /// Height above still water at which the inner pressure is given, such as that of the top end.
        pressure_height_m: f64 = 0.0, "height of the pressure", range of(-2e4, 2e4);
    }
}

words! {
    /// How the tension goes between the rows of a table of strains and tensions.
    #[derive(Default)]
    pub enum TensionInterpolation {
        /// By a curve without kinks that rises everywhere.
        #[default]
        Smooth = "smooth",
        /// Straight, as MoorDyn reads its tables.
        Linear = "linear",
    }
}

words! {
    /// How dynamic stiffness (Zhu, Yin and Shen 2017, eq. 1) makes a tension.
    #[derive(Default)]
    pub enum DynamicStiffness {
        /// Not at all: the static stiffness holds in motion too.
        #[default]
        None = "none",
        /// As a secant through the origin of strain, as in the paper.
        Secant = "secant",
        /// About the mean state, up to which the static stiffness holds.
        AboutTheMean = "about-the-mean",
    }
}

words! {
    /// What has a dynamic stiffness of its own (Zhu, Yin and Shen 2017, secs 1.2 and 1.3).
    #[derive(Default)]
    pub enum StiffnessScope {
        /// Each segment, by the mean and the deviation of its own tension.
        #[default]
        Segment = "segment",
        /// The whole rope, by the mean and the deviation of the tension averaged along it.
        Rope = "rope",
    }
}

words! {
    /// The slow part of a fibre rope.
    #[derive(Default)]
    pub enum CreepModel {
        /// None: the rope stretches at once.
        #[default]
        None = "none",
        /// A spring and a damper, in series with those of the fast part.
        Viscoelastic = "viscoelastic",
        /// The same, the spring following an original curve and working curves.
        Syrope = "syrope",
    }
}

words! {
    /// Shape of the working curves of a Syrope rope.
    #[derive(Default)]
    pub enum WorkingCurveShape {
        /// Straight.
        #[default]
        Linear = "linear",
        /// A parabola.
        Quadratic = "quadratic",
        /// An exponential.
        Exponential = "exponential",
    }
}

/// A drag coefficient, constant or from a named law of the Reynolds number.
#[derive(Debug, Clone, PartialEq)]
pub enum DragCoefficient {
    /// The same at every Reynolds number.
    Constant(f64),
    /// A law by name.
    Named(DragLawName),
}

impl KeyValue for DragCoefficient {
    const KIND: ValueType = NumberOrChoice(&["jia-2019-normal", "jia-2019-tangential"]);

    fn blank() -> Self {
        Self::Constant(0.0)
    }

    fn read(node: &TomlNode) -> Option<Self> {
        let constant = node.number().map(Self::Constant);
        constant.or_else(|| DragLawName::read(node).map(Self::Named))
    }

    fn write(&self) -> toml_edit::Value {
        match self {
            Self::Constant(value) => value.write(),
            Self::Named(law) => law.write(),
        }
    }
}

impl FromDefault<f64> for DragCoefficient {
    fn from_default(declared: f64) -> Self {
        Self::Constant(declared)
    }
}

words! {
    /// The drag laws known by name.
    pub enum DragLawName {
        /// Normal drag of Jia et al. 2019, eq. (4).
        Jia2019Normal = "jia-2019-normal",
        /// Tangential drag of Jia et al. 2019, eq. (5).
        Jia2019Tangential = "jia-2019-tangential",
    }
}

words! {
    /// The width that tangential drag is referred to.
    #[derive(Default)]
    pub enum DragWidth {
        /// The diameter D.
        #[default]
        Diameter = "diameter",
        /// The perimeter πD.
        Perimeter = "perimeter",
    }
}

table! {
    /// A section of the line.
    #[derive(Debug, Clone, PartialEq)]
    pub struct Section => SectionKeys {
        /// Name of the section, used in channel names and key paths.
        name: String, "name", kind Name;
        /// Name of its material.
        material: String, "material";
        /// Unstretched length.
        length_m: f64, "length", range positive(1e5);
        /// Number of segments the section is divided into.
        segments: usize, "segments", range of(1.0, 1e4);
    }
}

table! {
    /// Floats spread evenly over a stretch of a section.
    #[derive(Debug, Clone, PartialEq)]
    pub struct Floats => FloatsKeys {
        /// The section they sit on.
        section: Option<String>, "section", absent "that of a line which has one";
        /// Where the stretch begins, from the section's end nearer to A.
        from_m: f64 = 0.0, "from", range of(0.0, 1e5);
        /// Where the stretch ends, from the section's end nearer to A.
        to_m: Option<f64>, "to", range positive(1e5), absent "the section's end";
        /// Buoyancy less own weight of all of them, as mass.
        lift_kg: f64, "net lift", range of(-1e9, 1e9);
        /// Mass of all of them.
        mass_kg: f64 = 0.0, "mass", range of(0.0, 1e9);
        /// Drag coefficient times area of all of them, across the line.
        drag_area_m2: f64 = 0.0, "drag area", range of(0.0, 1e6);
        /// The same along the line.
        drag_area_tangential_m2: f64 = 0.0, "drag area along the line", range of(0.0, 1e6);
        /// Added mass of all of them, across the line.
        added_mass_kg: f64 = 0.0, "added mass", range of(0.0, 1e9);
    }
}

table! {
    /// A body hung on the line at one place: a clump weight, or a buoy where its weight in water is negative.
    #[derive(Debug, Clone, PartialEq)]
    pub struct Clump => ClumpKeys {
        /// Name of the body, used in channel names.
        name: String, "name", kind Name;
        /// The section it hangs on.
        section: Option<String>, "section", absent "that of a line which has one";
        /// Where it hangs, from the section's end nearer to A; at the node nearest to that.
        at_m: f64, "place", range of(0.0, 1e5);
        /// Mass in air.
        mass_kg: f64, "mass", range of(0.0, 1e10);
        /// Weight in water, as mass; negative for a buoy.
        wet_mass_kg: f64, "wet mass", range of(-1e10, 1e10);
        /// Drag coefficient times area: one number, or along x, y, z.
        drag_area_m2: OneOrMany = 0.0, "drag area", kind NumberOrTriple, range of(0.0, 1e6);
        /// Drag coefficient times area across the line, of a module around it and what else is aligned with it; in place of the drag area.
        drag_area_normal_m2: f64 = 0.0, "drag area across the line", range of(0.0, 1e6);
        /// The same along the line, that of a module by its length or of its ends.
        drag_area_tangential_m2: f64 = 0.0, "drag area along the line", range of(0.0, 1e6);
        /// Added mass: one number, or along x, y, z.
        added_mass_kg: OneOrMany = 0.0, "added mass", kind NumberOrTriple, range of(0.0, 1e10);
        /// Added mass across the line, of a module around it and what else is aligned with it; in place of the added mass.
        added_mass_normal_kg: f64 = 0.0, "added mass across the line", range of(0.0, 1e10);
        /// The same along the line, that of a module by its ends.
        added_mass_tangential_kg: f64 = 0.0, "added mass along the line", range of(0.0, 1e10);
        /// Area that bears on the sea bed.
        bed_area_m2: Option<f64>, "area on the bed", range of(0.0, 1e6), absent "the bottom of a cube of its volume";
        /// From the node down to what bears on the bed.
        bottom_m: f64 = 0.0, "bottom", range of(0.0, 1e3);
        /// Greatest pull by which the bed holds the body back once it has borne on it.
        breakout_n: f64 = 0.0, "breakout force", range of(0.0, 1e10);
        /// Distance off the bed at which it is free of that pull.
        breakout_distance_m: f64 = 0.1, "breakout distance", range positive(100.0);
    }
}

table! {
    /// A body that travels along the line, at a given speed: a cargo on a ropeway, a crawler.
    #[derive(Debug, Clone, PartialEq)]
    pub struct Traveller => TravellerKeys {
        /// Name of the body, used in channel names.
        name: String, "name", kind Name;
        /// Mass in air.
        mass_kg: f64, "mass", range of(0.0, 1e10);
        /// Weight in water, as mass.
        wet_mass_kg: f64, "wet mass", range of(-1e10, 1e10);
        /// Drag coefficient times area: one number, or along x, y, z.
        drag_area_m2: OneOrMany = 0.0, "drag area", kind NumberOrTriple, range of(0.0, 1e6);
        /// Unstretched length from end A at which it begins.
        from_m: f64 = 0.0, "from", range of(0.0, 1e5);
        /// Unstretched length from end A at which it stays.
        to_m: Option<f64>, "to", range of(0.0, 1e5), absent "end B";
        /// Speed along the unstretched line.
        speed_m_per_s: f64, "speed", range of(0.0, 1e3);
        /// Time at which it sets out.
        start_s: f64 = 0.0, "start", range of(0.0, 1e7);
        /// Time in which it accelerates to its speed.
        ramp_s: f64 = 0.0, "ramp", range of(0.0, 1e7);
    }
}

table! {
    /// Buoyancy modules clamped on a stretch of a section, one a pitch. Their volume, mass and drag are spread over the
    /// stretch (Lin, Guo, Niu and Zhang 2016, eqs 20 and 21).
    #[derive(Debug, Clone, PartialEq)]
    pub struct Modules => ModulesKeys {
        /// The section they sit on.
        section: Option<String>, "section", absent "that of a line which has one";
        /// Where the stretch begins, from the section's end nearer to A.
        from_m: f64 = 0.0, "from", range of(0.0, 1e5);
        /// Where the stretch ends, from the section's end nearer to A.
        to_m: Option<f64>, "to", range positive(1e5), absent "the section's end";
        /// Outer diameter of a module.
        diameter_m: f64, "diameter", range positive(50.0);
        /// Length of a module along the line.
        length_m: f64, "length", range positive(100.0);
        /// Distance from one module to the next; at least a module's length.
        pitch_m: f64, "pitch", range positive(1e3);
        /// Density of a module's material.
        density_kg_per_m3: f64, "density", range positive(2e4);
        /// Mass of what holds a module in place, each.
        fittings_kg: f64 = 0.0, "fittings", range of(0.0, 1e6);
        /// Normal drag coefficient of a module on its diameter.
        drag_normal: f64 = 0.0, "normal drag", range of(0.0, 20.0);
        /// Tangential drag coefficient of a module on its diameter.
        drag_tangential: Option<f64>, "tangential drag", range of(0.0, 20.0), absent "that of the line under it";
    }
}
