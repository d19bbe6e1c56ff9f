//! The cargo on the full line: hauled over it on the dynamic solver, and the natural periods of the line with the cargo
//! on it, beside the one degree of freedom of eq. (12).

use std::sync::atomic::AtomicBool;

use super::Trouble;
use super::line;
use super::service::MARGIN;
use super::work::Worked;
use crate::case::{self, Case};
use crate::modes::{self, ModeKind};
use crate::numerics::V3;
use crate::run::job::{self, Request};
use crate::run::{History, RunState};

/// A crossing that takes longer than this is not followed on the full line \[s\].
const LONGEST: f64 = 900.0;

/// The cargo on its way over the full line, at an instant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hauled {
    /// Time \[s\].
    pub time_s: f64,
    /// Place from the platform \[m\].
    pub x_m: f64,
    /// Height above still water \[m\].
    pub z_m: f64,
    /// Tension at the platform \[N\].
    pub platform_n: f64,
    /// Tension at the ship \[N\].
    pub ship_n: f64,
}

impl Worked {
    /// The cargo hauled from the ship to the platform over the full line, the ship lying still and the rope made fast.
    ///
    /// # Errors
    /// [`Trouble::NotFound`] where the line is not built or its march gives up.
    pub fn hauled(&self) -> Result<Vec<Hauled>, Trouble> {
        let way = (self.rest(1.0 - MARGIN)?.arc_m, self.rest(MARGIN)?.arc_m);
        if way.0 - way.1 > LONGEST * self.ropeway.cargo.speed_m_per_s {
            return Err(Trouble::NotFound(
                "the crossing takes longer than is followed here",
            ));
        }
        let duration = (way.0 - way.1) / self.ropeway.cargo.speed_m_per_s + 1.0;
        let text = line::crossing_text(&self.ropeway, self.length_m, way, duration);
        let case = line_case(&text)?;
        let request = Request {
            case,
            text,
            file: "crossing.toml".to_owned(),
            overrides: Vec::new(),
            id: String::new(),
        };
        let run = job::execute(&request, &AtomicBool::new(false), &mut |_| ());
        if run.info.state != RunState::Done {
            return Err(Trouble::NotFound("the march over the full line gave up"));
        }
        read(&run.history).ok_or(Trouble::NotFound("the run over the full line has no cargo"))
    }

    /// Natural frequency of the lowest mode of the full line that moves in its plane, up and down, with the cargo at a
    /// place \[Hz\].
    ///
    /// # Errors
    /// [`Trouble::NotFound`] where the line has no modes.
    pub fn full_hz(&self, position: f64) -> Result<f64, Trouble> {
        let rest = self.rest(position)?;
        let text = line::case_text(&self.ropeway, rest.length_m, rest.arc_m);
        let found = modes::of_case(&line_case(&text)?, 8)
            .map_err(|_| Trouble::NotFound("the modes of the full line were not found"))?;
        let cargo = found.scene.clumps.first().copied().unwrap_or(0);
        // The lowest mode in the plane moves the cargo to and fro; the first that lifts it is the one to compare.
        let lifts = |mode: &modes::Mode| {
            let most = mode.shape.iter().map(V3::norm).fold(0.0, f64::max);
            let up = mode.shape.get(cargo).map_or(0.0, |u| u.z.abs());
            mode.kind != ModeKind::OutOfPlane && up > 0.3 * most
        };
        let named = found.modes.iter().find(|named| lifts(&named.mode));
        named
            .map(|named| named.mode.frequency_hz())
            .ok_or(Trouble::NotFound(
                "no mode of the full line lifts the cargo",
            ))
    }
}

fn line_case(text: &str) -> Result<Case, Trouble> {
    case::parse(text, "ropeway").map_err(|_| Trouble::NotFound("the ropeway makes no line case"))
}

fn read(history: &History) -> Option<Vec<Hauled>> {
    let values = |name: &str| Some(&history.channel(name)?.values);
    let (x, z) = (values("x_m[cargo]")?, values("z_m[cargo]")?);
    let (a, b) = (
        values("tension_n[platform|rope]")?,
        values("tension_n[rope|ship]")?,
    );
    let at = |i: usize| {
        Some(Hauled {
            time_s: *history.time.get(i)?,
            x_m: *x.get(i)?,
            z_m: *z.get(i)?,
            platform_n: *a.get(i)?,
            ship_n: *b.get(i)?,
        })
    };
    (0..history.time.len()).map(at).collect()
}
