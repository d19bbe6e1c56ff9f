//! The line node by node: its envelopes over every accepted step and what lies between them, and its state at the end.

use super::observer::NodeChange;
use super::step_interval::StepInterval;
use super::{Profile, RopeProfile};
use crate::physics::seabed::ElasticBed;
use crate::scene::Scene;
use crate::solve::State;

/// Widens the envelopes.
pub(super) struct StepEnvelope {
    /// The bed of each line, where it has one.
    beds: Vec<Option<ElasticBed>>,
}

impl StepEnvelope {
    /// Over these lines.
    pub(super) fn of_scenes(scenes: &[&Scene]) -> Self {
        let beds = scenes.iter().map(|scene| scene.elements.bed.as_ref());
        Self {
            beds: beds.map(|bed| bed.map(|bed| bed.seabed.clone())).collect(),
        }
    }

    /// Takes in an accepted step; does not allocate.
    pub(super) fn step(&self, scene: &Scene, state: &State, profile: &mut Profile) {
        if !scene.line.laws.is_empty() {
            update_ropes(&mut profile.ropes, scene, state);
        }
        let Some(flexure) = &scene.elements.flexure else {
            return;
        };
        for i in 0..profile.curvature_max.len() {
            let (curvature, moment) = flexure.bent_at(i, &scene.line, state);
            profile.curvature_max[i] = profile.curvature_max[i].max(curvature);
            profile.moment_max[i] = profile.moment_max[i].max(moment);
        }
    }

    /// Takes in what lies between two steps; does not allocate.
    pub(super) fn widen(&self, between: &StepInterval<'_>, profiles: &mut [Profile]) {
        let mut first = 0;
        for (profile, bed) in profiles.iter_mut().zip(&self.beds) {
            let count = profile.arc.len();
            for i in 0..count {
                let ([slackest, tautest], [lowest, highest]) = (
                    between.tension_range(first + i),
                    between.height_range(first + i),
                );
                profile.tension_min[i] = profile.tension_min[i].min(slackest);
                profile.tension_max[i] = profile.tension_max[i].max(tautest);
                profile.z_min[i] = profile.z_min[i].min(lowest);
                profile.z_max[i] = profile.z_max[i].max(highest);
                if let Some(bed) = bed {
                    let least = least_clearance(bed, between, (first + i, lowest));
                    profile.bed_clearance_min[i] = profile.bed_clearance_min[i].min(least);
                }
            }
            first += count;
        }
    }
}

/// The least height of a node above the bed between two steps, whose lowest place there is known \[m\].
fn least_clearance(
    bed: &ElasticBed,
    between: &StepInterval<'_>,
    (node, lowest): (usize, f64),
) -> f64 {
    match bed.is_level() {
        true => lowest - bed.z,
        false => between.least_of_place(node, |place| bed.height(place)),
    }
}

/// The profile of a line before its first step. Envelopes hold nothing yet: they begin with the greatest numbers there are, not with
/// infinite ones, since a run may be stopped here and all of a checkpoint is finite.
#[must_use]
pub fn profile(scene: &Scene) -> Profile {
    let nodes = scene.line_nodes();
    let where_there_is = |is: bool| if is { nodes } else { 0 };
    let bending = where_there_is(scene.elements.flexure.is_some());
    let over_bed = where_there_is(scene.elements.bed.is_some());
    Profile {
        arc: scene.line.arc[..nodes].to_vec(),
        nodes: vec![[0.0; 3]; nodes],
        tension: vec![0.0; nodes],
        tension_min: vec![f64::MAX; nodes],
        tension_max: vec![f64::MIN; nodes],
        z_min: vec![f64::MAX; nodes],
        z_max: vec![f64::MIN; nodes],
        bed_clearance: vec![0.0; over_bed],
        bed_clearance_min: vec![f64::MAX; over_bed],
        curvature: vec![0.0; bending],
        curvature_max: vec![0.0; bending],
        moment: vec![0.0; bending],
        moment_max: vec![0.0; bending],
        ..Profile::default()
    }
}

/// Follows a node next to an end that comes or goes. One that comes has seen nothing yet; what one that goes has seen counts for the end,
/// which it passed.
pub(super) fn change_node(p: &mut Profile, change: NodeChange) {
    let NodeChange { node, comes, .. } = change;
    let end = if node == 1 { 0 } else { p.arc.len() - 1 };
    if !comes {
        for (list, better) in envelopes(p) {
            if !list.is_empty() {
                list[end] = better(list[end], list[node]);
            }
        }
    }
    let nodes = p.arc.len();
    for (list, unseen) in [
        (&mut p.arc, 0.0),
        (&mut p.tension, 0.0),
        (&mut p.tension_min, f64::MAX),
        (&mut p.tension_max, f64::MIN),
        (&mut p.z_min, f64::MAX),
        (&mut p.z_max, f64::MIN),
        (&mut p.bed_clearance, 0.0),
        (&mut p.bed_clearance_min, f64::MAX),
        (&mut p.curvature, 0.0),
        (&mut p.curvature_max, 0.0),
        (&mut p.moment, 0.0),
        (&mut p.moment_max, 0.0),
    ] {
        if list.len() == nodes {
            put(list, node, comes, unseen);
        }
    }
    put(&mut p.nodes, node, comes, [0.0; 3]);
    // Which segments have a dynamic stiffness is known by the first step only: it begins anew.
    p.ropes = RopeProfile::default();
}

/// Which of two values counts.
type Better = fn(f64, f64) -> f64;

/// The lists that every step widens, and which of two values counts.
fn envelopes(p: &mut Profile) -> [(&mut Vec<f64>, Better); 7] {
    [
        (&mut p.tension_min, f64::min),
        (&mut p.tension_max, f64::max),
        (&mut p.z_min, f64::min),
        (&mut p.z_max, f64::max),
        (&mut p.bed_clearance_min, f64::min),
        (&mut p.curvature_max, f64::max),
        (&mut p.moment_max, f64::max),
    ]
}

/// Puts a value into a list, or takes one out.
fn put<T>(list: &mut Vec<T>, at: usize, comes: bool, value: T) {
    if comes {
        list.insert(at, value);
    } else {
        list.remove(at);
    }
}

/// Takes in the last state, which counts for the envelopes as well: a line at rest has no other.
pub(super) fn end(scene: &Scene, state: &State, p: &mut Profile) {
    // Ends that are paid out move along the line.
    let nodes = p.arc.len();
    p.arc.copy_from_slice(&scene.line.arc[..nodes]);
    for i in 0..nodes {
        let (x, t) = (&state.x[i], scene.tension_at(i, state));
        p.nodes[i] = [x.x, x.y, x.z];
        p.tension[i] = t;
        p.tension_min[i] = p.tension_min[i].min(t);
        p.tension_max[i] = p.tension_max[i].max(t);
        p.z_min[i] = p.z_min[i].min(x.z);
        p.z_max[i] = p.z_max[i].max(x.z);
        if let Some(bed) = &scene.elements.bed {
            let height = bed.height(x);
            p.bed_clearance[i] = height;
            p.bed_clearance_min[i] = p.bed_clearance_min[i].min(height);
        }
    }
    if let Some(flexure) = &scene.elements.flexure {
        let (mut curvature, mut moment) = flexure.bent(&scene.line, state);
        curvature.truncate(p.arc.len());
        moment.truncate(p.arc.len());
        (p.curvature, p.moment) = (curvature, moment);
    }
}

/// Takes in the dynamic stiffness of every segment that has one; allocates at the first step only.
fn update_ropes(ropes: &mut RopeProfile, scene: &Scene, state: &State) {
    let mut known = 0;
    for i in 0..scene.line.segments.len() {
        let Some(reading) = scene.line.rope_reading(i, state) else {
            continue;
        };
        if known == ropes.arc.len() {
            begin_segment(ropes, 0.5 * (scene.line.arc[i] + scene.line.arc[i + 1]));
        }
        ropes.mean_load[known] = reading.mean_load;
        ropes.stiffness[known] = reading.stiffness;
        let low = |list: &mut [f64], value: f64| list[known] = list[known].min(value);
        low(&mut ropes.deviation_min, reading.deviation);
        low(&mut ropes.stiffness_min, reading.stiffness);
        let high = |list: &mut [f64], value: f64| list[known] = list[known].max(value);
        high(&mut ropes.deviation_max, reading.deviation);
        high(&mut ropes.stiffness_max, reading.stiffness);
        known += 1;
    }
}

/// Adds a segment at this arc length \[m\], without values yet.
fn begin_segment(ropes: &mut RopeProfile, arc: f64) {
    ropes.arc.push(arc);
    ropes.mean_load.push(0.0);
    ropes.stiffness.push(0.0);
    for list in [&mut ropes.deviation_min, &mut ropes.stiffness_min] {
        list.push(f64::MAX);
    }
    for list in [&mut ropes.deviation_max, &mut ropes.stiffness_max] {
        list.push(f64::MIN);
    }
}
