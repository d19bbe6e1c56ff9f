//! From a case to a scene in SI units.

use std::collections::BTreeMap;
use std::f64::consts::PI;

use super::elasticity::{Elasticity, elasticity};
use super::elements::{Elements, RigidPayload, clamps_without_effect};
use super::error::SceneError;
use super::labels::{Joint, Labels};
use super::line::{AttachedBody, LumpedLine, Segment};
use super::scene::{InitialState, Scene};
use super::{LaidFrom, bodies, buoyancy, ends, event, initial_shape, mesh, unused_inputs, waves};
use crate::case::{
    self, Attachment, Case, DragLength, DragWidth, OnSection, OneOrMany, StartShape,
};
use crate::numerics::V3;
use crate::physics::added_mass::AddedMass;
use crate::physics::drag::DragProperties;
use crate::physics::rope::TensionLaw;
use crate::physics::tension::AxialConstants;
use crate::physics::{CurrentProfile, DragLaw, PipeWall};

/// Builds the scene of a case, every section divided into `1 / coarsening` of its segments (rounded up): 1 for the run itself,
/// 2 for the companion that estimates the mesh error.
///
/// # Errors
/// [`SceneError`] when the case contradicts itself.
pub fn build(case: &Case, coarsening: usize) -> Result<Scene, SceneError> {
    let mut mesh = Mesh::of_case(case, coarsening)?;
    let (mut bodies, mut remarks) = bodies::on_line(case, &mesh.joints, &mesh.arc)?;
    let clumps: Vec<usize> = bodies[..case.clumps.len()].iter().map(|b| b.node).collect();
    bodies.sort_by_key(|hung| hung.node);
    let line_nodes = mesh.arc.len();
    let rigid_payload = bodies::rigid_payload(case, line_nodes - 1)?;
    if let Some(payload) = &rigid_payload {
        mesh.add_rod(payload);
    }
    let joints = std::mem::take(&mut mesh.joints);
    let line = line(
        case,
        mesh,
        line_nodes,
        bodies,
        rigid_payload.as_ref(),
        &mut remarks,
    )?;
    let elements = Elements::of_case(case, coarsening, &line, &clumps, rigid_payload);
    remarks.extend(clamps_without_effect(case, &line.segments));
    remarks.extend(unused_inputs::remarks(case));
    let mut scene = Scene {
        line,
        walls: case
            .line
            .iter()
            .map(|section| wall(case, section))
            .collect(),
        elements,
        start: InitialState {
            velocity: V3::from(case.start.velocity_m_per_s),
            in_equilibrium: case.start.shape == StartShape::Equilibrium,
            ..InitialState::default()
        },
        labels: Labels {
            end_names: [case.ends.a.name.clone(), case.ends.b.name.clone()],
            joints,
            clumps,
            remarks,
        },
        events: event::events(case),
    };
    add_start(case, &mut scene)?;
    scene.line.force_scale = scene.line.force_scale.max(scene.line.greatest_drag());
    Ok(scene)
}

/// Sets the positions, tensions and friction springs at time zero.
fn add_start(case: &Case, scene: &mut Scene) -> Result<(), SceneError> {
    scene.start.laid_from = LaidFrom::of_line(&scene.line);
    let guess = initial_shape::start(case, scene)?;
    scene.start.grips = if scene.start.in_equilibrium {
        let friction = scene.initial_friction(&guess.nodes, &guess.tension);
        scene.labels.remarks.extend(friction.remark);
        friction.grips
    } else {
        scene.grips_at(&guess.nodes)
    };
    scene.start.positions = guess.nodes;
    scene.start.tension = guess.tension;
    Ok(())
}

/// The lumped line of the case on its mesh.
fn line(
    case: &Case,
    mesh: Mesh,
    line_nodes: usize,
    bodies: Vec<AttachedBody>,
    rigid_payload: Option<&RigidPayload>,
    remarks: &mut Vec<String>,
) -> Result<LumpedLine, SceneError> {
    let (mass, weight) = lump(&mesh.segments, &bodies, rigid_payload)?;
    let (water, on_water) = waves::water(case, &mesh.segments, &bodies)?;
    remarks.extend(on_water);
    let waves = water.as_ref().and_then(|water| water.waves.as_ref());
    let ends = [
        ends::end(case, &case.ends.a, "ends.a", waves, remarks)?,
        ends::end(case, &case.ends.b, "ends.b", waves, remarks)?,
    ];
    let gross: f64 = weight.iter().map(|w| w.abs()).sum();
    Ok(LumpedLine {
        force_scale: gross
            .max(mass.iter().sum::<f64>() * 1e-3)
            .max(f64::MIN_POSITIVE),
        segments: mesh.segments,
        line_nodes,
        laws: mesh.laws,
        mass,
        weight,
        arc: mesh.arc,
        ends,
        bodies,
        current: current(case.current.as_ref(), &case.files),
        water,
        stretched_drag: case.environment.drag_length == DragLength::Stretched,
    })
}

/// The segments of the line, the arc lengths of their nodes, their laws and the places between sections.
struct Mesh {
    segments: Vec<Segment>,
    arc: Vec<f64>,
    laws: Vec<TensionLaw>,
    joints: Vec<Joint>,
}

impl Mesh {
    fn of_case(case: &Case, coarsening: usize) -> Result<Self, SceneError> {
        let mut mesh = Self {
            segments: Vec::new(),
            arc: vec![0.0],
            laws: Vec::new(),
            joints: Vec::new(),
        };
        let mut before = case.ends.a.name.as_str();
        for (index, section) in case.line.iter().enumerate() {
            mesh.add_joint(before, &section.name);
            mesh.add_section(case, index, coarsening)?;
            before = &section.name;
        }
        if mesh.segments.is_empty() {
            return Err(SceneError::Impossible {
                key: "line".into(),
                why: "it has no segments",
            });
        }
        mesh.add_joint(before, &case.ends.b.name);
        Ok(mesh)
    }

    /// Adds the place between two sections, or a section and an end.
    fn add_joint(&mut self, before: &str, after: &str) {
        self.joints.push(Joint {
            name: format!("{before}|{after}"),
            node: self.segments.len(),
        });
    }

    /// Adds the rod of a rigid payload: a segment with axial stiffness only.
    fn add_rod(&mut self, payload: &RigidPayload) {
        self.arc
            .push(self.arc[self.arc.len() - 1] + payload.body.reach);
        let mut rod = self.segments[self.segments.len() - 1];
        rod.axial = payload.body.rod();
        (rod.drag.normal, rod.drag.tangential) = (0.0, 0.0);
        (rod.drag.floats, rod.drag.floats_tangential) = (0.0, 0.0);
        rod.drag.normal_law = DragLaw::Constant(0.0);
        rod.drag.tangential_law = DragLaw::Constant(0.0);
        rod.drag.crisis = f64::INFINITY;
        (rod.added.normal, rod.added.tangential) = (0.0, 0.0);
        (rod.half_mass, rod.half_weight) = (0.0, 0.0);
        (rod.ei, rod.diameter, rod.bearing_width) = (0.0, 0.0, 0.0);
        self.segments.push(rod);
    }

    /// Adds the segments of a section.
    fn add_section(
        &mut self,
        case: &Case,
        index: usize,
        coarsening: usize,
    ) -> Result<(), SceneError> {
        let section = &case.line[index];
        let material =
            case.materials
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
        let elasticity = elasticity(&section.material, material, &mut self.laws)?;
        let name = Some(section.name.as_str());
        for (from, length) in mesh::of_section(case, index, coarsening) {
            let segment = buoyancy::segment(
                &case.environment,
                (material, &elasticity),
                (
                    section.length_m,
                    case.floats.iter().filter(|of| of.is_on(name)),
                    case.modules.iter().filter(|of| of.is_on(name)),
                ),
                (from, length),
            );
            self.segments.push(segment);
            self.arc.push(self.arc[self.arc.len() - 1] + length);
        }
        Ok(())
    }
}

/// A segment of a material, without floats.
pub(super) fn bare_segment(
    water: &case::Environment,
    material: &case::Material,
    elasticity: &Elasticity,
    length: f64,
) -> Segment {
    let area = material.area_m2();
    let displaced = water.water_density_kg_per_m3 * area;
    let wet = material.wet_kg_per_m(water.water_density_kg_per_m3);
    let critical = length * (elasticity.ea * material.mass_kg_per_m).sqrt();
    let damping = match (material.axial_damping_n_s, material.axial_damping_ratio) {
        (Some(c), _) => c,
        (None, Some(ratio)) => ratio * critical,
        (None, None) => 0.0,
    };
    // Of a rope that creeps it bounds the explicit step only.
    let damping = elasticity.creep_damping.unwrap_or(damping);
    let half_pressure = 0.5 * water.water_density_kg_per_m3 * material.diameter_m;
    let width = match material.drag_tangential_width {
        DragWidth::Diameter => 1.0,
        DragWidth::Perimeter => PI,
    };
    Segment {
        axial: AxialConstants::new(length, elasticity.steepest, damping)
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
            floats: 0.5 * water.water_density_kg_per_m3 * material.attached_drag_width_m,
            floats_tangential: 0.0,
        },
        added: AddedMass {
            normal: 0.5 * length * displaced * material.added_mass_normal,
            tangential: 0.5 * length * displaced * material.added_mass_tangential,
        },
        half_mass: 0.5 * length * material.mass_kg_per_m,
        half_weight: 0.5 * length * wet * water.gravity_m_per_s2,
        ei: material.ei_n_m2,
        diameter: material.diameter_m,
        bearing_width: material.diameter_m,
    }
}

/// The pipe wall of a section; none without a bore.
fn wall(case: &Case, section: &case::Section) -> Option<PipeWall> {
    let (material, water) = (case.materials.get(&section.material)?, &case.environment);
    let bore = material.bore.as_ref()?;
    Some(PipeWall {
        outer_diameter: material.diameter_m,
        inner_diameter: bore.diameter_m,
        water_weight: water.water_density_kg_per_m3 * water.gravity_m_per_s2,
        content_weight: bore.content_density_kg_per_m3 * water.gravity_m_per_s2,
        inner_pressure: bore.pressure_pa,
        pressure_height: bore.pressure_height_m,
    })
}

fn law(law: &case::DragCoefficient) -> DragLaw {
    match law {
        case::DragCoefficient::Constant(c) => DragLaw::Constant(*c),
        case::DragCoefficient::Named(case::DragLawName::Jia2019Normal) => DragLaw::Jia2019Normal,
        case::DragCoefficient::Named(case::DragLawName::Jia2019Tangential) => {
            DragLaw::Jia2019Tangential
        }
    }
}

/// Masses and weights of the nodes: halves of their segments, and the bodies on them.
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
pub fn current(
    current: Option<&case::Current>,
    files: &BTreeMap<String, Attachment>,
) -> CurrentProfile {
    let Some(current) = current else {
        return CurrentProfile::Uniform(V3::zeros());
    };
    // Its file was read with the case.
    if let Ok(Some(grid)) = case::current_grid(current, files) {
        return CurrentProfile::of_grid(&grid, 0.0);
    }
    let at = |value: &OneOrMany, i: usize| match value {
        OneOrMany::One(all) => *all,
        OneOrMany::Many(list) => list.get(i).or(list.last()).copied().unwrap_or(0.0),
    };
    let velocity = |i: usize| {
        let (sin, cos) = at(&current.direction_deg, i).to_radians().sin_cos();
        V3::new(cos, sin, 0.0)
            * current
                .speed_m_per_s
                .as_ref()
                .map_or(0.0, |speed| at(speed, i))
    };
    match &current.depth_m {
        Some(depth) if depth.len() > 1 => CurrentProfile::Table {
            depth: depth.clone(),
            velocity: (0..depth.len()).map(velocity).collect(),
        },
        _ => CurrentProfile::Uniform(velocity(0)),
    }
}
