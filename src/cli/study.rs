//! `seacable study`: hard cases against expected results, work against error, error-controlled against constant steps.

use std::process::ExitCode;
use std::sync::Mutex;

use super::{
    BAD_RESULT, CommandError, cases,
    common_args::HardArgs,
    effects, laboratory,
    output::{self, OutputFile},
    physics, progress,
    signals::StopFlag,
    studied_scene::{StudiedScene, scene_of},
    study_args::{SpeedArgs, StepsArgs, StudyArgs},
    study_table::{WIDTH, print, write_csv},
    system_study, vary,
};
use seacable_display::chart::draw;
use seacable_model::case::Method;
use seacable_studies::study::{
    hard_cases::{self, HardCase, TrialRun},
    speed::{
        self, SpeedError,
        at_rest::{self, SceneAtRest},
    },
    tally,
    timed::Timed,
};
use seacable_systems::system::at_rest::SystemAtRest;

/// Columns and rows of the chart.
const PLOT: (usize, usize) = (80, 24);

pub(super) fn study(args: &StudyArgs) -> Result<ExitCode, CommandError> {
    match args {
        StudyArgs::HardCases(args) => hard_cases(args),
        StudyArgs::Speed(args) => speed_of(args),
        StudyArgs::Steps(args) => steps_of(args),
        StudyArgs::Vary(args) => vary::vary(args),
        StudyArgs::Effects(args) => effects::effects(args),
        StudyArgs::Physics(args) => physics::physics(args),
        StudyArgs::Offsets(args) => system_study::offsets(args),
        StudyArgs::WatchCircle(args) => system_study::watch(args),
        StudyArgs::Seek(args) => system_study::goal(args),
        StudyArgs::Systems(args) => laboratory::systems(args),
        StudyArgs::Intervals(args) => laboratory::intervals(args),
        StudyArgs::Bars(args) => laboratory::bars(args),
        StudyArgs::Accuracy(args) => laboratory::accuracy(args),
    }
}

fn hard_cases(args: &HardArgs) -> Result<ExitCode, CommandError> {
    let file = OutputFile::check(args.table.output.as_deref(), args.table.force, &args.cases)?;
    let cases = cases::with_trials(&args.cases)?;
    let stop = StopFlag::listen()?;
    let computed = compute(&cases, &stop);
    if let Some(status) = stop.status() {
        output::message("Stopped before all trials were computed; nothing was judged.");
        return Ok(status);
    }
    let findings = hard_cases::verdicts(&cases, &computed);
    let table = hard_cases::table(&findings);
    write_csv(&table, file.as_ref())?;
    let tally = tally(&findings);
    print(&table, &format!("\n{tally}\n"), "hard-cases", &args.table)?;
    Ok(if tally.holds() {
        ExitCode::SUCCESS
    } else {
        ExitCode::from(BAD_RESULT)
    })
}

fn speed_of(args: &SpeedArgs) -> Result<ExitCode, CommandError> {
    let inputs = [args.case.file.clone()];
    let file = OutputFile::check(args.table.output.as_deref(), args.table.force, &inputs)?;
    let (name, scene) = scene_of(&args.case)?;
    match scene {
        StudiedScene::Line(case) if args.at_rest || case.solver.method == Method::Static => {
            speed_at_rest(args, file.as_ref(), &name, &*case)
        }
        StudiedScene::Line(case) => speed_of_scene(args, file.as_ref(), &name, &*case),
        StudiedScene::System(system) if args.at_rest => {
            let at_rest = SystemAtRest::new(system.solved.file.clone());
            speed_at_rest(args, file.as_ref(), &name, &at_rest)
        }
        StudiedScene::System(system) => speed_of_scene(args, file.as_ref(), &name, &system),
        StudiedScene::AtRest(system) => speed_at_rest(args, file.as_ref(), &name, &system),
    }
}

fn speed_of_scene<C: Timed>(
    args: &SpeedArgs,
    file: Option<&OutputFile<'_>>,
    name: &str,
    case: &C,
) -> Result<ExitCode, CommandError> {
    let stop = StopFlag::listen()?;
    let usage = |why: SpeedError| CommandError::Usage(format!("{name}: {why}."));
    let plan = speed::plan(case).map_err(usage)?;
    let mut line = progress::ProgressLine::new();
    let mut report_progress = |begun: usize, of: usize, what: &str| {
        line.show(&format!("{begun} of {of}: {what}"));
    };
    let study = match speed::compute(
        case,
        plan,
        args.repeats,
        stop.cancel(),
        &mut report_progress,
    ) {
        Ok(study) => study,
        Err(why) => return stopped(&stop, usage(why)),
    };
    drop(line);
    let table = speed::table(&study);
    write_csv(&table, file)?;
    let glyphs = output::glyphs(args.table.ascii);
    let chart = draw(&speed::chart(&study), PLOT.0, PLOT.1, glyphs).to_text();
    let mesh = speed::mesh_table(&study).to_text(WIDTH);
    print(&table, &format!("\n{chart}\n{mesh}"), "speed", &args.table)?;
    Ok(ExitCode::SUCCESS)
}

/// Closed form and segments of a scene at rest, and what is recommended for each accuracy.
fn speed_at_rest<S: SceneAtRest>(
    args: &SpeedArgs,
    file: Option<&OutputFile<'_>>,
    name: &str,
    scene: &S,
) -> Result<ExitCode, CommandError> {
    let stop = StopFlag::listen()?;
    let mut line = progress::ProgressLine::new();
    let mut report_progress = |begun: usize, of: usize, what: &str| {
        line.show(&format!("{begun} of {of}: {what}"));
    };
    let computed = at_rest::compute(scene, args.repeats, stop.cancel(), &mut report_progress);
    drop(line);
    let study = match computed {
        Ok(study) => study,
        Err(why) => return stopped(&stop, CommandError::Usage(format!("{name}: {why}."))),
    };
    let table = at_rest::table(&study);
    write_csv(&table, file)?;
    let glyphs = output::glyphs(args.table.ascii);
    let chart = draw(&at_rest::chart(&study), PLOT.0, PLOT.1, glyphs).to_text();
    let recommended = at_rest::recommended_table(&study, &args.accuracy).to_text(WIDTH);
    let results = at_rest::results_table(&study, &args.accuracy).to_text(WIDTH);
    let below = format!("\n{recommended}\n{chart}\n{results}");
    print(&table, &below, "speed", &args.table)?;
    Ok(ExitCode::SUCCESS)
}

/// How a study ends that did not come to its end: stopped by a signal, or in failure.
fn stopped(stop: &StopFlag, failure: CommandError) -> Result<ExitCode, CommandError> {
    let status = stop.status().ok_or(failure)?;
    output::message("Stopped before all points were computed.");
    Ok(status)
}

fn steps_of(args: &StepsArgs) -> Result<ExitCode, CommandError> {
    let inputs = [args.case.file.clone()];
    let file = OutputFile::check(args.table.output.as_deref(), args.table.force, &inputs)?;
    match scene_of(&args.case)? {
        (name, StudiedScene::Line(case)) => steps_of_scene(args, file.as_ref(), &name, &*case),
        (name, StudiedScene::System(system)) => steps_of_scene(args, file.as_ref(), &name, &system),
        (name, StudiedScene::AtRest(system)) => steps_of_scene(args, file.as_ref(), &name, &system),
    }
}

fn steps_of_scene<C: Timed>(
    args: &StepsArgs,
    file: Option<&OutputFile<'_>>,
    name: &str,
    case: &C,
) -> Result<ExitCode, CommandError> {
    let stop = StopFlag::listen()?;
    let mut line = progress::ProgressLine::new();
    let mut report_progress = |begun: usize, of: usize, what: &str| {
        line.show(&format!("{begun} of {of}: {what}"));
    };
    let rows = match speed::compare(case, args.variants, stop.cancel(), &mut report_progress) {
        Ok(rows) => rows,
        Err(why) => return stopped(&stop, CommandError::Usage(format!("{name}: {why}."))),
    };
    drop(line);
    let table = speed::comparison_table(&rows, args.variants);
    write_csv(&table, file)?;
    print(&table, "", "steps", &args.table)?;
    Ok(ExitCode::SUCCESS)
}

/// Every trial on its own core.
fn compute(cases: &[HardCase], stop: &StopFlag) -> Vec<Option<TrialRun>> {
    let line = Mutex::new(progress::ProgressLine::new());
    hard_cases::compute_all(cases, stop.cancel(), &|all, done| {
        if let Ok(mut line) = line.lock() {
            line.show(&format!("{done} of {} trials computed", all.len()));
        }
    })
}
