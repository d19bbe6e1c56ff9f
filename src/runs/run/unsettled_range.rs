//! The range of a result whose companions do not approach it.

use super::compute::Computed;
use super::{Quantity, QuantityId, Subject};
use crate::case::{ChannelQuantity, LineQuantity, Statistic};

/// By how much of itself the range is wider to either side: another result lies between three that scatter in half of the cases
/// only.
const SCATTER: f64 = 0.5;

/// The range that holds a number with its error and the same of companions that do not approach it, with room for another; none
/// without such. Where no such number can be, it does not reach beyond those that were found.
pub(super) fn unsettled_range(q: &Quantity, others: &[f64], run: &Computed) -> Option<[f64; 2]> {
    let error = q.error_estimate().filter(|_| !others.is_empty())?;
    let found = others.iter().chain([&q.value]).copied();
    let (lowest, highest) = (
        found.clone().fold(f64::INFINITY, f64::min),
        found.fold(f64::NEG_INFINITY, f64::max),
    );
    let (least, greatest) = (lowest.min(q.value - error), highest.max(q.value + error));
    let room = SCATTER * (greatest - least);
    let [from, to] = bounds(&q.id, run);
    Some([
        (least - room).max(from.min(lowest)),
        (greatest + room).min(to.max(highest)),
    ])
}

/// What a number can be at all: a place on the line, a time of the run, not less than zero.
fn bounds(id: &QuantityId, run: &Computed) -> [f64; 2] {
    let QuantityId::Statistic {
        of,
        statistic,
        within,
        ..
    } = id
    else {
        return [0.0, f64::INFINITY];
    };
    let anything = [f64::NEG_INFINITY, f64::INFINITY];
    match statistic {
        Statistic::ArcOfMax | Statistic::ArcOfMin => {
            let arc = &run.record.profile().arc;
            let line = arc.first().zip(arc.last());
            within.unwrap_or(line.map_or(anything, |(from, to)| [*from, *to]))
        }
        Statistic::TimeOfMax
        | Statistic::TimeOfMin
        | Statistic::SettlingTime
        | Statistic::RiseTime => within.unwrap_or([0.0, run.settings.duration_s]),
        Statistic::Rate
        | Statistic::GreatestFall
        | Statistic::Travel
        | Statistic::Turns
        | Statistic::Peaks => [0.0, f64::INFINITY],
        _ if is_of_either_sign(of) => anything,
        _ => [0.0, f64::INFINITY],
    }
}

/// Whether a quantity may be less than zero; of those not known to be greater it is taken to.
fn is_of_either_sign(of: &Subject) -> bool {
    match of {
        Subject::Channel(channel) => channel.quantity != ChannelQuantity::Tension,
        Subject::Line(quantity) | Subject::Along(quantity, _) => {
            matches!(quantity, LineQuantity::Height | LineQuantity::Travelling)
        }
        _ => true,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A line of 500 m over 60 s.
    fn range(name: &str, value: f64, error: f64, others: &[f64]) -> Option<[f64; 2]> {
        let mut run = Computed::stopped();
        run.record.profiles = vec![crate::run::Profile {
            arc: vec![0.0, 200.0, 500.0],
            ..crate::run::Profile::default()
        }];
        run.settings.duration_s = 60.0;
        let quantity = Quantity {
            mesh_error: Some(error),
            ..Quantity::new(name.parse().unwrap(), value)
        };
        unsettled_range(&quantity, others, &run)
    }

    #[test]
    fn there_is_room_for_another_companion() {
        let height = "z_m.min";
        assert_eq!(range(height, -2.0, 1.0, &[-6.0, 0.0]), Some([-9.0, 3.0]));
        assert_eq!(range(height, -2.0, 1.0, &[]), None);
    }

    #[test]
    fn a_range_ends_where_no_number_can_be() {
        let ends = |name, value| range(name, value, 400.0, &[10.0, 50.0]);
        assert_eq!(ends("tension_n.arc_of_max", 30.0), Some([0.0, 500.0]));
        let stretch = ends("tension_n.arc_of_max(5..40)", 30.0);
        assert_eq!(stretch, Some([5.0, 50.0]));
        assert_eq!(ends("tension_n[A].time_of_max", 30.0), Some([0.0, 60.0]));
        assert_eq!(ends("tension_n[A].max", 30.0), Some([0.0, 830.0]));
        // What was found is not cut off.
        assert_eq!(ends("tension_n[A].min", -30.0).unwrap()[0], -30.0);
    }
}
