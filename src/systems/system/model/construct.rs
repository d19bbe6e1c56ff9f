//! Parts of systems built in code by their required keys, all others as in a file that leaves them out.
//!
//! A weight on a rope between two points:
//!
//! ```
//! use seacable_model::case::Material;
//! use seacable_systems::system::model::{LineInputs, PointInputs, SystemFile};
//! use seacable_systems::system::solved::solve;
//!
//! let mut system = SystemFile::new("Weight on a rope");
//! system.environment.water_density_kg_per_m3 = 0.0;
//! system.materials.insert("rope".into(), Material::new(0.02, 1.1, 2e7));
//! for (name, point) in [
//!     ("left", PointInputs::fixed([0.0, 0.0, 20.0])),
//!     ("weight", PointInputs::free(50.0, [30.0, 0.0, 15.0])),
//!     ("right", PointInputs::fixed([80.0, 0.0, 20.0])),
//! ] {
//!     system.points.insert(name.into(), point);
//! }
//! system.lines = vec![
//!     LineInputs::new("one", ["left", "weight"], "rope", 31.0, 30),
//!     LineInputs::new("two", ["weight", "right"], "rope", 51.0, 50),
//! ];
//! assert!(solve(system).is_ok());
//! ```

use crate::case::{CaseInfo, OneOrMany};

use super::{
    LineInputs, PayoutInputs, PointInputs, PointKind, SlidingInputs, SystemFile, WhichEnd,
};

impl SystemFile {
    /// A system of this title without materials, points and lines.
    #[must_use]
    pub fn new(title: &str) -> Self {
        Self {
            about: CaseInfo {
                title: title.to_owned(),
                ..CaseInfo::default()
            },
            ..Self::default()
        }
    }
}

impl PointInputs {
    /// A point held at a place \[m\].
    #[must_use]
    pub fn fixed(position_m: [f64; 3]) -> Self {
        Self {
            position_m: Some(position_m),
            ..Self::of(PointKind::Fixed)
        }
    }

    /// A point that moves about a place \[m\] by amplitudes \[m\] and periods \[s\] along x, y, z.
    #[must_use]
    pub fn moved(position_m: [f64; 3], amplitude_m: [f64; 3], periods_s: [f64; 3]) -> Self {
        Self {
            position_m: Some(position_m),
            amplitude_m,
            period_s: Some(OneOrMany::Many(periods_s.to_vec())),
            ..Self::of(PointKind::Moved)
        }
    }

    /// A free point of a mass \[kg\], where its search begins \[m\].
    #[must_use]
    pub fn free(mass_kg: f64, position_m: [f64; 3]) -> Self {
        Self {
            position_m: Some(position_m),
            mass_kg,
            ..Self::of(PointKind::Free)
        }
    }
}

impl LineInputs {
    /// A line of one material between two points, its unstretched length \[m\] divided into segments.
    #[must_use]
    pub fn new(
        name: &str,
        [from, to]: [&str; 2],
        material: &str,
        length_m: f64,
        segments: usize,
    ) -> Self {
        Self {
            name: name.to_owned(),
            from: from.to_owned(),
            to: to.to_owned(),
            material: Some(material.to_owned()),
            length_m: Some(length_m),
            segments: Some(segments),
            ..Self::default()
        }
    }
}

impl SlidingInputs {
    /// A point hauled along two lines at a rate \[m/s\], from the first towards the other, which grows over a ramp \[s\].
    #[must_use]
    pub fn hauled(point: &str, [line, other]: [&str; 2], rate_m_per_s: f64, ramp_s: f64) -> Self {
        Self {
            point: point.to_owned(),
            line: line.to_owned(),
            other: other.to_owned(),
            rate_m_per_s: Some(rate_m_per_s),
            ramp_s,
            ..Self::default()
        }
    }
}

impl PayoutInputs {
    /// A winch that keeps a tension \[N\] at an end of a line.
    #[must_use]
    pub fn at_tension(line: &str, end: WhichEnd, tension_n: f64) -> Self {
        Self {
            line: line.to_owned(),
            end,
            tension_n: Some(tension_n),
            ..Self::default()
        }
    }
}
