//! Speed of the touchdown point along the bed, by the speed of transverse waves.
//!
//! The place where the line touches the bed moves as the line is lowered. Where it runs faster than the waves across the
//! line, `sqrt(T/m)` with the added mass, the line cannot lie down smoothly: it slams down (the shock of Triantafyllou,
//! Bliek and Shin 1985), and tensions near there depend on the mesh and on the stiffness of the bed. A run warns of it.

use serde::{Deserialize, Serialize};

use crate::numerics::V3;
use crate::scene::Scene;
use crate::solve::State;

/// A node has been off the bed once it was higher than this share of its segments.
const CLEAR: f64 = 0.01;
/// Segments that a front is timed over.
const SPAN: usize = 3;

/// The time of what has not happened \[s\]: a number that is finite, as all of a checkpoint are.
const NEVER: f64 = -1.0;

/// The touchdown of the nodes so far. The names of the fields are those of `checkpoint.toml`.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct TouchdownSpeed {
    /// Time of the last step \[s\].
    time: f64,
    /// Heights of the nodes above the bed then \[m\].
    height: Vec<f64>,
    /// Whether they have been off the bed since they last lay down.
    clear: Vec<bool>,
    /// When they lay down \[s\]; [`NEVER`] while they have not.
    landed: Vec<f64>,
    /// The fastest front against the waves there.
    fastest: Option<TouchdownFront>,
}

/// A moving touchdown point.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
struct TouchdownFront {
    time: f64,
    arc: f64,
    front: f64,
    wave: f64,
}

impl TouchdownSpeed {
    /// For a line; without a bed nothing is recorded.
    pub(super) fn of_scene(scene: &Scene) -> Self {
        let nodes = if scene.elements.bed.is_some() {
            scene.line_nodes()
        } else {
            0
        };
        Self {
            height: vec![f64::MIN; nodes],
            clear: vec![false; nodes],
            landed: vec![NEVER; nodes],
            ..Self::default()
        }
    }

    /// Whether it is that of a line of so many nodes, or of one without a bed.
    pub(super) fn fits(&self, nodes: usize) -> bool {
        let sizes = [self.height.len(), self.clear.len(), self.landed.len()];
        sizes == [nodes; 3] || sizes == [0; 3]
    }

    /// Follows a node that comes or goes: it counts as one that never was off the bed.
    pub(super) fn change_node(&mut self, node: usize, comes: bool) {
        if self.height.is_empty() {
            return;
        }
        if comes {
            self.height.insert(node, f64::MIN);
            self.clear.insert(node, false);
            self.landed.insert(node, NEVER);
        } else {
            self.height.remove(node);
            self.clear.remove(node);
            self.landed.remove(node);
        }
    }

    /// Takes in an accepted step; does not allocate.
    pub(super) fn update(&mut self, scene: &Scene, t: f64, state: &State) {
        let Some(bed) = &scene.elements.bed else {
            return;
        };
        for i in 0..self.height.len() {
            let (before, now) = (self.height[i], bed.height(&state.x[i]));
            self.height[i] = now;
            if now > CLEAR * length_at(scene, i) {
                (self.clear[i], self.landed[i]) = (true, NEVER);
            } else if now < 0.0 && before >= 0.0 && self.clear[i] {
                let share = before / (before - now);
                self.landed[i] = self.time + share * (t - self.time);
                self.clear[i] = false;
                for way in [-1, 1] {
                    self.compare(scene, i, way, state);
                }
            }
        }
        self.time = t;
    }

    /// Compares the speed of the touchdown point at node i, from this side, with the waves there.
    fn compare(&mut self, scene: &Scene, i: usize, way: isize, state: &State) {
        let back = |k: usize| i.checked_add_signed(-way * k as isize);
        let times = (0..=SPAN).map(|k| Some(*self.landed.get(back(k)?)?));
        let in_turn = |pair: (Option<f64>, Option<f64>)| match pair {
            (Some(later), Some(earlier)) => earlier > NEVER && earlier <= later,
            _ => false,
        };
        if !times.clone().zip(times.clone().skip(1)).all(in_turn) {
            return;
        }
        let (Some(from), Some(wave)) = (back(SPAN), wave_at(scene, i, state)) else {
            return;
        };
        let passed = self.landed[i] - self.landed[from];
        let front =
            (scene.line.arc[i] - scene.line.arc[from]).abs() / passed.max(f64::MIN_POSITIVE);
        if front > wave && self.fastest.is_none_or(|f| front * f.wave > f.front * wave) {
            self.fastest = Some(TouchdownFront {
                time: self.landed[i],
                arc: scene.line.arc[i],
                front,
                wave,
            });
        }
    }

    /// The warning where the touchdown point of a line of this name was faster than waves.
    pub(super) fn warning(&self, line: &str) -> Option<String> {
        let TouchdownFront {
            time,
            arc,
            front,
            wave,
        } = self.fastest?;
        let speed = if front > 1e4 {
            "all at once".to_owned()
        } else {
            format!("at {front:.1} m/s")
        };
        let line = match line {
            "" => "the line".to_owned(),
            name => format!("line {name}"),
        };
        Some(format!(
            "{line} lay down on the bed faster than waves run along it: {speed} near {arc:.1} m at t = {time:.2} s, waves \
             there at {wave:.1} m/s; it slams down there, and the tension goes with the mesh and the bed's stiffness and damping"
        ))
    }
}

/// Mean length of the segments at a node \[m\].
fn length_at(scene: &Scene, i: usize) -> f64 {
    let (first, last) = (i.saturating_sub(1), (i + 1).min(scene.line_nodes() - 1));
    (scene.line.arc[last] - scene.line.arc[first]) / (last - first) as f64
}

/// Speed of waves across the line at a node \[m/s\]; none where it is slack.
fn wave_at(scene: &Scene, i: usize, state: &State) -> Option<f64> {
    let tension = scene.tension_at(i, state);
    let mass = 1.0 / (V3::z().dot(&(scene.inverse_mass(i, state) * V3::z())) * length_at(scene, i));
    let speed = (tension / mass).sqrt();
    (speed > 0.0 && speed.is_finite()).then_some(speed)
}
