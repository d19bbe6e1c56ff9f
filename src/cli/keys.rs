//! `seacable keys`: the keys of a kind of file, a page a table.

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
use seacable_base::padding::{at_left, at_right};
use seacable_model::case::fields::{Field, Schema, TableSchema, json_schema, nearest};
use seacable_model::kinds::FileType;
use seacable_report::{document::wrap, text::WIDTH};

pub(super) fn keys(args: &KeysArgs) -> Result<ExitCode, CommandError> {
    let schema = kinds::schema(args.kind);
    if args.schema {
        let text = format!("{:#}\n", json_schema(schema));
        output::document(text.as_bytes(), FileFormat::Json)?;
        return Ok(ExitCode::SUCCESS);
    }
    let text = match &args.prefix {
        Some(prefix) => list(schema, prefix, width()),
        None if args.all => list(schema, "", width()),
        None => contents(schema, args.kind, width()),
    };
    if text.is_empty() {
        return Err(CommandError::Usage(without_keys(
            schema,
            args.prefix.as_deref().unwrap_or_default(),
        )));
    }
    output::results(&text, args.ascii)?;
    Ok(ExitCode::SUCCESS)
}

/// That no key has a prefix, with the table that may be meant.
fn without_keys(schema: &Schema, prefix: &str) -> String {
    let tables = schema
        .tables
        .iter()
        .map(|table| table.path.replace(".*", ""));
    let tables: Vec<String> = tables.collect();
    let near = nearest(prefix, tables.iter().map(String::as_str));
    let meant = near.map(|near| format!(", did you mean `{near}`?"));
    format!(
        "No key of a {} begins with `{prefix}`{} `seacable keys` without a prefix lists the tables, with --all every key.",
        schema.what,
        meant.as_deref().unwrap_or(";"),
    )
}

/// The tables of a kind of file, a line each: how many keys each has, and what it is.
fn contents(schema: &'static Schema, kind: FileType, width: usize) -> String {
    let mut seen: Vec<String> = Vec::new();
    let mut rows: Vec<(String, usize, &str)> = Vec::new();
    for table in schema.tables.iter() {
        let pattern = table.pattern().into_owned();
        let count = schema.fields_of(&pattern).count();
        if count == 0 || seen.contains(&pattern) {
            continue;
        }
        seen.push(pattern);
        let depth = table.path.split('.').filter(|part| *part != "*").count();
        let indent = "  ".repeat(depth.saturating_sub(1));
        rows.push((format!("{indent}{}", table.header()), count, table.help));
    }
    let column = rows.iter().map(|(name, ..)| name.len()).max();
    let column = column.unwrap_or(0) + 2;
    let whole: usize = rows.iter().map(|(_, count, _)| count).sum();
    let mut text = format!(
        "{} tables of a {}, with {whole} keys\n\n",
        rows.len(),
        schema.what
    );
    for (name, count, help) in &rows {
        let head = format!(
            "{}{}  ",
            at_left(name, column),
            at_right(&count.to_string(), 3)
        );
        let room = width.saturating_sub(head.len());
        text += &format!("{head}{}\n", in_a_line(help, room));
    }
    let named = match kind {
        FileType::Line => String::new(),
        other => format!(" --kind {}", other.table()),
    };
    let example = schema.tables.iter().find(|table| table.path == "solver");
    let example = example.or(schema.tables.first());
    let ends = format!(
        "`seacable keys{named} {}` lists the keys of one with units, ranges and defaults; --all those of all.",
        example.map_or("TABLE", |table| &table.path),
    );
    text.push('\n');
    text += &wrap(&ends, width).join("\n");
    text.push('\n');
    text
}

/// A sentence in a line, without its last words where there is no room.
fn in_a_line(sentence: &str, room: usize) -> String {
    if sentence.chars().count() <= room {
        return sentence.to_owned();
    }
    let first = wrap(sentence, room.saturating_sub(4)).into_iter().next();
    let first = first.unwrap_or_default();
    format!("{} ...", first.trim_end_matches([',', ';', ':']))
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
