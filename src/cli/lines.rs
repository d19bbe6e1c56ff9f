//! `seacable lines`: the library of line types.

use seacable_base::visible;
use std::{
    path::{Path, PathBuf},
    process::ExitCode,
};

use super::{CommandError, model_args::LinesArgs, output, output::FileFormat, study_page};
use seacable_base::files;
use seacable_foreign::import::yaml::library;
use seacable_model::case;
use seacable_model::line_types::{
    LINE_TYPES, Library, LineProperties, LineType, find, material_name, material_table,
    nominal_diameter, properties,
};
use seacable_report::line_types as tables;

pub(super) fn lines(args: &LinesArgs) -> Result<ExitCode, CommandError> {
    let inputs: Vec<PathBuf> = args.library.iter().cloned().collect();
    let file = output::OutputFile::check(
        args.page.table.output.as_deref(),
        args.page.table.force,
        &inputs,
    )?;
    let library = args.library.as_deref().map(read).transpose()?;
    let Some(name) = &args.line_type else {
        library.iter().for_each(warn_of_unread);
        let list = library.as_ref().map_or_else(tables::list, tables::library);
        study_page::print(
            "line types",
            &args.page,
            file.as_ref(),
            (std::slice::from_ref(&list), &list),
            &[],
        )?;
        return Ok(ExitCode::SUCCESS);
    };
    let line = match &library {
        Some(library) => of_library(library, name, args)?,
        None => computed(named(name)?, args)?,
    };
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

/// A library of the user.
fn read(path: &Path) -> Result<Library, CommandError> {
    let text = files::read::text_lossy(path).map_err(|error| {
        CommandError::Usage(format!("Reading {} failed: {error}", visible::path(path)))
    })?;
    let found = library::read(&text, &visible::path(path));
    found.map_err(CommandError::Invalid)
}

/// Says which types of a library cannot be read, and why.
fn warn_of_unread(library: &Library) {
    for of in &library.not_read {
        let why: Vec<String> = of.faults.iter().map(ToString::to_string).collect();
        let name = &of.name;
        let why = why.join("\n");
        output::message(&format!(
            "warning: the line type `{name}` is left out: {why}"
        ));
    }
}

/// The properties of a type of a library.
fn of_library(
    library: &Library,
    name: &str,
    args: &LinesArgs,
) -> Result<LineProperties, CommandError> {
    if let Some(unread) = library.find_unread(name) {
        return Err(CommandError::Invalid(unread.faults.clone()));
    }
    let Some(of) = library.find(name) else {
        let names: Vec<&str> = library.types.iter().map(|of| of.name.as_str()).collect();
        return Err(CommandError::Usage(format!(
            "The library {} has no line type `{name}`. It has {}.",
            library.file,
            names.join(", ")
        )));
    };
    let line = diameter(args, &of.name)?;
    let line = nominal_diameter(line).and_then(|diameter| library.properties(of, diameter));
    line.map_err(|error| CommandError::Usage(format!("{error}.")))
}

/// The nominal diameter that was given, as a text.
fn diameter<'a>(args: &'a LinesArgs, name: &str) -> Result<&'a str, CommandError> {
    let given = args.size.as_ref().or(args.diameter.as_ref());
    given.map(String::as_str).ok_or_else(|| {
        CommandError::Usage(format!(
            "Give the nominal diameter: `seacable lines {name} 120mm`."
        ))
    })
}

/// The type of a name; the error names those near it.
fn named(name: &str) -> Result<&'static LineType, CommandError> {
    find(name).ok_or_else(|| {
        let names = || LINE_TYPES.iter().map(|line| line.name);
        let mut meant: Vec<&str> = names().filter(|known| known.contains(name)).collect();
        if meant.is_empty() {
            meant.extend(case::nearest(name, names()));
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
    let text = diameter(args, line_type.name)?;
    let line = nominal_diameter(text).and_then(|diameter| properties(line_type, diameter));
    let line = line.map_err(|error| CommandError::Usage(format!("{error}.")))?;
    if let Some(warning) = &line.warning {
        output::message(&format!("warning: {warning}"));
    }
    Ok(line)
}

fn print_material(line: &LineProperties, name: Option<&str>) -> Result<(), CommandError> {
    let own = material_name(line);
    if let Some(name) = name.filter(|name| !case::is_name(name)) {
        return Err(CommandError::Usage(format!(
            "--name {name}: a name has letters, digits, - and _, at most 100 of them."
        )));
    }
    let text = material_table(line, name.unwrap_or(&own));
    output::document(text.as_bytes(), FileFormat::Toml)
}
