//! The ropeway as a kind of file: its checks, its result, its keys in reading order.

use std::sync::LazyLock;

use super::error::RopewayError;
use super::model::{Ropeway, RopewayKeys, SetBy};
use super::quantities::QUANTITIES;
use super::solve::{SolvedRopeway, solve};
use crate::case::fields::{Schema, either};
use crate::case::file_kind::{FileContent, FileKind};
use crate::case::schema::{Key, schema_of};
use crate::case::{FieldLister, FieldRow, Finding, nearest};
use crate::published::number as published_number;

/// The ropeway file.
pub static ROPEWAY: LazyLock<Schema> = LazyLock::new(|| {
    let least = "a ropeway has at least [ropeway] with a title and a span, [[rope]], [platform], [ship], [cargo] and [setting]";
    schema_of::<Ropeway>("ropeway", least).with_parameters()
});

impl FileContent for Ropeway {
    type Computed = SolvedRopeway;
}

impl FileKind for Ropeway {
    fn schema() -> &'static Schema {
        &ROPEWAY
    }

    fn check(keys: &RopewayKeys<'_>) -> Vec<Finding> {
        let mut found = Vec::from_iter(steep(keys));
        found.extend(missing_setting(keys));
        found.extend(published_number::check(
            &keys.published,
            unknown_quantity,
            &[],
            &[],
        ));
        let trends = keys.trend.iter();
        found.extend(trends.filter_map(|(_, trend)| unknown_quantity(&trend.quantity)));
        found
    }

    fn compute(self, keys: &RopewayKeys<'_>) -> Result<SolvedRopeway, Finding> {
        solve(&self).map_err(|error| unsolved(&error, keys))
    }

    fn list(lister: &FieldLister<'_>) -> Vec<FieldRow> {
        let tables = |names: &[&str]| -> Vec<FieldRow> {
            names.iter().flat_map(|name| lister.always(name)).collect()
        };
        [
            tables(&["ropeway", "setting", "cargo", "platform", "ship", "water"]),
            lister.named("rope", "rope"),
            tables(&["winch", "motion", "dynamics"]),
            lister.if_given(&["finite_element"], "finite-element check"),
        ]
        .concat()
    }
}

/// A rope steeper than a ropeway can be.
fn steep(ropeway: &RopewayKeys<'_>) -> Option<Finding> {
    let ship = &ropeway.ship.as_ref()?.height_m;
    let rise = ship.value()? - ropeway.platform.as_ref()?.height_m.value()?;
    let span = ropeway.about.as_ref()?.span_m.value()?;
    (rise.abs() > 2.0 * span).then(|| {
        ship.finding(
            "the rope would be steeper than a ropeway can be",
            "give the ends less difference of height, or a longer span",
        )
    })
}

/// The key that determines the length of the rope.
fn setting_key<'k, 'a>(ropeway: &'k RopewayKeys<'a>) -> Option<(SetBy, &'k Key<'a, f64>)> {
    let setting = ropeway.setting.as_ref()?;
    let by = setting.by.value()?;
    let key = match by {
        SetBy::BareSag | SetBy::LoadedSag => &setting.sag_m,
        SetBy::BareHorizontal => &setting.horizontal_n,
        SetBy::Length => &setting.length_m,
        SetBy::Tension => &setting.tension_n,
    };
    Some((by, key))
}

fn missing_setting(ropeway: &RopewayKeys<'_>) -> Option<Finding> {
    let (by, key) = setting_key(ropeway).filter(|(_, key)| !key.is_given())?;
    let remedy = format!("add `{} = ...` to [setting], or change `by`", key.name());
    Some(key.finding(format!("is missing: the rope is set by its {by}"), remedy))
}

/// A setting without a solution, at its key.
fn unsolved(error: &RopewayError, ropeway: &RopewayKeys<'_>) -> Finding {
    let remedy = match error {
        RopewayError::TooLittleTension { .. } => "give more tension, or a shorter span",
        RopewayError::TooDeep => "give less sag or less rope",
        RopewayError::TooLittleRope { .. } => "give less sag or more tension, or a longer rope",
        _ => "give more rope, or a shorter span",
    };
    let problem = error.to_string();
    match setting_key(ropeway) {
        Some((_, key)) => key.finding(problem, remedy),
        None => ropeway.place.finding(problem, remedy),
    }
}

/// A quantity that does not exist.
fn unknown_quantity(key: &Key<'_, String>) -> Option<Finding> {
    let quantity = key.get()?;
    let names: Vec<&str> = QUANTITIES.iter().map(|known| known.name).collect();
    if names.contains(&quantity.as_str()) {
        return None;
    }
    let remedy = match nearest(quantity, names.iter().copied()) {
        Some(near) => format!("did you mean \"{near}\"?"),
        None => format!("give {}", either(&names)),
    };
    let problem = format!("there is no quantity \"{}\"", quantity.escape_default());
    Some(key.finding(problem, remedy))
}
