//! `seacable laboratory intervals`: how often the intervals of extremes hold the truth, and how often a verdict over seeds is false.

use std::process::ExitCode;

use rayon::prelude::*;

use super::args::IntervalsArgs;
use crate::CommandError;
use crate::common_args::TableArgs;
use crate::output::{self, OutputFile};
use crate::study_page::print;
use seacable_display::table::{Align, Cell, Table};
use seacable_statistics::extremes::ExtremesError;
use seacable_statistics::extremes::coverage::{
    Coverage, CoverageStudy, Distribution, default_method, measure,
};
use seacable_statistics::extremes::sequential_study::{
    self, Rule, SequentialOutcome, SequentialStudy,
};
use seacable_statistics::extremes::target::ExtremesTarget;

/// Level of the intervals, and the error of the rules.
const LEVEL: f64 = 0.95;
/// Seeds after which a stream is given up.
const LONGEST: usize = 1000;
/// By how many deviations the limit is above the true figure.
const MARGINS: [f64; 4] = [0.0, 0.5, 1.0, 2.0];

const LAWS: [(&str, Distribution); 2] = [
    ("Gumbel", Distribution::Gumbel),
    ("Weibull, shape 2", Distribution::Weibull { shape: 2.0 }),
];

struct CoverageRow {
    law: &'static str,
    values: usize,
    figure: String,
    found: Result<Coverage, ExtremesError>,
}

struct RuleRow {
    rule: &'static str,
    margin: f64,
    found: Result<SequentialOutcome, ExtremesError>,
}

pub(crate) fn intervals(args: &IntervalsArgs) -> Result<ExitCode, CommandError> {
    let TableArgs { output, force, .. } = &args.page.table;
    let file = OutputFile::check(output.as_deref(), *force, &[])?;
    let tables = [coverage(args), rules(args)];
    print(
        "intervals",
        &args.page,
        file.as_ref(),
        (&tables, &tables[0]),
        &[],
    )?;
    output::message(
        "Each sample is a stream of the seed: other seeds give other samples of the same law.",
    );
    Ok(ExitCode::SUCCESS)
}

fn coverage(args: &IntervalsArgs) -> Table {
    let sizes = match args.values.is_empty() {
        true => vec![5, 10, 20, 30, 50, 100],
        false => args.values.iter().map(|n| usize::from(*n)).collect(),
    };
    let figures = |n: usize| {
        [
            ("90 % quantile".to_owned(), ExtremesTarget::quantile(0.9)),
            (
                format!("expected of {n}"),
                ExtremesTarget::expected(n as f64),
            ),
        ]
    };
    let studies = LAWS.into_iter().flat_map(|(law, distribution)| {
        let sizes = sizes.clone().into_iter();
        sizes.flat_map(move |n| {
            figures(n).map(|(figure, target)| (law, distribution, n, figure, target))
        })
    });
    let studies: Vec<_> = studies.collect();
    let one = |(law, distribution, values, figure, target)| CoverageRow {
        law,
        values,
        figure,
        found: measure(&CoverageStudy {
            distribution,
            count: values,
            target,
            level: LEVEL,
            method: default_method(distribution, args.seed),
            draws: args.draws,
            seed: args.seed,
        }),
    };
    let rows: Vec<CoverageRow> = studies.into_par_iter().map(one).collect();
    let percent = |row: &CoverageRow, read: fn(&Coverage) -> f64| match &row.found {
        Ok(found) => Cell::plain(format!("{:.1} %", 100.0 * read(found))),
        Err(why) => Cell::plain(why.to_string()),
    };
    Table::of_records("Intervals of 95 %: how often they hold the truth", &rows)
        .text("law", |row| row.law)
        .count("values", |row| row.values)
        .text("figure", |row| row.figure.clone())
        .cell("covered", Align::Decimal, |row| percent(row, |c| c.covered))
        .cell("standard error", Align::Decimal, |row| {
            percent(row, |c| c.error)
        })
        .cell("below the truth", Align::Decimal, |row| {
            percent(row, |c| c.below)
        })
        .cell("above the truth", Align::Decimal, |row| {
            percent(row, |c| c.above)
        })
        .build()
}

fn rules(args: &IntervalsArgs) -> Table {
    let rules = [
        ("fractile 0.37, any law", Rule::Fractile(0.37)),
        ("fractile 0.5, any law", Rule::Fractile(0.5)),
        (
            "mean, Gumbel's law",
            Rule::Gumbel(ExtremesTarget::expected(1.0), 5),
        ),
    ];
    let studies = rules
        .into_iter()
        .flat_map(|(name, rule)| MARGINS.map(|margin| (name, rule, margin)));
    let studies: Vec<_> = studies.collect();
    let one = |(rule, of, margin)| RuleRow {
        rule,
        margin,
        found: sequential_study::run(&SequentialStudy {
            rule: of,
            distribution: Distribution::Gumbel,
            margin,
            error: 1.0 - LEVEL,
            streams: args.draws,
            longest: LONGEST,
            seed: args.seed,
        }),
    };
    let rows: Vec<RuleRow> = studies.into_par_iter().map(one).collect();
    let cell = |row: &RuleRow, read: fn(&SequentialOutcome) -> String| match &row.found {
        Ok(found) => Cell::plain(read(found)),
        Err(why) => Cell::plain(why.to_string()),
    };
    Table::of_records("Seeds drawn until a verdict is settled, false with a probability of 5 % at most", &rows)
        .text("rule", |row| row.rule)
        .cell("limit above the figure [deviations]", Align::Decimal, |row| Cell::plain(row.margin.to_string()))
        .cell("below the limit", Align::Decimal, |row| cell(row, |f| format!("{:.1} %", 100.0 * f.below)))
        .cell("above the limit", Align::Decimal, |row| cell(row, |f| format!("{:.1} %", 100.0 * f.above)))
        .cell("open", Align::Decimal, |row| cell(row, |f| format!("{:.1} %", 100.0 * f.open)))
        .cell("seeds, median", Align::Right, |row| cell(row, |f| f.median_seeds.to_string()))
        .cell("nine in ten", Align::Right, |row| cell(row, |f| f.most_seeds.to_string()))
        .build()
        .noted(["With the limit at the figure itself either verdict is false: each must come in 5 % of the streams at most. A stream ends after 1,000 seeds."])
}
