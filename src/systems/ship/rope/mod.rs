//! The rope between the moving ship and a platform: the ropeway's hang-off point follows the ship's motion, with the rope made
//! fast and held by its winch, each instant an equilibrium; and the expected maximum tension.
//!
//! With the rope made fast, its tension is a smooth function of the position of the hang-off point. For the records of many
//! seeds a `TensionSurface` over the positions of the file's record, with a margin, locates the instants of maximum tension;
//! the exact rope then gives the tension at these.

pub mod dynamic;
pub mod hang_off;
mod tension_surface;

use std::path::Path;

use rayon::prelude::*;

use self::dynamic::DynamicRope;
pub use self::hang_off::HangOffMotion;
use self::tension_surface::{TensionSurface, exact_tension};
use super::model::MotionSettings;
use super::motion::wave_response::WaveResponse;
use super::motion::{ShipMotion, point_displacement};
use crate::case::{ReadFile, kind};
use crate::files::root;
use crate::numerics::V3;
use crate::numerics::statistics::Gumbel;
use crate::ropeway::winch::ShipOffset;
use crate::ropeway::{Ropeway, RopewayError, SolvedRopeway, WinchRun};

/// Instants of a record at which the exact tension is computed.
const TOP: usize = 100;

/// The rope while the ship moves.
#[derive(Debug, Clone, PartialEq)]
pub struct RopeAnalysis {
    /// The ropeway.
    pub ropeway: SolvedRopeway,
    /// Positions of its hang-off point.
    pub series: Vec<ShipOffset>,
    /// Made fast, and held by the winch.
    pub winch: WinchRun,
    /// Maximum tensions of several records with the rope made fast, the file's own first; empty without a solution \[N\].
    pub maxima_n: Vec<f64>,
    /// The distribution fitted to them.
    pub gumbel: Option<Gumbel>,
    /// Whether records of other seeds exist.
    pub more_seeds: bool,
    /// The rope made fast on the dynamic solver around its maximum tension; absent without a solution.
    pub dynamic: Option<Result<DynamicRope, RopewayError>>,
}

impl RopeAnalysis {
    /// Follows the hang-off point with the ropeway of the settings. `folder` is that of the ship's file.
    ///
    /// # Errors
    /// In words: a ropeway that cannot be read or has no solution.
    pub fn load(hang_off: &HangOffMotion<'_>, folder: &Path) -> Result<Self, String> {
        let name = &hang_off.rope.ropeway;
        let place = root::place(folder, name).map_err(|error| format!("{name}: {error}"))?;
        let read = kind::read_toml::<Ropeway>(&folder.join(name));
        let ropeway = read.and_then(ReadFile::compute).map_err(|all| {
            match all.first().filter(|_| !place.is_outside) {
                Some(first) => first.to_string(),
                None => "it cannot be read".to_owned(),
            }
        })?;
        Self::new(hang_off, ropeway)
    }

    /// Follows the hang-off point with a ropeway.
    ///
    /// # Errors
    /// In words, where the ropeway has no solution.
    pub fn new(hang_off: &HangOffMotion<'_>, ropeway: SolvedRopeway) -> Result<Self, String> {
        let series = hang_off.series(ropeway.ropeway.about.span_m);
        let winch = ropeway
            .run_winch(&series)
            .map_err(|error| error.to_string())?;
        let mut analysis = Self {
            ropeway,
            series,
            winch,
            maxima_n: Vec::new(),
            gumbel: None,
            more_seeds: hang_off.seeds.is_some(),
            dynamic: None,
        };
        if let Ok(fast) = &analysis.winch.made_fast {
            let own = fast.iter().fold(0.0_f64, |m, moment| m.max(moment.ship_n));
            analysis.maxima_n = vec![own];
            analysis.dynamic = Some(DynamicRope::new(&analysis.ropeway, fast, hang_off.step));
            if let Some((settings, response)) = hang_off.seeds {
                analysis.add_seeds(hang_off, settings, response)?;
            }
        }
        Ok(analysis)
    }

    /// Adds the maximum tensions of the records of other seeds, and fits their distribution.
    fn add_seeds(
        &mut self,
        hang_off: &HangOffMotion<'_>,
        settings: &MotionSettings,
        response: Option<&WaveResponse>,
    ) -> Result<(), String> {
        let surface =
            TensionSurface::new(&self.ropeway, &self.series).map_err(|e| e.to_string())?;
        let Some(surface) = surface else {
            return Ok(());
        };
        let arm = V3::from(settings.hang_point_m);
        let span = self.ropeway.ropeway.about.span_m;
        let exact = exact_tension(&self.ropeway).map_err(|error| error.to_string())?;
        let maximum = |record: usize| {
            let motion =
                ShipMotion::new(settings, response, settings.seed() + record as u64).ok()?;
            let records = motion.records();
            let positions = (0..motion.instants)
                .map(|i| hang_off.in_plane(&point_displacement(&records, &arm, i), span));
            let mut ranked: Vec<(f64, (f64, f64))> =
                positions.map(|(x, z)| (surface.at(x, z), (x, z))).collect();
            ranked.sort_by(|a, b| b.0.total_cmp(&a.0));
            let top = ranked.iter().take(TOP).map(|(_, (x, z))| exact(*x, *z));
            top.reduce(|a, b| Some(a?.max(b?)))?
        };
        let others: Option<Vec<f64>> = (1..hang_off.rope.records)
            .into_par_iter()
            .map(maximum)
            .collect();
        let too_short = "in the record of another seed the rope is too short";
        self.maxima_n.extend(others.ok_or(too_short)?);
        self.gumbel = Gumbel::fit(&self.maxima_n);
        Ok(())
    }
}
