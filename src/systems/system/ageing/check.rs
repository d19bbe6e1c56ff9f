//! Checks of marine growth and corrosion: lists that go together, names, bars that remain.

use crate::case::schema::Key;
use crate::case::{CreepModel, Finding, increasing, unknown};
use crate::system::model::{AgeingKeys, CorrosionKeys, SystemKeys};

/// Checks of the ageing of a system.
pub(in crate::system) fn ageing(keys: &SystemKeys<'_>) -> Vec<Finding> {
    let Some(ageing) = &keys.ageing else {
        return Vec::new();
    };
    let mut found = Vec::new();
    if ageing.growth.is_empty() && ageing.corrosion.is_empty() {
        found.push(ageing.years.finding(
            "has no effect: nothing grows and nothing corrodes",
            "add [[ageing.growth]] or [[ageing.corrosion]], or leave [ageing] out",
        ));
    }
    for (_, growth) in &ageing.growth {
        found.extend(by_depth(&growth.depth_m, &growth.thickness_m));
        if !growth.material.is_given() {
            found.extend(growth.nominal_diameter_m.if_given(
                "is given for growth on all materials",
                "name the material that has this diameter: `material = \"...\"`",
            ));
        }
    }
    for (_, corrosion) in &ageing.corrosion {
        found.extend(by_depth(&corrosion.depth_m, &corrosion.rate_m_per_year));
        found.extend(worn_away(ageing, corrosion));
        found.extend(fibre(keys, corrosion));
    }
    found.extend(materials(keys, ageing));
    found
}

/// Names of materials that the file has, each once; growth without a name counts as one.
fn materials(keys: &SystemKeys<'_>, ageing: &AgeingKeys<'_>) -> Vec<Finding> {
    let known: Vec<&str> = keys
        .materials
        .iter()
        .map(|(name, _)| name.as_str())
        .collect();
    let growth = ageing.growth.iter().map(|(_, growth)| &growth.material);
    let corrosion = ageing.corrosion.iter().map(|(_, table)| &table.material);
    let (growth, corrosion): (Vec<_>, Vec<_>) = (growth.collect(), corrosion.collect());
    let named = growth.iter().chain(&corrosion);
    let mut found: Vec<Finding> = named
        .filter_map(|key| unknown(key, &known, "material", "system"))
        .collect();
    for (tables, what) in [(&growth, "growth"), (&corrosion, "corrosion")] {
        for (index, key) in tables.iter().enumerate() {
            let before = tables[..index].iter();
            if key.is_faulty() || !before.clone().any(|other| same(other, key)) {
                continue;
            }
            let of = key
                .get()
                .map_or_else(|| "all materials".to_owned(), |name| format!("\"{name}\""));
            let problem = format!("the {what} of {of} is given twice");
            found.push(key.finding(
                problem,
                format!("give one table of {what} for each material"),
            ));
        }
    }
    found
}

/// Whether two tables are of the same material, or both of all.
fn same(one: &Key<'_, String>, other: &Key<'_, String>) -> bool {
    !one.is_faulty() && one.get() == other.get()
}

/// As many values as depths, the depths increasing; without depths one value.
fn by_depth(depths: &Key<'_, Vec<f64>>, values: &Key<'_, Vec<f64>>) -> Vec<Finding> {
    let Some(count) = values.given().map(Vec::len) else {
        return Vec::new();
    };
    if !depths.is_given() {
        let one = count == 1;
        let problem = format!("has {count} values, and the depths that they belong to are missing");
        let remedy = "give one value, or add `depth_m = [...]` with a depth for each, increasing";
        return (!one)
            .then(|| values.finding(problem, remedy))
            .into_iter()
            .collect();
    }
    let Some(given) = depths.get().map(Vec::len) else {
        return Vec::new();
    };
    if count != given || count == 0 {
        let problem = format!("has {count} values for {given} depths");
        return vec![values.finding(problem, "give one value for each depth of depth_m")];
    }
    let remedy = "list the depths from the surface down, each once";
    increasing(depths, "depths", remedy).into_iter().collect()
}

/// Corrosion of what is no steel: a rope that creeps, or one whose stiffness is a table.
fn fibre(keys: &SystemKeys<'_>, corrosion: &CorrosionKeys<'_>) -> Option<Finding> {
    let name = corrosion.material.get()?;
    let (_, material) = keys.materials.iter().find(|(known, _)| known == name)?;
    let steel = material.creep_model.is(&CreepModel::None) && !material.strain.is_given();
    let remedy = "leave it out; steel has one stiffness, `ea_n`";
    (!steel).then(|| {
        let problem = "is not covered for a fibre rope";
        corrosion.material.finding(problem, remedy)
    })
}

/// Bars that nothing is left of.
fn worn_away(ageing: &AgeingKeys<'_>, corrosion: &CorrosionKeys<'_>) -> Option<Finding> {
    let bar = corrosion.bar_diameter_m.value()?;
    let years = ageing.years.value()?;
    let rates = corrosion.rate_m_per_year.given()?;
    let (index, rate) = rates
        .iter()
        .enumerate()
        .find(|(_, rate)| *rate * years >= bar)?;
    let problem = format!(
        "loses {:.6} m in {years} years: nothing is left of a bar of {bar} m",
        rate * years
    );
    let remedy = "give a lower rate or fewer years; the rate is in m a year, 0.0003 for 0.3 mm";
    Some(
        corrosion
            .rate_m_per_year
            .finding_at_item(index, problem, remedy),
    )
}
