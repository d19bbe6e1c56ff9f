//! The shipped cases against the published values they state: what `seacable validate` promises.

use std::sync::{LazyLock, atomic::AtomicBool};

use rayon::prelude::*;
use seacable::{
    case::{self, Case, StudyPoint, shipped::SHIPPED},
    chart::Glyphs,
    reference::{self, Outcome, RowKind, ValidationRow},
    report::text,
    run::{
        Run, RunState,
        job::{self, Request},
    },
};

/// What a shipped line case gives.
pub(crate) struct Computed {
    pub(crate) path: &'static str,
    rows: Vec<ValidationRow>,
    /// The report of the case itself in ASCII; absent where only its variants state published values.
    pub(crate) report: Option<String>,
}

/// Every shipped line case, computed once.
pub(crate) static COMPUTED: LazyLock<Vec<Computed>> = LazyLock::new(|| {
    SHIPPED
        .par_iter()
        .map(|(path, text)| computed(path, text))
        .collect()
});

/// Rows of every shipped case, by its path.
pub(crate) static ROWS: LazyLock<Vec<(&str, Vec<ValidationRow>)>> = LazyLock::new(|| {
    let all = COMPUTED.iter();
    all.map(|one| (one.path, one.rows.clone())).collect()
});

fn computed(path: &'static str, content: &str) -> Computed {
    let case = case::parse(content, path).unwrap();
    let runs: Vec<(Option<StudyPoint>, Run)> = reference::plan(&case)
        .into_par_iter()
        .map(|at| {
            let run = compute(path, content, &case, at.as_ref());
            (at, run)
        })
        .collect();
    let lookup = |at: Option<&StudyPoint>| {
        runs.iter()
            .find(|(a, _)| a.as_ref() == at)
            .map(|(_, run)| run)
    };
    let rows = reference::rows(&case, &lookup);
    let report = lookup(None).map(|run| text::report(run, &case, &rows, Glyphs::Ascii));
    Computed { path, rows, report }
}

fn compute(path: &str, text: &str, case: &Case, at: Option<&StudyPoint>) -> Run {
    let (text, overrides) = match at {
        None => (text.to_owned(), Vec::new()),
        Some(at) => {
            let variant =
                reference::variant::<Case>(text, &case.case.title, &case.study, at).unwrap();
            (variant.text, variant.overrides)
        }
    };
    let case = case::parse(&text, path).unwrap();
    let request = Request {
        case,
        text,
        file: path.to_owned(),
        overrides,
        id: String::new(),
    };
    let run = job::execute(&request, &AtomicBool::new(false), &mut |_| ());
    assert_eq!(
        run.info.state,
        RunState::Done,
        "{path} at {at:?}: {:?}",
        run.info.failure
    );
    run
}

fn of(path: &str, name: &str) -> Vec<&'static ValidationRow> {
    let (_, rows) = ROWS.iter().find(|(p, _)| p.ends_with(path)).unwrap();
    rows.iter().filter(|row| row.name.contains(name)).collect()
}

#[test]
fn no_row_fails_and_none_is_left_out() {
    for (path, rows) in ROWS.iter() {
        for row in rows {
            assert!(
                matches!(row.outcome, Outcome::Pass | Outcome::Differs),
                "{path}: {row:#?}"
            );
        }
    }
}

#[test]
fn what_differs_says_why() {
    for (_, rows) in ROWS.iter() {
        for row in rows.iter().filter(|r| r.outcome == Outcome::Differs) {
            assert!(
                row.reason.as_deref().is_some_and(|r| r.len() > 20),
                "{row:#?}"
            );
        }
    }
}

/// The travels of the module hang on when which part of the line passes the drag crisis. Their errors, with the factor of safety of results that do not
/// fall from mesh to mesh, are up to nine tenths of the tolerance; the table says so at the row.
/// Share of its tolerance that the numerical error of a row may be: a tenth, but where the row cannot do better. Its
/// note in the table says so then.
fn allowed(path: &str, row: &ValidationRow) -> f64 {
    match (path, row.name.as_str()) {
        // A drag coefficient that jumps leaves the travel undetermined on any mesh.
        (_, name) if name.starts_with("travel") => 0.9,
        // The instant of an extreme is known to a step, and the bob's bounce on its wire moves it by as much.
        ("basics/pendulum.toml", "half the period") => 1.0,
        // The mesh is the paper's own, 158 segments.
        // Its results at the end of a section are of first order, which three meshes show and two did not.
        ("mooring/hybrid_fixed.toml", _) => 1.1,
        // The start at full velocity sends a front down the line, on which mesh and steps leave up to 3 points of 5.
        ("mooring/hybrid_moving.toml", name) if name.ends_with("by the static one") => 0.6,
        ("mooring/hybrid_moving.toml", name) if name.starts_with("swing of the stiffness") => 0.13,
        // The companion in longer steps has it one segment further along.
        ("mooring/hybrid_moving.toml", name) if name.starts_with("where along") => 2.1,
        // A place along the line is known to a segment, and that is the tolerance.
        (_, name) if name.starts_with("where along") || name.starts_with("the lowest point") => 1.0,
        ("umbilical/catenary.toml", "weight alone: tension at the anchor") => 0.2,
        // Whole numbers: one wave more or less on a companion's mesh or in its steps, which does not fall from run to run.
        (path, name) if path.starts_with("double_stepped/") && name.starts_with("waves") => 7.0,
        ("double_stepped/regular_wave.toml", _) => 0.5,
        // On three meshes these do not fall by the order of the method, and the error states what they do fall by.
        (path, name)
            if path.starts_with("double_stepped/extreme") && name.starts_with("response") =>
        {
            0.4
        }
        // The first rise passes the line as a front, whose top is known to a segment.
        ("pendulous/module.toml" | "pendulous/module_rotating.toml", name)
            if name.starts_with("greatest tension")
                || name.starts_with("time of the greatest")
                || name == "where the line bears most" =>
        {
            0.15
        }
        // The peak comes as the last nodes lift off the bed one by one, which scatters it from mesh to mesh.
        ("mooring/heaved_50m.toml", "greatest tension, heave 2 m") => 0.2,
        ("benchmarks/lindahl_chain.toml", name) if name.starts_with("mean peak") => 0.3,
        ("double_stepped/cantilever.toml", "drag at C_Y = 1000") => 0.13,
        ("benchmarks/current_across.toml", "pull on the anchor along z, 0.5 m/s") => 0.11,
        // The order on three meshes is a little off that of the method, and the bars have the wider factor of safety.
        ("benchmarks/elastica.toml", "tip z, P L2 / EI = 10") => 0.12,
        ("umbilical/steep_wave.toml", name) if name.ends_with("height at 60 m") => 0.11,
        // Nodes that touch down one by one: the coarse meshes are there to show how their noise falls, and halving
        // such a mesh for the estimate doubles it.
        ("hard/touchdown.toml", name) if name.ends_with(" segments") => 80.0,
        // Rounding decides how the folded chain throws its free end: over 32 values of the stiffness that differ in the twelfth
        // digit the estimate is between 0.9 and 25 times the tolerance.
        ("hard/whip.toml", "time of the fall") => 25.0,
        // Against a closed form the difference is the numerical error, and the tolerance its bound; a bar with its factor of
        // safety may be four times the error.
        (path, _) if path.starts_with("hard/") => 4.0,
        _ => 0.1,
    }
}

#[test]
fn numerical_errors_are_ten_times_smaller_than_the_tolerances() {
    let mut coarse = Vec::new();
    for (path, rows) in ROWS.iter() {
        for row in rows
            .iter()
            .filter(|r| r.trend.is_none() && r.outcome == Outcome::Pass)
        {
            // No evidence rests on it, and the table says that its error is not known.
            if row.error.is_none() && !row.kind.is_evidence() {
                continue;
            }
            let share = row.error.unwrap_or(f64::INFINITY) / row.tolerance.unwrap();
            if share > allowed(path, row) {
                coarse.push(format!("{path}: {}: {share:.3}", row.name));
            }
            let reported = row
                .reason
                .as_deref()
                .is_some_and(|r| r.contains("more than a tenth"));
            assert_eq!(reported, share > 0.1, "{path}: {row:#?}");
        }
    }
    assert!(coarse.is_empty(), "{coarse:#?}");
}

#[test]
fn all_nine_travels_come_out_and_three_of_them_were_fitted() {
    let travels = of("module.toml", "travel at");
    assert_eq!(travels.len(), 9);
    for row in &travels {
        assert_eq!(row.outcome, Outcome::Pass, "{row:#?}");
        assert!(row.difference.unwrap().abs() <= 0.8, "{row:#?}");
    }
    assert_eq!(
        travels
            .iter()
            .filter(|row| row.kind == RowKind::Fitted)
            .count(),
        3
    );
}

/// The four maxima of fig. 7, on the line that the manifold hangs on too.
#[test]
fn the_maxima_at_the_four_joints_come_out() {
    let maxima = of("/module.toml", "greatest tension at");
    let maxima = maxima.iter().filter(|row| !row.name.starts_with("time"));
    let outcomes: Vec<Outcome> = maxima.map(|row| row.outcome).collect();
    assert!(outcomes.len() >= 4);
    assert!(outcomes.iter().all(|outcome| *outcome == Outcome::Pass));
}

#[test]
fn the_manifold_means_are_within_three_percent_of_the_reference() {
    let means = of("manifold.toml", "reference [6]");
    assert_eq!(means.len(), 2);
    for row in means {
        assert_eq!(row.outcome, Outcome::Pass, "{row:#?}");
        assert!(
            row.difference.unwrap().abs() <= 0.03 * row.published.unwrap(),
            "{row:#?}"
        );
    }
}

/// That the module turns about its hang point changes its travels by less than their own errors.
#[test]
fn a_module_that_turns_travels_as_far_as_one_that_does_not() {
    for row in of("module_rotating.toml", "travel at") {
        let point = of("/module.toml", &row.name)[0].computed.unwrap();
        assert!((row.computed.unwrap() - point).abs() < 0.5, "{row:#?}");
    }
}

#[test]
fn a_single_run_is_compared_with_its_own_rows() {
    let (path, text) = SHIPPED
        .iter()
        .find(|(path, _)| path.ends_with("module.toml"))
        .unwrap();
    let case = case::parse(text, path).unwrap();
    let judged = |overrides: &[&str]| {
        let edits: Vec<(&str, &str)> = overrides
            .iter()
            .map(|o| o.split_once('=').unwrap())
            .collect();
        let text = case::edit::set_all(text, &edits).unwrap();
        let case = case::parse(&text, path).unwrap();
        let mut request = Request {
            case: case.clone(),
            text,
            file: (*path).to_owned(),
            overrides: overrides.iter().map(|o| (*o).to_owned()).collect(),
            id: String::new(),
        };
        request.case.solver.error_estimate = false;
        let run = job::execute(&request, &AtomicBool::new(false), &mut |_| ());
        let rows = reference::rows_of_run(&run, &case);
        let names = rows
            .iter()
            .filter(|r| !matches!(r.outcome, Outcome::NotRun | Outcome::Edited))
            .map(|r| r.name.clone());
        names.collect::<Vec<_>>()
    };
    let base: Vec<&str> = case
        .published
        .iter()
        .filter(|p| p.at.is_none())
        .map(|p| p.name.as_str())
        .collect();
    let own = judged(&["solver.rho_inf=0.3"]);
    assert!(
        base.iter().all(|name| own.iter().any(|o| o == name)),
        "{own:?}"
    );
    // The case stands at one of its study's weights.
    assert!(
        own.iter()
            .any(|name| name == "travel at a dry weight of 469 t"),
        "{own:?}"
    );

    let at_point = judged(&["current.speed_m_per_s=0.2"]);
    assert_eq!(at_point, ["travel at a current of 0.2 m/s"]);
    let elsewhere = judged(&["current.speed_m_per_s=0.2", "payload.drag_area_m2=5"]);
    assert!(elsewhere.is_empty(), "{elsewhere:?}");
}
