//! The node that parts the segment at an end that is paid out.
//!
//! A new node is where it is in balance with the load of its halves, and moves as the material there does: with the chord d of the segment
//! of length l, parted into s next to the end and h beyond, the load p per length across and along, the node is
//! `h s / 2 (p_along / EA + p_across / T)` off the chord. Tensions at the end and beyond then change by what hangs between, as in
//! the undivided line, and no wave runs along it.

use super::moving_system::MovingSystem;
use super::system_state::SystemState;
use crate::numerics::V3;

/// Greatest distance of a new node from the chord, by the length of the mesh.
const ASIDE: f64 = 0.1;

/// A node that parts an end segment.
pub(super) struct NewNode {
    pub(super) place: V3,
    pub(super) velocity: V3,
    pub(super) acceleration: V3,
}

impl MovingSystem {
    /// The node that parts an end segment.
    pub(super) fn new_node(
        &self,
        number: usize,
        end: usize,
        t: f64,
        state: &SystemState,
    ) -> NewNode {
        let line = self.paid[number].line;
        let (scene, own) = (self.scene(line, state), &state.lines[line]);
        let out = self.paid_out(number, end, state);
        let (l, mesh) = (out.length, self.mesh_length(number, end));
        let last = own.x.len() - 1;
        let [f, g] = [[0, 1], [last, last - 1]][end];
        let i = end * (scene.line.segments.len() - 1);
        let far = mesh / l;
        let (d, w) = (own.x[f] - own.x[g], own.v[f] - own.v[g]);
        let chord = scene.line.chord(i, own);
        let tension = scene.line.pull(i, &chord, t, own);
        let segment = &scene.line.segments[i];
        let mean = (own.a[f] + own.a[g]) * 0.5;
        let load = scene.line.drag_on(i, &chord, own)
            - V3::z() * (2.0 * segment.half_weight)
            - mean * (2.0 * segment.half_mass);
        let moment = load * (0.5 * mesh * (l - mesh) / l);
        let (along, across) = asides(
            &chord.tangent,
            &moment,
            (tension.value, tension.by_length * l),
            ASIDE * mesh,
        );
        let share = d * far;
        let across = across + scene.lift_to_bed(&(own.x[g] + share), &across);
        // The part beyond keeps its length.
        let way = (share + across).try_normalize(0.0);
        let beyond = way.map_or(share, |way| way * share.norm());
        // It sinks as the part next to the end grows.
        let drawn = d - across / (1.0 - far);
        let (grows, turns) = (out.rate / l, out.acceleration / l);
        NewNode {
            place: own.x[g] + beyond + along,
            velocity: own.v[g] + (w - drawn * grows) * far,
            acceleration: own.a[g]
                + (own.a[f] - own.a[g] - w * (2.0 * grows) + drawn * (2.0 * grows * grows - turns))
                    * far,
        }
    }
}

/// How far off its chord a segment of this tension and stiffness EA \[N\] is in balance where it is parted \[m\], along it and across, by the moment
/// of the load on it \[N m\], and no farther than `most`. Where it is slack it stays on its chord: what falls does so in motion.
fn asides(tangent: &V3, moment: &V3, (tension, stiff): (f64, f64), most: f64) -> (V3, V3) {
    if tension <= 0.0 || stiff <= 0.0 {
        return (V3::zeros(), V3::zeros());
    }
    let along = tangent * tangent.dot(moment);
    let at_most = |off: V3| off * (most / off.norm().max(most));
    (at_most(along / stiff), at_most((moment - along) / tension))
}
