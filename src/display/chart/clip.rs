//! Cutting a line at the edges of the plot.

/// A point in dots, not yet rounded.
pub(super) type Dot = (f64, f64);

/// The part of a segment inside the rectangle from `(low, low)` to `high`, by Liang and Barsky:
/// every edge cuts the parameter of the segment from one side. Absent when nothing is inside.
pub(super) fn clip(from: Dot, to: Dot, low: f64, high: Dot) -> Option<(Dot, Dot)> {
    let (dx, dy) = (to.0 - from.0, to.1 - from.1);
    let edges = [
        (-dx, from.0 - low),
        (dx, high.0 - from.0),
        (-dy, from.1 - low),
        (dy, high.1 - from.1),
    ];
    let (mut enter, mut leave) = (0.0_f64, 1.0_f64);
    for (towards, room) in edges {
        if towards < 0.0 {
            enter = enter.max(room / towards);
        } else if towards > 0.0 {
            leave = leave.min(room / towards);
        } else if room < 0.0 {
            return None;
        }
    }
    let at = |t: f64| (from.0 + t * dx, from.1 + t * dy);
    (enter <= leave).then(|| (at(enter), at(leave)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_across_is_cut_at_both_edges() {
        let cut = clip((-10.0, 5.0), (30.0, 5.0), 0.0, (20.0, 10.0));
        assert_eq!(cut, Some(((0.0, 5.0), (20.0, 5.0))));
    }

    #[test]
    fn a_line_past_the_corner_is_outside() {
        assert_eq!(clip((-5.0, 4.0), (4.0, -5.0), 0.0, (9.0, 9.0)), None);
        assert_eq!(clip((2.0, 20.0), (8.0, 20.0), 0.0, (9.0, 9.0)), None);
    }

    #[test]
    fn a_point_inside_stays() {
        let dot = (3.0, 3.0);
        assert_eq!(clip(dot, dot, 0.0, (9.0, 9.0)), Some((dot, dot)));
    }
}
