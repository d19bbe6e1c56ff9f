//! `seacable rules`: the sets of rules that come with the program.

use std::path::PathBuf;
use std::process::ExitCode;

use super::{
    CommandError,
    common_args::StudyPageArgs,
    output::{self, OutputFile},
    study_page::print,
};
use seacable_base::files::read;
use seacable_base::visible;
use seacable_display::table::Table;
use seacable_model::case::{nearest, rule_sets};
use seacable_report::rules;

#[derive(Debug, clap::Args)]
pub(super) struct RulesArgs {
    /// A set, by the name that `[[checks]]` give as `rules`, or a file of one; without it all that come with the program are listed.
    #[arg(value_name = "SET")]
    set: Option<String>,

    /// Print the text of the set, to copy and change.
    #[arg(long, requires = "set", conflicts_with_all = ["csv", "json"])]
    toml: bool,

    #[command(flatten)]
    page: StudyPageArgs,
}

pub(super) fn rules(args: &RulesArgs) -> Result<ExitCode, CommandError> {
    let page = &args.page;
    let inputs: Vec<PathBuf> = args.set.iter().map(PathBuf::from).collect();
    let file = OutputFile::check(page.table.output.as_deref(), page.table.force, &inputs)?;
    let table = match &args.set {
        None => sets()?,
        Some(name) => {
            let text = text(name)?;
            if args.toml {
                output::results(&text, page.table.ascii)?;
                return Ok(ExitCode::SUCCESS);
            }
            let set = rule_sets::parse(&text, name).map_err(CommandError::Invalid)?;
            rules::rules(&set)
        }
    };
    let tables = (std::slice::from_ref(&table), &table);
    print("rules", page, file.as_ref(), tables, &[])?;
    Ok(ExitCode::SUCCESS)
}

/// The sets that come with the program.
fn sets() -> Result<Table, CommandError> {
    let sets = rule_sets::shipped().map(|(name, text)| {
        let set = rule_sets::parse(text, name).map_err(CommandError::Invalid)?;
        Ok((name, set))
    });
    Ok(rules::sets(
        &sets.collect::<Result<Vec<_>, CommandError>>()?,
    ))
}

/// The text of a set.
fn text(name: &str) -> Result<String, CommandError> {
    if name.ends_with(".toml") {
        let text = read::text(name.as_ref());
        let shown = visible::path(name.as_ref());
        return text.map_err(|error| CommandError::Usage(format!("{shown}: {error}.")));
    }
    let mut shipped = rule_sets::shipped();
    let found = shipped.find(|(known, _)| *known == name);
    found.map(|(_, text)| text.to_owned()).ok_or_else(|| {
        let near = nearest(name, rule_sets::NAMES.iter().copied());
        let near = near.map_or_else(String::new, |near| format!(" Did you mean `{near}`?"));
        CommandError::Usage(format!(
            "There is no set of rules `{name}`; `seacable rules` lists them.{near}"
        ))
    })
}
