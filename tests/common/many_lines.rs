//! A system whose search at rest takes a while.

use std::fmt::Write as _;

/// A system of so many lines in a current, which takes a while to come to rest.
pub(crate) fn many_lines(lines: usize) -> String {
    let mut text = "[system]\ntitle = \"Many lines\"\n[current]\nspeed_m_per_s = 1.0\n[materials.w]\nmass_kg_per_m = 20.0\ndiameter_m = 0.06\nea_n = 1e8\n".to_owned();
    for i in 0..lines {
        let _ = write!(
            text,
            "[points.a{i}]\nkind = \"fixed\"\nposition_m = [{i}.0, 0.0, 0.0]\n[points.b{i}]\nkind = \"fixed\"\nposition_m = [{i}.0, 90.0, -20.0]\n\
             [points.c{i}]\nkind = \"free\"\nmass_kg = 100.0\n\
             [[lines]]\nname = \"l{i}\"\nfrom = \"a{i}\"\nto = \"c{i}\"\nmaterial = \"w\"\nlength_m = 60.0\nsegments = 300\n\
             [[lines]]\nname = \"m{i}\"\nfrom = \"c{i}\"\nto = \"b{i}\"\nmaterial = \"w\"\nlength_m = 60.0\nsegments = 300\n"
        );
    }
    text
}
