//! The one period at which a system is driven.

use crate::case::OneOrMany;
use crate::run::response::AskedResponse;
use crate::system::SystemFile;

/// What a file asks for of the response of its lines; nothing where it does not ask.
#[must_use]
pub fn asked_response(file: &SystemFile) -> Option<AskedResponse> {
    Some(AskedResponse {
        from: file.output.response_from_s?,
        period: driving_period(file),
    })
}

/// The one period \[s\] at which the lines are driven: that of regular waves, or of what moves. Nothing where several do, or a table.
fn driving_period(file: &SystemFile) -> Option<f64> {
    let mut waves = file.waves.iter().map(|waves| waves.period_s);
    if let Some(first) = waves.next() {
        return first.filter(|_| waves.all(|other| other == first));
    }
    let points = file.points.values();
    let points = points.flat_map(|point| {
        let axes = point.amplitude_m.iter().enumerate();
        axes.filter(|(_, amplitude)| **amplitude != 0.0)
            .filter_map(|(axis, _)| match &point.period_s {
                Some(OneOrMany::One(period)) => Some(*period),
                Some(OneOrMany::Many(periods)) => periods.get(axis).copied(),
                None => None,
            })
    });
    let bodies = file.bodies.values();
    let bodies = bodies.flat_map(|body| {
        let axes = body.amplitude_m.iter().chain(&body.amplitude_deg);
        axes.enumerate()
            .filter(|(_, amplitude)| **amplitude != 0.0)
            .filter_map(|(axis, _)| match body.period_s.as_slice() {
                [one] => Some(*one),
                many => many.get(axis).copied(),
            })
    });
    let mut periods = points.chain(bodies);
    let first = periods.next()?;
    periods.all(|other| other == first).then_some(first)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::system::model::{BodyInputs, PointInputs};

    fn file(points: &[(f64, f64)]) -> SystemFile {
        let mut file = SystemFile::default();
        for (number, (amplitude, period)) in points.iter().enumerate() {
            let point = PointInputs {
                amplitude_m: [0.0, 0.0, *amplitude],
                period_s: Some(OneOrMany::One(*period)),
                ..PointInputs::default()
            };
            file.points.insert(format!("point{number}"), point);
        }
        file
    }

    #[test]
    fn what_moves_has_one_period_or_none() {
        assert_eq!(driving_period(&file(&[])), None);
        assert_eq!(driving_period(&file(&[(1.0, 8.0), (2.0, 8.0)])), Some(8.0));
        assert_eq!(driving_period(&file(&[(1.0, 8.0), (2.0, 9.0)])), None);
        // What does not move has none.
        assert_eq!(driving_period(&file(&[(1.0, 8.0), (0.0, 9.0)])), Some(8.0));
        let mut both = file(&[(1.0, 8.0)]);
        let body = BodyInputs {
            amplitude_deg: [0.0, 3.0, 0.0],
            period_s: vec![1.0, 1.0, 1.0, 1.0, 8.0, 1.0],
            ..BodyInputs::default()
        };
        both.bodies.insert("ship".to_owned(), body);
        assert_eq!(driving_period(&both), Some(8.0));
    }
}
