//! `seacable bindings`: the keys of the workbench.

use std::process::ExitCode;

use serde_json::json;

use super::{CommandError, about_args::BindingsArgs, output};
use seacable_base::visible;
use seacable_model::case::render_all;
use seacable_tui::bindings::listing::{self, ListedCommand};
use seacable_tui::settings::{UserSettings, keys_file};

/// Exit status of a file of keys with faults.
const FAULTS: u8 = 1;

pub(super) fn bindings(args: &BindingsArgs) -> Result<ExitCode, CommandError> {
    if args.default {
        output::results(&listing::default_file(), args.ascii)?;
        return Ok(ExitCode::SUCCESS);
    }
    let settings = UserSettings::load();
    let listed = wanted(args, listing::commands(&settings.keys))?;
    if args.json {
        output::object(&object(&listed))?;
    } else {
        let width = output::page_width(args.width);
        output::results(&page(&listed, width), args.ascii)?;
    }
    let faults: Vec<_> = settings
        .faults
        .into_iter()
        .filter(|fault| fault.file.ends_with("keys.toml"))
        .collect();
    if faults.is_empty() {
        return Ok(ExitCode::SUCCESS);
    }
    output::coloured_message(&render_all(&faults, false), &render_all(&faults, true));
    Ok(ExitCode::from(FAULTS))
}

/// The commands of the table asked for.
fn wanted(
    args: &BindingsArgs,
    mut listed: Vec<ListedCommand>,
) -> Result<Vec<ListedCommand>, CommandError> {
    let Some(table) = &args.table else {
        return Ok(listed);
    };
    let mut tables: Vec<String> = listed.iter().map(|line| line.table.clone()).collect();
    tables.dedup();
    listed.retain(|line| line.table == *table);
    if listed.is_empty() {
        return Err(CommandError::Usage(format!(
            "There is no table `{table}` of keys; the tables are {}.",
            tables.join(", ")
        )));
    }
    Ok(listed)
}

fn page(listed: &[ListedCommand], width: usize) -> String {
    let file = keys_file().map_or_else(|error| error.to_string(), |path| visible::path(&path));
    let table = listing::table(listed).noted([
        format!("Your own keys are read from {file}; `seacable bindings --default` prints such a file, with a comment for each key."),
    ]);
    table.to_text(width)
}

fn object(listed: &[ListedCommand]) -> serde_json::Value {
    let each = listed.iter().map(|line| {
        json!({
            "table": line.table,
            "command": line.name,
            "keys": line.keys.iter().collect::<Vec<_>>(),
            "help": line.doc,
        })
    });
    json!({ "commands": each.collect::<Vec<_>>() })
}
