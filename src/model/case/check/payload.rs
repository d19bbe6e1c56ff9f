//! The payload: its weight in water given once, drag and added mass known; one that turns is symmetric about its axis,
//! never cut off, and spins only with a moment of inertia.

use crate::case::diagnostic::Finding;
use crate::case::fields::{number, quantity};
use crate::case::model::{CaseKeys, OneOrMany, PayloadKeys, RotationKeys, ShapeKeys};
use crate::case::schema::Key;

/// Checks of the payload.
pub(super) fn check(case: &CaseKeys<'_>) -> Vec<Finding> {
    let Some(payload) = &case.payload else {
        return Vec::new();
    };
    let mut found = weight(payload);
    if payload.place.node.get("shape").is_none() {
        found.extend(left_open(payload));
    }
    if let Some(rotation) = &payload.rotation {
        found.extend(payload.release_s.if_given(
            "a payload that turns cannot be cut off",
            "remove [payload.rotation]: a body that hangs as a point can be cut off",
        ));
        found.extend(uneven(payload));
        found.extend(oblong(payload));
        found.extend(spins(rotation));
    }
    found
}

/// The weight in water is given once, and is less than that in air.
fn weight(payload: &PayloadKeys<'_>) -> Vec<Finding> {
    let (wet, dry) = (&payload.wet_mass_kg, &payload.dry_mass_kg);
    let twice = payload.volume_m3.if_given(
        "the weight in water is given twice, by wet_mass_kg and by volume_m3",
        "keep one of the two",
    );
    let heavier = || {
        let (in_water, in_air) = (wet.value()?, dry.value()?);
        (in_water > in_air).then(|| {
            let problem = format!(
                "a mass in water of {} kg is more than the {} kg in air",
                number(in_water),
                number(in_air)
            );
            wet.finding(
                problem,
                "give dry_mass_kg less the mass of the displaced water",
            )
        })
    };
    [twice.filter(|_| wet.is_given()), heavier()]
        .into_iter()
        .flatten()
        .collect()
}

/// What the keys of a payload without shape leave open.
fn left_open(payload: &PayloadKeys<'_>) -> Vec<Finding> {
    let open = |known: bool, name: &str, problem: &str, wanted: &str| {
        let remedy = format!("give {wanted}, or a [payload.shape] it follows from");
        (!known).then(|| Finding {
            key: payload.place.key(name),
            ..payload.dry_mass_kg.finding_at_table(problem, remedy)
        })
    };
    let found = [
        open(
            payload.wet_mass_kg.is_given() || payload.volume_m3.is_given(),
            "wet_mass_kg",
            "the weight in water is not known",
            "wet_mass_kg in kg, volume_m3 in m³",
        ),
        open(
            payload.drag_area_m2.is_given(),
            "drag_area_m2",
            "the drag is not known",
            "drag_area_m2 in m² (drag coefficient times area)",
        ),
        open(
            payload.added_mass_kg.is_given(),
            "added_mass_kg",
            "the added mass is not known",
            "added_mass_kg in kg",
        ),
    ];
    found.into_iter().flatten().collect()
}

/// A spin needs its moment of inertia, and no body has more about one axis than about two others together.
fn spins(rotation: &RotationKeys<'_>) -> Option<Finding> {
    let inertia = &rotation.spin_inertia_kg_m2;
    if !inertia.is_given() {
        rotation
            .spin_deg_per_s
            .given()
            .filter(|spin| **spin != 0.0)?;
        let remedy = "add `spin_inertia_kg_m2 = ...`, the moment of inertia about its own axis";
        return Some(Finding {
            key: inertia.path(),
            ..rotation.spin_deg_per_s.finding("is missing", remedy)
        });
    }
    let (own, across) = (inertia.value()?, rotation.inertia_kg_m2.value()?);
    (own > 2.0 * across).then(|| {
        let [own, across, most] = [own, across, 2.0 * across].map(|size| quantity(size, "kg m²"));
        let problem = format!("no body has {own} about its axis and only {across} across it");
        inertia.finding(problem, format!("give at most {most}"))
    })
}

/// A payload that turns is symmetric about its axis, which is z where it hangs upright.
fn uneven(payload: &PayloadKeys<'_>) -> Vec<Finding> {
    let differs = |key: &Key<'_, OneOrMany>| {
        match key.get() {
        Some(OneOrMany::Many(values)) if values.first() != values.get(1) => Some(key.finding(
            "differs along x and y, and a payload that turns is symmetric about its axis, which is z",
            "give the same number along x and y: that across the axis",
        )),
        _ => None,
    }
    };
    let keys = [&payload.drag_area_m2, &payload.added_mass_kg].into_iter();
    keys.filter_map(differs).collect()
}

/// A box that turns, with sides that its drag or added mass would follow from, and that are not the same.
fn oblong(payload: &PayloadKeys<'_>) -> Option<Finding> {
    let Some(ShapeKeys::Box(shape)) = &payload.shape else {
        return None;
    };
    let open = !payload.drag_area_m2.is_given() || !payload.added_mass_kg.is_given();
    let uneven = shape.length_m.value()? != shape.breadth_m.value()?;
    (open && uneven).then(|| {
        let problem = "is not symmetric about its axis, as a payload that turns must be";
        let remedy = "give drag_area_m2 and added_mass_kg, each with the same number along x and y, or a square box";
        Finding::new(&shape.place.node.span, &*shape.place.path, problem, remedy)
    })
}
