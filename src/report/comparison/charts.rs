//! Difference curves as a chart.

use crate::document::Report;
use seacable_display::chart::{Axis, Chart, LimitLine, ReferenceLine, Series};
use seacable_model::case::ChannelQuantity;
use seacable_runs::run::Run;
use seacable_studies::comparison::{CurveDifference, differences, letter};

/// The difference curves of one quantity, a curve a place, about a line at zero. `words` say which run less which.
#[must_use]
pub fn difference_chart(
    curves: &[CurveDifference],
    quantity: ChannelQuantity,
    words: &str,
) -> Chart {
    let of_quantity = curves.iter().filter(|curve| curve.id.quantity == quantity);
    let series = of_quantity
        .enumerate()
        .map(|(slot, curve)| Series::new(&curve.id.place, slot, curve.points.clone()));
    let unit = quantity.unit();
    let mut chart = Chart::new(
        format!("{}: {words}", quantity.title()),
        Axis::new("time", "s"),
        Axis::new("difference", unit),
        series.collect(),
    );
    chart.limits = vec![ReferenceLine::new("", LimitLine::Horizontal(0.0))];
    chart
}

/// Rows of a chart.
const LINES: usize = 16;

/// Adds the difference curves of each run less the first, a chart a quantity; quantities without a difference are left out.
pub fn add_difference_curves(page: &mut Report, runs: &[&Run]) {
    let Some((first, others)) = runs.split_first() else {
        return;
    };
    for (other, index) in others.iter().zip(1..) {
        let words = format!("{} - {}", letter(index), letter(0));
        let curves = differences(&first.history, &other.history);
        for quantity in quantities(&curves) {
            page.chart(difference_chart(&curves, quantity, &words), LINES);
        }
    }
}

/// The quantities of curves that differ, in their order.
fn quantities(curves: &[CurveDifference]) -> Vec<ChannelQuantity> {
    let mut found = Vec::new();
    for curve in curves.iter().filter(|curve| curve.rms > 0.0) {
        if !found.contains(&curve.id.quantity) {
            found.push(curve.id.quantity);
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_curves_of_the_quantity_are_drawn() {
        let curve = |name: &str| CurveDifference {
            id: name.parse().unwrap(),
            points: vec![(0.0, 0.0), (1.0, 2.0)],
            rms: 1.0,
            greatest: (2.0, 1.0),
        };
        let curves = [curve("z_m[end]"), curve("tension_n[a|rope]")];
        let chart = difference_chart(&curves, ChannelQuantity::Tension, "B - A");
        assert_eq!(chart.series.len(), 1);
        assert_eq!(chart.series[0].label, "a|rope");
        assert_eq!(chart.y.unit, "N");
    }
}
