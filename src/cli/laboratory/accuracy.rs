//! `seacable laboratory accuracy`: accuracies asked, held against the truth.

use std::process::ExitCode;

use super::args::AccuracyArgs;
use super::scenes::{NamedScene, scenes};
use crate::CommandError;
use crate::output::{self, OutputFile};
use crate::progress;
use crate::signals::StopFlag;
use crate::studied_scene::StudiedScene;
use crate::study_table::{WIDTH, print, write_csv};
use seacable_studies::laboratory::accuracy::{self, AccuracyTrial};

pub(crate) fn accuracy(args: &AccuracyArgs) -> Result<ExitCode, CommandError> {
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
