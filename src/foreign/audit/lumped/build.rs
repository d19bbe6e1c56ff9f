//! The lumped masses of a mooring that was read, where the program that it is for begins.

use std::f64::consts::PI;

use super::{Bend, LumpedModel, LumpedPoint, ModelLine, SegmentElasticity};
use crate::import::mooring::{
    Attachment, Damping, Hold, Mass, Mooring, MooringLine, MooringLineType, Rod, Stiffness,
};
use crate::import::to_case::sea::SeaOfCase;
use crate::numerics::V3;
use crate::statics::catenary::{CatenaryLine, EndOffset, RigidBed, SectionProperties};
use crate::system::pose::Pose;

/// Push and damping of the bed where the file gives none \[Pa/m, Pa s/m\]: those of `MoorDyn`.
const BED: [f64; 2] = [3.0e6, 3.0e5];
/// Horizontal distance of two ends below which `MoorDyn` begins with a straight line \[m\].
const VERTICAL: f64 = 1e-4;
/// Depth of an end, by that of the bed, at which it counts as lying on it.
const ON_BED: f64 = 1e-5;

/// Distance of the node that holds the direction of a clamped end, by the length of a segment.
const CLOSE: f64 = 1e-5;

/// The model of a mooring, each line with `refined` times its segments.
///
/// # Errors
/// What of it has no lumped masses here.
pub fn lumped(mooring: &Mooring, sea: &SeaOfCase, refined: usize) -> Result<LumpedModel, String> {
    let given = |value: &Option<crate::import::mooring::Given<f64>>, default: f64| {
        value.as_ref().map_or(default, |given| given.value)
    };
    let mut model = LumpedModel {
        gravity: sea.gravity,
        density: sea.density,
        bed_z: sea.depth.map(|depth| -depth.max(deepest(mooring))),
        bed_stiffness: given(&mooring.sea.bed_stiffness, BED[0]),
        bed_damping: given(&mooring.sea.bed_damping, BED[1]),
        ..LumpedModel::default()
    };
    let mut nodes = EndNodes::default();
    for point in &mooring.points {
        let place = V3::from(point.place.each_ref().map(|given| given.value));
        let node = add(&mut model, mooring, &point.hold.value, place);
        if point.hold.value == Hold::Free {
            let volume = point.volume.value;
            model.points.push(LumpedPoint {
                node,
                mass: point.mass.value,
                moving_mass: point.mass.value + sea.density * volume * point.added_mass.value,
                volume,
                drag_area: point.drag_area.value,
                load: V3::from(point.load.each_ref().map(|given| given.value)),
            });
        }
        nodes.points.push(node);
    }
    for rod in &mooring.rods {
        nodes.rods.push(rod_nodes(&mut model, mooring, rod));
    }
    model.holds_bodies |= mooring
        .bodies
        .iter()
        .any(|body| matches!(body.hold.value, Hold::Free | Hold::Pinned(_)));
    for line in &mooring.lines {
        add_line(&mut model, mooring, line, &nodes, refined)?;
    }
    bends_at_joints(&mut model, mooring, &nodes);
    Ok(model)
}

/// Depth of the deepest fixed point \[m\], above which `MoorDyn` has no bed.
fn deepest(mooring: &Mooring) -> f64 {
    let points = mooring.points.iter();
    let fixed = points.filter(|point| point.hold.value == Hold::Fixed);
    fixed.map(|point| -point.place[2].value).fold(0.0, f64::max)
}

/// Nodes of what lines end at.
#[derive(Debug, Default)]
struct EndNodes {
    points: Vec<usize>,
    rods: Vec<[usize; 2]>,
}

impl EndNodes {
    fn node_at(&self, at: Attachment) -> Result<usize, String> {
        match at {
            Attachment::Point(point) => Ok(self.points[point]),
            Attachment::Rod(rod, end) => Ok(self.rods[rod][end]),
            Attachment::Inside(_) => Err("it has sections".to_owned()),
        }
    }
}

/// A node; of a body at its place in the frame of that body.
fn add(model: &mut LumpedModel, mooring: &Mooring, hold: &Hold, place: V3) -> usize {
    let place = match hold {
        Hold::Body(body) => {
            let pose = pose_of(mooring, *body);
            pose.origin + pose.arm(&place)
        }
        _ => place,
    };
    model.start.push(place);
    model.free.push(*hold == Hold::Free);
    model.start.len() - 1
}

/// Where the file puts a body.
fn pose_of(mooring: &Mooring, body: usize) -> Pose {
    let body = &mooring.bodies[body];
    let origin = V3::from(body.place.each_ref().map(|given| given.value));
    let angles = body.angles.each_ref().map(|given| given.value.to_radians());
    Pose::of_roll_first(origin, angles)
}

/// The nodes of the ends of a rod: one of a joint without length.
fn rod_nodes(model: &mut LumpedModel, mooring: &Mooring, rod: &Rod) -> [usize; 2] {
    let hold = &rod.hold.value;
    if rod.is_joint() {
        let node = add(model, mooring, hold.base(), V3::from(rod.end(0)));
        if *hold == Hold::Free && rod.load() != [0.0; 3] {
            model.points.push(LumpedPoint {
                node,
                mass: 0.0,
                moving_mass: 0.0,
                volume: 0.0,
                drag_area: 0.0,
                load: V3::from(rod.load()),
            });
        }
        return [node; 2];
    }
    model.holds_bodies |= matches!(hold, Hold::Free | Hold::Pinned(_));
    let held = match hold {
        Hold::Free => &Hold::Fixed,
        _ => hold.base(),
    };
    [0, 1].map(|end| add(model, mooring, held, V3::from(rod.end(end))))
}

fn add_line(
    model: &mut LumpedModel,
    mooring: &Mooring,
    line: &MooringLine,
    nodes: &EndNodes,
    refined: usize,
) -> Result<(), String> {
    let of = &mooring.line_types[line.of_type.value];
    let segments = line.segments.value * refined;
    let segment = line.length.value / segments as f64;
    let Mass::InAir(mass) = of.mass.value else {
        return Err("its mass is given in water".to_owned());
    };
    let elasticity = elasticity(&of.stiffness.value)?;
    model.creeps |= matches!(of.stiffness.value, Stiffness::Viscoelastic { .. });
    let damping = match of.damping.value {
        Damping::Coefficient(damping) => damping,
        // Of the critical damping of a segment in air, as MoorDyn takes it.
        Damping::Ratio(ratio) => ratio * segment * (elasticity.initial() * mass).sqrt(),
        Damping::Two(slow, _) => slow,
    };
    let ends = [
        nodes.node_at(line.ends[0].value)?,
        nodes.node_at(line.ends[1].value)?,
    ];
    let inner = shape(model, of, line, ends, segments);
    let first = model.start.len();
    model.free.extend(inner.iter().map(|_| true));
    model.start.extend(inner);
    let mut all = vec![ends[0]];
    all.extend(first..model.start.len());
    all.push(ends[1]);
    let number = model.lines.len();
    if of.bending.value > 0.0 {
        bend(
            model,
            mooring,
            line,
            &all,
            (of.bending.value, number, segment),
        );
    }
    model.lines.push(ModelLine {
        nodes: all,
        segment,
        elasticity,
        damping,
        mass,
        diameter: of.diameter.value,
        drag: [of.drag_normal.value, of.drag_tangential.value],
        added_mass: [of.added_mass_normal.value, of.added_mass_tangential.value],
    });
    Ok(())
}

/// Adds the bending stiffness of a line over its nodes, and its clamps.
fn bend(
    model: &mut LumpedModel,
    mooring: &Mooring,
    line: &MooringLine,
    nodes: &[usize],
    (ei, number, segment): (f64, usize, f64),
) {
    model.bends.extend(nodes.windows(3).map(|nodes| Bend {
        nodes: [nodes[0], nodes[1], nodes[2]],
        ei,
        line: number,
        length: segment,
    }));
    for (end, at) in line.ends.iter().enumerate() {
        clamp(
            model,
            mooring,
            at.value,
            (nodes, end),
            (ei, number, segment),
        );
    }
}

/// The tension of segments by their strain.
fn elasticity(stiffness: &Stiffness) -> Result<SegmentElasticity, String> {
    match stiffness {
        Stiffness::Constant(ea) => Ok(SegmentElasticity::Constant(*ea)),
        Stiffness::Viscoelastic { slow, .. } => Ok(SegmentElasticity::Constant(*slow)),
        Stiffness::Table(rows) => {
            let mut rows = rows.clone();
            rows.retain(|row| row[0] > 0.0);
            Ok(SegmentElasticity::Table(rows))
        }
        Stiffness::Syrope(_) => Err("a Syrope rope depends on its past".to_owned()),
    }
}

/// A line that bends and ends at a rod goes on in the direction of the rod, but for joints that turn: a node close behind its end holds it.
fn clamp(
    model: &mut LumpedModel,
    mooring: &Mooring,
    at: Attachment,
    (nodes, end): (&[usize], usize),
    (ei, line, segment): (f64, usize, f64),
) {
    let Attachment::Rod(rod, rod_end) = at else {
        return;
    };
    let rod = &mooring.rods[rod];
    let last = nodes.len() - 1;
    let (own, next) = match end {
        0 => (nodes[0], nodes[1]),
        _ => (nodes[last], nodes[last - 1]),
    };
    let mut axis = V3::from(rod.end(1)) - V3::from(rod.end(0));
    // Rods with length that turn are held here.
    if axis == V3::zeros() || rod.is_joint() && rod.hold.value.turns() {
        return;
    }
    if let Hold::Body(body) = rod.hold.value.base() {
        axis = pose_of(mooring, *body).arm(&axis);
    }
    let outwards = if rod_end == 1 { axis } else { -axis }.normalize();
    let close = CLOSE * (model.start[next] - model.start[own]).norm();
    model.start.push(model.start[own] - outwards * close);
    model.free.push(false);
    let ghost = model.start.len() - 1;
    let nodes = if end == 0 {
        [ghost, own, next]
    } else {
        [next, own, ghost]
    };
    model.bends.push(Bend {
        nodes,
        ei,
        line,
        length: 0.5 * segment,
    });
}

/// Inner nodes of a line between its ends: a catenary, with a bed where an end is on it, straight where there is none.
fn shape(
    model: &LumpedModel,
    of: &MooringLineType,
    line: &MooringLine,
    ends: [usize; 2],
    segments: usize,
) -> Vec<V3> {
    let [a, b] = ends.map(|node| model.start[node]);
    let share = |k: usize| k as f64 / segments as f64;
    let straight = || (1..segments).map(|k| a.lerp(&b, share(k))).collect();
    let apart = V3::new(b.x - a.x, b.y - a.y, 0.0);
    if apart.norm() <= VERTICAL {
        return straight();
    }
    let Mass::InAir(mass) = of.mass.value else {
        return straight();
    };
    let area = 0.25 * PI * of.diameter.value.powi(2);
    let weight = (mass - model.density * area) * model.gravity;
    let ea = match &of.stiffness.value {
        Stiffness::Constant(ea) | Stiffness::Viscoelastic { slow: ea, .. } => *ea,
        Stiffness::Table(rows) => rows.last().map_or(0.0, |row| row[1] / row[0]),
        Stiffness::Syrope(rope) => rope.fast,
    };
    let length = line.length.value;
    let lies = |z: f64| model.bed_z.is_some_and(|bed| z <= bed * (1.0 - ON_BED));
    let (low, high) = if b.z < a.z { (b, a) } else { (a, b) };
    let bed = (lies(a.z) || lies(b.z)).then_some(RigidBed {
        below_a_m: 0.0,
        ..RigidBed::default()
    });
    // Longer than an L on the bed, MoorDyn gives up its catenary.
    let by_weight = ea / weight;
    let longest = apart.norm() - by_weight
        + (by_weight * by_weight + 2.0 * (high.z - low.z) * by_weight).sqrt();
    if weight == 0.0 || (weight > 0.0 && bed.is_some() && length >= longest) {
        return straight();
    }
    let section = [SectionProperties::new(length, weight, ea)];
    let hanging = CatenaryLine {
        ends: EndOffset::between([low.x, low.y, low.z], [high.x, high.y, high.z]),
        sections: &section,
        bed,
        surface_above_a_m: None,
    };
    let Ok(solution) = hanging.solve() else {
        return straight();
    };
    let outwards = (high - low)
        .component_mul(&V3::new(1.0, 1.0, 0.0))
        .normalize();
    let at = |k: usize| {
        let share = if b.z < a.z { 1.0 - share(k) } else { share(k) };
        let found = solution.at(share * length);
        low + outwards * found.x_m + V3::z() * found.z_m
    };
    (1..segments).map(at).collect()
}

/// Two lines that bend and end at a free joint bend against each other there.
fn bends_at_joints(model: &mut LumpedModel, mooring: &Mooring, nodes: &EndNodes) {
    for (number, rod) in mooring.rods.iter().enumerate() {
        if !rod.is_joint() || rod.hold.value != Hold::Free {
            continue;
        }
        let joint = nodes.rods[number][0];
        let mut next = Vec::new();
        for (k, line) in model.lines.iter().enumerate() {
            let of = &mooring.line_types[mooring.lines[k].of_type.value];
            let (first, last) = (line.nodes[0], line.nodes[line.nodes.len() - 1]);
            if first == joint {
                next.push((line.nodes[1], of.bending.value, k));
            } else if last == joint {
                next.push((line.nodes[line.nodes.len() - 2], of.bending.value, k));
            }
        }
        if let &[(before, ei, line), (behind, other, second)] = next.as_slice()
            && ei > 0.0
            && other > 0.0
        {
            model.bends.push(Bend {
                nodes: [before, joint, behind],
                ei: 0.5 * (ei + other),
                line,
                length: 0.5 * (model.lines[line].segment + model.lines[second].segment),
            });
        }
    }
}
