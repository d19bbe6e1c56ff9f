//! Irregular records: of waves, and of the motions of ends and points.

use crate::physics::motion::MotionPath;
use crate::physics::sea::{Component, Harmonics, Spectrum, synthesise};

/// An irregular record of a case and its components.
#[derive(Debug, Clone, PartialEq)]
pub struct IrregularRecord {
    /// `waves`, or an end with its axis.
    pub name: String,
    /// Whether it is of waves, reported by their height, or of a motion, reported by its root mean square.
    pub of_waves: bool,
    /// Seed of its frequencies and phases.
    pub seed: u64,
    /// The spectrum asked for.
    pub spectrum: Spectrum,
    /// Its components.
    pub components: Vec<Component>,
}

/// An irregular motion along x, y and z, made to its root mean square and to the peak of its spectrum.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct IrregularMotion {
    /// Root mean square along x, y, z \[m\].
    pub rms: [f64; 3],
    /// Period of the peak \[s\].
    pub peak_period: f64,
    /// Gamma of the JONSWAP spectrum.
    pub gamma: f64,
    /// Harmonics along each axis.
    pub components: usize,
    /// Seed of frequencies and phases; axes use its random streams after that of the waves.
    pub seed: u64,
}

impl IrregularMotion {
    /// The motion as a sum of harmonics.
    #[must_use]
    pub fn path(&self) -> MotionPath {
        let axes = [0, 1, 2].map(|axis| {
            let record = self.along(axis);
            record.map_or_else(Vec::new, |(_, components)| components)
        });
        MotionPath::Sum(Harmonics::along_axes(&axes))
    }

    /// The records of what moves so and has this name.
    #[must_use]
    pub fn records(&self, name: &str) -> Vec<IrregularRecord> {
        let named = ["x", "y", "z"].into_iter().enumerate();
        let one = |(axis, letter): (usize, &str)| {
            let (spectrum, components) = self.along(axis)?;
            Some(IrregularRecord {
                name: format!("{name} {letter}"),
                of_waves: false,
                seed: self.seed,
                spectrum,
                components,
            })
        };
        named.filter_map(one).collect()
    }

    /// Spectrum and components along an axis; nothing where it does not move.
    fn along(&self, axis: usize) -> Option<(Spectrum, Vec<Component>)> {
        let rms = self.rms[axis];
        let spectrum = (rms != 0.0).then(|| Spectrum::of_rms(rms, self.peak_period, self.gamma))?;
        let components = synthesise(&spectrum, self.components, self.seed, axis as u64 + 1);
        Some((spectrum, components))
    }
}
