//! What a case states along its studies: published and computed numbers over the key that is varied.

use seacable_display::chart::{Axis, Chart, Series};
use seacable_model::case::{Case, Statistic, Study};
use seacable_runs::reference::ValidationRow;
use seacable_runs::run::{self, QuantityId};

/// What a number is: of which study, of which channel, which statistic, within which window or stretch, which of
/// several.
type CurveKey<'c> = (
    &'c str,
    &'c run::Subject,
    Statistic,
    Option<[f64; 2]>,
    Option<usize>,
);

/// The charts of the studies of a case, from the rows of its validation table: one for each quantity that is stated at
/// several points of a study, or of which a trend is stated; in the order in which the case states them.
#[must_use]
pub fn along_studies(case: &Case, rows: &[ValidationRow]) -> Vec<Chart> {
    let mut all: Vec<(CurveKey<'_>, Chart)> = Vec::new();
    for (published, row) in case.published.iter().zip(rows) {
        let plain = row.from.is_none() && row.by.is_none() && published.by_stretch_m.is_none();
        let Some(at) = published.at.as_ref().filter(|_| plain) else {
            continue;
        };
        // Words have no place on an axis.
        let Some(value) = at.value.number() else {
            continue;
        };
        let within = published.within();
        let subject = (
            at.study.as_str(),
            &published.channel,
            published.statistic,
            within,
            published.nth,
        );
        let chart = chart_of_subject(&mut all, case, subject, row);
        add(chart, "published", 0, (value, row.published));
        add(chart, "computed", 1, (value, row.computed));
    }
    let trends = case
        .trend
        .iter()
        .zip(rows.iter().skip(case.published.len()));
    for (trend, row) in trends {
        let subject = (
            trend.study.as_str(),
            &trend.channel,
            trend.statistic,
            trend.within(),
            trend.nth,
        );
        let chart = chart_of_subject(&mut all, case, subject, row);
        for point in row.trend.iter().flat_map(|line| &line.points) {
            if let Some(value) = point.value.number() {
                add(chart, "computed", 1, (value, point.computed));
            }
        }
    }
    let mut charts: Vec<Chart> = all.into_iter().map(|(_, chart)| chart).collect();
    for series in charts.iter_mut().flat_map(|chart| &mut chart.series) {
        series.points.sort_by(|a, b| a.0.total_cmp(&b.0));
    }
    charts.retain(|chart| chart.series.iter().any(|series| series.points.len() > 1));
    charts
}

/// The chart of this subject, made where it is not there yet.
fn chart_of_subject<'a, 'c>(
    all: &'a mut Vec<(CurveKey<'c>, Chart)>,
    case: &Case,
    subject: CurveKey<'c>,
    row: &ValidationRow,
) -> &'a mut Chart {
    let place = all.iter().position(|(known, _)| *known == subject);
    let place = place.unwrap_or_else(|| {
        all.push((subject, empty(case, subject, row)));
        all.len() - 1
    });
    &mut all[place].1
}

fn empty(
    case: &Case,
    (study, channel, statistic, within, nth): CurveKey<'_>,
    row: &ValidationRow,
) -> Chart {
    let quantity = QuantityId::new(channel.clone(), statistic, within).numbered(nth);
    let key = case.study.iter().find(|s| s.name == study);
    Chart::new(
        format!("{quantity} along {study}"),
        key.map_or_else(Axis::default, axis),
        Axis::new(statistic.name(), &row.unit),
        Vec::new(),
    )
}

/// The axis of the key that a study varies.
fn axis(study: &Study) -> Axis {
    let path: Vec<&str> = study.key.split('.').collect();
    let field = seacable_model::case::field_at(&path);
    field.map_or_else(
        || Axis::new(&study.key, ""),
        |field| {
            let (label, unit) = field.in_words(&study.key);
            Axis::new(&label, unit)
        },
    )
}

/// Adds a point to a series, once.
fn add(chart: &mut Chart, name: &str, slot: usize, (x, y): (f64, Option<f64>)) {
    let Some(y) = y else { return };
    let place = chart.series.iter().position(|series| series.label == name);
    let place = place.unwrap_or_else(|| {
        chart.series.push(Series::new(name, slot, Vec::new()));
        chart.series.len() - 1
    });
    let points = &mut chart.series[place].points;
    if points.iter().all(|point| point.0 != x) {
        points.push((x, y));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use seacable_model::case;

    const CASE: &str = r#"
        case.title = "two studies"
        current.speed_m_per_s = 0.1
        materials.m = { diameter_m = 0.1, mass_kg_per_m = 10.0, ea_n = 1e8 }
        line = [{ name = "s", material = "m", length_m = 10.0, segments = 2 }]
        ends.a = { name = "a", kind = "fixed", position_m = [0.0, 0.0, 0.0] }
        ends.b = { name = "b", kind = "free" }
        study = [{ name = "flow", key = "current.speed_m_per_s", values = [0.2, 0.1] }]
        published = [
            { name = "p", channel = "x_m[b]", statistic = "travel", value = 3.0, tolerance_abs = 1.0, source = "s", inputs = "published", at = { study = "flow", value = 0.2 } },
            { name = "q", channel = "x_m[b]", statistic = "travel", value = 5.0, tolerance_abs = 1.0, source = "s", inputs = "published", at = { study = "flow", value = 0.1 } },
            { name = "alone", channel = "x_m[b]", statistic = "max", value = 5.0, tolerance_abs = 1.0, source = "s", inputs = "published", at = { study = "flow", value = 0.1 } },
        ]
        trend = [{ name = "t", study = "flow", channel = "x_m[b]", statistic = "travel", expect = "falls", source = "s" }]
    "#;

    /// Published values before anything is computed: sorted by the key, in its unit; one value alone makes no curve.
    #[test]
    fn what_is_published_is_there_before_any_run() {
        let case = case::parse(CASE, "c").unwrap();
        let rows = seacable_runs::reference::rows(&case, &|_| None);
        let charts = along_studies(&case, &rows);
        assert_eq!(charts.len(), 1);
        assert_eq!(charts[0].title, "x_m[b].travel along flow");
        assert_eq!(
            (charts[0].x.label.as_str(), charts[0].x.unit.as_str()),
            ("current speed", "m/s")
        );
        assert_eq!(charts[0].y.unit, "m");
        assert_eq!(charts[0].series.len(), 1);
        assert_eq!(charts[0].series[0].points, [(0.1, 5.0), (0.2, 3.0)]);
        assert!(along_studies(&case, &[]).is_empty());
    }

    /// Computed numbers of a value and of a trend of the same quantity lie on one chart, each once.
    #[test]
    fn what_is_computed_stands_beside_it() {
        let case = case::parse(CASE, "c").unwrap();
        let mut rows = seacable_runs::reference::rows(&case, &|_| None);
        rows[0].computed = Some(3.25);
        let line = rows[3].trend.as_mut().unwrap();
        for point in &mut line.points {
            point.computed = point.value.number();
        }
        let charts = along_studies(&case, &rows);
        assert_eq!(charts[0].series[1].label, "computed");
        assert_eq!(charts[0].series[1].points, [(0.1, 0.1), (0.2, 3.25)]);
    }
}
