//! Bodies of a case: clumps along the line, and the payload at its end.

use std::f64::consts::FRAC_PI_4;

use super::labels::Joint;
use super::line::AttachedBody;
use super::vectors::per_axis;
use super::{RigidPayload, SceneError};
use crate::case::{self, Case, EndKind, OnSection, OneOrMany};
use crate::numerics::V3;
use crate::physics::added_mass::AddedMass;
use crate::physics::kirchhoff::KirchhoffAddedMass;
use crate::physics::payload::{FormCoefficients, box_form, sphere_and_cylinder};
use crate::physics::rigid_body::RigidBodyProperties;
use crate::physics::{BodyProperties, RigidBody};

/// The point bodies, clumps in the order of the case and then the payload, and remarks on their places.
pub(super) fn on_line(
    case: &Case,
    joints: &[Joint],
    arc: &[f64],
) -> Result<(Vec<AttachedBody>, Vec<String>), SceneError> {
    let mut bodies = Vec::new();
    let mut remarks = Vec::new();
    for clump in &case.clumps {
        let (node, off) = nearest_node(case, clump, joints, arc)?;
        let mut sections = case.line.iter();
        let section = sections.find(|section| clump.is_on(Some(&section.name)));
        if off.abs() > 1e-6 * arc[arc.len() - 1] {
            remarks.push(format!(
                "`{}` hangs at the nearest node, {:.3} m {} the place given; choose the segments of section `{}` so that a node lies there",
                clump.name,
                off.abs(),
                if off > 0.0 { "beyond" } else { "before" },
                section.map_or("", |section| section.name.as_str()),
            ));
        }
        bodies.push(AttachedBody {
            node,
            body: clump_body(case, clump),
        });
    }
    let turns = |body: &case::Payload| body.rotation.is_some();
    if !case.payload.as_ref().is_some_and(turns) {
        bodies.extend(payload(case)?.map(|body| AttachedBody {
            node: arc.len() - 1,
            body,
        }));
    }
    Ok((bodies, remarks))
}

/// The node of the section nearest to the place of a clump, and its distance beyond that place \[m\].
fn nearest_node(
    case: &Case,
    clump: &case::Clump,
    joints: &[Joint],
    arc: &[f64],
) -> Result<(usize, f64), SceneError> {
    let section = case.line.iter().position(|s| clump.is_on(Some(&s.name)));
    let section = section.ok_or_else(|| SceneError::Impossible {
        key: format!("clumps.{}.section", clump.name),
        why: "the case has no section of that name",
    })?;
    let (first, last) = (joints[section].node, joints[section + 1].node);
    let place = arc[first] + clump.at_m;
    let off = |node: usize| arc[node] - place;
    let nearest = (first..=last).min_by(|a, b| off(*a).abs().total_cmp(&off(*b).abs()));
    let node = nearest.unwrap_or(first);
    Ok((node, off(node)))
}

fn clump_body(case: &Case, clump: &case::Clump) -> BodyProperties {
    let water = &case.environment;
    BodyProperties {
        mass: clump.mass_kg,
        weight: clump.wet_mass_kg * water.gravity_m_per_s2,
        drag: per_axis(&clump.drag_area_m2) * (0.5 * water.water_density_kg_per_m3),
        added: per_axis(&clump.added_mass_kg),
        aligned: clump.has_aligned_added_mass().then_some(AddedMass {
            normal: clump.added_mass_normal_kg,
            tangential: clump.added_mass_tangential_kg,
        }),
    }
}

/// Density that the volume of a body follows from where nothing else gives it, to guess the area of its bottom \[kg/m³\].
const GUESSED_DENSITY: f64 = 2000.0;

/// Bottom of a cube of what a body displaces \[m²\].
fn cube_face(mass: f64, wet_mass: f64, water: &case::Environment) -> f64 {
    let rho = water.water_density_kg_per_m3;
    let displaced = (mass - wet_mass) / rho;
    let volume = if rho > 0.0 && displaced > 0.0 {
        displaced
    } else {
        mass / GUESSED_DENSITY
    };
    volume.powf(2.0 / 3.0)
}

/// Area on which a clump bears on the bed \[m²\].
#[must_use]
pub fn clump_bed_area(clump: &case::Clump, water: &case::Environment) -> f64 {
    let guess = || cube_face(clump.mass_kg, clump.wet_mass_kg, water);
    clump.bed_area_m2.unwrap_or_else(guess)
}

/// Area on which the payload bears on the bed \[m²\]: that of its shape, or the bottom of a cube of its volume.
#[must_use]
pub fn payload_bed_area(body: &case::Payload, water: &case::Environment) -> f64 {
    let by_shape = body.shape.as_ref().map(|shape| match shape {
        case::PayloadShape::Box(of) => of.length_m * of.breadth_m,
        case::PayloadShape::SphereAndCylinder(of) => {
            FRAC_PI_4 * of.sphere_diameter_m.max(of.cylinder_diameter_m).powi(2)
        }
    });
    let by_volume = body.volume_m3.map(|volume| volume.powf(2.0 / 3.0));
    let by_volume = by_volume.filter(|area| *area > 0.0);
    let guess = || {
        let wet = body.wet_mass_kg.unwrap_or(body.dry_mass_kg);
        cube_face(body.dry_mass_kg, wet, water)
    };
    let given = body.bed_area_m2.or(by_shape).or(by_volume);
    given.unwrap_or_else(guess)
}

/// The payload, with defaults from its shape.
fn payload(case: &Case) -> Result<Option<BodyProperties>, SceneError> {
    if case.ends.a.kind == EndKind::Payload {
        let key = "ends.a.kind".into();
        return Err(SceneError::Impossible {
            key,
            why: "the payload hangs at end B; list the sections the other way",
        });
    }
    if case.ends.b.kind != EndKind::Payload {
        return Ok(None);
    }
    let missing = |key: &str, why| SceneError::Missing {
        key: key.into(),
        why,
    };
    let body = case
        .payload
        .as_ref()
        .ok_or_else(|| missing("payload", "end B carries one"))?;
    let rho = case.environment.water_density_kg_per_m3;
    let form = body.shape.as_ref().map(shape_form);
    let volume = body.volume_m3.or(form.map(|f| f.volume));
    let wet = match (body.wet_mass_kg, volume) {
        (Some(wet), _) => wet,
        (None, Some(volume)) => body.dry_mass_kg - rho * volume,
        (None, None) => {
            return Err(missing(
                "payload.wet_mass_kg",
                "neither volume nor shape gives the buoyancy",
            ));
        }
    };
    let given = [&body.drag_area_m2, &body.added_mass_kg];
    let of = Hydrodynamics::new(body.shape.as_ref(), given, rho);
    Ok(Some(BodyProperties {
        mass: body.dry_mass_kg,
        weight: wet * case.environment.gravity_m_per_s2,
        drag: of.drag_area * (0.5 * rho),
        added: of.added_mass,
        aligned: None,
    }))
}

/// The payload, if it rotates about the last node of the line.
pub(super) fn rigid_payload(case: &Case, node: usize) -> Result<Option<RigidPayload>, SceneError> {
    let rotation = case
        .payload
        .as_ref()
        .and_then(|body| body.rotation.as_ref());
    let (Some(rotation), Some(body)) = (rotation, payload(case)?) else {
        return Ok(None);
    };
    let impossible = |why| SceneError::Impossible {
        key: "payload.rotation".into(),
        why,
    };
    if body.drag.x != body.drag.y || body.added.x != body.added.y {
        return Err(impossible(
            "a body that turns is symmetric about its axis, with the same drag area and added mass along x and y",
        ));
    }
    let weight = body.mass * case.environment.gravity_m_per_s2;
    let gravity_at = rotation.centre_of_gravity_m;
    let buoyancy_at = rotation.centre_of_buoyancy_m.unwrap_or(gravity_at);
    let measures = RigidBodyProperties {
        mass: body.mass,
        weight,
        buoyancy: weight - body.weight,
        gravity_at,
        buoyancy_at,
        drag_at: rotation.centre_of_drag_m.unwrap_or(buoyancy_at),
        drag_length: rotation.drag_length_m,
        inertia: rotation.inertia_kg_m2,
        added: KirchhoffAddedMass {
            normal: body.added.x,
            tangential: body.added.z,
            inertia: rotation.added_inertia_kg_m2,
        },
        drag: [body.drag.x, body.drag.z],
        spin: rotation.spin_inertia_kg_m2.unwrap_or(0.0) * rotation.spin_deg_per_s.to_radians(),
    };
    let body = RigidBody::new(&measures)
        .ok_or_else(|| impossible("its centre of gravity must lie below the hang point"))?;
    Ok(Some(RigidPayload { node, body }))
}

/// Drag area and added mass of a body along x, y, z.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hydrodynamics {
    /// Drag coefficient times area \[m²\].
    pub drag_area: V3,
    /// Added mass \[kg\].
    pub added_mass: V3,
}

impl Hydrodynamics {
    /// As drag area \[m²\] and added mass \[kg\] are given, in this order, or follow from a shape in water of a density \[kg/m³\]; else none.
    #[must_use]
    pub fn new(
        shape: Option<&case::PayloadShape>,
        [drag_area, added_mass]: [&Option<OneOrMany>; 2],
        density: f64,
    ) -> Self {
        let form = shape.map(shape_form);
        let area = drag_area.as_ref().map(per_axis);
        let added = added_mass.as_ref().map(per_axis);
        let area = area.or(form.map(|f| f.drag_area));
        let added = added.or(form.map(|f| f.added_volume * density));
        Self {
            drag_area: area.unwrap_or_default(),
            added_mass: added.unwrap_or_default(),
        }
    }
}

/// What the shape of a body gives.
#[must_use]
pub fn shape_form(shape: &case::PayloadShape) -> FormCoefficients {
    match *shape {
        case::PayloadShape::Box(case::BoxShape {
            length_m,
            breadth_m,
            height_m,
        }) => box_form(length_m, breadth_m, height_m),
        case::PayloadShape::SphereAndCylinder(case::SphereAndCylinder {
            sphere_diameter_m,
            cylinder_diameter_m,
            cylinder_length_m,
        }) => sphere_and_cylinder(sphere_diameter_m, cylinder_diameter_m, cylinder_length_m),
    }
}
