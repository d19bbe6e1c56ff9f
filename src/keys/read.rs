//! From a text to its tree, and to diagnostics with their places.

use toml::de::DeTable;

use seacable_base::files::shallow::shallow;

use super::diagnostic::{Diagnostic, Finding, MOST_DIAGNOSTICS};
use super::fields::Schema;
use super::parameters;
use super::tree::TomlNode;

/// The tree of a text with the numbers of its expressions, or what is wrong with its syntax and with them.
pub fn evaluated_tree(schema: &'static Schema, text: &str) -> Result<TomlNode, Vec<Finding>> {
    let mut tree = tree_of(text)?;
    match parameters::evaluate(schema, &mut tree) {
        found if found.is_empty() => Ok(tree),
        found => Err(found),
    }
}

/// Findings with their places in the text; of very many the first ones, and how many more there are.
pub fn diagnose(mut found: Vec<Finding>, text: &str, file: &str) -> Vec<Diagnostic> {
    let left_out = found.split_off(found.len().min(MOST_DIAGNOSTICS));
    let placed = found.into_iter().map(|finding| finding.at(file, text));
    let mut list: Vec<Diagnostic> = placed.collect();
    let number = left_out.len();
    if let Some(first) = left_out.into_iter().next() {
        list.push(Diagnostic::further(number, first.at(file, text)));
    }
    list
}

/// The tree of the text, or its faults of syntax.
pub fn tree_of(text: &str) -> Result<TomlNode, Vec<Finding>> {
    TomlNode::parse(text).map_err(|first| {
        if is_table_of_numbers(text) {
            let problem = "this is a table of numbers, not a case";
            let remedy = "give the case or the file of MoorDyn that names it";
            return vec![Finding::new(&(0..0), "", problem, remedy)];
        }
        let (_, all) = DeTable::parse_recoverable(shallow(text));
        let mut found: Vec<Finding> = all
            .iter()
            .map(|fault| syntax(fault.span(), fault.message()))
            .collect();
        if found.is_empty() {
            found.push(syntax(first.span(), first.message()));
        }
        found.sort_by_key(|fault| fault.span.start);
        found
    })
}

/// Whether the first row that says something has numbers alone, two at least, as a file of waves or of a motion has.
fn is_table_of_numbers(text: &str) -> bool {
    let mut rows = text.lines().map(str::split_whitespace);
    let first = rows.find_map(|words| {
        let words: Vec<&str> = words.collect();
        (!words.is_empty()).then_some(words)
    });
    first.is_some_and(|words| {
        words.len() > 1 && words.iter().all(|word| word.parse::<f64>().is_ok())
    })
}

fn syntax(span: Option<std::ops::Range<usize>>, message: &str) -> Finding {
    let said = message
        .lines()
        .map(str::trim)
        .collect::<Vec<_>>()
        .join(", ");
    Finding::new(
        &span.unwrap_or(0..0),
        "",
        format!("this is not TOML: {said}"),
        "a line holds `key = value`, a `[table]` header, or a `# comment`; text stands in quotes",
    )
}
