//! `seacable ship`: a ship at single-point mooring.

use std::{path::Path, process::ExitCode, sync::atomic::AtomicBool};

use super::{CommandError, cases, model_args::ShipArgs, output};
use seacable_foreign::import::ImportOptions;
use seacable_model::kinds::FileBytes;
use seacable_report::{ship, text::WIDTH};
use seacable_systems::ship::{DynamicAnalysis, MotionError, Ship};

pub(super) fn ship(args: &ShipArgs) -> Result<ExitCode, CommandError> {
    let (fields, rest) = cases::load_with::<Ship>(
        FileBytes::read(&args.file),
        &args.set,
        &ImportOptions::default(),
    )?;
    let folder = args.file.parent().unwrap_or(Path::new(""));
    let sea = DynamicAnalysis::new(&rest, folder, &AtomicBool::new(false));
    if let Some(Some(Err(MotionError::File(diagnostic)))) = sea.as_ref().map(|sea| &sea.motion) {
        return Err(CommandError::Invalid(vec![diagnostic.clone()]));
    }
    let glyphs = output::glyphs(args.ascii);
    let report = ship::report(&rest, sea.as_ref(), &fields);
    output::results(&report.to_text(WIDTH, glyphs), args.ascii)?;
    Ok(ExitCode::SUCCESS)
}
