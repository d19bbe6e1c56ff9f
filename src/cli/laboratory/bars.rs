//! `seacable laboratory bars`: estimated errors held against those of converged runs.

use std::process::ExitCode;
use std::sync::Mutex;

use super::args::BarsArgs;
use super::scenes::{NamedScene, scenes};
use crate::CommandError;
use crate::cases::{self, NamedCase};
use crate::output::{self, OutputFile};
use crate::progress;
use crate::signals::StopFlag;
use crate::studied_scene::StudiedScene;
use crate::study_table::{WIDTH, print, write_csv};
use seacable_studies::laboratory::bars::{self, BarSetting};
use seacable_studies::laboratory::varied;

pub(crate) fn bars(args: &BarsArgs) -> Result<ExitCode, CommandError> {
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
