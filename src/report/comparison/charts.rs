//! Difference curves as a chart.

use crate::case::ChannelQuantity;
use crate::comparison::CurveDifference;
use crate::report::chart::{Axis, Chart, Limit, LimitLine, Series};

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
    chart.limits = vec![Limit::new("", LimitLine::Horizontal(0.0))];
    chart
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
