//! A system of lines at rest, as a run computes it.

use std::collections::BTreeMap;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, OnceLock};
use std::time::Instant;

use super::record::record;
use super::refinable_rest::RefinableRest;
use crate::background::cpu_time;
use crate::case::fields::Schema;
use crate::case::{Attachment, kind};
use crate::run::accuracy::searchable::Asked;
use crate::run::computation::{Computation, first};
use crate::run::compute::Computed;
use crate::run::event::Listener;
use crate::run::march::MarchResult;
use crate::run::refinable::Refinable;
use crate::run::{Cost, Resumed, RunState, Settings, Work};
use crate::system::discretised::LineForm;
use crate::system::model::LineInputs;
use crate::system::parts::parts;
use crate::system::rest::UnsolvedSystem;
use crate::system::solved::{LineForms, solve_without_errors};
use crate::system::{SYSTEM, SolvedSystem, SystemFile};

/// The word for its method.
pub(super) const STATIC: &str = "static";

/// A system at rest.
#[derive(Debug, Clone)]
pub struct SystemAtRest {
    /// What its file says.
    pub file: Arc<SystemFile>,
    /// How its lines take part.
    pub forms: LineForms,
    /// The accuracy that is asked.
    pub asked: Option<Asked>,
    /// Whether companions tell the errors of its results.
    pub has_companions: bool,
    /// By what each companion is coarser, from the finest; absent where the program chooses them.
    pub companions: Option<Vec<String>>,
    /// Where it rests, once it was computed.
    found: Arc<OnceLock<SolvedSystem>>,
}

impl SystemAtRest {
    /// The system of a file that the checks passed, with the accuracy that its method `static` asks for: its lines are closed forms where these
    /// are known, which a run of its rest has none of, and a method of a run in time is not of a system at rest.
    #[must_use]
    pub fn new(mut file: SystemFile) -> Self {
        let solver = file.solver.take().filter(|solver| !solver.is_in_time());
        let solver = solver.unwrap_or_default();
        Self {
            file: Arc::new(file),
            forms: LineForms::ClosedWhereKnown,
            asked: solver.accuracy.map(|accuracy| Asked {
                accuracy,
                budget_s: solver.budget_s,
            }),
            has_companions: solver.error_estimate,
            companions: solver.companions,
            found: Arc::default(),
        }
    }

    /// The same, asked otherwise.
    #[must_use]
    pub fn asking(&self, asked: Option<Asked>, has_companions: bool) -> Self {
        Self {
            asked,
            has_companions,
            companions: None,
            ..self.clone()
        }
    }

    /// The same system with its file changed.
    #[must_use]
    pub fn with_file(&self, change: impl FnOnce(&mut SystemFile)) -> Self {
        let mut file = SystemFile::clone(&self.file);
        change(&mut file);
        Self {
            file: Arc::new(file),
            found: Arc::default(),
            ..self.clone()
        }
    }

    /// The same with its lines in other forms.
    #[must_use]
    pub fn in_forms(&self, forms: LineForms) -> Self {
        Self {
            forms,
            found: Arc::default(),
            ..self.clone()
        }
    }

    /// The lines that are divided into segments, or may be, by their numbers in the file.
    pub(super) fn meshed(&self) -> impl Iterator<Item = (usize, &LineInputs)> {
        let is_meshed = |line: &LineInputs| {
            let closed = LineForm::of_parts(&self.file, line, &parts(&self.file, line));
            self.forms == LineForms::Divided || closed != LineForm::Closed
        };
        let lines = self.file.lines.iter().enumerate();
        lines.filter(move |(_, line)| is_meshed(line))
    }

    /// Works the system out, without errors.
    ///
    /// # Errors
    /// [`UnsolvedSystem`], as of a file.
    pub fn solve(&self) -> Result<SolvedSystem, UnsolvedSystem> {
        solve_without_errors(SystemFile::clone(&self.file), self.forms)
    }

    /// Where it rests; nothing before it was computed.
    pub(super) fn found(&self) -> Option<&SolvedSystem> {
        self.found.get()
    }
}

impl Computation for SystemAtRest {
    /// Nothing at rest is resumed.
    type State = ();

    fn of_stored(text: &str, file: &str) -> Result<Self, String> {
        let solved = kind::parse_stored::<SystemFile>(text, file).map_err(|all| first(&all))?;
        Ok(Self::new(solved.file))
    }

    fn with_key(text: &str, key: &str, value: &str) -> Result<String, String> {
        kind::put::<SystemFile>(text, key, value).map_err(|all| first(&all))
    }

    fn schema() -> &'static Schema {
        &SYSTEM
    }

    fn title(&self) -> &str {
        &self.file.about.title
    }

    fn method(&self) -> &'static str {
        STATIC
    }

    fn duration_s(&self) -> f64 {
        0.0
    }

    fn files(&self) -> &BTreeMap<String, Attachment> {
        &self.file.files
    }

    fn has_companions(&self) -> bool {
        self.has_companions
    }

    fn with_chosen_method(
        &self,
        _: Option<&Resumed<()>>,
        _: &AtomicBool,
    ) -> Option<(Self, Option<String>)> {
        None
    }

    fn compute(&self, _: Option<&Resumed<()>>, cancel: &AtomicBool, _: Listener<'_>) -> Computed {
        if cancel.load(Ordering::Relaxed) {
            return Computed::stopped();
        }
        let (cpu, clock) = (cpu_time(), Instant::now());
        let solved = match self.solve() {
            Ok(solved) => solved,
            Err(why) => return Computed::failed(format!("{}; {}", why.problem, why.remedy)),
        };
        let cost = Cost {
            cpu_s: cpu_time() - cpu,
            wall_s: clock.elapsed().as_secs_f64(),
            companions_wall_s: 0.0,
        };
        let mut computed = Computed {
            outcome: MarchResult::without_steps(RunState::Done, None, work(&solved)),
            settings: settings(&solved),
            cost,
            record: record(&solved),
            ..Computed::failed(String::new())
        };
        let modes = solved.asked_modes();
        computed.take_modes(modes.map(<[_]>::to_vec).map_err(str::to_owned));
        self.found.get_or_init(|| solved);
        computed
    }

    fn remarks(&self, _: &Computed) -> Vec<String> {
        Vec::new()
    }

    fn ask_refinable<T>(&self, ask: impl FnOnce(&dyn Refinable) -> T) -> Option<T> {
        Some(ask(&RefinableRest::new(self)?))
    }
}

/// What the search for the equilibrium took: Newton steps of the system, and evaluations of all lines.
fn work(solved: &SolvedSystem) -> Work {
    Work {
        iterations: solved.rest.steps as u64,
        evaluations: solved.rest.evaluations as u64,
        ..Work::default()
    }
}

fn settings(solved: &SolvedSystem) -> Settings {
    let divided = solved.rest.balance.lines.iter();
    let divided = divided.filter_map(|line| line.discretised.as_ref());
    Settings {
        method: STATIC.to_owned(),
        nodes: divided.map(|line| line.found.position_m.len()).sum(),
        ..Settings::default()
    }
}
