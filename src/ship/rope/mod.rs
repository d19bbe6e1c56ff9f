//! The rope between the ship and a platform while the ship moves: the ropeway's hang point follows the ship's record, with
//! the rope made fast and held by its winch, each instant an equilibrium; and the greatest tension to expect.
//!
//! With the rope made fast its tension is a smooth function of where the hang point is. For the records of many seeds it
//! is therefore interpolated, in Chebyshev polynomials over all places that the record of the file reaches and some more,
//! to find the instants of greatest tension; the exact rope then tells the tension at these.

pub mod dynamic;

use std::f64::consts::PI;
use std::path::Path;

use rayon::prelude::*;

use self::dynamic::{DynamicRope, beside};
use crate::numerics::V3;
use crate::numerics::statistics::{Gumbel, Statistics};
use crate::ropeway::winch::{ShipOffset, WinchSample, WinchState};
use crate::ropeway::{self, RopewayError, SolvedRopeway, WinchRun};
use crate::ship::model::{Motion, Rope};
use crate::ship::motion::wave_response::WaveResponse;
use crate::ship::motion::{ShipMotion, point};
use crate::ship::motion_analysis::MotionAnalysis;

/// The rope while the ship moves.
#[derive(Debug, Clone, PartialEq)]
pub struct RopeAnalysis {
    /// The ropeway.
    pub worked: SolvedRopeway,
    /// Where its hang point is, as displaced.
    pub series: Vec<ShipOffset>,
    /// Made fast, and held by the winch.
    pub followed: WinchRun,
    /// Greatest tensions of several records with the rope made fast; the file's own first. Empty where there is no answer.
    pub maxima_n: Vec<f64>,
    /// The same with the law fitted to them.
    pub law: Option<Gumbel>,
    /// Whether records of other seeds can be made.
    pub others: bool,
    /// The rope made fast on the dynamic solver around its greatest tension, beside the equilibria; absent where the rope
    /// has none.
    pub dynamic: Option<Result<DynamicRope, RopewayError>>,
}

/// How often the winch does not keep its tension.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct WinchLimits {
    /// Instants at its greatest speed.
    pub at_speed: usize,
    /// Instants at its greatest power.
    pub at_power: usize,
    /// Instants with all rope paid out.
    pub rope_out: usize,
}

/// Where the hang point of a rope goes.
#[derive(Debug, Clone)]
pub struct HangOffMotion<'a> {
    /// The words of the rope.
    pub rope: &'a Rope,
    /// Displacements of the hang point in the axes of the ship, at equal steps from t = 0 \[m\].
    pub places: Vec<V3>,
    /// The step \[s\].
    pub step: f64,
    /// The words of the motion and how the ship answers its sea, where other records of it can be made.
    pub others: Option<(&'a Motion, Option<&'a WaveResponse>)>,
}

impl<'a> HangOffMotion<'a> {
    /// That of the ship in its sea.
    #[must_use]
    pub fn of_ship(rope: &'a Rope, settings: &'a Motion, motion: &'a MotionAnalysis) -> Self {
        Self {
            rope,
            places: motion.point_displacements(&V3::from(settings.hang_point_m)),
            step: motion.motions.step,
            others: Some((settings, motion.answer())),
        }
    }

    /// The ropeway that the rope's words name. `folder` is that of the ship's file.
    ///
    /// # Errors
    /// In words: a ropeway that cannot be read or has no answer.
    pub fn follow(&self, folder: &Path) -> Result<RopeAnalysis, String> {
        let loaded = ropeway::load(&folder.join(&self.rope.ropeway)).map_err(|all| {
            all.first()
                .map_or_else(|| "it cannot be read".to_owned(), ToString::to_string)
        })?;
        RopeAnalysis::of(self, loaded.worked)
    }

    fn place(&self, shift: &V3, span: f64) -> (f64, f64) {
        off(shift, self.rope.bearing_deg.to_radians(), span)
    }
}

impl RopeAnalysis {
    /// Follows the hang point with a ropeway that is worked out.
    ///
    /// # Errors
    /// In words, where the ropeway has no answer.
    pub fn of(course: &HangOffMotion<'_>, worked: SolvedRopeway) -> Result<Self, String> {
        let span = worked.ropeway.about.span_m;
        let at = |(i, shift): (usize, &V3)| {
            let (x_m, z_m) = course.place(shift, span);
            ShipOffset {
                time_s: course.step * i as f64,
                x_m,
                z_m,
            }
        };
        let series: Vec<ShipOffset> = course.places.iter().enumerate().map(at).collect();
        let told = |trouble: RopewayError| trouble.to_string();
        let followed = worked.run_winch(&series).map_err(told)?;
        let mut made = Self {
            worked,
            series,
            followed,
            maxima_n: Vec::new(),
            law: None,
            others: course.others.is_some(),
            dynamic: None,
        };
        if let Ok(fast) = &made.followed.made_fast {
            let own = fast.iter().fold(0.0_f64, |m, moment| m.max(moment.ship_n));
            made.maxima_n = vec![own];
            made.dynamic = Some(beside(&made.worked, fast, course.step));
            if let Some((motion, answer)) = course.others {
                made.other_records(course, motion, answer)?;
            }
        }
        Ok(made)
    }

    /// Greatest tensions of the records of other seeds.
    fn other_records(
        &mut self,
        course: &HangOffMotion<'_>,
        motion: &Motion,
        answer: Option<&WaveResponse>,
    ) -> Result<(), String> {
        let Some(surface) =
            TensionSurface::new(&self.worked, &self.series).map_err(|t| t.to_string())?
        else {
            return Ok(());
        };
        let arm = V3::from(motion.hang_point_m);
        let worked = &self.worked;
        let span = worked.ropeway.about.span_m;
        let start = worked
            .equilibrium(worked.ropeway.cargo.position)
            .map_err(|t| t.to_string())?;
        let exact = |x: f64, z: f64| {
            let there = worked.rope.moved(x, z);
            let rest = there.with_cargo_at(start.length_m, start.arc_m);
            rest.ok().map(|rest| rest.ship_n())
        };
        let greatest = |record: usize| {
            let motions = ShipMotion::new(motion, answer, motion.seed() + record as u64).ok()?;
            let records = motions.records();
            let places =
                (0..motions.instants).map(|i| course.place(&point(&records, &arm, i), span));
            let mut ranked: Vec<(f64, (f64, f64))> =
                places.map(|(x, z)| (surface.at(x, z), (x, z))).collect();
            ranked.sort_by(|a, b| b.0.total_cmp(&a.0));
            let top = ranked.iter().take(TOP).map(|(_, (x, z))| exact(*x, *z));
            top.reduce(|a, b| Some(a?.max(b?)))?
        };
        let others: Option<Vec<f64>> = (1..course.rope.records)
            .into_par_iter()
            .map(greatest)
            .collect();
        let Some(others) = others else {
            return Err("a record of another seed goes beyond the reach of the rope".to_owned());
        };
        self.maxima_n.extend(others);
        self.law = Gumbel::fit(&self.maxima_n);
        Ok(())
    }

    /// Statistics of the tension at the ship \[N\].
    #[must_use]
    pub fn tension(moments: &[WinchSample]) -> Statistics {
        let values: Vec<f64> = moments.iter().map(|moment| moment.ship_n).collect();
        Statistics::of(&values)
    }

    /// How often the winch does not keep its tension.
    #[must_use]
    pub fn winch_limits(moments: &[WinchSample]) -> WinchLimits {
        let count = |held: WinchState| moments.iter().filter(|moment| moment.state == held).count();
        WinchLimits {
            at_speed: count(WinchState::SpeedLimit),
            at_power: count(WinchState::PowerLimit),
            rope_out: count(WinchState::RopeOut),
        }
    }
}

/// Where the hang point is, away from the platform and upwards, for a shift in the axes of the ship. The platform lies at
/// a bearing \[rad\] from the bow to port, a span \[m\] away; a shift across the rope lengthens it by its square.
fn off(shift: &V3, bearing: f64, span: f64) -> (f64, f64) {
    let (sin, cos) = bearing.sin_cos();
    let away = -(shift.x * cos + shift.y * sin);
    let across = shift.y * cos - shift.x * sin;
    ((span + away).hypot(across) - span, shift.z)
}

/// Tension at the ship over the places of the hang point, interpolated.
struct TensionSurface {
    /// Middle and half width along x and z \[m\].
    frame: [(f64, f64); 2],
    /// Coefficients of the products of Chebyshev polynomials, x first.
    coefficients: Vec<[f64; NZ]>,
}

/// Polynomials along x and z.
const NX: usize = 48;
const NZ: usize = 8;

/// Instants of a record that the exact rope is asked about.
const TOP: usize = 100;

/// How much further than the series the surface goes, for records that go further.
const MORE: f64 = 1.6;

impl TensionSurface {
    /// None where the rope does not reach over all the places.
    fn new(worked: &SolvedRopeway, series: &[ShipOffset]) -> Result<Option<Self>, RopewayError> {
        let start = worked.equilibrium(worked.ropeway.cargo.position)?;
        let exact = |x: f64, z: f64| {
            let there = worked.rope.moved(x, z);
            let rest = there.with_cargo_at(start.length_m, start.arc_m);
            rest.map(|rest| rest.ship_n())
        };
        let frame = [frame(series, |p| p.x_m), frame(series, |p| p.z_m)];
        let place = |(middle, half): (f64, f64), s: f64| middle + half * s;
        let node = |i: usize, n: usize| (PI * (i as f64 + 0.5) / n as f64).cos();
        let mut values = vec![[0.0; NZ]; NX];
        for (i, row) in values.iter_mut().enumerate() {
            for (j, value) in row.iter_mut().enumerate() {
                match exact(place(frame[0], node(i, NX)), place(frame[1], node(j, NZ))) {
                    Ok(tension) => *value = tension,
                    Err(_) => return Ok(None),
                }
            }
        }
        Ok(Some(Self {
            frame,
            coefficients: coefficients(&values),
        }))
    }

    fn at(&self, x: f64, z: f64) -> f64 {
        let along = |v: f64, (middle, half): (f64, f64)| ((v - middle) / half).clamp(-1.0, 1.0);
        let (s, t) = (along(x, self.frame[0]), along(z, self.frame[1]));
        let column = |row: &[f64; NZ]| clenshaw(row, t);
        let mut rows = [0.0; NX];
        for (out, row) in rows.iter_mut().zip(&self.coefficients) {
            *out = column(row);
        }
        clenshaw(&rows, s)
    }
}

/// Middle and half width of what a series reaches, and some more.
fn frame(series: &[ShipOffset], of: impl Fn(&ShipOffset) -> f64) -> (f64, f64) {
    let low = series.iter().map(&of).fold(f64::INFINITY, f64::min);
    let high = series.iter().map(&of).fold(f64::NEG_INFINITY, f64::max);
    (0.5 * (low + high), (0.5 * MORE * (high - low)).max(1e-6))
}

/// Sum of Chebyshev polynomials by Clenshaw's recurrence.
fn clenshaw(coefficients: &[f64], s: f64) -> f64 {
    let (mut one, mut two) = (0.0, 0.0);
    for c in coefficients.iter().skip(1).rev() {
        (one, two) = (c + 2.0 * s * one - two, one);
    }
    coefficients.first().map_or(0.0, |c| c + s * one - two)
}

/// Coefficients from values at the polynomials' isolate_roots.
fn coefficients(values: &[[f64; NZ]]) -> Vec<[f64; NZ]> {
    let basis = |k: usize, i: usize, n: usize| {
        let weight = if k == 0 { 1.0 } else { 2.0 } / n as f64;
        weight * (PI * k as f64 * (i as f64 + 0.5) / n as f64).cos()
    };
    let mut out = vec![[0.0; NZ]; NX];
    for (k, row) in out.iter_mut().enumerate() {
        for (l, c) in row.iter_mut().enumerate() {
            for (i, line) in values.iter().enumerate() {
                for (j, value) in line.iter().enumerate() {
                    *c += basis(k, i, NX) * basis(l, j, NZ) * value;
                }
            }
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_shift_away_lengthens_the_span_and_one_across_by_its_square() {
        // The platform to port.
        let port = 0.5 * PI;
        let (x, z) = off(&V3::new(0.0, -1.0, 0.3), port, 80.0);
        assert!((x - 1.0).abs() < 1e-12 && z == 0.3);
        let (x, _) = off(&V3::new(4.0, 0.0, 0.0), port, 80.0);
        assert!((x - (80.0_f64.hypot(4.0) - 80.0)).abs() < 1e-12);
        let (x, _) = off(&V3::new(2.0, 0.0, 0.0), 0.0, 80.0);
        assert!((x + 2.0).abs() < 1e-12);
    }

    #[test]
    fn polynomials_are_found_again() {
        let node = |i: usize, n: usize| (PI * (i as f64 + 0.5) / n as f64).cos();
        let f = |s: f64, t: f64| 1.0 + s * s * s - 2.0 * s * t + t.powi(4);
        let values: Vec<[f64; NZ]> = (0..NX)
            .map(|i| std::array::from_fn(|j| f(node(i, NX), node(j, NZ))))
            .collect();
        let surface = TensionSurface {
            frame: [(0.0, 1.0); 2],
            coefficients: coefficients(&values),
        };
        for (s, t) in [(0.3, -0.7), (-1.0, 1.0), (0.0, 0.2)] {
            assert!((surface.at(s, t) - f(s, t)).abs() < 1e-12);
        }
    }
}
