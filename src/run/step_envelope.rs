//! Envelopes along the line over every step, where the case asks for them: a peak may lie between two output times.
//!
//! A case asks with a limit that its line must keep (`min_bend_radius_m`; breaking loads are watched by the recorder), with
//! a published extreme or a trend of the whole line, or with `output.envelope = "steps"`. No other run pays.

use std::ops::Range;

use super::Profile;
use crate::case::{AlongLine, Case, EnvelopeOf, Statistic};
use crate::scene::Scene;
use crate::solve::State;

/// The nodes whose envelopes are widened at every step.
#[derive(Debug, Clone, Default)]
pub(super) struct StepEnvelope {
    /// Nodes whose tension and height are.
    whole: Range<usize>,
    /// Nodes whose bending is.
    bent: Vec<usize>,
}

impl StepEnvelope {
    /// The nodes that a case asks for.
    pub(super) fn of(case: &Case, scene: &Scene) -> Self {
        use AlongLine::{BendRadius, Curvature, Height, Moment, Tension};
        let nodes = 0..scene.line_nodes();
        let all = case.output.envelope == EnvelopeOf::Steps;
        let whole = all || extremes_asked(case, &[Tension, Height]);
        let bends = all || extremes_asked(case, &[Curvature, BendRadius, Moment]);
        let limited = |i: &usize| bends || keeps_a_radius(case, scene, *i);
        Self {
            whole: if whole { nodes.clone() } else { 0..0 },
            bent: match scene.elements.flexure {
                Some(_) => nodes.filter(limited).collect(),
                None => Vec::new(),
            },
        }
    }

    /// Takes in an accepted step; does not allocate.
    pub(super) fn update(&self, scene: &Scene, state: &State, profile: &mut Profile) {
        for i in self.whole.clone() {
            let (tension, z) = (scene.tension_at(i, state), state.x[i].z);
            profile.tension_min[i] = profile.tension_min[i].min(tension);
            profile.tension_max[i] = profile.tension_max[i].max(tension);
            profile.z_min[i] = profile.z_min[i].min(z);
            profile.z_max[i] = profile.z_max[i].max(z);
        }
        let Some(flexure) = &scene.elements.flexure else {
            return;
        };
        for i in &self.bent {
            let (curvature, moment) = flexure.bent_at(*i, &scene.line, state);
            profile.curvature_max[*i] = profile.curvature_max[*i].max(curvature);
            profile.moment_max[*i] = profile.moment_max[*i].max(moment);
        }
    }
}

/// Whether a published value or a trend is an extreme of one of these.
fn extremes_asked(case: &Case, quantities: &[AlongLine]) -> bool {
    use Statistic::{ArcOfMax, ArcOfMin, Max, Min};
    let published = case.published.iter().map(|p| (&p.channel, p.statistic));
    let trends = case.trend.iter().map(|t| (&t.channel, t.statistic));
    published.chain(trends).any(|(channel, statistic)| {
        matches!(statistic, Max | Min | ArcOfMax | ArcOfMin)
            && AlongLine::named(channel).is_some_and(|q| quantities.contains(&q))
    })
}

/// Whether a node lies in a section whose material has a least bending radius.
fn keeps_a_radius(case: &Case, scene: &Scene, node: usize) -> bool {
    scene
        .labels
        .joints
        .windows(2)
        .zip(&case.line)
        .any(|(reach, section)| {
            (reach[0].node..=reach[1].node).contains(&node)
                && case
                    .materials
                    .get(&section.material)
                    .is_some_and(|m| m.min_bend_radius_m.is_some())
        })
}
