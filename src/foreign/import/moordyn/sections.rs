//! A file of MoorDyn or MAP++ cut into its sections, each between rows of dashes.

use std::ops::Range;

use crate::import::fault::Fault;
use crate::import::words::Row;

/// The sections that are known.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum SectionTitle {
    /// Line types.
    LineTypes,
    /// Rod types.
    RodTypes,
    /// Bodies.
    Bodies,
    /// Rods.
    Rods,
    /// Points.
    Points,
    /// Lines.
    Lines,
    /// Past tensions of Syrope ropes.
    SyropeIc,
    /// Lines that come off points.
    Failure,
    /// Lines that a controller drives.
    Control,
    /// Loads on points and bodies.
    ExternalLoads,
    /// Options.
    Options,
    /// Outputs.
    Outputs,
    /// Sections of lines, of `CableDyn`.
    LineSections,
    /// Stiffness of the ends of lines, of `CableDyn`.
    EndConnections,
    /// Buoyancy along lines, of `CableDyn`.
    EquivalentBuoyancy,
    /// Clumps and floats on lines, of `CableDyn`.
    LineAttachments,
    /// Places of turbines, of `CableDyn`.
    Turbines,
}

/// Titles by which a section is known, in the order in which they are looked for.
const TITLES: [(&str, SectionTitle); 34] = [
    ("LINE TYPES", SectionTitle::LineTypes),
    ("LINE DICTIONARY", SectionTitle::LineTypes),
    ("ROD TYPES", SectionTitle::RodTypes),
    ("ROD DICTIONARY", SectionTitle::RodTypes),
    ("BODIES", SectionTitle::Bodies),
    ("BODY LIST", SectionTitle::Bodies),
    ("BODY PROPERTIES", SectionTitle::Bodies),
    ("ROD LIST", SectionTitle::Rods),
    ("ROD PROPERTIES", SectionTitle::Rods),
    ("RODS", SectionTitle::Rods),
    ("CONNECTION PROPERTIES", SectionTitle::Points),
    ("NODE PROPERTIES", SectionTitle::Points),
    ("POINT PROPERTIES", SectionTitle::Points),
    ("POINT LIST", SectionTitle::Points),
    ("POINTS", SectionTitle::Points),
    ("LINETYPES", SectionTitle::LineTypes),
    ("RODTYPES", SectionTitle::RodTypes),
    ("END CONNECTION", SectionTitle::EndConnections),
    ("EQUIVALENT BUOYANCY", SectionTitle::EquivalentBuoyancy),
    ("EQUIVALENT SECTIONS", SectionTitle::EquivalentBuoyancy),
    ("BUOYANCY SECTIONS", SectionTitle::EquivalentBuoyancy),
    ("ATTACHMENTS", SectionTitle::LineAttachments),
    ("LINE PROPERTIES", SectionTitle::Lines),
    ("LINE LIST", SectionTitle::Lines),
    ("LINES", SectionTitle::Lines),
    ("SYROPE IC", SectionTitle::SyropeIc),
    ("FAILURE", SectionTitle::Failure),
    ("CONTROL", SectionTitle::Control),
    ("EXTERNAL LOADS", SectionTitle::ExternalLoads),
    ("OPTIONS", SectionTitle::Options),
    ("OUTPUT", SectionTitle::Outputs),
    ("SECTIONS", SectionTitle::LineSections),
    ("TURBINES", SectionTitle::Turbines),
    ("CONNECTS", SectionTitle::Points),
];

/// Titles of rows of dashes that begin no section.
const OTHER_TITLES: [&str; 3] = ["NEED THIS LINE", "INPUT FILE", "END"];

impl SectionTitle {
    /// The title by which it is usually written.
    #[must_use]
    pub fn title(self) -> &'static str {
        match self {
            Self::LineTypes => "LINE TYPES",
            Self::RodTypes => "ROD TYPES",
            Self::Bodies => "BODIES",
            Self::Rods => "RODS",
            Self::Points => "POINTS",
            Self::Lines => "LINES",
            Self::SyropeIc => "SYROPE IC",
            Self::Failure => "FAILURE",
            Self::Control => "CONTROL",
            Self::ExternalLoads => "EXTERNAL LOADS",
            Self::Options => "OPTIONS",
            Self::Outputs => "OUTPUTS",
            Self::LineSections => "SECTIONS",
            Self::EndConnections => "END CONNECTIONS",
            Self::EquivalentBuoyancy => "EQUIVALENT BUOYANCY",
            Self::LineAttachments => "ATTACHMENTS",
            Self::Turbines => "TURBINES",
        }
    }

    /// What one of its rows is.
    #[must_use]
    pub const fn of_one(self) -> &'static str {
        match self {
            Self::LineTypes => "line type",
            Self::RodTypes => "rod type",
            Self::Bodies => "body",
            Self::Rods => "rod",
            Self::Points => "point",
            Self::Lines => "line",
            _ => "row",
        }
    }
}

/// A section with its rows, blank ones left out.
#[derive(Debug, Clone, PartialEq)]
pub struct SectionBlock<'t> {
    /// Which.
    pub section: SectionTitle,
    /// Its row of dashes.
    pub span: Range<usize>,
    /// Its rows.
    pub rows: Vec<Row<'t>>,
}

/// A text cut into its sections; what stands before the first, and every title that is not known.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Sections<'t> {
    /// Rows before the first section.
    pub head: Vec<Row<'t>>,
    /// The sections in their order.
    pub blocks: Vec<SectionBlock<'t>>,
    /// What is wrong with the titles.
    pub faults: Vec<Fault>,
}

impl<'t> Sections<'t> {
    /// Cuts a text whose first byte is counted as `start`.
    #[must_use]
    pub fn of_text(text: &'t str, start: usize) -> Self {
        let mut sections = Self::default();
        let mut open = true;
        for row in Row::all_from(text, start) {
            match title(row.text) {
                Some(title) => open = sections.begin(&title, row),
                None if row.is_blank() && row.text.trim().is_empty() => {}
                None if let Some(fault) = too_few_dashes(&row) => {
                    sections.faults.push(fault);
                    open = false;
                }
                None if !open => {}
                None => match sections.blocks.last_mut() {
                    Some(block) => block.rows.push(row),
                    None => sections.head.push(row),
                },
            }
        }
        sections
    }

    /// The rows of a section; none if the file does not have it.
    #[must_use]
    pub fn block(&self, section: SectionTitle) -> Option<&SectionBlock<'t>> {
        self.blocks.iter().find(|block| block.section == section)
    }

    /// Begins what a row of dashes announces; false where its rows are not to be read.
    fn begin(&mut self, title: &str, row: Row<'t>) -> bool {
        let known = TITLES.iter().find(|(known, _)| title.contains(known));
        if let Some((_, section)) = known {
            if self.block(*section).is_some() {
                self.faults.push(Fault::new(
                    row.span(),
                    section.title(),
                    format!("there is a second section {}", section.title()),
                    "put all its rows into one",
                ));
            }
            self.blocks.push(SectionBlock {
                section: *section,
                span: row.span(),
                rows: Vec::new(),
            });
            return true;
        }
        let is_other = OTHER_TITLES.iter().any(|other| title.contains(other));
        if title.is_empty() || is_other {
            return self.blocks.is_empty();
        }
        if self.blocks.is_empty() && !looks_like_a_section(title) {
            return true;
        }
        self.faults.push(unknown(title, row));
        false
    }
}

/// The title on a row of dashes, in capitals with single blanks; `None` for other rows.
fn title(text: &str) -> Option<String> {
    let text = text.trim();
    if !(text.starts_with("---") || text.starts_with("===")) {
        return None;
    }
    let words = text.split(|letter: char| letter.is_whitespace() || "-=".contains(letter));
    let words: Vec<String> = words
        .filter(|word| !word.is_empty())
        .map(str::to_uppercase)
        .collect();
    Some(words.join(" "))
}

/// The fault of the title of a section behind one dash or two, which the programs take for a row of the section before.
fn too_few_dashes(row: &Row<'_>) -> Option<Fault> {
    let text = row.text.trim();
    let inner = text.strip_prefix('-')?.strip_suffix('-')?;
    let title = title(&format!("---{inner}---"))?;
    let (known, _) = TITLES.iter().find(|(known, _)| title == *known)?;
    Some(Fault::new(
        row.span(),
        *known,
        "the title of a section stands behind three dashes or more",
        format!("write `--- {known} ---`"),
    ))
}

/// Whether a title comes near to that of a section.
fn looks_like_a_section(title: &str) -> bool {
    nearest(title).is_some()
}

fn nearest(title: &str) -> Option<&'static str> {
    const LONGEST: usize = 64;
    if title.len() > LONGEST {
        return None;
    }
    let alike = |known: &str| strsim::damerau_levenshtein(known, title);
    let (known, _) = TITLES.iter().min_by_key(|(known, _)| alike(known))?;
    (alike(known) <= 3).then_some(*known)
}

fn unknown(title: &str, row: Row<'_>) -> Fault {
    let remedy = match nearest(title) {
        Some(known) => format!("did you mean {known}?"),
        None => {
            "sections are LINE TYPES, ROD TYPES, BODIES, RODS, POINTS, LINES, FAILURE, CONTROL, SYROPE IC, OPTIONS, OUTPUTS".to_owned()
        }
    };
    Fault::new(
        row.span(),
        "",
        format!("`{title}` is not a section"),
        remedy,
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    const FILE: &str = "----- MoorDyn Input File -----\nsome title\n\
        ----- LINE TYPES Chain studless 0.018m ----\nName Diam\n(-) (m)\nmain 0.3\n\n\
        ---- SOLVER OPTIONS----\n9.8 g\n----- need this line ----\nrest\n";

    #[test]
    fn sections_hold_their_rows() {
        let sections = Sections::of_text(FILE, 0);
        assert_eq!(sections.faults, []);
        assert_eq!(sections.head[0].text, "some title");
        let rows = |section| sections.block(section).unwrap().rows.len();
        assert_eq!(rows(SectionTitle::LineTypes), 3);
        assert_eq!(rows(SectionTitle::Options), 1);
        assert!(sections.block(SectionTitle::Points).is_none());
    }

    #[test]
    fn a_title_that_is_not_known_says_which_is_meant() {
        let text = FILE.replace("LINE TYPES Chain studless 0.018m", "LINE TYPPES");
        let faults = Sections::of_text(&text, 0).faults;
        assert_eq!(faults.len(), 1);
        assert!(faults[0].remedy.contains("LINE TYPES"), "{faults:?}");
        let twice = format!("{FILE}--- LINE TYPES ---\n");
        assert_eq!(Sections::of_text(&twice, 0).faults.len(), 1);
    }
}
