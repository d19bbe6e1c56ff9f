//! Every line of a system written from its other end.

use std::collections::BTreeSet;

use toml::{Table, Value};

use super::tree::{change, exchange, length, list, listed, number, put, word};
use super::variant::SystemVariant;

pub(super) fn reversed(system: &Table) -> SystemVariant {
    let mut variant = SystemVariant::of_file(system.clone());
    let mut names = Vec::new();
    for line in listed(&mut variant.file, "lines") {
        reverse(line);
        names.extend(word(line, "name").map(str::to_owned));
    }
    for payout in listed(&mut variant.file, "payouts") {
        let other = if word(payout, "end") == Some("b") {
            "a"
        } else {
            "b"
        };
        put(payout, "end", other);
    }
    for name in names {
        for (end, other) in [('a', 'b'), ('b', 'a')] {
            variant
                .ends
                .insert((name.clone(), end), (name.clone(), other));
        }
    }
    variant
}

/// A line from its end B to its end A.
fn reverse(line: &mut Table) {
    let whole = length(line);
    exchange(line, "from", "to");
    for (a, b) in [
        ("clamp_a_elevation_deg", "clamp_b_elevation_deg"),
        ("clamp_a_azimuth_deg", "clamp_b_azimuth_deg"),
        ("release_a_s", "release_b_s"),
        ("release_a_n", "release_b_n"),
    ] {
        exchange(line, a, b);
    }
    // The direction of a clamp is that of the line as it goes on.
    for end in ["a", "b"] {
        let elevation = format!("clamp_{end}_elevation_deg");
        if line.contains_key(&elevation) {
            change(line, &elevation, |angle| -angle);
            let azimuth = format!("clamp_{end}_azimuth_deg");
            let before = number(line, &azimuth).unwrap_or(0.0);
            put(
                line,
                &azimuth,
                if before > 0.0 {
                    before - 180.0
                } else {
                    before + 180.0
                },
            );
        }
    }
    change(line, "break_at_m", |at| whole - at);
    if let Some(sections) = list(line, "sections") {
        sections.reverse();
        shift_clumps(sections);
    }
}

/// Puts the clump at the end of a section towards B, which is now its end towards A, to the section before.
fn shift_clumps(sections: &mut [Value]) {
    let tables = sections.iter().filter_map(Value::as_table);
    let keys = tables.flat_map(|section| section.keys().cloned());
    let of_clump: BTreeSet<String> = keys.filter(|key| key.starts_with("clump_")).collect();
    for key in of_clump {
        let each = sections.iter_mut().filter_map(Value::as_table_mut);
        let clumps: Vec<Option<Value>> = each.map(|section| section.remove(&key)).collect();
        let moved = clumps.into_iter().skip(1);
        let each = sections.iter_mut().filter_map(Value::as_table_mut);
        for (section, clump) in each.zip(moved) {
            if let Some(clump) = clump {
                section.insert(key.clone(), clump);
            }
        }
    }
}
