//! `seacable lines`: the library of line types.

use std::process::ExitCode;

use super::{CommandError, args::LinesArgs, output, output::FileFormat, study_page};
use crate::{
    line_types::{
        LINE_TYPES, LineProperties, LineType, find, material_name, material_table,
        nominal_diameter, properties,
    },
    report::line_types as tables,
};

pub(super) fn lines(args: &LinesArgs) -> Result<ExitCode, CommandError> {
    let file = output::OutputFile::check(
        args.page.table.output.as_deref(),
        args.page.table.force,
        &[],
    )?;
    let Some(name) = &args.line_type else {
        let list = tables::list();
        study_page::print(
            "line types",
            &args.page,
            file.as_ref(),
            (std::slice::from_ref(&list), &list),
            &[],
        )?;
        return Ok(ExitCode::SUCCESS);
    };
    let line = computed(named(name)?, args)?;
    if args.toml {
        print_material(&line, args.name.as_deref())?;
        return Ok(ExitCode::SUCCESS);
    }
    let (shown, data) = (tables::properties(&line), tables::data(&line));
    study_page::print(
        "line type",
        &args.page,
        file.as_ref(),
        (&[shown], &data),
        &[],
    )?;
    Ok(ExitCode::SUCCESS)
}

/// The type of a name; the error names those near it.
fn named(name: &str) -> Result<&'static LineType, CommandError> {
    find(name).ok_or_else(|| {
        let names = || LINE_TYPES.iter().map(|line| line.name);
        let mut meant: Vec<&str> = names().filter(|known| known.contains(name)).collect();
        if meant.is_empty() {
            meant.extend(crate::case::nearest(name, names()));
        }
        let meant = match meant.is_empty() {
            true => String::new(),
            false => format!("Near it: {}. ", meant.join(", ")),
        };
        CommandError::Usage(format!(
            "No line type is called `{name}`. {meant}`seacable lines` lists all."
        ))
    })
}

fn computed(
    line_type: &'static LineType,
    args: &LinesArgs,
) -> Result<LineProperties, CommandError> {
    let given = args.size.as_ref().or(args.diameter.as_ref());
    let Some(text) = given else {
        return Err(CommandError::Usage(format!(
            "Give the nominal diameter: `seacable lines {} 120mm`.",
            line_type.name
        )));
    };
    let line = nominal_diameter(text).and_then(|diameter| properties(line_type, diameter));
    let line = line.map_err(|error| CommandError::Usage(format!("{error}.")))?;
    if let Some(warning) = &line.warning {
        output::message(&format!("warning: {warning}"));
    }
    Ok(line)
}

fn print_material(line: &LineProperties, name: Option<&str>) -> Result<(), CommandError> {
    let own = material_name(line);
    let text = material_table(line, name.unwrap_or(&own));
    output::document(text.as_bytes(), FileFormat::Toml)
}
