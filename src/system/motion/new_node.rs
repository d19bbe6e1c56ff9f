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
/// Newton iterations for its sag, more than it needs from there.
const SAG_ITERATIONS: usize = 8;

impl MovingSystem {
    /// Place, velocity and acceleration of the node that parts an end segment.
    pub(super) fn new_node(
        &self,
        number: usize,
        end: usize,
        t: f64,
        state: &SystemState,
    ) -> [V3; 3] {
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
        let off = aside(
            &chord.tangent,
            &moment,
            (tension.value, tension.by_length * l),
            mesh * (l - mesh),
        );
        let aside = off * (ASIDE * mesh / off.norm().max(ASIDE * mesh));
        let grows = out.rate / l;
        let turns = out.acceleration / l;
        let on_chord = own.x[g] + d * far;
        [
            on_chord + aside + scene.lift_to_bed(&on_chord, &aside),
            own.v[g] + (w - d * grows) * far,
            own.a[g]
                + (own.a[f] - own.a[g] - w * (2.0 * grows) + d * (2.0 * grows * grows - turns))
                    * far,
        ]
    }
}

/// How far off its chord a segment of this tension and stiffness EA \[N\] is in balance where it is parted \[m\], by the moment of the load on it
/// \[N m\] and the product of its parts h s. Across, `T a + EA a³ / 2 h s = M`: the parts are longer than the chord by `a² (1/h + 1/s) / 2`,
/// which stretches them. Where it is slack it stays on its chord: what falls does so in motion.
fn aside(tangent: &V3, moment: &V3, (tension, stiff): (f64, f64), parts: f64) -> V3 {
    if tension <= 0.0 || stiff <= 0.0 {
        return V3::zeros();
    }
    let along = tangent * tangent.dot(moment);
    let across = moment - along;
    let (load, cubic) = (across.norm(), 0.5 * stiff / parts);
    let mut off = (load / tension).min((load / cubic).cbrt());
    for _ in 0..SAG_ITERATIONS {
        let square = cubic * off * off;
        off = (load + 2.0 * square * off) / (tension + 3.0 * square);
    }
    along / stiff + across * (off / load.max(f64::MIN_POSITIVE))
}
