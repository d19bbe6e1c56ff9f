//! What the dynamic stiffness of ropes stands at along the line: at the end of a run, and its envelope over the output
//! times.

use serde::{Deserialize, Serialize};

use crate::scene::Scene;
use crate::solve::State;

/// The segments of rope that have dynamic stiffness, from A to B; empty where there are none.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct RopeProfile {
    /// Unstretched arc length from A to the middles of the segments \[m\].
    pub arc: Vec<f64>,
    /// Lm at the end: mean of the past tension, in percent of the breaking load.
    pub mean_load: Vec<f64>,
    /// Smallest La: deviation of the tension from the mean, in percent of the breaking load.
    pub deviation_min: Vec<f64>,
    /// Greatest La, likewise.
    pub deviation_max: Vec<f64>,
    /// k at the end: stiffness EA by breaking load \[-\].
    pub stiffness: Vec<f64>,
    /// Smallest k \[-\].
    pub stiffness_min: Vec<f64>,
    /// Greatest k \[-\].
    pub stiffness_max: Vec<f64>,
}

impl RopeProfile {
    /// True where no rope has dynamic stiffness.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.arc.is_empty()
    }

    /// Takes in an output instant.
    pub(super) fn widen(&mut self, scene: &Scene, state: &State) {
        let mut known = 0;
        for i in 0..scene.segments.len() {
            let Some(told) = scene.rope_reading(i, state) else {
                continue;
            };
            if known == self.arc.len() {
                self.begin(0.5 * (scene.arc[i] + scene.arc[i + 1]));
            }
            self.mean_load[known] = told.mean_load;
            self.stiffness[known] = told.stiffness;
            let low = |list: &mut [f64], value: f64| list[known] = list[known].min(value);
            low(&mut self.deviation_min, told.deviation);
            low(&mut self.stiffness_min, told.stiffness);
            let high = |list: &mut [f64], value: f64| list[known] = list[known].max(value);
            high(&mut self.deviation_max, told.deviation);
            high(&mut self.stiffness_max, told.stiffness);
            known += 1;
        }
    }

    /// Makes room for one more segment.
    fn begin(&mut self, arc: f64) {
        self.arc.push(arc);
        self.mean_load.push(0.0);
        self.stiffness.push(0.0);
        for list in [&mut self.deviation_min, &mut self.stiffness_min] {
            list.push(f64::INFINITY);
        }
        for list in [&mut self.deviation_max, &mut self.stiffness_max] {
            list.push(f64::NEG_INFINITY);
        }
    }
}
