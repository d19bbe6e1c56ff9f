//! A ropeway worked out: its rope's length, what the tables of the paper would print, and the readings for any
//! place of the cargo.

use super::Trouble;
use super::bare::Bare;
use super::exact::{self, Rest, Span};
use super::line::{self, LineRest};
use super::loaded::Loaded;
use super::model::{By, Ropeway};
use super::paper::{self, Least, Tabled};
use super::parabola::{self, Load};
use crate::case::Misfit;
use crate::report::number::si;

/// A ropeway with what follows from its words alone.
#[derive(Debug, Clone, PartialEq)]
pub struct Worked {
    /// The words.
    pub ropeway: Ropeway,
    /// The elastic rope between its ends.
    pub span: Span,
    /// Unstretched length between the ends, with the cargo where the file has it \[m\].
    pub length_m: f64,
    /// The paper's model of it.
    pub tabled: Result<Tabled, Trouble>,
    /// The least that the paper's greatest tension can be.
    pub least: Result<Least, Trouble>,
}

/// The ropeway with its cargo at one place, read in every way there is.
#[derive(Debug, Clone, PartialEq)]
pub struct Readings {
    /// Place of the cargo, 0 at the platform to 1 at the ship.
    pub position: f64,
    /// Unstretched length of the rope \[m\].
    pub length_m: f64,
    /// Parabola theory with the pull of the paper's model: tensions at the platform and the ship \[N\], sag at the cargo \[m\].
    pub parabola: Option<(f64, f64, f64)>,
    /// The elastic rope with the cargo on it.
    pub exact: Rest,
    /// Mean tensions before and behind the cargo, eqs (9) and (10), with the pull of the exact rope \[N\].
    pub means_n: Option<(f64, f64)>,
    /// The discretised line.
    pub line: Result<LineRest, Trouble>,
}

/// Works a ropeway out.
///
/// # Errors
/// What cannot be, at the key that says so.
pub fn work(ropeway: &Ropeway) -> Result<Worked, Misfit> {
    let (key, needed) = match ropeway.setting.by {
        By::BareSag | By::LoadedSag => ("sag_m", ropeway.setting.sag_m),
        By::Length => ("length_m", ropeway.setting.length_m),
        By::Tension => ("tension_n", ropeway.setting.tension_n),
    };
    if needed.is_none() {
        let problem = format!("is missing: the rope is set by its {}", ropeway.setting.by);
        return Err(Misfit::new(
            &["setting", key],
            problem,
            format!("add `{key} = ...` to [setting], or change `by`"),
        ));
    }
    let misfit = |trouble: Trouble| {
        let remedy = match trouble {
            Trouble::TooLittleTension { .. } => "give more tension, or a shorter span",
            Trouble::TooDeep => "give less sag or less rope",
            _ => "give more rope, or a shorter span",
        };
        Misfit::new(&["setting", key], trouble.to_string(), remedy)
    };
    let length_m = exact::length_m(ropeway).map_err(misfit)?;
    let span = Span::of(ropeway);
    // Whatever else is asked of it, the rope must have a place for the cargo.
    span.with_cargo(length_m, ropeway.cargo.position)
        .map_err(misfit)?;
    let stored = ropeway.stored_m();
    if length_m > stored {
        return Err(Misfit::new(
            &["setting", key],
            format!(
                "takes {} of rope, and of the shortest there is {}",
                si(length_m, "m"),
                si(stored, "m")
            ),
            "give less sag or more tension, or a longer rope",
        ));
    }
    let (w, q) = (ropeway.weight_n_per_m(), ropeway.cargo_n());
    let bare = match (ropeway.setting.by, ropeway.setting.sag_m) {
        (By::BareSag, Some(sag)) => Bare::with_sag(span.gap, w, sag),
        _ => Bare::with_length(span.gap, w, length_m),
    };
    Ok(Worked {
        tabled: bare.map(|bare| paper::tabled(bare, q)),
        least: paper::least(span.gap, w, q),
        ropeway: ropeway.clone(),
        span,
        length_m,
    })
}

impl Worked {
    /// The rope with the cargo at this place, 0 at the platform to 1 at the ship; a rope set by tension is paid out as the
    /// winch does, any other keeps its length.
    ///
    /// # Errors
    /// What cannot be.
    pub fn rest(&self, position: f64) -> Result<Rest, Trouble> {
        let length = match (self.ropeway.setting.by, self.ropeway.setting.tension_n) {
            (By::Tension, Some(tension)) => self
                .span
                .length_by_tension(tension, |length| self.span.with_cargo(length, position))?,
            _ => self.length_m,
        };
        self.span.with_cargo(length, position)
    }

    /// Every reading with the cargo at this place.
    ///
    /// # Errors
    /// Those of [`Worked::rest`].
    pub fn readings(&self, position: f64) -> Result<Readings, Trouble> {
        let exact = self.rest(position)?;
        let (gap, x) = (self.span.gap, position * self.span.gap.span_m);
        let load = Load {
            weight_n_per_m: self.span.weight_n_per_m,
            cargo_n: self.span.cargo_n,
        };
        let pull = self.tabled.as_ref().ok().map(|t| t.rope.horizontal_n);
        let parabola = pull.map(|pull| {
            let (a, b) = parabola::end_tensions_n(gap, load, pull, x);
            (a, b, parabola::sag_m(gap, load, pull, x))
        });
        let inside = exact.carrier == exact::Carrier::Rope;
        let means = inside.then(|| {
            let cargo = (x, self.span.cargo_n);
            Loaded::with_pull(gap, load.weight_n_per_m, exact.solution.h_b_n, cargo)
        });
        Ok(Readings {
            position,
            length_m: exact.length_m,
            parabola,
            means_n: means
                .and_then(Result::ok)
                .map(|loaded| loaded.mean_tensions_n()),
            line: line::at_rest(&self.ropeway, exact.length_m, exact.arc_m),
            exact,
        })
    }

    /// The part of its breaking load that the most heavily loaded rope carries of a tension in all of them; absent: no breaking
    /// load is known.
    #[must_use]
    pub fn of_breaking(&self, tension_n: f64) -> Option<f64> {
        let part = |rope: &super::model::Rope| {
            let share = rope.ea_n / self.span.ea_n;
            Some(share * tension_n / rope.break_load_n?)
        };
        self.ropeway.ropes.iter().filter_map(part).reduce(f64::max)
    }

    /// Height of the cargo's lower side above the wave crests \[m\]; negative: it is in the water.
    #[must_use]
    pub fn clearance_m(&self, rest: &Rest) -> f64 {
        let hook = self.ropeway.platform.height_m + rest.cargo_m.1;
        hook - self.ropeway.cargo.drop_m - self.ropeway.water.crest_m
    }

    /// Height of the rope's lowest point above the wave crests \[m\].
    #[must_use]
    pub fn rope_clearance_m(&self, rest: &Rest) -> f64 {
        self.ropeway.platform.height_m + rest.solution.lowest().z_m - self.ropeway.water.crest_m
    }

    /// The place at which the cargo comes nearest to the water, and its clearance there \[m\]; of so many places between
    /// the supports.
    #[must_use]
    pub fn lowest_crossing(&self, places: usize) -> Option<(f64, f64)> {
        let place = |i: usize| (i as f64 + 1.0) / (places as f64 + 1.0);
        let at = |i: usize| {
            let position = place(i);
            let rest = self.rest(position).ok()?;
            Some((position, self.clearance_m(&rest)))
        };
        (0..places)
            .filter_map(at)
            .min_by(|a, b| a.1.total_cmp(&b.1))
    }
}
