//! Bending at the inner nodes of the line and at clamped ends.

use crate::case::{self, Case};
use crate::numerics::lanes;
use crate::numerics::{BlockBand, M3, V3};
use crate::physics::bending::{self, BendAngle, curvature};
use crate::physics::tension::Chord;
use crate::scene::element::{At, Element};
use crate::scene::vectors::direction;
use crate::scene::{LumpedLine, Segment};
use crate::solve::{Factors, State};

/// Bending stiffness of the nodes, and clamps.
#[derive(Debug, Clone, PartialEq)]
pub struct Flexure {
    /// Stiffness of the bend at every node, EI / l \[N m\]; zero at the ends and at hinges.
    pub joints: Vec<f64>,
    /// Mean unstretched length of the segments that meet at every node \[m\]; half a segment at an end.
    pub spans: Vec<f64>,
    /// Clamped ends A and B: the direction of the line there, from A to B, and the stiffness of the bend \[N m\].
    pub clamps: [Option<(V3, f64)>; 2],
    /// The inner nodes at which neither shear nor curvature jumps: without a body, and of one stiffness.
    even: Vec<bool>,
}

impl Element for Flexure {
    fn add_residual(&self, at: At<'_>, r: &mut [V3]) {
        let At { line, state, .. } = at;
        let last = line.segments.len();
        let mut a = line.chord(0, state);
        for i in 1..last {
            let b = line.chord(i, state);
            let k = self.joints[i];
            if k > 0.0 {
                let [by_first, by_second] = between(&a, &b).forces(k);
                r[i - 1] -= by_first;
                r[i] += by_first - by_second;
                r[i + 1] += by_second;
            }
            a = b;
        }
        self.add_clamps(line, state, r);
    }

    /// Sets the far blocks, which are those of bending alone.
    fn linearise(&self, at: At<'_>, c: Factors, r: &mut [V3], tangent: &mut BlockBand) {
        let At { line, state, .. } = at;
        self.linearise_joints(line, state, c.stiffness, r, tangent);
        self.add_clamps(line, state, r);
        for (i, chord, direction, k) in self.clamped_ends(line, state) {
            let bend = BendAngle::new((&chord.tangent, chord.inverse), (&direction, 0.0));
            let own = lanes::block(&bend.tangent(k * c.stiffness).own, 0);
            tangent.diag[i] += own;
            tangent.diag[i + 1] += own;
            tangent.upper[i] -= own;
            tangent.lower[i + 1] -= own;
        }
    }

    fn is_pentadiagonal(&self) -> bool {
        true
    }

    /// `8 EI / l³`, as two neighbouring bends resist a zigzag.
    fn segment_stiffness(&self, line: &LumpedLine, i: usize) -> f64 {
        let length = line.segments[i].axial.length;
        8.0 * self.joints[i].max(self.joints[i + 1]) / (length * length)
    }

    /// By the forces of the moments at nodes and clamps.
    fn equivalent_displacement(&self, at: At<'_>, d: &[V3], stiffest: f64) -> f64 {
        let force = |k: f64, turn: V3, length: f64| 2.0 * k * turn.amax() / (length * length);
        let mut most = 0.0_f64;
        for i in 1..at.line.segments.len() {
            let turn = d[i - 1] + d[i + 1] - d[i] * 2.0;
            most = most.max(force(self.joints[i], turn, self.spans[i]));
        }
        for (i, _, _, k) in self.clamped_ends(at.line, at.state) {
            let length = at.line.segments[i].axial.length;
            most = most.max(force(k, d[i + 1] - d[i], length));
        }
        most / stiffest
    }

    fn add_energy(&self, at: At<'_>, energy: &mut f64) {
        *energy += self.energy(at.line, at.state);
    }

    fn add_end_force(&self, at: At<'_>, node: usize, force: &mut V3) {
        *force += self.end_force(at.line, node, at.state);
    }
}

impl Flexure {
    /// Adds the residual of the clamps.
    fn add_clamps(&self, line: &LumpedLine, state: &State, r: &mut [V3]) {
        for (i, chord, direction, k) in self.clamped_ends(line, state) {
            let g = clamped(k, &direction, &chord);
            r[i] -= g;
            r[i + 1] += g;
        }
    }

    /// The bends at the inner nodes, each over three nodes; the parts at the later two are kept for the next bend, so that every
    /// block is written once.
    fn linearise_joints(
        &self,
        line: &LumpedLine,
        state: &State,
        share: f64,
        r: &mut [V3],
        tangent: &mut BlockBand,
    ) {
        let last = line.segments.len();
        let mut a = line.chord(0, state);
        let mut force = [V3::zeros(); 2];
        let mut diag = [M3::zeros(); 2];
        let mut upper = M3::zeros();
        for i in 1..last {
            let b = line.chord(i, state);
            let bend = between(&a, &b);
            let k = self.joints[i];
            let [by_first, by_second] = bend.forces(k);
            r[i - 1] += force[0] - by_first;
            force = [force[1] + by_first - by_second, by_second];
            let bent = bend.tangent(k * share);
            let (mixed, back) = (bent.mixed, bent.mixed.transpose());
            let [first, second] = [0, 1].map(|chord| lanes::block(&bent.own, chord));
            tangent.diag[i - 1] += diag[0] + first;
            diag = [diag[1] + first + second - mixed - back, second];
            upper += mixed - first;
            tangent.upper[i - 1] += upper;
            tangent.lower[i] += upper.transpose();
            upper = mixed - second;
            tangent.far_upper[i - 1] = -mixed;
            tangent.far_lower[i + 1] = -back;
            a = b;
        }
        for (node, (force, diag)) in (last - 1..).zip(force.into_iter().zip(diag)) {
            r[node] += force;
            tangent.diag[node] += diag;
        }
        tangent.upper[last - 1] += upper;
        tangent.lower[last] += upper.transpose();
        // No node is two beyond the ends.
        tangent.far_upper[last - 1..].fill(M3::zeros());
    }

    /// The segments at clamped ends: their numbers, chords, and directions and stiffnesses of the clamps.
    fn clamped_ends(
        &self,
        line: &LumpedLine,
        state: &State,
    ) -> impl Iterator<Item = (usize, Chord, V3, f64)> {
        let last = line.segments.len();
        let ends = [(0, 0), (1, last - 1)];
        ends.map(|(end, i)| {
            self.clamp(end, state)
                .map(|(direction, k)| (i, line.chord(i, state), direction, k))
        })
        .into_iter()
        .flatten()
    }

    /// Force of bending on the first or last node \[N\].
    pub(in crate::scene) fn end_force(&self, line: &LumpedLine, node: usize, state: &State) -> V3 {
        let last = line.segments.len();
        let (end, i, sign) = if node == 0 {
            (0, 0, 1.0)
        } else {
            (1, last - 1, -1.0)
        };
        let chord = line.chord(i, state);
        let mut force = self
            .clamp(end, state)
            .map_or_else(V3::zeros, |(direction, k)| {
                clamped(k, &direction, &chord) * sign
            });
        if last > 1 {
            let (joint, other) = if node == 0 {
                (1, 1)
            } else {
                (last - 1, last - 2)
            };
            let beside = line.chord(other, state);
            // The bend is symmetric in its two segments.
            let [by_outer, _] = between(&chord, &beside).forces(self.joints[joint]);
            force += by_outer * sign;
        }
        force
    }

    /// Curvature \[1/m\] at node i about its axis, by the segments and clamps there; none at hinges.
    fn curvature_by_segments(&self, i: usize, line: &LumpedLine, state: &State) -> V3 {
        let last = line.segments.len();
        let tangent = |i: usize| line.chord(i, state).tangent;
        let [first, second] = match (i, self.clamp_at(i, state)) {
            (i, None) if i > 0 && i < last && self.joints[i] > 0.0 => [tangent(i - 1), tangent(i)],
            (0, Some(clamp)) => [clamp, tangent(0)],
            (_, Some(clamp)) => [tangent(last - 1), clamp],
            _ => return V3::zeros(),
        };
        curvature(&first, &second, self.spans[i])
    }

    /// The same with what the segments at clamps and bodies leave out, within a part of which a line under tension bends there: see
    /// [`bending::unresolved_at_clamp`]. At a body the line turns to both sides as at a clamp.
    fn curvature_at(&self, i: usize, line: &LumpedLine, state: &State) -> V3 {
        let own = self.curvature_by_segments(i, line, state);
        let last = line.segments.len();
        let curvature = |i: usize| self.curvature_by_segments(i, line, state);
        let (beside, segments) = match i {
            0 if last > 1 && self.is_clamped(0) => (curvature(1), [0, 0]),
            i if i == last && last > 1 && self.is_clamped(last) => {
                (curvature(last - 1), [last - 1; 2])
            }
            i if self.turns_at_body(i, line) => {
                (0.5 * (curvature(i - 1) + curvature(i + 1)), [i - 1, i])
            }
            _ => return own,
        };
        let tension = segments.map(|i| line.tension_now(i, &line.chord(i, state), state).value);
        let tension = 0.5 * (tension[0] + tension[1]).max(0.0);
        let of = &line.segments[segments[0]];
        let x = of.axial.length * (tension / of.ei).sqrt();
        own + (own - beside) * bending::unresolved_at_clamp(x)
    }

    /// Whether a line of one stiffness, which is no hinge, has a body at this inner node.
    fn turns_at_body(&self, i: usize, line: &LumpedLine) -> bool {
        !self.even[i]
            && i > 0
            && i + 1 < line.line_nodes
            && self.joints[i] > 0.0
            && line.segments[i - 1].ei == line.segments[i].ei
    }

    /// The direction of the line at a clamped end, from A to B, and the stiffness of the bend \[N m\].
    pub(in crate::scene) fn clamp(&self, end: usize, state: &State) -> Option<(V3, f64)> {
        let (direction, k) = self.clamps[end]?;
        Some((state.clamps[end].unwrap_or(direction), k))
    }

    /// The direction of the line at a node, if that is a clamped end, from A to B.
    pub(in crate::scene) fn clamp_at(&self, node: usize, state: &State) -> Option<V3> {
        let (direction, _) = self.clamp(self.end_of(node)?, state)?;
        Some(direction)
    }

    /// Whether a node is a clamped end.
    pub(in crate::scene) fn is_clamped(&self, node: usize) -> bool {
        self.end_of(node)
            .is_some_and(|end| self.clamps[end].is_some())
    }

    /// The end that a node is.
    fn end_of(&self, node: usize) -> Option<usize> {
        match node {
            0 => Some(0),
            node if node + 1 == self.joints.len() => Some(1),
            _ => None,
        }
    }

    /// Curvature \[1/m\] at every node in two planes of a frame that does not twist along the line; at rest the first is nearly vertical,
    /// since the frame begins at end A with the horizontal across the line as the axis of bending. As it is carried along by the least
    /// rotation from tangent to tangent, it turns with the line as a cable without torsion does. Hinges have no curvature. A line that
    /// begins upright begins with the y axis.
    pub fn curvatures(&self, line: &LumpedLine, state: &State, out: &mut [[f64; 2]]) {
        let last = line.segments.len();
        let mut before = line.chord(0, state).tangent;
        let clamped = |end: usize| self.clamp(end, state).map(|(direction, _)| direction);
        let mut axis = across(&clamped(0).unwrap_or(before));
        for (i, out) in out.iter_mut().enumerate() {
            let [first, second] = match i {
                0 => [clamped(0).unwrap_or(before), before],
                i if i >= last => [before, clamped(1).unwrap_or(before)],
                i => [before, line.chord(i, state).tangent],
            };
            let middle = (first + second).try_normalize(1e-9).unwrap_or(second);
            axis = carried(&axis, &first, &middle);
            let curvature = self.curvature_at(i, line, state);
            *out = [curvature.dot(&axis), curvature.dot(&middle.cross(&axis))];
            axis = carried(&axis, &middle, &second);
            before = second;
        }
    }

    /// Bending moment \[N m\] at every node.
    #[must_use]
    pub fn moments(&self, line: &LumpedLine, state: &State) -> Vec<f64> {
        self.bent(line, state).1
    }

    /// Curvature \[1/m\] and bending moment \[N m\] at every node. A hinge, where the line may turn without a moment,
    /// has no curvature.
    #[must_use]
    pub fn bent(&self, line: &LumpedLine, state: &State) -> (Vec<f64>, Vec<f64>) {
        let nodes = 0..=line.segments.len();
        nodes.map(|i| self.bent_at(i, line, state)).unzip()
    }

    /// The same at node i.
    #[must_use]
    pub fn bent_at(&self, i: usize, line: &LumpedLine, state: &State) -> (f64, f64) {
        let curvature = self.curvature_at(i, line, state).norm();
        let k = match i {
            0 => self.clamps[0].map_or(0.0, |c| c.1),
            i if i == line.segments.len() => self.clamps[1].map_or(0.0, |c| c.1),
            i => self.joints[i],
        };
        (curvature, curvature * self.spans[i] * k)
    }

    /// The first node at which the line bends by a right angle or more, past which the discrete moment falls.
    #[must_use]
    pub fn kinked_node(&self, line: &LumpedLine, state: &State) -> Option<usize> {
        let chord = |i: usize| state.x[i + 1] - state.x[i];
        let last = line.segments.len();
        let back = |direction: &V3, i: usize| direction.dot(&chord(i)) <= 0.0;
        let at_end =
            |end: usize, i: usize| self.clamp(end, state).is_some_and(|(d, _)| back(&d, i));
        if at_end(0, 0) {
            return Some(0);
        }
        let inner = (1..last).find(|i| self.joints[*i] > 0.0 && back(&chord(i - 1), *i));
        inner.or_else(|| at_end(1, last - 1).then_some(last))
    }

    /// The same with every clamp turned by a share of the angle from the direction of the line in `start` to its own, in
    /// the plane of both; nothing without clamps.
    pub(in crate::scene) fn with_clamps(
        &self,
        line: &LumpedLine,
        start: &State,
        share: f64,
    ) -> Option<Self> {
        self.clamps.iter().flatten().next()?;
        let mut turned = self.clone();
        for (end, i) in [(0, 0), (1, line.segments.len() - 1)] {
            if let Some((direction, _)) = &mut turned.clamps[end] {
                *direction = part_way(&line.chord(i, start).tangent, direction, share);
            }
        }
        Some(turned)
    }

    /// Whether neither shear nor curvature jumps at a node.
    pub(in crate::scene) fn is_even(&self, node: usize) -> bool {
        self.even[node]
    }

    /// The part of shear in the tensions along the chords of the segments before and after an inner node, by their length \[N/m\]: `Q k / 2`
    /// of the shear and the curvature there. Nothing beside a slack segment, along which no force is known.
    pub(in crate::scene) fn shear_in_tension(
        &self,
        node: usize,
        before: f64,
        after: f64,
    ) -> Option<f64> {
        let taut = before != 0.0 && after != 0.0;
        taut.then(|| 0.5 * (after - before) / self.spans[node])
    }

    /// Energy of bending \[J\].
    #[must_use]
    pub fn energy(&self, line: &LumpedLine, state: &State) -> f64 {
        let last = line.segments.len();
        let tangent = |i: usize| line.chord(i, state).tangent;
        let inner: f64 = (1..last)
            .map(|i| self.joints[i] * (1.0 - tangent(i - 1).dot(&tangent(i))))
            .sum();
        let ends = [(0, 0), (1, last - 1)].into_iter();
        inner
            + ends
                .filter_map(|(end, i)| {
                    let (d, k) = self.clamp(end, state)?;
                    Some(k * (1.0 - d.dot(&tangent(i))))
                })
                .sum::<f64>()
    }
}

/// The bend between two segments.
#[inline(always)]
fn between(first: &Chord, second: &Chord) -> BendAngle {
    BendAngle::new(
        (&first.tangent, first.inverse),
        (&second.tangent, second.inverse),
    )
}

/// The unit vector at a share of the angle from one to another; through the vertical if they are opposite.
fn part_way(from: &V3, to: &V3, share: f64) -> V3 {
    let cos = from.dot(to);
    let beside = |v: &V3| (v - from * from.dot(v)).try_normalize(1e-6);
    let Some(side) = beside(to)
        .or_else(|| beside(&V3::z()))
        .or_else(|| beside(&V3::x()))
    else {
        return *to;
    };
    let angle = share * cos.clamp(-1.0, 1.0).acos();
    from * angle.cos() + side * angle.sin()
}

impl Flexure {
    /// The bending of a case on its line; none if no material has a bending stiffness.
    pub(super) fn of_case(case: &Case, line: &LumpedLine) -> Option<Self> {
        let segments = &line.segments;
        if segments.iter().all(|s| s.ei <= 0.0) {
            return None;
        }
        let last = segments.len();
        let part = |i: usize| (segments[i].ei, segments[i].axial.length);
        let span = |i: usize| match i {
            0 => 0.5 * part(0).1,
            i if i == last => 0.5 * part(last - 1).1,
            i => 0.5 * (part(i - 1).1 + part(i).1),
        };
        let joint = |i: usize| {
            if i == 0 || i == last {
                0.0
            } else {
                bending::stiffness(part(i - 1), part(i))
            }
        };
        let clamp = |end: &case::End, i: usize| {
            let elevation = end
                .clamp_elevation_deg
                .filter(|_| part(i).0 > 0.0)?
                .to_radians();
            let azimuth = end.clamp_azimuth_deg.to_radians();
            let (ei, length) = part(i);
            Some((
                direction(azimuth, elevation),
                bending::clamp_stiffness(ei, length),
            ))
        };
        let even = |i: &usize| {
            let inner = *i > 0 && *i + 1 < line.line_nodes;
            inner
                && segments[i - 1].ei == segments[*i].ei
                && line.bodies.iter().all(|hung| hung.node != *i)
        };
        Some(Self {
            even: (0..=last).map(|i| even(&i)).collect(),
            joints: (0..=last).map(joint).collect(),
            spans: (0..=last).map(span).collect(),
            clamps: [clamp(&case.ends.a, 0), clamp(&case.ends.b, last - 1)],
        })
    }
}

/// Remarks on clamps at ends without bending stiffness, which have no effect.
pub(in crate::scene) fn clamps_without_effect(case: &Case, segments: &[Segment]) -> Vec<String> {
    let ends = [
        (&case.ends.a, segments.first()),
        (&case.ends.b, segments.last()),
    ];
    let without_effect = ends.into_iter().filter(|(end, segment)| {
        end.clamp_elevation_deg.is_some() && segment.is_some_and(|s| s.ei <= 0.0)
    });
    without_effect.map(|(end, _)| {
        format!(
            "the clamp at `{}` holds nothing: the line has no bending stiffness there (ei_n_m2); it turns as on a hinge",
            end.name
        )
    })
    .collect()
}

/// Gradient of the energy of a clamp by the chord of its segment; the same at both ends, since the bend is symmetric.
fn clamped(k: f64, direction: &V3, chord: &Chord) -> V3 {
    BendAngle::new((&chord.tangent, chord.inverse), (direction, 0.0)).forces(k)[0]
}

/// The horizontal direction across a tangent; the y axis across an upright one.
fn across(tangent: &V3) -> V3 {
    let horizontal = V3::new(-tangent.y, tangent.x, 0.0);
    let y = V3::new(0.0, 1.0, 0.0);
    horizontal
        .try_normalize(1e-6)
        .unwrap_or(y - tangent * tangent.y)
}

/// An axis across one tangent carried to the next by the least rotation between them.
fn carried(axis: &V3, from: &V3, to: &V3) -> V3 {
    let both = 1.0 + from.dot(to);
    match both > 1e-9 {
        true => axis - (from + to) * (axis.dot(to) / both),
        false => *axis,
    }
}
