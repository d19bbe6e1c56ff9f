//! Every template makes a file that is read without a fault, and refuses what cannot be.

use seacable::case::{self, kind};
use seacable::kinds::FileType;
use seacable::ropeway::Ropeway;
use seacable::section::CrossSection;
use seacable::ship::Ship;
use seacable::system::SystemFile;
use seacable::templates::{TEMPLATES, find};

fn read(text: &str) -> Result<(), String> {
    let faults = match FileType::of_text(text) {
        FileType::Line => case::parse(text, "x.toml").map(|_| ()),
        FileType::Section => kind::parse::<CrossSection>(text, "x.toml").map(|_| ()),
        FileType::Ropeway => kind::parse::<Ropeway>(text, "x.toml").map(|_| ()),
        FileType::Ship => kind::parse::<Ship>(text, "x.toml").map(|_| ()),
        FileType::System => kind::parse::<SystemFile>(text, "x.toml").map(|_| ()),
    };
    faults.map_err(|all| format!("{all:?}\n{text}"))
}

#[test]
fn every_template_as_proposed_is_a_file_without_a_fault() {
    for template in TEMPLATES {
        let text = template.text(&[]).unwrap();
        read(&text).unwrap_or_else(|faults| panic!("{}: {faults}", template.name));
        assert_eq!(find(template.name), Some(template));
    }
}

#[test]
fn what_is_typed_is_in_the_file() {
    let template = find("spread mooring").unwrap();
    let typed = |key: &'static str, value: &str| (key, value.to_owned());
    let text = template
        .text(&[
            typed("title", "Six \"equal\" lines"),
            typed("lines", "6"),
            typed("depth_m", "100"),
        ])
        .unwrap();
    read(&text).unwrap();
    let system = kind::parse::<SystemFile>(&text, "x.toml").unwrap();
    assert_eq!(system.file.about.title, "Six \"equal\" lines");
    assert_eq!(system.network.lines.len(), 6);
    assert_eq!(system.file.seabed.as_ref().unwrap().depth_m, 100.0);
}

#[test]
fn what_cannot_be_is_refused_in_words() {
    let refused = |name: &str, key: &'static str, value: &str| {
        let template = find(name).unwrap();
        template.text(&[(key, value.to_owned())]).unwrap_err()
    };
    for (name, key, value, expected) in [
        (
            "mooring line",
            "depth_m",
            "deep",
            "water depth must be a number from",
        ),
        (
            "mooring line",
            "fairlead_depth_m",
            "250",
            "above the sea bed",
        ),
        (
            "mooring line",
            "line_type",
            "steel",
            "There is no line type `steel`",
        ),
        ("mooring line", "diameter_mm", "-3", "."),
        ("spread mooring", "lines", "2.5", "must be a whole number"),
        (
            "spread mooring",
            "fairlead_radius_m",
            "900",
            "greater than the fairlead radius",
        ),
        (
            "lowering",
            "rope_m",
            "600",
            "shorter than the water is deep",
        ),
        ("lowering", "wet_mass_t", "70", "cannot exceed the mass"),
        ("umbilical", "mass_kg_per_m", "1", "heavier than the water"),
        ("ropeway", "span_m", "", "."),
    ] {
        if value.is_empty() {
            continue;
        }
        let said = refused(name, key, value);
        assert!(said.contains(expected), "{name} {key}: {said}");
    }
}

#[test]
fn a_title_with_braces_stays_as_it_is_typed() {
    for template in TEMPLATES {
        let typed = [("title", "{depth} and {wet} {title}".to_owned())];
        let text = template.text(&typed).unwrap();
        assert!(
            text.contains("title = \"{depth} and {wet} {title}\""),
            "{text}"
        );
        read(&text).unwrap_or_else(|faults| panic!("{}: {faults}", template.name));
    }
}
