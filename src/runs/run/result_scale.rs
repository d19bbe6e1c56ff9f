//! What a result is a part of: the range of its channel, by which its accuracy is measured.

use super::{History, Quantity, QuantityId, Run, Subject};
use crate::case::{ChannelId, Statistic};

/// The results of a run over this time \[s\] that have an accuracy, each with what that is a share of, in its unit.
#[must_use]
pub fn result_scales(duration_s: f64, run: &Run) -> Vec<(QuantityId, f64)> {
    let scales = ResultScales {
        duration_s,
        summary: &run.summary,
        history: &run.history,
    };
    let scaled = run.summary.iter();
    scaled
        .filter_map(|q| Some((q.id.clone(), scales.scale_of_result(q)?)))
        .collect()
}

/// What results are a part of.
pub(super) struct ResultScales<'a> {
    /// Simulated time \[s\].
    pub(super) duration_s: f64,
    pub(super) summary: &'a [Quantity],
    pub(super) history: &'a History,
}

impl ResultScales<'_> {
    /// The range of its channel; of what is at rest or along the line its magnitude; of a time the duration. None of
    /// what is zero but for rounding, of places along the line, and of what is neither of a channel nor of the line.
    pub(super) fn scale_of_result(&self, q: &Quantity) -> Option<f64> {
        const ZERO: f64 = 1e-9;
        let QuantityId::Statistic { of, statistic, .. } = &q.id else {
            return None;
        };
        match statistic {
            Statistic::TimeOfMax
            | Statistic::TimeOfMin
            | Statistic::SettlingTime
            | Statistic::RiseTime => {
                return Some(self.duration_s);
            }
            // A place is known to a segment, whatever the forces are.
            Statistic::ArcOfMax | Statistic::ArcOfMin => return None,
            // Nor at rest how much of a line lies on the bed.
            _ if self.duration_s == 0.0 && of.is_length_on_bed() => return None,
            _ if of.counts_nodes() => return None,
            _ => {}
        }
        let unit = q.unit();
        let same_unit = self.summary.iter().filter(|other| other.unit() == unit);
        let largest = same_unit.map(|other| other.value.abs()).fold(0.0, f64::max);
        let scale = match of {
            Subject::Channel(id) => self.of_channel(id),
            Subject::Line(_) | Subject::Along(..) => self.magnitude(of),
            _ => return None,
        };
        (scale > ZERO * largest).then_some(scale)
    }

    /// The range of a channel; of one that does not move the largest magnitude in its unit.
    fn of_channel(&self, id: &ChannelId) -> f64 {
        const STILL: f64 = 1e-6;
        let mut range = 0.0;
        let mut largest: f64 = 0.0;
        for channel in &self.history.channels {
            let (peak, trough) = (channel.peak.0, channel.trough.0);
            if channel.id.quantity.unit() == id.quantity.unit() {
                largest = largest.max(peak.abs()).max(trough.abs());
            }
            if channel.id == *id {
                range = peak - trough;
            }
        }
        if range > STILL * largest {
            range
        } else {
            largest
        }
    }

    /// The largest result of a subject.
    fn magnitude(&self, of: &Subject) -> f64 {
        let same = self.summary.iter().filter(|q| {
            matches!(&q.id, QuantityId::Statistic { of: other, statistic, .. }
                if other == of && !matches!(statistic, Statistic::ArcOfMax | Statistic::ArcOfMin))
        });
        same.map(|q| q.value.abs()).fold(0.0, f64::max)
    }
}
