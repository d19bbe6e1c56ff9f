//! `seacable keys`: every key of a kind of file.

use std::{
    io::{IsTerminal, stdout},
    process::ExitCode,
};

use super::{
    CommandError,
    args::KeysArgs,
    kinds,
    output::{self, FileFormat},
};
use seacable_base::padding::at_left;
use seacable_model::case::fields::{Field, Schema, TableSchema, json_schema};
use seacable_report::{document::wrap, text::WIDTH};

pub(super) fn keys(args: &KeysArgs) -> Result<ExitCode, CommandError> {
    let schema = kinds::schema(args.kind);
    if args.schema {
        let text = format!("{:#}\n", json_schema(schema));
        output::document(text.as_bytes(), FileFormat::Json)?;
        return Ok(ExitCode::SUCCESS);
    }
    let prefix = args.prefix.as_deref().unwrap_or_default();
    let text = list(schema, prefix, width());
    if text.is_empty() {
        return Err(CommandError::Usage(format!(
            "No key of a {} begins with `{prefix}`; `seacable keys` without a prefix lists all.",
            schema.what
        )));
    }
    output::results(&text, args.ascii)?;
    Ok(ExitCode::SUCCESS)
}

/// Columns of the terminal, or those of a plain page.
fn width() -> usize {
    let terminal = stdout().is_terminal().then(crossterm::terminal::size);
    let columns = terminal
        .and_then(Result::ok)
        .map(|(columns, _)| usize::from(columns));
    columns.unwrap_or(WIDTH).clamp(40, 120)
}

/// The keys whose path begins with `prefix`, table by table.
fn list(schema: &'static Schema, prefix: &str, width: usize) -> String {
    let wanted = prefix.trim_end_matches('.').replace(".<name>", ".*");
    let below = |path: &str| {
        let rest = path.strip_prefix(wanted.as_str());
        rest.is_some_and(|rest| wanted.is_empty() || rest.is_empty() || rest.starts_with('.'))
    };
    let mut seen: Vec<String> = Vec::new();
    let mut text = String::new();
    for table in schema.tables.iter() {
        let pattern = table.pattern().into_owned();
        let whole = below(&table.path) || below(&pattern);
        let fields: Vec<&Field> = schema
            .fields_of(&pattern)
            .filter(|field| whole || below(&field.path))
            .collect();
        if fields.is_empty() || seen.contains(&pattern) {
            continue;
        }
        if !text.is_empty() {
            text.push('\n');
        }
        text += &table_text(table, &fields, width);
        seen.push(pattern);
    }
    text
}

fn table_text(table: &TableSchema, fields: &[&Field], width: usize) -> String {
    let name_of = |field: &&Field| match field.key() {
        "*" => "<name>".to_owned(),
        key => key.to_owned(),
    };
    let names = fields.iter().map(|field| name_of(field).len());
    let column = names.max().unwrap_or(0).min(width / 2) + 4;
    let title = format!("{}  {}", table.header(), table.help);
    let mut text = wrap(&title, width).join("\n    ") + "\n";
    for field in fields {
        let name = format!("  {}", name_of(field));
        let facts = format!("{}; {}", field.range_text(), field.absent_text());
        let condition = field.condition();
        let meaning = format!("{}: {}", field.label, field.help);
        let paragraphs = [Some(facts), condition, Some(meaning)];
        let words = paragraphs
            .iter()
            .flatten()
            .flat_map(|words| wrap(words, width - column));
        let mut head = name.as_str();
        for line in words {
            if head.len() + 2 > column {
                text += &format!("{head}\n");
                head = "";
            }
            text += &format!("{}{line}\n", at_left(head, column));
            head = "";
        }
    }
    text
}
