//! Initial bed friction: the equilibrium on a rough bed depends on how the line was laid.
//!
//! **The rule.** A line is taken as laid straight, without tension, and then pulled to where its ends are: friction opposes the
//! way of every node from where it was laid, up to its limit. Tension so falls from the end that is pulled towards the place that the
//! line was laid from, by the friction on every metre until it vanishes. That place is
//!
//! | the line lies on the bed | laid from |
//! |---|---|
//! | with one end | that end |
//! | with both ends, lifted between them | both ends, each up to the lifted part |
//! | from end to end, one end held | the held end |
//! | from end to end, both ends held | nowhere: it has the tension that it was laid with, without friction |
//! | from end to end, no end held | its middle |
//!
//! whichever end is called A ([`LaidFrom`]). The closed form makes the same assumption (J. M. Jonkman, NREL/TP-500-41958, 2007, sec. 2.6).
//! Line not yet pulled is held where it was laid, far more stiffly than by its own stiffness. A current across it, or weight down a
//! slope, moves it from there: see `statics/sliding.rs`.
//!
//! If neither end is on the bed, this does not determine the tension, nor where a line touches down a second time away from its
//! ends: friction is then left out of the equilibrium there.

use super::{EndCondition, LumpedLine, Scene};
use crate::numerics::V3;
use crate::physics::ElasticBed;
use crate::physics::bed_friction::{Friction, FrictionAnchor, FrictionModel};
use crate::physics::motion::MotionPath;

/// Stiffness of the friction springs of line just laid, relative to that of its segments.
const HOLD: f64 = 10.0;
/// Height relative to the length of the line up to which an end counts as on the bed.
const ON_BED: f64 = 1e-3;
/// Halvings of a range of tensions, and rounds for a chord over a grid of depths.
const BISECTIONS: usize = 100;
const ON_GRID: usize = 20;

/// Where a line that lies on the bed from end to end was laid from: friction takes tension off towards there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum LaidFrom {
    /// From this share of its unstretched length from A \[-\], both ways: 0 is end A, 1 end B.
    Share(f64),
    /// With the tension that it has, between ends that are held: without friction.
    HeldEnds,
}

impl Default for LaidFrom {
    fn default() -> Self {
        Self::Share(0.0)
    }
}

impl LaidFrom {
    /// Between ends of which some are held: from the held one, or from the middle if neither is.
    #[must_use]
    pub fn of_held([a, b]: [bool; 2]) -> Self {
        match (a, b) {
            (true, true) => Self::HeldEnds,
            (true, false) => Self::Share(0.0),
            (false, true) => Self::Share(1.0),
            (false, false) => Self::Share(0.5),
        }
    }

    /// Between the ends of a line by itself: ends that move or are free are not held.
    pub(super) fn of_line(line: &LumpedLine) -> Self {
        Self::of_held([0, 1].map(|end| match &line.ends[end] {
            EndCondition::Prescribed(motion) => matches!(motion.course, MotionPath::Still),
            EndCondition::Free => false,
        }))
    }
}

/// The friction springs of a line in equilibrium, and a remark on them.
pub(super) struct InitialFriction {
    pub(super) grips: Vec<FrictionAnchor>,
    pub(super) remark: Option<String>,
}

impl Scene {
    /// The friction springs for the initial guess at an equilibrium.
    pub(super) fn initial_friction(&self, guess: &[V3], tension: &[f64]) -> InitialFriction {
        let mut grips = self.grips_at(guess);
        let remark = match self.seabed().and_then(|bed| bed.friction) {
            None => None,
            Some(Friction {
                law: FrictionModel::Regularised(_),
                ..
            }) => Some(
                "friction by `zhu-2017` holds nothing at rest: it is left out of the equilibrium"
                    .to_owned(),
            ),
            Some(_) => Some(self.lay(guess, tension, &mut grips)),
        };
        InitialFriction { grips, remark }
    }

    /// Attaches the friction springs where the line was laid; returns a remark.
    fn lay(&self, guess: &[V3], tension: &[f64], grips: &mut [FrictionAnchor]) -> String {
        let (last, all) = (guess.len() - 1, 0..guess.len());
        let on_bed = [0, last].map(|end| self.lies(&guess[end]));
        let mut words = match (on_bed, self.lifted_nodes(guess)) {
            ([false, false], _) => return self.lay_between_lifted_ends(guess, tension, grips),
            ([true, true], None) => self.lay_on_bed_from_end_to_end((guess, tension), grips),
            ([true, true], Some([first, end])) => {
                self.lay_from_both_ends((guess, tension), [first, end], grips)
            }
            ([a, _], _) => {
                let end = usize::from(!a) * last;
                self.lay_from_end((end, all), (guess, tension), grips)
            }
        };
        for (i, grip) in grips.iter_mut().enumerate() {
            grip.stiffness = self.hold(i);
        }
        self.hold_weight_on_slope(grips);
        let again = self.release_between_contacts(on_bed, guess, grips);
        if again {
            words +=
                "; where it comes down on the bed again, friction is left out of the equilibrium";
        }
        if self.line.current.max_speed() > 0.0 {
            words += "; where the current moves it from there, friction opposes that way, up to its limit";
        }
        words
    }

    /// A line that lies with one end: laid straight from there, its springs on these nodes. Returns a remark.
    fn lay_from_end(
        &self,
        (end, nodes): (usize, std::ops::Range<usize>),
        (guess, tension): (&[V3], &[f64]),
        grips: &mut [FrictionAnchor],
    ) -> String {
        let last = guess.len() - 1;
        let name = &self.labels.end_names[usize::from(end > 0)];
        let first = if end == 0 { 0 } else { last - 1 };
        let chord = (guess[first + 1] - guess[first]).norm();
        let heaped =
            tension[first] <= 0.0 && chord < (1.0 - 1e-6) * self.line.segments[first].axial.length;
        if !heaped {
            self.lay_straight(
                (end, guess[end]),
                (guess[last - end], &[]),
                nodes.clone(),
                grips,
            );
        }
        for grip in &mut grips[nodes] {
            grip.laid = !heaped;
        }
        if heaped {
            format!(
                "more line than needed lies on the bed at `{name}`, without tension; friction keeps it from sliding"
            )
        } else {
            format!(
                "the line is taken as laid straight from `{name}` and then pulled: along what was pulled, friction on the \
                 bed is at its full"
            )
        }
    }

    /// A line that lies with both ends and is lifted between them, at these nodes: laid from either end. Returns a remark.
    fn lay_from_both_ends(
        &self,
        line: (&[V3], &[f64]),
        [first, end]: [usize; 2],
        grips: &mut [FrictionAnchor],
    ) -> String {
        let count = grips.len();
        let middle = usize::midpoint(first, end);
        let words = self.lay_from_end((0, 0..middle), line, grips);
        let other = self.lay_from_end((count - 1, middle..count), line, grips);
        format!("{words}; {other}")
    }

    /// A line that lies from end to end. Returns a remark.
    fn lay_on_bed_from_end_to_end(
        &self,
        line: (&[V3], &[f64]),
        grips: &mut [FrictionAnchor],
    ) -> String {
        let (count, last) = (grips.len(), grips.len() - 1);
        let heaped = (line.0[last] - line.0[0]).norm() < (1.0 - 1e-9) * self.line.arc[last]
            && line.1.iter().all(|tension| *tension <= 0.0);
        let share = match self.start.laid_from {
            LaidFrom::Share(share) if share <= 0.0 => {
                return self.lay_from_end((0, 0..count), line, grips);
            }
            LaidFrom::Share(share) if share >= 1.0 => {
                return self.lay_from_end((last, 0..count), line, grips);
            }
            LaidFrom::Share(share) => Some(share),
            LaidFrom::HeldEnds => None,
        };
        if heaped {
            return "more line than needed lies on the bed between its ends, without tension; friction keeps it from sliding"
                .to_owned();
        }
        let tensions = self.laid_tensions((line.0[0], line.0[last]), share);
        let Some(share) = share else {
            self.lay_straight((0, line.0[0]), (line.0[last], &tensions), 0..count, grips);
            return "the line lies on the bed between held ends: it is taken as laid there with the tension that it has, without friction"
                .to_owned();
        };
        let from = self.arc_share(share);
        // Where the place that it was laid from lies: beyond what is stretched between A and there.
        let strains = self.strains(&tensions);
        let [a, b] = [line.0[0], line.0[last]];
        let mut before = 0.0;
        for (segment, strain) in self.line.segments[..from].iter().zip(&strains) {
            before += segment.axial.length * (1.0 + strain);
        }
        let whole: f64 = self
            .line
            .segments
            .iter()
            .zip(&strains)
            .map(|(segment, strain)| segment.axial.length * (1.0 + strain))
            .sum();
        let place = a.lerp(&b, before / whole);
        self.lay_straight((from, place), (a, &[]), 0..from, grips);
        self.lay_straight((from, place), (b, &[]), from..count, grips);
        for grip in grips.iter_mut() {
            grip.laid = true;
        }
        "the line lies on the bed between ends that are both pulled: along what was pulled, friction on the bed takes tension off \
         from both towards the middle"
            .to_owned()
    }

    /// The node nearest to this share of the unstretched length from A.
    fn arc_share(&self, share: f64) -> usize {
        let arc = &self.line.arc;
        let at = share * arc[arc.len() - 1];
        let after = arc.partition_point(|s| *s < at).clamp(1, arc.len() - 1);
        if at - arc[after - 1] < arc[after] - at {
            after - 1
        } else {
            after
        }
    }

    /// Strains of the segments under these tensions \[-\].
    fn strains(&self, tensions: &[f64]) -> Vec<f64> {
        let segments = 0..self.line.segments.len();
        segments
            .map(|i| self.line.strain_at_tension(i, tensions[i]))
            .collect()
    }

    /// Tensions of the segments of a line that lies stretched between these ends \[N\]: the same all along, or rising by the friction on
    /// every metre away from a share of the length, and no less than zero.
    fn laid_tensions(&self, (a, b): (V3, V3), from: Option<f64>) -> Vec<f64> {
        let friction = self
            .seabed()
            .and_then(|bed| bed.friction)
            .map_or(0.0, |friction| friction.axial);
        let node = from.map_or(0, |share| self.arc_share(share));
        let count = self.line.segments.len();
        // Friction between a segment and that place.
        let rubbed = |i: usize| {
            let nodes = if i < node {
                &self.line.weight[i + 1..node]
            } else {
                &self.line.weight[node + 1..=i]
            };
            let weight: f64 = nodes.iter().map(|w| w.max(0.0)).sum();
            if from.is_some() {
                friction * weight
            } else {
                0.0
            }
        };
        let rubbed: Vec<f64> = (0..count).map(rubbed).collect();
        let stretch = |least: f64| -> f64 {
            let longer = |i: usize| {
                let tension = (least + rubbed[i]).max(0.0);
                self.line.segments[i].axial.length * self.line.strain_at_tension(i, tension)
            };
            (0..count).map(longer).sum()
        };
        let wanted = (b - a).norm() - self.line.arc[self.line.arc.len() - 1];
        let most = rubbed.iter().copied().fold(0.0, f64::max);
        let stiffest = self
            .line
            .segments
            .iter()
            .map(|s| s.axial.ea)
            .fold(0.0, f64::max);
        let (mut low, mut high) = (-most, stiffest.max(most));
        for _ in 0..BISECTIONS {
            let middle = 0.5 * (low + high);
            if stretch(middle) < wanted {
                low = middle;
            } else {
                high = middle;
            }
        }
        rubbed.iter().map(|more| (low + more).max(0.0)).collect()
    }

    /// The first node off the bed, and the one after the last; nothing where all lie on it.
    fn lifted_nodes(&self, guess: &[V3]) -> Option<[usize; 2]> {
        let off = |i: &usize| !self.touches(guess, *i);
        let first = (0..guess.len()).find(off)?;
        let last = (0..guess.len()).rfind(off)?;
        Some([first, last + 1])
    }

    /// Whether a node of the guess touches the bed, an end as it counts for the whole.
    fn touches(&self, guess: &[V3], node: usize) -> bool {
        let last = guess.len() - 1;
        let tall = 1e-9 * self.line.arc[last];
        match node {
            end if end == 0 || end == last => self.lies(&guess[end]),
            _ => self
                .seabed()
                .is_some_and(|bed| bed.height(&guess[node]) <= tall),
        }
    }

    /// On a slope, moves the springs uphill so that they carry the weight of the line laid, up to the friction limit.
    fn hold_weight_on_slope(&self, grips: &mut [FrictionAnchor]) {
        let Some((bed, friction)) = self.seabed().and_then(|b| Some((b, b.friction?))) else {
            return;
        };
        for (grip, weight) in grips.iter_mut().zip(&self.line.weight) {
            let normal = bed.normal(&grip.at);
            let uphill = V3::z() - normal * normal.z;
            let steep = uphill.norm().max(f64::MIN_POSITIVE);
            let most = friction.axial.min(friction.lateral) * normal.z / steep;
            grip.at += uphill * (weight.max(0.0) * most.min(1.0) / grip.stiffness);
        }
    }

    /// Stiffness of the friction spring of node i of a line just laid \[N/m\].
    fn hold(&self, i: usize) -> f64 {
        let beside =
            self.line.segments[i.saturating_sub(1)..(i + 1).min(self.line.segments.len())].iter();
        HOLD * beside
            .map(|s| s.axial.ea / s.axial.length)
            .fold(0.0, f64::max)
    }

    /// Friction springs if neither end is on the bed: only on line that lies there without tension; returns a remark.
    fn lay_between_lifted_ends(
        &self,
        guess: &[V3],
        tension: &[f64],
        grips: &mut [FrictionAnchor],
    ) -> String {
        let last = guess.len() - 1;
        let tall = 1e-9 * self.line.arc[last];
        let heap = |i: usize| {
            let slack = tension[i.saturating_sub(1)] <= 0.0 && tension[i.min(last - 1)] <= 0.0;
            slack
                && self
                    .seabed()
                    .is_some_and(|bed| bed.height(&guess[i]) <= tall)
        };
        let mut heaped = false;
        for (i, grip) in grips.iter_mut().enumerate() {
            grip.stiffness = if heap(i) { self.hold(i) } else { 0.0 };
            heaped |= heap(i);
        }
        let words = if heaped {
            "more line than needed lies on the bed, without tension; friction keeps it from sliding"
        } else {
            "neither end of the line lies on the bed: how friction acts on it depends on how it was laid, and it is left out \
             of the equilibrium (from there on it holds)"
        };
        words.to_owned()
    }

    /// Whether an end is on the bed.
    pub(super) fn lies(&self, end: &V3) -> bool {
        let whole = self.line.arc[self.line.arc.len() - 1];
        self.seabed()
            .is_some_and(|bed| bed.height(end) <= ON_BED * whole)
    }

    /// Positions of the springs on these nodes of a line laid straight from a node at a place towards another place, at rest under its
    /// weight, under these tensions of its segments, or none.
    fn lay_straight(
        &self,
        (from, place): (usize, V3),
        (to, tensions): (V3, &[f64]),
        nodes: std::ops::Range<usize>,
        grips: &mut [FrictionAnchor],
    ) {
        let Some(bed) = self.seabed() else { return };
        // In the vertical plane through both places, in which it hangs: up and down with a plane, level over a grid, whose slope each step finds.
        let mut flat = V3::new(to.x - place.x, to.y - place.y, 0.0);
        if let (Some(normal), None) = (&bed.slope, &bed.grid) {
            flat.z = -normal.dot(&flat) / normal.z;
        }
        let Some(direction) = flat.try_normalize(1e-9 * self.line.arc[self.line.arc.len() - 1])
        else {
            return;
        };
        let last = grips.len() - 1;
        for forwards in [false, true] {
            let steps = if forwards { last - from } else { from };
            let mut at = place;
            let mut height = bed.height(&place);
            for k in 1..=steps {
                let (i, segment) = if forwards {
                    (from + k, from + k - 1)
                } else {
                    (from - k, from - k)
                };
                let strain = tensions.get(segment).map_or(0.0, |tension| {
                    self.line.strain_at_tension(segment, *tension)
                });
                let length = self.line.segments[segment].axial.length * (1.0 + strain);
                let rest = self.rest_height(bed, i, &at);
                let before = at;
                let mut step = (length * length - (rest - height).powi(2)).max(0.0).sqrt();
                at = before + direction * step;
                // Over a grid the chord counts, up and down with the bed.
                for _ in 0..bed.grid.as_ref().map_or(0, |_| ON_GRID) {
                    at -= bed.way_out(&at) * (bed.height(&at) - rest);
                    let rise = at.z - before.z;
                    step = (length * length - rise * rise).max(0.0).sqrt();
                    at = V3::new(before.x, before.y, at.z) + direction * step;
                }
                height = rest;
                if nodes.contains(&i) {
                    grips[i].at = at;
                    grips[i].along = match bed.grid {
                        Some(_) => on_bed_of(&bed.normal(&at), &direction),
                        None => direction,
                    };
                }
            }
        }
        if nodes.contains(&from) {
            grips[from].at = place;
        }
    }

    /// The height above the bed at which a node rests under its weight \[m\], by the slope of the bed at a place.
    fn rest_height(&self, bed: &ElasticBed, node: usize, at: &V3) -> f64 {
        // Over a grid heights are vertical, and the bed pushes along their gradient.
        let upright = bed.normal(at).z;
        let upright = if bed.grid.is_some() {
            upright * upright
        } else {
            upright
        };
        -(self.line.weight[node] * upright).max(0.0) / (bed.stiffness * self.footprint(node))
    }

    /// Removes the springs where the line touches down away from the stretches that its ends lie on; whether it does.
    fn release_between_contacts(
        &self,
        on_bed: [bool; 2],
        guess: &[V3],
        grips: &mut [FrictionAnchor],
    ) -> bool {
        let Some([first, end]) = self.lifted_nodes(guess) else {
            return false;
        };
        let between = if on_bed[0] { first } else { 0 }..if on_bed[1] { end } else { guess.len() };
        let mut again = between.filter(|i| self.touches(guess, *i));
        let Some(least) = again.next() else {
            return false;
        };
        let most = again.next_back().unwrap_or(least);
        let least = if on_bed[0] { least } else { 0 };
        let most = if on_bed[1] { most } else { guess.len() - 1 };
        for grip in &mut grips[least..=most] {
            grip.stiffness = 0.0;
        }
        true
    }
}

/// The direction along a bed of this normal in the vertical plane of a level direction.
fn on_bed_of(normal: &V3, level: &V3) -> V3 {
    let rise = -normal.xy().dot(&level.xy()) / normal.z;
    V3::new(level.x, level.y, rise).normalize()
}
