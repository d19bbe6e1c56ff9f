//! The release of an end or of the payload.

use super::{EndCondition, Scene, event::SceneChange};

impl Scene {
    /// The scene after a change.
    #[must_use]
    pub fn after(&self, change: SceneChange) -> Self {
        let mut scene = self.clone();
        match change {
            SceneChange::ReleaseEnd(end) => {
                scene.line.ends[end] = EndCondition::Free;
                scene.unclamp(end);
            }
            SceneChange::ReleasePayload => {
                // The payload is the last of the bodies, at the last node.
                if let (Some(hung), Some(last)) =
                    (scene.line.bodies.pop(), scene.line.segments.last())
                {
                    let left = || {
                        scene
                            .line
                            .bodies
                            .iter()
                            .filter(|other| other.node == hung.node)
                    };
                    let (mass, weight) =
                        (left().map(|h| h.body.mass), left().map(|h| h.body.weight));
                    scene.line.mass[hung.node] = last.half_mass + mass.sum::<f64>();
                    scene.line.weight[hung.node] = last.half_weight + weight.sum::<f64>();
                }
                // Of the bodies that bear on the bed it is the last too.
                if let Some(contact) = &mut scene.elements.body_contact {
                    contact.bodies.pop();
                }
            }
        }
        scene
    }
}
