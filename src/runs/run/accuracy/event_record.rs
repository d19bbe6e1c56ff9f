//! What a run reports, kept until it is known whether it is the one looked for.

use crate::run::event::JobEvent;

/// How many numbers the events of a run may hold together to be kept.
const KEPT: usize = 1 << 22;

/// What a run reports, as long as it is not too much.
pub(super) struct EventRecord {
    events: Option<Vec<JobEvent>>,
    numbers: usize,
    /// The last state from which the run can be resumed, and how many events came before it.
    checkpoint: Option<(usize, JobEvent)>,
}

impl EventRecord {
    pub(super) fn new() -> Self {
        Self {
            events: Some(Vec::new()),
            numbers: 0,
            checkpoint: None,
        }
    }

    pub(super) fn push(&mut self, event: JobEvent) {
        if matches!(event, JobEvent::Checkpoint(_)) {
            let before = self.events.as_ref().map_or(0, Vec::len);
            self.checkpoint = Some((before, event));
            return;
        }
        self.numbers += match &event {
            JobEvent::Frame(frame) => {
                let nodes = frame.shapes.iter().map(|shape| 4 * shape.nodes.len());
                frame.values.len() + nodes.sum::<usize>()
            }
            _ => 0,
        };
        if self.numbers > KEPT {
            self.events = None;
        }
        if let Some(events) = &mut self.events {
            events.push(event);
        }
    }

    pub(super) fn finish(self) -> Option<Vec<JobEvent>> {
        let mut events = self.events?;
        // Where it came: its seal is over the rows before it.
        if let Some((before, checkpoint)) = self.checkpoint {
            events.insert(before, checkpoint);
        }
        Some(events)
    }
}
