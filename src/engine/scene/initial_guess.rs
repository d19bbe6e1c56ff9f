//! Initial guess at an equilibrium: the closed-form catenary in the resultant of weight and mean drag, or a line hanging from one
//! end.

use super::{EndCondition, LaidFrom, Scene};
use crate::numerics::V3;
use crate::physics::ElasticBed;
use crate::physics::bed_friction::{Friction, FrictionModel};
use crate::solve::State;
use crate::statics::catenary::{
    CatenaryError, CatenaryLine, EndOffset, RigidBed, SectionProperties, Solution,
};

/// Estimated positions of the nodes at rest \[m\], and tensions of the segments \[N\].
#[derive(Debug, Clone)]
pub(super) struct InitialGuess {
    pub(super) nodes: Vec<V3>,
    pub(super) tension: Vec<f64>,
}

/// The closed form of a line at rest, at the nodes of its mesh.
#[derive(Debug, Clone)]
pub struct ClosedForm {
    /// Positions \[m\].
    pub nodes: Vec<V3>,
    /// Effective tensions \[N\]; where a body hangs, on its side towards A.
    pub tension: Vec<f64>,
}

/// A catenary in space.
struct PlacedCatenary {
    solution: Solution,
    /// Where it begins, the horizontal direction to its other end, and up.
    first: V3,
    along: V3,
    up: V3,
    /// Unstretched length \[m\], and whether the catenary begins at end B.
    whole: f64,
    reversed: bool,
}

impl PlacedCatenary {
    /// Position \[m\] and tension \[N\] at an unstretched arc length from A \[m\].
    fn at(&self, s: f64) -> (V3, f64) {
        let s = if self.reversed { self.whole - s } else { s };
        let point = self.solution.at(s);
        let place = self.first + self.along * point.x_m + self.up * point.z_m;
        (place, point.tension_n)
    }
}

/// Iterations between the drag on a shape and the shape in that drag.
const ROUNDS: usize = 2;
/// The same if the stiffness of ropes depends on tension.
const ROUNDS_OF_ROPES: usize = 3;
/// The same for a line hanging from one end, which drag may turn far.
const HANGING_ROUNDS: usize = 4;

impl Scene {
    /// Between two prescribed ends.
    pub(super) fn guess_between(&self, from: V3, to: V3) -> InitialGuess {
        let straight = between(from, to, &self.line.arc);
        let mut best: Option<InitialGuess> = None;
        let rounds = if self.line.laws.is_empty() {
            ROUNDS
        } else {
            ROUNDS_OF_ROPES
        };
        for _ in 0..rounds {
            let shape = best.as_ref().map_or(&straight, |guess| &guess.nodes);
            let drag = self.drag_on(shape);
            let stiffness = self.stiffness_of_laws(best.as_ref());
            let Ok(guess) = self.catenary(from, to, &drag, &stiffness) else {
                break;
            };
            let still = drag.iter().all(|force| *force == V3::zeros());
            best = Some(guess);
            if still && self.line.laws.is_empty() {
                break;
            }
        }
        let calm = || vec![V3::zeros(); self.line.segments.len()];
        let mut guess = best
            .or_else(|| {
                self.catenary(from, to, &calm(), &self.stiffness_of_laws(None))
                    .ok()
            })
            .unwrap_or_else(|| self.sagging(from, to));
        self.lay_on_bed(&mut guess.nodes);
        guess
    }

    /// Why the same line, without bending and in still water, has no unique equilibrium, if it has none.
    #[must_use]
    pub fn catenary_error(&self) -> Option<CatenaryError> {
        let (EndCondition::Prescribed(from), EndCondition::Prescribed(to)) =
            (&self.line.ends[0], &self.line.ends[1])
        else {
            return None;
        };
        let calm = vec![V3::zeros(); self.line.segments.len()];
        let laws = self.stiffness_of_laws(None);
        let solved = self.catenary(from.at(0.0).0, to.at(0.0).0, &calm, &laws);
        solved.err()
    }

    /// Drag on every segment of a line at rest in this shape \[N\].
    fn drag_on(&self, nodes: &[V3]) -> Vec<V3> {
        let state = State::at_rest(nodes.to_vec());
        let on = |i| {
            let [first, second] = self
                .line
                .drag(i, &self.line.chord(i, &state), &state)
                .forces();
            first + second
        };
        (0..self.line.segments.len()).map(on).collect()
    }

    /// The closed form of the line at rest between prescribed ends, on a bed that does not yield.
    ///
    /// # Errors
    /// Why it has none, in words: it bends, stretches by a law, or something else than weight loads it.
    pub fn closed_form(&self) -> Result<ClosedForm, String> {
        let (EndCondition::Prescribed(from), EndCondition::Prescribed(to)) =
            (&self.line.ends[0], &self.line.ends[1])
        else {
            return Err("an end of the line is free".to_owned());
        };
        let elements = &self.elements;
        let start = self.initial_state();
        let on_clumps = |node: usize| {
            let aligned = elements.clump_drag.as_ref();
            let aligned =
                aligned.map_or_else(V3::zeros, |drag| drag.at_node(&self.line, node, &start));
            self.drag_of_bodies(node, &start.x[node]) + aligned
        };
        let still = (self.drag_on(&start.x).into_iter())
            .chain((0..start.x.len()).map(on_clumps))
            .all(|force| force == V3::zeros());
        let reasons = [
            (elements.flexure.is_some(), "the line bends"),
            (
                !self.line.laws.is_empty(),
                "the line has a tension-strain table",
            ),
            (!still, "a current acts on the line"),
            (
                elements.traveller.is_some(),
                "a body travels along the line",
            ),
            (
                self.line.water.is_some(),
                "the line may cross the surface of the water",
            ),
        ];
        if let Some((_, why)) = reasons.iter().find(|(is_so, _)| *is_so) {
            return Err((*why).to_owned());
        }
        let calm = vec![V3::zeros(); self.line.segments.len()];
        let found = self.placed_catenary(from.at(0.0).0, to.at(0.0).0, &calm, &[]);
        let found = found.map_err(|why| why.to_string())?;
        let (nodes, tension) = self.line.arc.iter().map(|s| found.at(*s)).unzip();
        Ok(ClosedForm { nodes, tension })
    }

    /// The guess by [`Scene::placed_catenary`].
    fn catenary(
        &self,
        from: V3,
        to: V3,
        drag: &[V3],
        of_laws: &[f64],
    ) -> Result<InitialGuess, CatenaryError> {
        let found = self.placed_catenary(from, to, drag, of_laws)?;
        let arc = &self.line.arc;
        let middle = |ends: &[f64]| found.at(0.5 * (ends[0] + ends[1])).1;
        Ok(InitialGuess {
            nodes: arc.iter().map(|s| found.at(*s).0).collect(),
            tension: arc.windows(2).map(middle).collect(),
        })
    }

    /// The catenary in the resultant of weight and the mean of this drag, in the plane of that and both ends; with a bed,
    /// in still water.
    fn placed_catenary(
        &self,
        from: V3,
        to: V3,
        drag: &[V3],
        of_laws: &[f64],
    ) -> Result<PlacedCatenary, CatenaryError> {
        let whole = self.line.arc[self.line.arc.len() - 1];
        let (down, mean) = if self.seabed().is_some() {
            (-V3::z(), V3::zeros())
        } else {
            let mean = drag.iter().sum::<V3>() / whole;
            let load = mean * whole - V3::z() * self.line.weight.iter().sum::<f64>();
            let size = load.norm();
            // A load that nearly cancels has no direction.
            if size > 1e-9 * self.line.force_scale {
                let down = load / size;
                // A buoyant line in still water is solved as such.
                (if down.z > 0.99 { -down } else { down }, mean)
            } else {
                (-V3::z(), V3::zeros())
            }
        };
        let up = -down;
        let bed = self.seabed().map(|bed| bed.plane_below(&from, &to));
        let bed = bed.map(|bed| self.rubbing(bed, [&from, &to]));
        let bed = bed.as_ref();
        let lying = bed.is_some() && self.lies(&from) && self.lies(&to);
        let reversed = match self.start.laid_from {
            LaidFrom::Share(share) if lying => share > 0.5,
            _ => bed.is_some_and(|bed| !bed.is_plain() && bed.height(&from) > bed.height(&to)),
        };
        let sections = self.sections(&down, &mean, of_laws, reversed);
        let (first, last) = if reversed { (to, from) } else { (from, to) };
        let chord = last - first;
        let rise = chord.dot(&up);
        let level = chord - up * rise;
        let ends = EndOffset {
            x_m: level.norm(),
            z_m: rise,
        };
        let along = if ends.x_m > 0.0 {
            level / ends.x_m
        } else {
            across(&up)
        };
        Ok(PlacedCatenary {
            solution: self.solve_over_bed(bed, (first, along), ends, &sections)?,
            first,
            along,
            up,
            whole,
            reversed,
        })
    }

    /// The bed, without friction where a line that lies on it from end to end was not laid from one of them.
    fn rubbing(&self, bed: ElasticBed, ends: [&V3; 2]) -> ElasticBed {
        let from_end =
            matches!(self.start.laid_from, LaidFrom::Share(share) if share <= 0.0 || share >= 1.0);
        match from_end || !ends.iter().all(|end| self.lies(end)) {
            true => bed,
            false => ElasticBed {
                friction: None,
                ..bed
            },
        }
    }

    /// A stiffness for every law \[N\]: at the mean tension of its segments in a guess, or that of the whole law.
    fn stiffness_of_laws(&self, guess: Option<&InitialGuess>) -> Vec<f64> {
        let of = |number: usize| {
            let mine =
                |i: &usize| self.line.segments[*i].axial.law.map(usize::from) == Some(number);
            let segments: Vec<usize> = (0..self.line.segments.len()).filter(mine).collect();
            let (Some(guess), Some(first)) = (guess, segments.first()) else {
                return self.line.laws[number].representative_stiffness();
            };
            let sum: f64 = segments.iter().map(|i| guess.tension[*i]).sum();
            self.line
                .stiffness_at_tension(*first, sum / segments.len() as f64)
        };
        (0..self.line.laws.len()).map(of).collect()
    }

    /// The closed form over the slope of the bed in the plane of the line; without friction if that fails with it.
    fn solve_over_bed(
        &self,
        bed: Option<&ElasticBed>,
        (first, along): (V3, V3),
        ends: EndOffset,
        sections: &[SectionProperties],
    ) -> Result<Solution, CatenaryError> {
        let bed = bed.map(|bed| {
            let normal = bed.normal(&first);
            let slope = (-normal.dot(&along) / normal.z).atan();
            RigidBed {
                below_a_m: if bed.is_plain() {
                    first.z - bed.z
                } else {
                    (bed.height(&first) / normal.z).max(0.0)
                },
                // Across the line a bed may slope without sloping along it, but for rounding.
                slope_rad: if slope.abs() > 1e-12 { slope } else { 0.0 },
                friction: match bed.friction {
                    Some(Friction {
                        axial,
                        law: FrictionModel::ElasticPlastic(_),
                        ..
                    }) => axial,
                    _ => 0.0,
                },
            }
        });
        let line = |bed| CatenaryLine {
            ends,
            sections,
            bed,
            surface_above_a_m: None,
        };
        line(bed).solve().or_else(|refusal| {
            let rough = bed.filter(|bed| bed.friction > 0.0).ok_or(refusal)?;
            let smooth = RigidBed {
                friction: 0.0,
                ..rough
            };
            line(Some(smooth)).solve()
        })
    }

    /// Sections of equal segments with the bodies between them, their loads as seen along `down`; from end B to A where
    /// reversed.
    fn sections(
        &self,
        down: &V3,
        mean_drag: &V3,
        of_laws: &[f64],
        reversed: bool,
    ) -> Vec<SectionProperties> {
        let sinks = -down.z;
        let mut sections: Vec<SectionProperties> = Vec::new();
        let last = self.line.segments.len() - 1;
        for k in 0..=last {
            let i = if reversed { last - k } else { k };
            let segment = &self.line.segments[i];
            let length = segment.axial.length;
            let weight = 2.0 * segment.half_weight / length * sinks + mean_drag.dot(down);
            let law = segment.axial.law.map(usize::from);
            let ea = law.map_or(segment.axial.ea, |law| of_laws[law]);
            match sections.last_mut() {
                Some(s)
                    if same(s.weight_n_per_m, weight) && same(s.ea_n, ea) && s.clump_n == 0.0 =>
                {
                    s.length_m += length;
                }
                _ => sections.push(SectionProperties::new(length, weight, ea)),
            }
            if let Some(s) = sections.last_mut().filter(|_| k < last) {
                let beyond = if reversed { i } else { i + 1 };
                let here = self.line.bodies.iter().filter(|hung| hung.node == beyond);
                s.clump_n = here.map(|hung| hung.body.weight * sinks).sum();
            }
        }
        sections
    }

    /// Lowers the line on the bed to the equilibrium of its weight and the normal springs.
    fn lay_on_bed(&self, nodes: &mut [V3]) {
        let Some(bed) = self.seabed() else { return };
        let tall = 1e-9 * self.line.arc[nodes.len() - 1];
        for i in self.line.free() {
            let node = &mut nodes[i];
            let (height, out) = (bed.height(node), bed.way_out(node));
            let area = self.bearing_area(i);
            if height <= tall && area > 0.0 {
                let give = self.line.weight[i].max(0.0) * out.z / (bed.stiffness * area);
                match (bed.slope, &bed.grid) {
                    (None, None) => node.z = bed.z - give,
                    _ => *node -= out * (height + give),
                }
            }
        }
    }

    /// A parabola of about the right length between two held ends, hanging down (up for a buoyant line).
    fn sagging(&self, from: V3, to: V3) -> InitialGuess {
        let whole = self.line.arc[self.line.arc.len() - 1];
        let chord = (to - from).norm();
        let slack = (whole * whole - chord * chord).max(0.0).sqrt();
        // Between the flat parabola's sag, sqrt(3/8 c (L - c)), and that of a line folded double, L/2.
        let sag = 0.43 * slack;
        let weight: f64 = self.line.weight.iter().sum();
        let down = if weight >= 0.0 { -1.0 } else { 1.0 };
        let mut nodes = between(from, to, &self.line.arc);
        for (node, s) in nodes.iter_mut().zip(&self.line.arc) {
            let f = s / whole;
            *node += V3::z() * (down * sag * 4.0 * f * (1.0 - f));
        }
        let tension = vec![self.line.force_scale; self.line.segments.len()];
        InitialGuess { nodes, tension }
    }

    /// From prescribed end A to free end B (or `reversed`): each segment along the sum of the loads beyond it.
    pub(super) fn guess_hanging(&self, from: V3, reversed: bool) -> InitialGuess {
        let count = self.line.segments.len();
        let mut guess = InitialGuess {
            nodes: vec![from; count + 1],
            tension: vec![0.0; count],
        };
        let mut drag = vec![V3::zeros(); count];
        for round in 0..HANGING_ROUNDS {
            self.hang(&drag, reversed, &mut guess);
            if round + 1 < HANGING_ROUNDS {
                drag = self.drag_on(&guess.nodes);
                if drag.iter().all(|force| *force == V3::zeros()) {
                    break;
                }
            }
        }
        self.lay_on_bed(&mut guess.nodes);
        guess
    }

    /// The shape of a line that hangs from one end, with this drag on its segments.
    fn hang(&self, drag: &[V3], reversed: bool, guess: &mut InitialGuess) {
        let count = self.line.segments.len();
        let order = |k: usize| if reversed { k } else { count - 1 - k };
        // From the free end to the held one: k counts segments from the free end.
        let mut load = V3::zeros();
        let mut pull = vec![V3::zeros(); count];
        for k in 0..count {
            let i = order(k);
            let outer = if reversed { i } else { i + 1 };
            let beyond = if k > 0 {
                drag[order(k - 1)]
            } else {
                V3::zeros()
            };
            load += (drag[i] + beyond) * 0.5 - V3::z() * self.line.weight[outer];
            load += self.drag_of_bodies(outer, &guess.nodes[outer]);
            pull[i] = load;
        }
        for k in (0..count).rev() {
            let i = order(k);
            let (inner, outer) = if reversed { (i + 1, i) } else { (i, i + 1) };
            let axial = &self.line.segments[i].axial;
            let size = pull[i].norm();
            let direction = if size > 0.0 { pull[i] / size } else { -V3::z() };
            let length = axial.length * (1.0 + self.line.strain_at_tension(i, size));
            guess.nodes[outer] = guess.nodes[inner] + direction * length;
            guess.tension[i] = size;
        }
    }

    fn drag_of_bodies(&self, node: usize, at: &V3) -> V3 {
        let here = self.line.bodies.iter().filter(|hung| hung.node == node);
        here.map(|hung| hung.body.drag(&self.line.current.at(at).0))
            .sum()
    }
}

/// Nodes on the straight line between two ends, spaced by arc length.
pub fn between(from: V3, to: V3, arc: &[f64]) -> Vec<V3> {
    let whole = arc[arc.len() - 1];
    arc.iter()
        .map(|s| from + (to - from) * (s / whole))
        .collect()
}

/// A unit vector across this one: x where that is upright.
fn across(up: &V3) -> V3 {
    let x = V3::x() - up * up.x;
    x.try_normalize(1e-3).unwrap_or_else(V3::y)
}

/// Equal but for rounding: segments of one section come out of the same formulas.
fn same(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-9 * a.abs().max(b.abs())
}
