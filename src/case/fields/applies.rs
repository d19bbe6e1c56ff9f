//! Whether an optional key matters where the keys beside it are as they are: the motion of an end that does not move has no
//! period. Such a key may be given all the same; editor and report leave it out unless it is.

use super::{Absent, Field, Schema};
use crate::case::tree::Node;

/// Ends that are held, and so may move, be clamped, or be let go.
const HELD: &[&str] = &["fixed", "anchor", "moving"];

/// What a key needs: each of these keys of its table, as one of these words.
type Needs = &'static [(&'static str, &'static [&'static str])];

const MOVING: Needs = &[("kind", &["moving"])];
const HARMONIC: Needs = &[("kind", &["moving"]), ("motion", &["harmonic"])];
const IRREGULAR: Needs = &[("kind", &["moving"]), ("motion", &["irregular"])];
const FROM_FILE: Needs = &[("kind", &["moving"]), ("motion", &["table", "vessel"])];
const VESSEL: Needs = &[("kind", &["moving"]), ("motion", &["vessel"])];
const STRAIGHT: Needs = &[("shape", &["straight"])];

fn needs(field: &Field) -> Needs {
    match (field.table(), field.key()) {
        ("ends.*", key) => match key {
            "motion" | "ramp_s" => MOVING,
            "amplitude_m" | "period_s" | "phase_deg" => HARMONIC,
            "rms_m" | "peak_period_s" | "gamma" | "components" | "seed" => IRREGULAR,
            "motion_file" => FROM_FILE,
            "heading_deg" | "hang_point_m" => VESSEL,
            "release_s" | "clamp_elevation_deg" | "clamp_azimuth_deg" => &[("kind", HELD)],
            _ => &[],
        },
        ("start", "azimuth_deg" | "elevation_deg") => STRAIGHT,
        _ => &[],
    }
}

/// Whether the field matters in this table of a file, which may leave the table out.
pub(super) fn applies(schema: &Schema, field: &Field, table: Option<&Node>) -> bool {
    needs(field).iter().all(|(key, words)| {
        let given = table.and_then(|node| node.get(key)).and_then(Node::text);
        let default = schema.fields_of(field.table()).find(|f| f.key() == *key);
        let default = default.and_then(|f| match f.absent {
            Absent::Default(value) => Some(value.trim_matches('"')),
            _ => None,
        });
        given.or(default).is_none_or(|word| words.contains(&word))
    })
}
