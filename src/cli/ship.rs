//! `seacable ship`: a ship at single-point mooring.

use std::{path::Path, process::ExitCode, sync::atomic::AtomicBool};

use super::{CommandError, args::ShipArgs, cases, output};
use crate::{
    report::ship::text,
    ship::{self, DynamicAnalysis, MotionError, edit},
};

pub(super) fn ship(args: &ShipArgs) -> Result<ExitCode, CommandError> {
    let loaded = ship::load(&args.file).map_err(CommandError::invalid_file(&args.file))?;
    let edits = cases::edits(&args.set)?;
    let text = edit::set_all(&loaded.text, &edits).map_err(CommandError::invalid(&loaded.text))?;
    let rest = ship::parse(&text, &args.file.display().to_string())
        .map_err(CommandError::invalid(&text))?;
    let folder = args.file.parent().unwrap_or(Path::new(""));
    let sea = DynamicAnalysis::new(&rest, folder, &AtomicBool::new(false));
    if let Some(Some(Err(MotionError::File(diagnostic)))) = sea.as_ref().map(|sea| &sea.motion) {
        let invalid = CommandError::invalid_file(Path::new(&diagnostic.file));
        return Err(invalid(vec![diagnostic.clone()]));
    }
    let glyphs = output::glyphs(args.ascii);
    let page = text::text(&rest, sea.as_ref(), &text, glyphs);
    output::results(&page, args.ascii)?;
    Ok(ExitCode::SUCCESS)
}
