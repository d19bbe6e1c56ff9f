//! A user's own curve as a file in TOML.
//!
//! ```toml
//! [curve]
//! title = "Chain 84 mm"
//! kind = "stress"              # or "tension": range over the reference strength
//! m = 3.0
//! k = 6.0e10                   # or log_k = 10.778; of stresses in MPa
//! mean_slope = 0.0             # log10 K = log_k - mean_slope * Lm
//! range = "double-amplitude"   # or "amplitude"
//! diameter_m = 0.084
//! nominal_area_m2 = 0.01108    # or component = "chain" or "rope", from the diameter
//! reference_strength_n = 7.0e6
//! knee = { cycles = 1e7, m = 5.0 }
//! thickness = { thickness_m = 0.084, reference_m = 0.025, exponent = 0.25 }
//! ```
//!
//! Instead of `kind`, `m`, `k` and what belongs to them, `library = "dnv-studless-chain"` takes a published curve.

use super::component::{FatigueComponent, Measure, RangeKind, chain_area, rope_area};
use super::curve::{CurveError, Knee, Law, check};
use super::curve_library::{PUBLISHED, published};
use crate::files::shallow::shallow;
use serde::Deserialize;

/// Why a file is no curve.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum CurveFileError {
    /// It is no TOML, lacks a key or has one that is unknown.
    #[error("the curve cannot be read: {0}")]
    Syntax(String),
    /// A key that is missing beside others.
    #[error("the curve needs {needed}")]
    Missing {
        /// What is missing.
        needed: &'static str,
    },
    /// Two keys that exclude each other.
    #[error("the curve has {one} and {other}; it takes one of them")]
    Both {
        /// The one.
        one: &'static str,
        /// The other.
        other: &'static str,
    },
    /// A published curve that there is not.
    #[error("there is no published curve {id:?}; there are {known}")]
    Unknown {
        /// Its name.
        id: String,
        /// Names that there are.
        known: String,
    },
    /// A number that is out of bounds.
    #[error(transparent)]
    Curve(#[from] CurveError),
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    curve: CurveTable,
}

/// What the range of a curve is related to.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum FileRangeKind {
    /// The reference strength.
    Tension,
    /// The nominal area, in MPa.
    Stress,
}

/// What the range of a curve is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum FileRange {
    /// From trough to crest.
    #[default]
    DoubleAmplitude,
    /// Half of it.
    Amplitude,
}

/// Whose nominal area a diameter gives.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum FileComponent {
    /// Both bars of a link.
    Chain,
    /// The circle about a rope.
    Rope,
}

/// A second slope.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FileKnee {
    /// Cycles to failure at the knee.
    pub cycles: f64,
    /// Exponent beyond.
    pub m: f64,
}

/// Ranges grow by `(thickness / reference)^exponent` above the reference thickness (DNV-RP-C203, 2.4.3).
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FileThickness {
    /// Thickness, m.
    pub thickness_m: f64,
    /// Reference thickness of the curve, m.
    pub reference_m: f64,
    /// Exponent.
    pub exponent: f64,
}

impl FileThickness {
    fn factor(&self) -> Result<f64, CurveError> {
        let bounds = "from 1e-4 to 100 m";
        check("the thickness in m", self.thickness_m, 1e-4..=100.0, bounds)?;
        check(
            "the reference thickness in m",
            self.reference_m,
            1e-4..=100.0,
            bounds,
        )?;
        check(
            "the exponent of the thickness",
            self.exponent,
            0.0..=1.0,
            "from 0 to 1",
        )?;
        Ok((self.thickness_m / self.reference_m)
            .max(1.0)
            .powf(self.exponent))
    }
}

/// The table `[curve]`.
#[derive(Debug, Clone, PartialEq, Default, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct CurveTable {
    /// What it is called.
    pub title: Option<String>,
    /// Name of a published curve.
    pub library: Option<String>,
    /// What its range is related to.
    pub kind: Option<FileRangeKind>,
    /// Exponent.
    pub m: Option<f64>,
    /// Constant K.
    pub k: Option<f64>,
    /// Its logarithm to base 10.
    pub log_k: Option<f64>,
    /// By how much a mean load of the whole strength lowers that logarithm.
    pub mean_slope: Option<f64>,
    /// What its range is.
    pub range: Option<FileRange>,
    /// Reference strength, N.
    pub reference_strength_n: Option<f64>,
    /// Nominal area, m2.
    pub nominal_area_m2: Option<f64>,
    /// Whose area the diameter gives.
    pub component: Option<FileComponent>,
    /// Nominal diameter, m.
    pub diameter_m: Option<f64>,
    /// Second slope.
    pub knee: Option<FileKnee>,
    /// Thickness.
    pub thickness: Option<FileThickness>,
}

/// Reads a file.
///
/// # Errors
/// What is no TOML or no curve, with what would be one.
pub fn read_curve(text: &str) -> Result<FatigueComponent, CurveFileError> {
    let file: File =
        toml::from_str(shallow(text)).map_err(|e| CurveFileError::Syntax(e.to_string()))?;
    file.curve.component()
}

impl CurveTable {
    /// The component of the table.
    ///
    /// # Errors
    /// Keys that are missing or exclude each other; numbers out of bounds.
    pub fn component(&self) -> Result<FatigueComponent, CurveFileError> {
        let component = match &self.library {
            Some(id) => self.published_one(id)?,
            None => self.own()?,
        };
        match self.thickness {
            Some(thickness) => Ok(component.with_range_factor(thickness.factor()?)?),
            None => Ok(component),
        }
    }

    fn published_one(&self, id: &str) -> Result<FatigueComponent, CurveFileError> {
        let own = [
            ("kind", self.kind.is_some()),
            ("m", self.m.is_some()),
            ("k", self.k.is_some()),
            ("log_k", self.log_k.is_some()),
            ("mean_slope", self.mean_slope.is_some()),
            ("range", self.range.is_some()),
            ("nominal_area_m2", self.nominal_area_m2.is_some()),
            ("component", self.component.is_some()),
            ("knee", self.knee.is_some()),
        ];
        if let Some(&(other, _)) = own.iter().find(|(_, is_there)| *is_there) {
            return Err(CurveFileError::Both {
                one: "library",
                other,
            });
        }
        let curve = published(id).ok_or_else(|| CurveFileError::Unknown {
            id: id.to_owned(),
            known: PUBLISHED.map(|curve| curve.id).join(", "),
        })?;
        let title = self.title.as_deref().unwrap_or(curve.title);
        let component = curve.component(self.diameter_m, self.reference_strength_n)?;
        Ok(component.with_title(title))
    }

    fn own(&self) -> Result<FatigueComponent, CurveFileError> {
        let needed = |needed: &'static str| CurveFileError::Missing { needed };
        let kind = self
            .kind
            .ok_or_else(|| needed("kind = \"tension\" or \"stress\", or library"))?;
        let mut law = Law::new(
            self.m.ok_or_else(|| needed("the exponent m"))?,
            self.constant()?,
        );
        law.mean_slope = self.mean_slope.unwrap_or(0.0);
        law.knee = self.knee.map(|FileKnee { cycles, m }| Knee {
            cycles,
            exponent: m,
        });
        let measure = match kind {
            FileRangeKind::Tension => Measure::TensionRatio,
            FileRangeKind::Stress => Measure::Stress {
                nominal_area: self.area()?,
            },
        };
        let range = match self.range.unwrap_or_default() {
            FileRange::DoubleAmplitude => RangeKind::DoubleAmplitude,
            FileRange::Amplitude => RangeKind::Amplitude,
        };
        let title = self.title.as_deref().unwrap_or("own curve");
        let component = FatigueComponent::new(title, law, measure, self.reference_strength_n)?;
        Ok(component.with_range_kind(range))
    }

    fn constant(&self) -> Result<f64, CurveFileError> {
        match (self.k, self.log_k) {
            (Some(k), None) => {
                Ok(check("the constant k", k, 1e-100..=1e100, "from 1e-100 to 1e100")?.log10())
            }
            (None, Some(log_k)) => Ok(log_k),
            (Some(_), Some(_)) => Err(CurveFileError::Both {
                one: "k",
                other: "log_k",
            }),
            (None, None) => Err(CurveFileError::Missing {
                needed: "the constant k or its logarithm log_k",
            }),
        }
    }

    fn area(&self) -> Result<f64, CurveFileError> {
        match (self.nominal_area_m2, self.component, self.diameter_m) {
            (Some(_), Some(_), _) => Err(CurveFileError::Both {
                one: "nominal_area_m2",
                other: "component",
            }),
            (Some(area), None, _) => Ok(area),
            (None, Some(component), Some(diameter)) => {
                check(
                    "the diameter in m",
                    diameter,
                    1e-4..=10.0,
                    "from 1e-4 to 10 m",
                )?;
                Ok(match component {
                    FileComponent::Chain => chain_area(diameter),
                    FileComponent::Rope => rope_area(diameter),
                })
            }
            _ => Err(CurveFileError::Missing {
                needed: "nominal_area_m2, or component with diameter_m",
            }),
        }
    }
}

#[cfg(test)]
mod tests;
