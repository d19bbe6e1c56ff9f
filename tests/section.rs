//! The cross-section designer.

#![expect(clippy::unwrap_used, reason = "a test may panic")]

use std::path::Path;

use seacable::report::chart::Glyphs;
use seacable::section;

#[test]
fn show() {
    for name in ["section", "section_power_cable"] {
        let path = format!("{}/cases/umbilical/{name}.toml", env!("CARGO_MANIFEST_DIR"));
        let loaded = section::load(Path::new(&path));
        match loaded {
            Ok(loaded) => {
                println!(
                    "{}",
                    section::text::text(&loaded.design, 100, Glyphs::Braille, None)
                );
                println!("{}", section::fragment(&loaded.design));
                println!("{:#?}", loaded.design.rigid);
                println!("{:#?}", loaded.design.incompressible);
            }
            Err(all) => all.iter().for_each(|d| println!("{d}")),
        }
    }
}
