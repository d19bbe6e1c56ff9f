//! The line node by node at the last output time, and its envelopes over the output times.

use super::{Profile, RopeProfile};
use crate::scene::Scene;
use crate::solve::State;

/// The profile of a line before its first output time.
pub(super) fn profile(scene: &Scene) -> Profile {
    let nodes = scene.line_nodes();
    let bending = if scene.elements.flexure.is_some() {
        nodes
    } else {
        0
    };
    Profile {
        arc: scene.line.arc[..nodes].to_vec(),
        nodes: vec![[0.0; 3]; nodes],
        tension: vec![0.0; nodes],
        tension_min: vec![f64::INFINITY; nodes],
        tension_max: vec![f64::NEG_INFINITY; nodes],
        z_min: vec![f64::INFINITY; nodes],
        z_max: vec![f64::NEG_INFINITY; nodes],
        curvature: vec![0.0; bending],
        curvature_max: vec![0.0; bending],
        moment: vec![0.0; bending],
        moment_max: vec![0.0; bending],
        ..Profile::default()
    }
}

/// Takes in an output time; `tension` is that of the nodes \[N\].
pub(super) fn update(p: &mut Profile, scene: &Scene, state: &State, tension: &[f64]) {
    for (i, (x, t)) in state.x.iter().zip(tension).enumerate() {
        p.nodes[i] = [x.x, x.y, x.z];
        p.tension[i] = *t;
        p.tension_min[i] = p.tension_min[i].min(*t);
        p.tension_max[i] = p.tension_max[i].max(*t);
        p.z_min[i] = p.z_min[i].min(x.z);
        p.z_max[i] = p.z_max[i].max(x.z);
    }
    update_ropes(&mut p.ropes, scene, state);
    if let Some(flexure) = &scene.elements.flexure {
        let (mut curvature, mut moment) = flexure.bent(&scene.line, state);
        curvature.truncate(tension.len());
        moment.truncate(tension.len());
        raise(&mut p.curvature_max, &curvature);
        raise(&mut p.moment_max, &moment);
        (p.curvature, p.moment) = (curvature, moment);
    }
}

/// Raises greatest values to the new ones.
fn raise(greatest: &mut [f64], values: &[f64]) {
    for (most, value) in greatest.iter_mut().zip(values) {
        *most = most.max(*value);
    }
}

/// Takes in the dynamic stiffness of every segment that has one.
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
        list.push(f64::INFINITY);
    }
    for list in [&mut ropes.deviation_max, &mut ropes.stiffness_max] {
        list.push(f64::NEG_INFINITY);
    }
}
