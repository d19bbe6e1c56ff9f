//! From the words of a case to a line in SI.

use std::f64::consts::{FRAC_PI_4, PI};

use super::line::{End, Hung, Joint, Scene, Segment};
use super::{Flexure, bodies, buoyancy, shape};
use crate::case::{self, Case, DragWidth, EndKind, OneOrMany, StartShape};
use crate::linalg::V3;
use crate::physics::added_mass::AddedMass;
use crate::physics::drag::Profile;
use crate::physics::tension::Axial;
use crate::physics::{Current, DragLaw, EndMotion, Seabed, bending, motion};

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
    let mut name_before = case.ends.a.name.as_str();
    for (index, section) in case.line.iter().enumerate() {
        joints.push(Joint {
            name: format!("{name_before}|{}", section.name),
            node: segments.len(),
        });
        add_section(case, index, coarsening, &mut segments, &mut arc)?;
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
    let (mut bodies, remarks) = bodies::on_line(case, &joints, &arc)?;
    let clumps = bodies[..case.clumps.len()].iter().map(|b| b.node).collect();
    bodies.sort_by_key(|hung| hung.node);
    let (mass, weight) = lump(&segments, &bodies)?;
    let ends = [end(&case.ends.a, "ends.a")?, end(&case.ends.b, "ends.b")?];
    let flexure = flexure(case, &segments);
    let bed = case.seabed.as_ref().map(|bed| Seabed {
        z: -bed.depth_m,
        stiffness: bed.stiffness_n_per_m3,
        damping: bed.damping_n_s_per_m3,
    });
    let gross: f64 = weight.iter().map(|w| w.abs()).sum();
    let mut scene = Scene {
        force_scale: gross
            .max(mass.iter().sum::<f64>() * 1e-3)
            .max(f64::MIN_POSITIVE),
        mass,
        weight,
        end_names: [case.ends.a.name.clone(), case.ends.b.name.clone()],
        ends,
        bodies,
        clumps,
        remarks,
        flexure,
        bed,
        footprint: footprint(&segments),
        segments,
        current: current(case.current.as_ref()),
        joints,
        arc,
        start: Vec::new(),
        start_tension: Vec::new(),
        start_in_equilibrium: case.start.shape == StartShape::Equilibrium,
    };
    let guess = shape::start(case, &scene)?;
    scene.start = guess.nodes;
    scene.start_tension = guess.tension;
    Ok(scene)
}

/// Adds the segments of a section.
fn add_section(
    case: &Case,
    index: usize,
    coarsening: usize,
    segments: &mut Vec<Segment>,
    arc: &mut Vec<f64>,
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
    let count = section.segments.div_ceil(coarsening.max(1));
    let length = section.length_m / count as f64;
    for k in 0..count {
        let from = length * k as f64;
        let mut segment = bare_segment(&case.environment, material, length);
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
fn bare_segment(water: &case::Environment, material: &case::Material, length: f64) -> Segment {
    let area = FRAC_PI_4 * material.diameter_m * material.diameter_m;
    let displaced = water.water_density_kg_per_m3 * area;
    let wet = material
        .wet_weight_kg_per_m
        .unwrap_or(material.mass_kg_per_m - displaced);
    let critical = length * (material.ea_n * material.mass_kg_per_m).sqrt();
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
        axial: Axial::new(length, material.ea_n, damping).as_rod(material.ei_n_m2 > 0.0),
        drag: Profile {
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

fn law(law: &case::DragLaw) -> DragLaw {
    match law {
        case::DragLaw::Constant(c) => DragLaw::Constant(*c),
        case::DragLaw::Named(case::DragLawName::Jia2019Normal) => DragLaw::Jia2019Normal,
        case::DragLaw::Named(case::DragLawName::Jia2019Tangential) => DragLaw::Jia2019Tangential,
    }
}

/// What bends and what clamps; nothing where no material has a bending stiffness.
fn flexure(case: &Case, segments: &[Segment]) -> Option<Flexure> {
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
        let elevation = end.clamp_elevation_deg?.to_radians();
        let azimuth = end.clamp_azimuth_deg.to_radians();
        let (ei, length) = part(i);
        Some((
            shape::direction(azimuth, elevation),
            bending::clamp_stiffness(ei, length),
        ))
    };
    Some(Flexure {
        joints: (0..=last).map(joint).collect(),
        spans: (0..=last).map(span).collect(),
        clamps: [clamp(&case.ends.a, 0), clamp(&case.ends.b, last - 1)],
    })
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
fn lump(segments: &[Segment], bodies: &[Hung]) -> Result<(Vec<f64>, Vec<f64>), SceneError> {
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
    if mass.iter().all(|m| m.is_finite() && *m > 0.0) && weight.iter().all(|w| w.is_finite()) {
        Ok((mass, weight))
    } else {
        Err(SceneError::Impossible {
            key: "materials".into(),
            why: "every node must have a positive, finite mass",
        })
    }
}

fn end(end: &case::End, key: &str) -> Result<End, SceneError> {
    let position = || {
        end.position_m
            .map(V3::from)
            .ok_or_else(|| SceneError::Missing {
                key: format!("{key}.position_m"),
                why: "a held end must be somewhere",
            })
    };
    match end.kind {
        EndKind::Payload | EndKind::Free => Ok(End::Free),
        EndKind::Fixed | EndKind::Anchor => Ok(End::Held(EndMotion::still(position()?))),
        EndKind::Moving => {
            let period = end
                .period_s
                .filter(|p| *p > 0.0)
                .ok_or_else(|| SceneError::Missing {
                    key: format!("{key}.period_s"),
                    why: "a moving end needs the period of its motion",
                })?;
            Ok(End::Held(EndMotion {
                position: position()?,
                amplitude: V3::from(end.amplitude_m),
                omega: motion::omega(period),
                phase: V3::from(end.phase_deg).map(f64::to_radians),
                ramp: end.ramp_s,
            }))
        }
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
