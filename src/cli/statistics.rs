//! `seacable statistics`: statistics, extremes and fatigue of stored runs.

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use rayon::iter::{IntoParallelIterator, ParallelIterator};

use super::{CommandError, common_args::StudyPageArgs, output::OutputFile, study_page::print};
use seacable_base::files::read;
use seacable_base::visible;
use seacable_display::table::{Align, Cell, Columns, Table};
use seacable_model::case::fields::{TypedNumber, nearest};
use seacable_model::case::{ChannelId, ChannelQuantity, QuantityId, Statistic, Subject};
use seacable_numerics::statistics::Statistics as Moments;
use seacable_report::record_statistics::{ChannelView, FatigueView, fatigue, greatest, moments};
use seacable_runs::run::Quantity;
use seacable_runs::run::store::{ChannelRows, channel_rows, read_results};
use seacable_statistics::fatigue::component::FatigueComponent;
use seacable_statistics::fatigue::curve_file::read_curve;
use seacable_statistics::fatigue::curve_library::{PUBLISHED, published};
use seacable_studies::study::record_statistics::{
    self, ChannelRecord, ExtremeMethod, ExtremeQuestion, GreatestValue, RecordStatistics,
};

#[derive(Debug, clap::Args)]
pub(super) struct StatisticsArgs {
    /// Runs of the same case, alike but for the seed of their waves: their records are taken together.
    #[arg(value_name = "RUN_DIR", required_unless_present = "curves")]
    runs: Vec<PathBuf>,

    /// List the published fatigue curves, with their sources, and do nothing else.
    #[arg(long)]
    curves: bool,

    /// A channel, by its name in history.csv; may be repeated. By default all tensions.
    #[arg(long, value_name = "NAME")]
    channel: Vec<ChannelId>,

    /// Leave out what comes before this time, such as 60s: the start of the waves.
    #[arg(long, value_name = "TIME", value_parser = super::duration::seconds)]
    from: Option<f64>,

    /// Greatest value of so many hours.
    #[arg(long, value_name = "HOURS", default_value = "3", value_parser = hours)]
    hours: f64,

    /// Level of confidence of the intervals.
    #[arg(long, value_name = "SHARE", default_value = "0.95", value_parser = level)]
    level: f64,

    /// Fatigue by a published curve (`--curves` lists them), or by one in a file FILE.toml.
    #[arg(long, value_name = "CURVE")]
    fatigue: Option<String>,

    /// Nominal diameter of the line, such as 120mm, for curves of stress.
    #[arg(long, value_name = "LENGTH", value_parser = metres, requires = "fatigue")]
    diameter: Option<f64>,

    /// Reference breaking strength, such as 8MN, for curves of tension.
    #[arg(long, value_name = "FORCE", value_parser = newtons, requires = "fatigue")]
    strength: Option<f64>,

    /// Factor by which the life must exceed the service life.
    #[arg(long, value_name = "FACTOR", default_value = "1", value_parser = hours, requires = "fatigue")]
    design_factor: f64,

    #[command(flatten)]
    page: StudyPageArgs,
}

fn quantity(text: &str, unit: &str) -> Result<f64, String> {
    match TypedNumber::read(text, unit) {
        Some(TypedNumber::Plain(value) | TypedNumber::Converted(value)) if value > 0.0 => Ok(value),
        _ => Err(format!(
            "give a number above zero in {unit}, or with its unit"
        )),
    }
}

fn metres(text: &str) -> Result<f64, String> {
    quantity(text, "m")
}

fn newtons(text: &str) -> Result<f64, String> {
    quantity(text, "N")
}

fn hours(text: &str) -> Result<f64, String> {
    let number = text.parse::<f64>().ok();
    number
        .filter(|number| (1e-3..=1e6).contains(number))
        .ok_or_else(|| "give a number from 0.001 to 1e6".to_owned())
}

fn level(text: &str) -> Result<f64, String> {
    let number = text.parse::<f64>().ok();
    number
        .filter(|number| (0.5..=0.999).contains(number))
        .ok_or_else(|| "give a share from 0.5 to 0.999".to_owned())
}

pub(super) fn statistics(args: &StatisticsArgs) -> Result<ExitCode, CommandError> {
    if args.curves {
        return listed(args);
    }
    let table = &args.page.table;
    let file = OutputFile::check(table.output.as_deref(), table.force, &args.runs)?;
    let component = args
        .fatigue
        .as_ref()
        .map(|name| component(args, name))
        .transpose()?;
    let (records, summaries) = records(args)?;
    let question = ExtremeQuestion {
        hours: args.hours,
        level: args.level,
    };
    let views = records.into_par_iter().filter_map(|(id, records)| {
        let statistics = RecordStatistics::of_records(&records, question)?;
        let errors = [Statistic::Max, Statistic::Min].map(|of| numerical(&summaries, &id, of));
        let fatigue = component
            .as_ref()
            .filter(|_| id.quantity == ChannelQuantity::Tension)
            .map(|component| fatigue_of(&records, component, errors));
        Some(ChannelView {
            numerical: errors[0],
            id,
            statistics,
            fatigue,
        })
    });
    let views: Vec<ChannelView> = views.collect();
    let mut tables = vec![moments(&views), greatest(&views, question)];
    if let Some(component) = &component {
        tables.push(fatigue(&views, component.title(), args.design_factor));
    }
    let csv = csv(&views);
    print(
        "statistics",
        &args.page,
        file.as_ref(),
        (&tables, &csv),
        &[],
    )?;
    Ok(ExitCode::SUCCESS)
}

/// A channel with its records in all runs.
type Records = (ChannelId, Vec<ChannelRecord>);

/// The records of the channels asked for, and the results of the runs.
fn records(args: &StatisticsArgs) -> Result<(Vec<Records>, Vec<Vec<Quantity>>), CommandError> {
    let is_asked = |id: &ChannelId| match args.channel.is_empty() {
        true => id.quantity == ChannelQuantity::Tension,
        false => args.channel.contains(id),
    };
    let (mut records, mut summaries): (Vec<Records>, _) = (Vec::new(), Vec::new());
    for dir in &args.runs {
        let (_, summary) = read_results(dir)?;
        summaries.push(summary);
        let rows = channel_rows(dir, args.from.unwrap_or(0.0), is_asked)?;
        if let Some(missing) = args.channel.iter().find(|id| !rows.ids.contains(id)) {
            let dir = visible::path(dir);
            return Err(CommandError::Usage(format!(
                "{dir} has no channel {missing}."
            )));
        }
        add(&mut records, &rows)
            .map_err(|why| CommandError::Usage(format!("{}: {why}.", visible::path(dir))))?;
    }
    if records.is_empty() {
        let what = "The runs have no tensions; name a channel by --channel.";
        return Err(CommandError::Usage(what.to_owned()));
    }
    Ok((records, summaries))
}

/// Adds the records of a run.
fn add(records: &mut Vec<Records>, rows: &ChannelRows) -> Result<(), String> {
    for (id, values) in rows.ids.iter().zip(&rows.values) {
        let record = ChannelRecord::of_history(&rows.time, values).ok_or_else(|| {
            let rows = rows.time.len();
            format!("its history has {rows} rows from there on, too few or at uneven times")
        })?;
        match records.iter_mut().find(|(known, _)| known == id) {
            Some((_, list)) => list.push(record),
            None => records.push((id.clone(), vec![record])),
        }
    }
    Ok(())
}

/// The greatest numerical error of a statistic of a channel over the runs; none where one is not estimated.
fn numerical(summaries: &[Vec<Quantity>], id: &ChannelId, of: Statistic) -> Option<f64> {
    let id = QuantityId::new(Subject::Channel(id.clone()), of, None);
    let errors = summaries.iter().map(|summary| {
        let found = summary.iter().find(|quantity| quantity.id == id);
        found.and_then(Quantity::error_estimate)
    });
    errors
        .collect::<Option<Vec<f64>>>()?
        .into_iter()
        .reduce(f64::max)
}

/// The component of a published curve or of a file.
fn component(args: &StatisticsArgs, name: &str) -> Result<FatigueComponent, CommandError> {
    let wrong =
        |why: String| CommandError::Usage(format!("--fatigue {}: {why}.", visible::text(name)));
    if let Some(curve) = published(name) {
        let found = curve.component(args.diameter, args.strength);
        return found.map_err(|error| {
            wrong(format!(
                "{error}; give --strength or --diameter, as the curve needs"
            ))
        });
    }
    if !name.ends_with(".toml") {
        let known: Vec<&str> = PUBLISHED.iter().map(|curve| curve.id).collect();
        let remedy = match nearest(name, known.iter().copied()) {
            Some(near) => format!("did you mean `{near}`?"),
            None => format!("the curves are {}; a file ends in .toml", known.join(", ")),
        };
        return Err(wrong(format!("there is no such curve; {remedy}")));
    }
    let text = read::text(Path::new(name)).map_err(|error| wrong(error.to_string()))?;
    read_curve(&text).map_err(|error| wrong(error.to_string()))
}

fn fatigue_of(
    records: &[ChannelRecord],
    component: &FatigueComponent,
    errors: [Option<f64>; 2],
) -> Result<FatigueView, String> {
    let found = record_statistics::fatigue(records, component);
    let found = found.map_err(|error| error.to_string())?;
    let range_error = errors[0].zip(errors[1]).map(|(most, least)| most + least);
    let damage = found.damage;
    let numerical = range_error.filter(|_| damage.sum > 0.0);
    Ok(FatigueView {
        found,
        numerical: numerical
            .map(|error| damage.error_of_ranges(error) * found.per_year / damage.sum),
    })
}

/// The published curves.
fn listed(args: &StatisticsArgs) -> Result<ExitCode, CommandError> {
    let table = Table::of_records("Published curves", &PUBLISHED)
        .text("curve", |curve| curve.id)
        .text("of", |curve| curve.title)
        .cell("m", Align::Decimal, |curve| {
            Cell::plain(curve.law.exponent.to_string())
        })
        .text("reference strength", |curve| curve.strength)
        .text("source", |curve| curve.source)
        .text("numbers", |curve| curve.confirmed)
        .build();
    let page = &args.page;
    let file = OutputFile::check(page.table.output.as_deref(), page.table.force, &[])?;
    let tables = (std::slice::from_ref(&table), &table);
    print("curves", page, file.as_ref(), tables, &[])?;
    Ok(ExitCode::SUCCESS)
}

/// A figure with its name.
type NamedFigure<T> = (&'static str, fn(&T) -> f64);
/// One that may be missing.
type PossibleFigure<T> = (&'static str, fn(&T) -> Option<f64>);

/// A row for each channel, with every digit.
fn csv(views: &[ChannelView]) -> Table {
    let table = Table::of_records("", views)
        .text("channel", |row| row.id.to_string())
        .text("unit", |row| row.id.quantity.unit());
    with_fatigue(with_greatest(with_moments(table))).build()
}

fn number(value: Option<f64>) -> Cell {
    Cell::plain(value.map_or_else(String::new, |value| value.to_string()))
}

/// Moments, in the unit of the channel where they have one.
fn with_moments(mut table: Columns<'_, ChannelView>) -> Columns<'_, ChannelView> {
    let moments: [NamedFigure<Moments>; 7] = [
        ("mean", |s| s.mean),
        ("deviation", |s| s.deviation),
        ("skewness", |s| s.skewness),
        ("excess kurtosis", |s| s.excess),
        ("least", |s| s.min),
        ("greatest", |s| s.max),
        ("root mean square", |s| s.rms),
    ];
    for (name, read) in moments {
        table = table.cell(name, Align::Right, move |row| {
            number(Some(read(&row.statistics.moments)))
        });
    }
    table
        .cell("error of the mean", Align::Right, |row| {
            let mean = row.statistics.mean.as_ref().ok();
            number(mean.map(|mean| mean.error.max(mean.batch_error)))
        })
        .cell("crossings [1/s]", Align::Right, |row| {
            number(row.statistics.crossing_rate.as_ref().ok().copied())
        })
}

/// Greatest values with the ends of their intervals, in the unit of the channel.
fn with_greatest(mut table: Columns<'_, ChannelView>) -> Columns<'_, ChannelView> {
    let figures: [NamedFigure<GreatestValue>; 6] = [
        ("most probable", |g| g.most_probable.estimate),
        ("most probable, low", |g| g.most_probable.low),
        ("most probable, high", |g| g.most_probable.high),
        ("expected", |g| g.expected.estimate),
        ("expected, low", |g| g.expected.low),
        ("expected, high", |g| g.expected.high),
    ];
    for method in ExtremeMethod::ALL {
        for (name, read) in figures {
            let head = format!("{}: {name}", method.name());
            table = table.cell(&head, Align::Right, move |row| {
                let mut all = row.statistics.greatest.iter();
                let found = all.find(|(of, _)| *of == method);
                number(found.and_then(|(_, found)| found.as_ref().ok()).map(read))
            });
        }
    }
    table.cell("numerical error of the greatest", Align::Right, |row| {
        number(row.numerical)
    })
}

/// Damage of a year with its two errors, where it is asked for.
fn with_fatigue(mut table: Columns<'_, ChannelView>) -> Columns<'_, ChannelView> {
    let figures: [PossibleFigure<FatigueView>; 3] = [
        ("damage [1/year]", |f| Some(f.found.per_year)),
        ("numerical error of the damage [1/year]", |f| f.numerical),
        ("sample error of the damage [1/year]", |f| {
            f.found.sample_error
        }),
    ];
    for (name, read) in figures {
        table = table.cell(name, Align::Right, move |row| {
            let found = row.fatigue.as_ref().and_then(|found| found.as_ref().ok());
            number(found.and_then(read))
        });
    }
    table
}
