//! Answers that do not depend on how they are asked for: random systems, each held against itself written from the other ends of its lines,
//! in another order under other names, turned, mirrored, moved, with a line divided by a free point without mass, on twice the
//! segments, in steps half as long.
//!
//! What is written otherwise is the same to rounding at rest, in motion within the errors that both state; a divided line, a finer mesh and
//! shorter steps agree within the errors.

mod computed;
mod divided;
mod drawn;
mod mirrored;
mod moved;
mod refined;
mod reordered;
mod results;
mod reversed;
mod space;
mod tree;
mod turned;
mod variant;

use rayon::prelude::*;
use toml::Table;

use self::computed::computed;
pub use self::drawn::KINDS;
pub use self::results::Violation;
use self::results::{Errors, Tolerance};
pub use self::variant::{SystemVariant, text};
use crate::numerics::random::Random;

/// What must not change the answer.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Invariant {
    /// Lines written from their other ends.
    Reversed,
    /// Lines, points, bodies and materials in another order, under other names.
    Reordered,
    /// Turned about the vertical.
    Turned,
    /// Mirrored in the plane of x and z.
    Mirrored,
    /// Moved horizontally.
    Moved,
    /// A line divided by a free point without mass.
    Divided,
    /// Twice the segments.
    Refined,
    /// Steps half as long.
    Halved,
}

impl Invariant {
    /// All of them.
    pub const ALL: [Self; 8] = [
        Self::Reversed,
        Self::Reordered,
        Self::Turned,
        Self::Mirrored,
        Self::Moved,
        Self::Divided,
        Self::Refined,
        Self::Halved,
    ];

    /// In a word, as in the names of files.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Reversed => "reversed",
            Self::Reordered => "reordered",
            Self::Turned => "turned",
            Self::Mirrored => "mirrored",
            Self::Moved => "moved",
            Self::Divided => "divided",
            Self::Refined => "refined",
            Self::Halved => "halved",
        }
    }

    /// A system asked for this way; nothing where it cannot be.
    fn variant(self, system: &Table, random: &mut Random) -> Option<SystemVariant> {
        Some(match self {
            Self::Reversed => reversed::reversed(system),
            Self::Reordered => reordered::reordered(system),
            Self::Turned => turned::turned(system),
            Self::Mirrored => mirrored::mirrored(system),
            Self::Moved => moved::moved(system),
            Self::Divided => divided::divided(system, random)?,
            Self::Refined => refined::refined(system),
            Self::Halved => refined::halved(system)?,
        })
    }

    /// How far the results may be apart. Rounding grows in motion, where lines snap and land, no further than what both state.
    fn tolerance(self, moves: bool) -> Tolerance {
        let errors = match self {
            Self::Divided | Self::Refined | Self::Halved => Errors::Needed,
            _ if moves => Errors::Allowed,
            _ => Errors::Ignored,
        };
        Tolerance {
            relative: ROUNDING,
            errors,
        }
    }
}

/// Differences that are rounding and what a search leaves, by the greatest tension and by the greatest coordinate.
const ROUNDING: f64 = 1e-6;

/// What came of a system asked for in another way.
#[derive(Debug, Clone, PartialEq)]
pub enum VariantOutcome {
    /// Not asked: it cannot be.
    NotAsked,
    /// So many numbers agree.
    Agrees(usize),
    /// The result that is furthest off.
    Differs(Violation),
    /// The system has an answer, and it has none: why.
    Refused(String),
}

/// What came of a system.
#[derive(Debug, Clone)]
pub struct InvariantOutcome {
    /// Its number.
    pub index: usize,
    /// The number of its kind.
    pub kind: usize,
    /// Its file.
    pub file: Table,
    /// Why it has no answer itself, if it has none.
    pub refused: Option<String>,
    /// By [`Invariant::ALL`]; with the file of what was asked where it does not agree.
    pub held: Vec<(VariantOutcome, Option<SystemVariant>)>,
}

impl InvariantOutcome {
    /// The invariants that it violates, with the files.
    pub fn violations(&self) -> impl Iterator<Item = (Invariant, &VariantOutcome, &SystemVariant)> {
        let all = Invariant::ALL.into_iter().zip(&self.held);
        all.filter_map(|(invariant, (held, variant))| Some((invariant, held, variant.as_ref()?)))
    }
}

/// Holds so many random systems of a seed against themselves, on all cores.
#[must_use]
pub fn run(count: usize, seed: u64, moves: bool) -> Vec<InvariantOutcome> {
    let all = (0..count).into_par_iter();
    all.map(|index| one(index, seed, moves)).collect()
}

/// The number of the kind of the random system of a number, and its file.
///
/// # Errors
/// The file: what is written is no TOML, which would be a fault here.
pub fn file(index: usize, seed: u64, moves: bool) -> (usize, Result<Table, String>) {
    drawn_of(index, moves, &mut Random::new(seed, index as u64))
}

fn drawn_of(index: usize, moves: bool, random: &mut Random) -> (usize, Result<Table, String>) {
    let kinds = match moves {
        true => KINDS.len(),
        false => KINDS.len() - drawn::IN_MOTION_ALONE,
    };
    let kind = index % kinds;
    (kind, drawn::drawn(kind, random, moves))
}

/// Holds the random system of a number against itself.
#[must_use]
pub fn one(index: usize, seed: u64, moves: bool) -> InvariantOutcome {
    let mut random = Random::new(seed, index as u64);
    let (kind, file) = drawn_of(index, moves, &mut random);
    let outcome = match file {
        Ok(file) => against_itself(file, &mut random, moves),
        Err(why) => refused(Table::new(), why),
    };
    InvariantOutcome {
        index,
        kind,
        ..outcome
    }
}

/// Holds a system against itself.
#[must_use]
pub fn against_itself(file: Table, random: &mut Random, moves: bool) -> InvariantOutcome {
    let system = match computed(&text(&file), moves) {
        Ok(system) => system,
        Err(why) => return refused(file, why),
    };
    let held = Invariant::ALL.map(|invariant| {
        let Some(variant) = invariant.variant(&file, random) else {
            return (VariantOutcome::NotAsked, None);
        };
        let other = match computed(&variant.text(), moves) {
            Ok(other) => other,
            Err(why) => return (VariantOutcome::Refused(why), Some(variant)),
        };
        match system.worst(&other, &variant, invariant.tolerance(moves)) {
            (compared, None) => (VariantOutcome::Agrees(compared), None),
            (_, Some(violation)) => (VariantOutcome::Differs(violation), Some(variant)),
        }
    });
    InvariantOutcome {
        index: 0,
        kind: 0,
        file,
        refused: None,
        held: held.into(),
    }
}

fn refused(file: Table, why: String) -> InvariantOutcome {
    InvariantOutcome {
        index: 0,
        kind: 0,
        file,
        refused: Some(why),
        held: Vec::new(),
    }
}
