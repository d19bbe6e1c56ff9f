//! From the words of a case to a line in SI.

use std::f64::consts::{FRAC_PI_4, PI};

use super::elasticity::{Elasticity, elasticity};
use super::line::{AttachedBody, Joint, Scene, Segment};
use super::{
    RigidPayload, Traveller, bed, bodies, buoyancy, ends, event, flexure, initial_shape, mesh,
    unused_inputs, waves,
};
use crate::case::{self, Case, DragWidth, OneOrMany, StartShape};
use crate::numerics::V3;
use crate::physics::added_mass::AddedMass;
use crate::physics::drag::DragProperties;
use crate::physics::rope::TensionLaw;
use crate::physics::tension::Axial;
use crate::physics::{Current, DragLaw};

/// Why a case cannot be made into a scene. A case that passed its checks does not meet these.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum SceneError {
    /// A section names a material that the case does not have.
    #[error("section `{section}` is made of `{material}`, which the case does not describe")]
    NoMaterial {
        /// The section.
        section: String,
        /// The material.
        material: String,
    },
    /// A key is needed and absent.
    #[error("`{key}` is needed: {why}")]
    Missing {
        /// The key path.
        key: String,
        /// Why.
        why: &'static str,
    },
    /// A file that the case names cannot be what it is named for.
    #[error("{0}")]
    File(String),
    /// A number would spoil the computation.
    #[error("`{key}` makes no line: {why}")]
    Impossible {
        /// The key path.
        key: String,
        /// Why.
        why: &'static str,
    },
}

/// Makes the line of a case, every section divided into `1 / coarsening` of its segments (rounded up): 1 for
/// the run itself, 2 for the companion that estimates the mesh error.
///
/// # Errors
/// [`SceneError`] when the case contradicts itself.
pub fn build(case: &Case, coarsening: usize) -> Result<Scene, SceneError> {
    let mut segments = Vec::new();
    let mut joints = Vec::new();
    let mut arc = vec![0.0];
    let mut laws = Vec::new();
    let mut name_before = case.ends.a.name.as_str();
    for (index, section) in case.line.iter().enumerate() {
        joints.push(Joint {
            name: format!("{name_before}|{}", section.name),
            node: segments.len(),
        });
        add_section(case, index, coarsening, &mut segments, &mut arc, &mut laws)?;
        name_before = &section.name;
    }
    if segments.is_empty() {
        return Err(SceneError::Impossible {
            key: "line".into(),
            why: "it has no segments",
        });
    }
    joints.push(Joint {
        name: format!("{name_before}|{}", case.ends.b.name),
        node: segments.len(),
    });
    let (mut bodies, mut remarks) = bodies::on_line(case, &joints, &arc)?;
    let clumps = bodies[..case.clumps.len()].iter().map(|b| b.node).collect();
    bodies.sort_by_key(|hung| hung.node);
    let rigid_payload = bodies::rigid_payload(case, arc.len() - 1)?;
    if let Some(rigid_payload) = &rigid_payload {
        arc.push(arc[arc.len() - 1] + rigid_payload.body.reach);
        segments.push(rod(&segments[segments.len() - 1], rigid_payload));
    }
    let (mass, weight) = lump(&segments, &bodies, rigid_payload.as_ref())?;
    let (water, of_water) = waves::water(case, &segments, &bodies)?;
    remarks.extend(of_water);
    let waves = water.as_ref().and_then(|water| water.waves.as_ref());
    let ends = [
        ends::end(case, &case.ends.a, "ends.a", waves, &mut remarks)?,
        ends::end(case, &case.ends.b, "ends.b", waves, &mut remarks)?,
    ];
    let flexure = flexure::flexure(case, &segments);
    remarks.extend(flexure::clamps_in_vain(case, &segments));
    remarks.extend(unused_inputs::remarks(case));
    let bed = case.seabed.as_ref().map(bed::seabed);
    let gross: f64 = weight.iter().map(|w| w.abs()).sum();
    let line_length = case.line.iter().map(|section| section.length_m).sum();
    let mut scene = Scene {
        force_scale: gross
            .max(mass.iter().sum::<f64>() * 1e-3)
            .max(f64::MIN_POSITIVE),
        mass,
        weight,
        end_names: [case.ends.a.name.clone(), case.ends.b.name.clone()],
        ends,
        bodies,
        rigid_payload,
        traveller: case
            .traveller
            .as_ref()
            .map(|words| traveller(words, &case.environment, line_length)),
        clumps,
        remarks,
        flexure,
        bed,
        footprint: footprint(&segments),
        segments,
        laws,
        current: current(case.current.as_ref()),
        water,
        joints,
        arc,
        start: Vec::new(),
        start_tension: Vec::new(),
        start_grips: Vec::new(),
        start_velocity: V3::from(case.start.velocity_m_per_s),
        events: event::events(case),
        start_in_equilibrium: case.start.shape == StartShape::Equilibrium,
    };
    let guess = initial_shape::start(case, &scene)?;
    if scene.start_in_equilibrium {
        let laid = scene.initial_friction(&guess.nodes, &guess.tension);
        scene.start_grips = laid.grips;
        scene.remarks.extend(laid.remark);
    } else {
        scene.start_grips = scene.grips_at(&guess.nodes);
    }
    scene.start = guess.nodes;
    scene.start_tension = guess.tension;
    scene.force_scale = scene.force_scale.max(scene.greatest_drag());
    Ok(scene)
}

/// Adds the segments of a section.
fn add_section(
    case: &Case,
    index: usize,
    coarsening: usize,
    segments: &mut Vec<Segment>,
    arc: &mut Vec<f64>,
    laws: &mut Vec<TensionLaw>,
) -> Result<(), SceneError> {
    let section = &case.line[index];
    let material = case
        .materials
        .get(&section.material)
        .ok_or_else(|| SceneError::NoMaterial {
            section: section.name.clone(),
            material: section.material.clone(),
        })?;
    if section.segments == 0 || section.length_m.is_nan() || section.length_m <= 0.0 {
        let key = format!("line.{}", section.name);
        return Err(SceneError::Impossible {
            key,
            why: "its length and its number of segments must be positive",
        });
    }
    let elasticity = elasticity(&section.material, material, laws)?;
    for (from, length) in mesh::of_section(case, index, coarsening) {
        let mut segment = bare_segment(&case.environment, material, &elasticity, length);
        for modules in case.modules.iter().filter(|m| m.section == section.name) {
            let bare = material.diameter_m;
            let reach = (from, from + length);
            buoyancy::add_modules(
                &case.environment,
                modules,
                bare,
                section.length_m,
                reach,
                &mut segment,
            );
        }
        for floats in case.floats.iter().filter(|f| f.section == section.name) {
            buoyancy::add_floats(
                &case.environment,
                floats,
                section.length_m,
                (from, from + length),
                &mut segment,
            );
        }
        segments.push(segment);
        arc.push(arc[arc.len() - 1] + length);
    }
    Ok(())
}

/// A segment of a material, without floats.
fn bare_segment(
    water: &case::Environment,
    material: &case::Material,
    elasticity: &Elasticity,
    length: f64,
) -> Segment {
    let area = FRAC_PI_4 * material.diameter_m * material.diameter_m;
    let displaced = water.water_density_kg_per_m3 * area;
    let wet = material
        .wet_weight_kg_per_m
        .unwrap_or(material.mass_kg_per_m - displaced);
    let critical = length * (elasticity.ea * material.mass_kg_per_m).sqrt();
    let damping = match (material.axial_damping_n_s, material.axial_damping_ratio) {
        (Some(c), _) => c,
        (None, Some(ratio)) => ratio * critical,
        (None, None) => 0.0,
    };
    let half_pressure = 0.5 * water.water_density_kg_per_m3 * material.diameter_m;
    let width = match material.drag_tangential_width {
        DragWidth::Diameter => 1.0,
        DragWidth::Perimeter => PI,
    };
    Segment {
        axial: Axial::new(length, elasticity.steepest, damping)
            .bearing_compression(material.ei_n_m2 > 0.0)
            .with_law(elasticity.law),
        drag: DragProperties {
            reynolds: material.diameter_m / water.kinematic_viscosity_m2_per_s,
            normal: half_pressure,
            tangential: half_pressure * width,
            normal_law: law(&material.drag_normal),
            tangential_law: law(&material.drag_tangential),
            crisis: law(&material.drag_normal)
                .crisis()
                .map_or(f64::INFINITY, |re| {
                    re * water.kinematic_viscosity_m2_per_s / material.diameter_m
                }),
            floats: 0.0,
        },
        added: AddedMass {
            normal: 0.5 * length * displaced * material.added_mass_normal,
            tangential: 0.5 * length * displaced * material.added_mass_tangential,
        },
        half_mass: 0.5 * length * material.mass_kg_per_m,
        half_weight: 0.5 * length * wet * water.gravity_m_per_s2,
        ei: material.ei_n_m2,
        diameter: material.diameter_m,
    }
}

/// The rod of a payload that turns: no line, only stiffness. What it shares with the segment before it has no effect.
fn rod(before: &Segment, rigid_payload: &RigidPayload) -> Segment {
    let mut rod = *before;
    rod.axial = rigid_payload.body.rod();
    (rod.drag.normal, rod.drag.tangential, rod.drag.floats) = (0.0, 0.0, 0.0);
    rod.drag.normal_law = DragLaw::Constant(0.0);
    rod.drag.tangential_law = DragLaw::Constant(0.0);
    rod.drag.crisis = f64::INFINITY;
    (rod.added.normal, rod.added.tangential) = (0.0, 0.0);
    (rod.half_mass, rod.half_weight) = (0.0, 0.0);
    (rod.ei, rod.diameter) = (0.0, 0.0);
    rod
}

fn law(law: &case::DragLaw) -> DragLaw {
    match law {
        case::DragLaw::Constant(c) => DragLaw::Constant(*c),
        case::DragLaw::Named(case::DragLawName::Jia2019Normal) => DragLaw::Jia2019Normal,
        case::DragLaw::Named(case::DragLawName::Jia2019Tangential) => DragLaw::Jia2019Tangential,
    }
}

/// The body that travels along the line.
fn traveller(words: &case::Traveller, water: &case::Environment, length: f64) -> Traveller {
    Traveller {
        mass: words.mass_kg,
        weight: words.wet_mass_kg * water.gravity_m_per_s2,
        drag: bodies::axes(&words.drag_area_m2) * (0.5 * water.water_density_kg_per_m3),
        displaced: (words.mass_kg - words.wet_mass_kg).max(0.0),
        from: words.from_m.min(length),
        to: words.to_m.unwrap_or(length).min(length),
        speed: words.speed_m_per_s,
        start: words.start_s,
        ramp: words.ramp_s,
    }
}

/// Area that each node rests on the bed with: the diameter times the halves of its segments.
fn footprint(segments: &[Segment]) -> Vec<f64> {
    let mut area = vec![0.0; segments.len() + 1];
    for (i, segment) in segments.iter().enumerate() {
        let half = 0.5 * segment.axial.length * segment.diameter;
        area[i] += half;
        area[i + 1] += half;
    }
    area
}

/// Masses and weights of the nodes: halves of their segments, and the bodies hung there.
fn lump(
    segments: &[Segment],
    bodies: &[AttachedBody],
    rigid_payload: Option<&RigidPayload>,
) -> Result<(Vec<f64>, Vec<f64>), SceneError> {
    let nodes = segments.len() + 1;
    let (mut mass, mut weight) = (vec![0.0; nodes], vec![0.0; nodes]);
    for (i, segment) in segments.iter().enumerate() {
        for node in [i, i + 1] {
            mass[node] += segment.half_mass;
            weight[node] += segment.half_weight;
        }
    }
    for hung in bodies {
        mass[hung.node] += hung.body.mass;
        weight[hung.node] += hung.body.weight;
    }
    if let Some(RigidPayload { node, body }) = rigid_payload {
        for i in 0..2 {
            mass[node + i] += body.mass[i];
            weight[node + i] += body.weight[i];
        }
    }
    if mass.iter().all(|m| m.is_finite() && *m > 0.0) && weight.iter().all(|w| w.is_finite()) {
        Ok((mass, weight))
    } else {
        Err(SceneError::Impossible {
            key: "materials".into(),
            why: "every node must have a positive, finite mass",
        })
    }
}

/// Still water unless the case has a current.
fn current(current: Option<&case::Current>) -> Current {
    let Some(current) = current else {
        return Current::Uniform(V3::zeros());
    };
    let at = |value: &OneOrMany, i: usize| match value {
        OneOrMany::One(all) => *all,
        OneOrMany::Many(list) => list.get(i).or(list.last()).copied().unwrap_or(0.0),
    };
    let velocity = |i: usize| {
        let (sin, cos) = at(&current.direction_deg, i).to_radians().sin_cos();
        V3::new(cos, sin, 0.0) * at(&current.speed_m_per_s, i)
    };
    match &current.depth_m {
        Some(depth) if depth.len() > 1 => Current::Table {
            depth: depth.clone(),
            velocity: (0..depth.len()).map(velocity).collect(),
        },
        _ => Current::Uniform(velocity(0)),
    }
}
