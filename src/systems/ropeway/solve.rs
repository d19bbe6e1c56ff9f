//! A ropeway solved: the length of its rope, the inextensible model, and the results of all models at a position of the
//! cargo.

use super::RopewayError;
use super::elastic::{self, ElasticRope, RopeEquilibrium};
use super::inextensible::{InextensibleModel, MinimumTension, minimum_tension};
use super::line::{self, DiscretisedEquilibrium};
use super::loaded::LoadedRope;
use super::model::{Ropeway, SetBy};
use super::parabola::{self, ParabolaLoad};
use super::unloaded::UnloadedRope;

/// A ropeway with what its file alone determines.
#[derive(Debug, Clone, PartialEq)]
pub struct SolvedRopeway {
    /// The keys of its file.
    pub ropeway: Ropeway,
    /// The elastic rope between its ends.
    pub rope: ElasticRope,
    /// Unstretched length between the ends, with the cargo where the file has it \[m\].
    pub length_m: f64,
    /// The inextensible model behind the tables of the paper.
    pub inextensible: Result<InextensibleModel, RopewayError>,
    /// The least of the greatest tensions of that model over all lengths.
    pub minimum_tension: Result<MinimumTension, RopewayError>,
}

/// The results of all models with the cargo at one position.
#[derive(Debug, Clone, PartialEq)]
pub struct ModelResults {
    /// Position of the cargo, 0 at the platform to 1 at the ship.
    pub position: f64,
    /// Unstretched length of the rope \[m\].
    pub length_m: f64,
    /// Parabola theory with the horizontal tension of the inextensible model: tensions at the platform and the ship \[N\], sag at the cargo \[m\].
    pub parabola: Option<(f64, f64, f64)>,
    /// The elastic rope with the cargo on it.
    pub exact: RopeEquilibrium,
    /// Mean tensions before and behind the cargo, eqs (9) and (10), with the horizontal tension of the elastic rope \[N\].
    pub mean_tensions_n: Option<(f64, f64)>,
    /// The discretised line.
    pub line: Result<DiscretisedEquilibrium, RopewayError>,
}

/// Solves a ropeway: the length of its rope, and the inextensible model.
///
/// # Errors
/// A setting without a solution.
pub fn solve(ropeway: &Ropeway) -> Result<SolvedRopeway, RopewayError> {
    let length_m = elastic::length_m(ropeway)?;
    let rope = ElasticRope::of_ropeway(ropeway);
    // Every model needs a position of the cargo on the rope.
    rope.with_cargo(length_m, ropeway.cargo.position)?;
    let stored_m = ropeway.stored_m();
    if length_m > stored_m {
        return Err(RopewayError::TooLittleRope { length_m, stored_m });
    }
    let (w, q) = (ropeway.weight_n_per_m(), ropeway.cargo_n());
    let setting = &ropeway.setting;
    let unloaded = match (setting.by, setting.sag_m, setting.horizontal_n) {
        (SetBy::BareSag, Some(sag), _) => UnloadedRope::with_sag(rope.geometry, w, sag),
        (SetBy::BareHorizontal, _, Some(horizontal)) => {
            UnloadedRope::with_horizontal_tension(rope.geometry, w, horizontal)
        }
        _ => UnloadedRope::with_length(rope.geometry, w, length_m),
    };
    Ok(SolvedRopeway {
        inextensible: unloaded.map(|rope| InextensibleModel::new(rope, q)),
        minimum_tension: minimum_tension(rope.geometry, w, q),
        ropeway: ropeway.clone(),
        rope,
        length_m,
    })
}

impl SolvedRopeway {
    /// The elastic rope with the cargo at this position, 0 at the platform to 1 at the ship; a rope set by tension has the
    /// length that gives the tension, any other keeps its length.
    ///
    /// # Errors
    /// No solution at this position.
    pub fn equilibrium(&self, position: f64) -> Result<RopeEquilibrium, RopewayError> {
        let length = match (self.ropeway.setting.by, self.ropeway.setting.tension_n) {
            (SetBy::Tension, Some(tension)) => self
                .rope
                .length_for_tension(tension, |length| self.rope.with_cargo(length, position))?,
            _ => self.length_m,
        };
        self.rope.with_cargo(length, position)
    }

    /// Weights of rope and cargo for parabola theory.
    pub(super) fn parabola_load(&self) -> ParabolaLoad {
        ParabolaLoad {
            weight_n_per_m: self.rope.weight_n_per_m,
            cargo_n: self.rope.cargo_n,
        }
    }

    /// Every reading with the cargo at this place.
    ///
    /// # Errors
    /// Those of [`SolvedRopeway::equilibrium`].
    pub fn results(&self, position: f64) -> Result<ModelResults, RopewayError> {
        let exact = self.equilibrium(position)?;
        let (geometry, x) = (self.rope.geometry, position * self.rope.geometry.span_m);
        let load = self.parabola_load();
        let horizontal = self.inextensible.as_ref().ok().map(|t| t.rope.horizontal_n);
        let parabola = horizontal.map(|horizontal| {
            let (a, b) = parabola::end_tensions_n(geometry, load, horizontal, x);
            (a, b, parabola::sag_m(geometry, load, horizontal, x))
        });
        let inside = exact.carrier == elastic::Carrier::Rope;
        let means = inside.then(|| {
            let cargo = (x, self.rope.cargo_n);
            LoadedRope::with_horizontal_tension(
                geometry,
                load.weight_n_per_m,
                exact.solution.h_b_n,
                cargo,
            )
        });
        Ok(ModelResults {
            position,
            length_m: exact.length_m,
            parabola,
            mean_tensions_n: means
                .and_then(Result::ok)
                .map(|loaded| loaded.mean_tensions_n()),
            line: line::equilibrium(&self.ropeway, exact.length_m, exact.arc_m),
            exact,
        })
    }

    /// The part of its breaking load that the most heavily loaded rope carries of a tension in all of them; absent: no breaking
    /// load is known.
    #[must_use]
    pub fn breaking_load_ratio(&self, tension_n: f64) -> Option<f64> {
        let part = |rope: &super::model::Rope| {
            let share = rope.ea_n / self.rope.ea_n;
            Some(share * tension_n / rope.break_load_n?)
        };
        self.ropeway.ropes.iter().filter_map(part).reduce(f64::max)
    }

    /// Height of the cargo's lower side above the wave crests \[m\]; negative: it is in the water.
    #[must_use]
    pub fn clearance_m(&self, rest: &RopeEquilibrium) -> f64 {
        let hook = self.ropeway.platform.height_m + rest.cargo_m.1;
        hook - self.ropeway.cargo.drop_m - self.ropeway.water.crest_m
    }

    /// Height of the rope's lowest point above the wave crests \[m\].
    #[must_use]
    pub fn rope_clearance_m(&self, rest: &RopeEquilibrium) -> f64 {
        self.ropeway.platform.height_m + rest.solution.lowest().z_m - self.ropeway.water.crest_m
    }

    /// The position of least clearance of the cargo, and the clearance there \[m\], of so many positions between
    /// the supports.
    #[must_use]
    pub fn lowest_crossing(&self, places: usize) -> Option<(f64, f64)> {
        let place = |i: usize| (i as f64 + 1.0) / (places as f64 + 1.0);
        let at = |i: usize| {
            let position = place(i);
            let rest = self.equilibrium(position).ok()?;
            Some((position, self.clearance_m(&rest)))
        };
        (0..places)
            .filter_map(at)
            .min_by(|a, b| a.1.total_cmp(&b.1))
    }
}
