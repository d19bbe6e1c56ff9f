//! `seacable modes`: natural frequencies and mode shapes of a case's line.

use std::process::ExitCode;

use super::{
    BAD_RESULT, CommandError, cases,
    model_args::ModesArgs,
    output::{self, FileFormat, OutputFile},
    system_args::SystemArgs,
    system_study,
};
use seacable_base::visible;
use seacable_display::chart;
use seacable_engine::modes;
use seacable_model::kinds::{FileBytes, FileType};
use seacable_report::{modes as views, run_json};

/// Columns and lines of the page.
const WIDTH: usize = 108;
const HEIGHT: usize = 22;
/// Modes listed unless it is said how many.
const MODES: usize = 10;

pub(super) fn modes(args: &ModesArgs) -> Result<ExitCode, CommandError> {
    let bytes = FileBytes::read(&args.case.file);
    if bytes.kind() == FileType::System {
        if args.output.is_some() || !args.shape.is_empty() || args.count.is_some() {
            let how = "Systems of lines do not take --output, --shape or --count: all modes of their bodies are listed, without shapes.";
            return Err(CommandError::Usage(how.to_owned()));
        }
        let args = SystemArgs {
            case: args.case.clone(),
            ascii: args.ascii,
            json: args.json,
        };
        return system_study::modes(&args, bytes);
    }
    let inputs = [args.case.file.clone()];
    let file = OutputFile::check(args.output.as_deref(), args.force, &inputs)?;
    let case = cases::load_set(bytes, &args.case.set)?.case;
    let found = match modes::of_case(&case, args.count.unwrap_or(MODES)) {
        Ok(found) => found,
        Err(why) => {
            output::message(&format!("error: No modes were computed: {why}"));
            return Ok(ExitCode::from(BAD_RESULT));
        }
    };
    if args.json {
        if let Some(file) = file {
            file.write(views::csv(&found).as_bytes(), FileFormat::Text)?;
        }
        output::object(&run_json::modes(&found))?;
        return Ok(ExitCode::SUCCESS);
    }
    if let Some(file) = file {
        file.write(views::csv(&found).as_bytes(), FileFormat::Text)?;
    }
    let glyphs = output::glyphs(args.ascii);
    let shown: Vec<usize> = if args.shape.is_empty() {
        (0..found.modes.len().min(3)).collect()
    } else {
        args.shape.iter().map(|number| number - 1).collect()
    };
    if let Some(beyond) = shown.iter().find(|number| **number >= found.modes.len()) {
        return Err(CommandError::Usage(format!(
            "There is no mode {}: {} were found; ask for more with --count.",
            beyond + 1,
            found.modes.len()
        )));
    }
    let picture = chart::draw(&views::chart(&found, &shown), WIDTH, HEIGHT, glyphs);
    let page = format!(
        "Natural modes of {}\n\n{}\n{}",
        visible::line(&case.case.title),
        views::table(&found).to_text(WIDTH),
        picture.to_text()
    );
    output::results(&page, args.ascii)?;
    Ok(ExitCode::SUCCESS)
}
