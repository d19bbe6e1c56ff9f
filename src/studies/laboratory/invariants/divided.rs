//! A line of a system divided by a free point without mass.

use toml::{Table, Value};

use super::tree::{length, list, listed, number, put, word};
use super::variant::SystemVariant;
use crate::numerics::random::Random;

/// The name of the point; that of the second part is the line's with this after it.
const BETWEEN: &str = "between";
/// Segments that either part keeps: fewer would be divided more finely.
const FEWEST: i64 = 8;

/// Keys of an end that is at the point in between after the division.
const OF_END_A: [&str; 4] = [
    "clamp_a_elevation_deg",
    "clamp_a_azimuth_deg",
    "release_a_s",
    "release_a_n",
];
/// See [`OF_END_A`].
const OF_END_B: [&str; 4] = [
    "clamp_b_elevation_deg",
    "clamp_b_azimuth_deg",
    "release_b_s",
    "release_b_n",
];

/// None where no line can be divided: those that bend pass their moment on, and what is paid out or breaks is one line.
pub(super) fn divided(system: &Table, random: &mut Random) -> Option<SystemVariant> {
    let mut variant = SystemVariant::of_file(system.clone());
    let file = &mut variant.file;
    let bending: Vec<String> = super::tree::named(file, "materials")
        .filter(|(_, material)| number(material, "ei_n_m2").is_some_and(|ei| ei > 0.0))
        .map(|(name, _)| name.clone())
        .collect();
    let paid: Vec<String> = listed(file, "payouts")
        .filter_map(|payout| word(payout, "line").map(str::to_owned))
        .collect();
    let lines = list(file, "lines")?;
    let may = |value: &Value| {
        let line = value.as_table();
        line.is_some_and(|line| is_divisible(line, &bending, &paid))
    };
    let able: Vec<usize> = (0..lines.len()).filter(|k| may(&lines[*k])).collect();
    let chosen = *able.get((random.uniform() * able.len() as f64) as usize)?;
    let line = lines[chosen].as_table_mut()?;
    let name = word(line, "name")?.to_owned();
    let second_name = format!("{name}-2");
    let whole = length(line);
    let segments = number(line, "segments")? as i64;
    let more = (segments - 2 * FEWEST + 1) as f64;
    let first = FEWEST + (random.uniform() * more) as i64;
    let mut second = line.clone();
    put(line, "to", BETWEEN);
    put(&mut second, "from", BETWEEN);
    put(&mut second, "name", second_name.as_str());
    for (part, count) in [(&mut *line, first), (&mut second, segments - first)] {
        put(part, "segments", Value::Integer(count));
        put(part, "length_m", whole * count as f64 / segments as f64);
    }
    for (part, keys) in [(&mut *line, OF_END_B), (&mut second, OF_END_A)] {
        for key in keys {
            part.remove(key);
        }
    }
    lines.push(second.into());
    let mut point = Table::new();
    put(&mut point, "kind", "free");
    let points = file.get_mut("points")?.as_table_mut()?;
    points.insert(BETWEEN.to_owned(), point.into());
    variant.ends.insert((name, 'b'), (second_name, 'b'));
    Some(variant)
}

/// Whether a line can be divided, by the materials that bend and the lines that are paid out.
fn is_divisible(line: &Table, bending: &[String], paid: &[String]) -> bool {
    let name = word(line, "name").unwrap_or_default();
    let bends = word(line, "material").is_none_or(|of| bending.iter().any(|b| b == of));
    let breaks = line.contains_key("break_at_m");
    let segments = number(line, "segments").unwrap_or(0.0) as i64;
    !bends && !breaks && segments >= 2 * FEWEST && !paid.iter().any(|one| one == name)
}
