//! `seacable modes`: natural frequencies and mode shapes of a case's line, or of a whole system.

use std::process::ExitCode;

use super::{
    BAD_RESULT, CommandError, cases,
    model_args::ModesArgs,
    output::{self, FileFormat, OutputFile},
    system_study,
};
use seacable_base::visible;
use seacable_display::chart;
use seacable_display::table::Table;
use seacable_engine::modes::{self, LineModes};
use seacable_model::kinds::{FileBytes, FileType};
use seacable_report::{modes as views, run_json, system::analysis as system_views};
use seacable_systems::system::analysis::periods;
use seacable_systems::system::motion::modes::modes_of_system;
use serde_json::Value;

/// Columns and lines of the page.
const WIDTH: usize = 108;
const HEIGHT: usize = 22;
/// Modes listed unless it is said how many.
const MODES: usize = 10;

pub(super) fn modes(args: &ModesArgs) -> Result<ExitCode, CommandError> {
    let bytes = FileBytes::read(&args.case.file);
    let count = args.count.unwrap_or(MODES);
    let inputs = [args.case.file.clone()];
    let file = OutputFile::check(args.output.as_deref(), args.force, &inputs)?;
    if bytes.kind() == FileType::System {
        let solved = system_study::solved(&args.case, bytes)?;
        let found = modes_of_system(&solved, count);
        let found = found.map_err(|why| format!("{}; {}", why.problem, why.remedy));
        let bodies = periods::periods(&solved.network, &solved.rest);
        let bodies = bodies.ok().filter(|found| !found.modes.is_empty());
        let object =
            |found: &LineModes| system_study::modes_object(&solved, found, bodies.as_ref());
        let more = bodies
            .as_ref()
            .map(|bodies| system_views::periods(&solved, bodies));
        let page = ModesPage {
            title: &solved.file.about.title,
            file,
            more,
        };
        return show(args, found, &object, page);
    }
    let case = cases::load_set(bytes, &args.case.set)?.case;
    let found = modes::of_case(&case, count).map_err(|why| why.to_string());
    let page = ModesPage {
        title: &case.case.title,
        file,
        more: None,
    };
    show(args, found, &run_json::modes, page)
}

/// What stands around the table and the picture.
struct ModesPage<'a> {
    title: &'a str,
    /// Where the shapes go.
    file: Option<OutputFile<'a>>,
    /// A table below them.
    more: Option<Table>,
}

/// Prints the modes, and writes their shapes where it is asked.
fn show(
    args: &ModesArgs,
    found: Result<LineModes, String>,
    object: &dyn Fn(&LineModes) -> Value,
    page: ModesPage<'_>,
) -> Result<ExitCode, CommandError> {
    let found = match found {
        Ok(found) => found,
        Err(why) => {
            output::message(&format!("error: No modes were computed: {why}"));
            return Ok(ExitCode::from(BAD_RESULT));
        }
    };
    if let Some(file) = page.file {
        file.write(views::csv(&found).as_bytes(), FileFormat::Text)?;
    }
    if args.json {
        output::object(&object(&found))?;
        return Ok(ExitCode::SUCCESS);
    }
    let glyphs = output::glyphs(args.ascii);
    let shown: Vec<usize> = if args.shape.is_empty() {
        // Of several lines each mode is several curves.
        let few = if found.lines.len() > 1 { 1 } else { 3 };
        (0..found.modes.len().min(few)).collect()
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
    let more = page
        .more
        .as_ref()
        .map(|table| format!("\n{}", table.to_text(WIDTH)));
    let text = format!(
        "Natural modes of {}\n\n{}\n{}{}",
        visible::line(page.title),
        views::table(&found).to_text(WIDTH),
        picture.to_text(),
        more.unwrap_or_default()
    );
    output::results(&text, args.ascii)?;
    Ok(ExitCode::SUCCESS)
}
