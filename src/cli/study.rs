//! `seacable study`: hard cases against expected results, work against error, error-controlled against constant steps.

use std::{
    io,
    path::PathBuf,
    process::ExitCode,
    sync::{Arc, Mutex},
};

use super::{
    BAD_RESULT, CommandError,
    cases::{self, EditedFile, NamedCase},
    common_args::{CaseArgs, TableArgs},
    effects, intervals,
    output::{self, FileFormat, OutputFile},
    physics, progress, random_systems,
    signals::StopFlag,
    study_args::{AccuracyArgs, BarsArgs, HardArgs, SpeedArgs, StepsArgs, StudyArgs},
    system_study, vary,
};
use seacable_display::chart::draw;
use seacable_display::table::Table;
use seacable_foreign::import::ImportOptions;
use seacable_model::case::{Case, Method};
use seacable_model::kinds::{FileBytes, FileType};
use seacable_report::run_json as study_json;
use seacable_studies::study::{
    accuracy::{self, AccuracyTrial},
    bars::{self, BarSetting},
    hard_cases::{self, HardCase, TrialRun},
    speed::{
        self, SpeedError,
        at_rest::{self, AtRest},
    },
    tally,
    timed::Timed,
    varied,
};
use seacable_systems::system::{
    SystemFile, at_rest::SystemAtRest, motion::system_in_time::SystemInTime,
};

/// Columns of the page.
const WIDTH: usize = 160;

/// Columns and rows of the chart.
const PLOT: (usize, usize) = (80, 24);

pub(super) fn study(args: &StudyArgs) -> Result<ExitCode, CommandError> {
    match args {
        StudyArgs::HardCases(args) => hard_cases(args),
        StudyArgs::Speed(args) => speed_of(args),
        StudyArgs::Steps(args) => steps_of(args),
        StudyArgs::Bars(args) => bars_of(args),
        StudyArgs::Accuracy(args) => accuracy_of(args),
        StudyArgs::Intervals(args) => intervals::intervals(args),
        StudyArgs::Vary(args) => vary::vary(args),
        StudyArgs::Effects(args) => effects::effects(args),
        StudyArgs::Physics(args) => physics::physics(args),
        StudyArgs::Systems(args) => random_systems::systems(args),
        StudyArgs::Offsets(args) => system_study::offsets(args),
        StudyArgs::WatchCircle(args) => system_study::watch(args),
        StudyArgs::Seek(args) => system_study::goal(args),
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

/// Prints a table and what stands below it, or its rows as JSON.
fn print(table: &Table, below: &str, study: &str, args: &TableArgs) -> Result<(), CommandError> {
    if args.json {
        return output::object(&study_json::study(study, table));
    }
    let text = format!("{}{below}", table.to_text(WIDTH));
    output::results(&text, args.ascii)
}

/// Writes a table to a file, where one is asked for.
fn write_csv(table: &Table, file: Option<&OutputFile<'_>>) -> Result<(), CommandError> {
    let Some(file) = file else { return Ok(()) };
    let mut text = Vec::new();
    let written = table.write_csv(&mut text).map_err(io::Error::other);
    written.map_err(CommandError::Output)?;
    file.write(&text, FileFormat::Text)
}

/// A scene in time or at rest.
enum StudiedScene {
    Line(Box<Case>),
    System(SystemInTime),
    AtRest(SystemAtRest),
}

/// The scene of a file with what is set on top of it, and its name.
fn scene_of(args: &CaseArgs) -> Result<(String, StudiedScene), CommandError> {
    let file = FileBytes::read(&args.file);
    let name = file.path().display().to_string();
    if file.kind() != FileType::System {
        let loaded = cases::load_set(file, &args.set)?;
        return Ok((loaded.name, StudiedScene::Line(Box::new(loaded.case))));
    }
    let (system, _) = system_of(file, &args.set, &args.import.options())?;
    Ok((name, system))
}

/// The system of a file, in time where it has a table `[solver]`, and its text.
fn system_of(
    file: FileBytes,
    set: &[String],
    options: &ImportOptions,
) -> Result<(StudiedScene, String), CommandError> {
    let file = EditedFile::<SystemFile>::read(file, set, options)?;
    let text = file.whole_text();
    let solved = file.compute()?.computed;
    let scene = match solved.file.solver.clone() {
        Some(motion) => StudiedScene::System(SystemInTime::new(Arc::new(solved), motion)),
        None => StudiedScene::AtRest(SystemAtRest::new(solved.file)),
    };
    Ok((scene, text))
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
fn speed_at_rest<S: AtRest>(
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

fn bars_of(args: &BarsArgs) -> Result<ExitCode, CommandError> {
    let (varied, seed, by_result) = (args.varied, args.seed, args.results);
    let args = &args.cases;
    let file = OutputFile::check(args.table.output.as_deref(), args.table.force, &args.cases)?;
    let scenes = match varied {
        Some(_) => Vec::new(),
        None => scenes(&args.cases)?,
    };
    let drawn = match varied {
        Some(_) => cases::of_lines(&args.cases)?,
        None => Vec::new(),
    };
    let stop = StopFlag::listen()?;
    let of_scene = |named: &NamedScene| match &named.scene {
        StudiedScene::Line(case) => bars::settings(&named.name, &**case),
        StudiedScene::System(system) => bars::settings(&named.name, system),
        StudiedScene::AtRest(system) => bars::settings(&named.name, system),
    };
    let of_drawn = |named: &NamedCase| {
        let count = varied.unwrap_or_default();
        varied::settings(&named.name, &named.case, seed, count)
    };
    let settings: Vec<BarSetting> = (scenes.iter().flat_map(of_scene))
        .chain(drawn.iter().flat_map(of_drawn))
        .collect();
    let (line, total) = (
        Mutex::new((0, progress::ProgressLine::new())),
        settings.len(),
    );
    let checks = bars::compute(settings, stop.cancel(), &|setting| {
        if let Ok(mut line) = line.lock() {
            line.0 += 1;
            let words = format!(
                "{} of {total}: {}, {}",
                line.0, setting.name, setting.setting
            );
            line.1.show(&words);
        }
    });
    drop(line);
    if let Some(status) = stop.status() {
        output::message("Stopped before all settings were computed; nothing was judged.");
        return Ok(status);
    }
    let (table, below) = if by_result {
        (bars::results_table(&checks), String::new())
    } else {
        let outside = bars::outside_table(&checks).to_text(WIDTH);
        (bars::table(&checks), format!("\n{outside}"))
    };
    write_csv(&table, file.as_ref())?;
    print(&table, &below, "bars", &args.table)?;
    Ok(ExitCode::SUCCESS)
}

/// A scene of a file that is named.
struct NamedScene {
    name: String,
    text: String,
    scene: StudiedScene,
}

/// The scenes named, systems among them; without names, the cases of lines as [`cases::of_lines`].
fn scenes(paths: &[PathBuf]) -> Result<Vec<NamedScene>, CommandError> {
    let systems = cases::systems(paths)?;
    let lines = match systems.is_empty() {
        true => cases::of_lines(paths)?,
        false => cases::lines_among(paths)?,
    };
    let of_line = |named: NamedCase| NamedScene {
        name: named.name,
        text: named.text,
        scene: StudiedScene::Line(Box::new(named.case)),
    };
    let mut scenes: Vec<NamedScene> = lines.into_iter().map(of_line).collect();
    for path in &systems {
        let file = FileBytes::read(path);
        let name = path.display().to_string();
        let (scene, text) = system_of(file, &[], &ImportOptions::default())?;
        scenes.push(NamedScene { name, text, scene });
    }
    Ok(scenes)
}

fn accuracy_of(args: &AccuracyArgs) -> Result<ExitCode, CommandError> {
    let file = OutputFile::check(args.table.output.as_deref(), args.table.force, &args.cases)?;
    let scenes = scenes(&args.cases)?;
    let stop = StopFlag::listen()?;
    let mut line = progress::ProgressLine::new();
    let total = scenes.len() * args.accuracy.len();
    let mut rows = Vec::with_capacity(total);
    for NamedScene { name, text, scene } in &scenes {
        for asked in &args.accuracy {
            line.show(&format!("{} of {total}: {name}, {asked:e}", rows.len() + 1));
            let trial = AccuracyTrial {
                name: name.clone(),
                asked: *asked,
                budget_s: args.budget,
            };
            let found = match scene {
                StudiedScene::Line(case) => accuracy::check(&trial, &**case, text, stop.cancel()),
                StudiedScene::System(system) => {
                    accuracy::check(&trial, system, text, stop.cancel())
                }
                StudiedScene::AtRest(system) => {
                    accuracy::check(&trial, system, text, stop.cancel())
                }
            };
            if let Some(status) = stop.status() {
                output::message("Stopped before all searches were computed; nothing was judged.");
                return Ok(status);
            }
            rows.push((trial, found));
        }
    }
    drop(line);
    let table = accuracy::table(&rows);
    write_csv(&table, file.as_ref())?;
    let totals = accuracy::totals(&rows).to_text(WIDTH);
    print(&table, &format!("\n{totals}"), "accuracy", &args.table)?;
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
