//! The variants of a case that its studies and published values need, worked out behind the screen.

use std::path::PathBuf;

use super::field_rows::rows;
use crate::case::{Case, StudyPoint, TextDigest};
use crate::facade::{self, FieldRow};
use crate::kinds::FileType;
use crate::reference;
use crate::study::points::PointRequest;
use crate::study::vary::Variation;

/// A case at a point of a study.
#[derive(Debug, Clone)]
pub struct CaseVariant {
    /// The point; absent: the case itself.
    pub at: Option<StudyPoint>,
    /// Its text.
    pub text: String,
    /// The digest of its text.
    pub digest: TextDigest,
    /// Its fields.
    pub rows: Vec<FieldRow>,
    /// What the text says, or why there is no such case.
    pub case: Result<Box<Case>, String>,
}

/// The variants of a text.
#[derive(Debug, Clone, Default)]
pub struct VariantPlan {
    /// The text of the case.
    pub text: String,
    /// The variants, those that the published values need first.
    pub variants: Vec<CaseVariant>,
    /// How many of them the published values need.
    pub needed: usize,
}

impl VariantPlan {
    /// Works the variants of a case out: every point of its studies, and what its published values need.
    #[must_use]
    pub fn new(text: &str, case: &Case, file: &str) -> Self {
        let mut points = reference::plan(case);
        let needed = points.len();
        let of_studies = case.study.iter().flat_map(|study| {
            study.values.iter().map(|value| {
                Some(StudyPoint {
                    study: study.name.clone(),
                    value: value.clone(),
                })
            })
        });
        for point in of_studies {
            if !points.contains(&point) {
                points.push(point);
            }
        }
        let variant = |at: Option<StudyPoint>| {
            let (text, case) = match facade::variant(text, case, at.as_ref(), file) {
                Ok((text, case)) => (text, Ok(Box::new(case))),
                Err(why) => (String::new(), Err(why)),
            };
            CaseVariant {
                at,
                digest: TextDigest::of_text(&text),
                rows: rows(FileType::Line, &text),
                text,
                case,
            }
        };
        Self {
            text: text.to_owned(),
            variants: points.into_iter().map(variant).collect(),
            needed,
        }
    }

    /// The variants that the published values need.
    #[must_use]
    pub fn of_published_values(&self) -> &[CaseVariant] {
        self.variants.get(..self.needed).unwrap_or_default()
    }

    /// The variants of a study.
    pub fn of_study<'a>(&'a self, name: &'a str) -> impl Iterator<Item = &'a CaseVariant> {
        let of = move |v: &&CaseVariant| v.at.as_ref().is_some_and(|at| at.study == name);
        self.variants.iter().filter(of)
    }
}

/// The runs of a case over ranges of its inputs.
#[derive(Debug, Clone)]
pub struct VariedRuns {
    /// The file of the case.
    pub path: PathBuf,
    /// The keys that are varied.
    pub keys: String,
    /// What is special about each, and what it computes or why the case refuses it.
    pub runs: Vec<(String, PointRequest)>,
}

impl VariedRuns {
    /// Works out the texts of a variation of the case in a file.
    #[must_use]
    pub fn new(path: PathBuf, variation: &Variation) -> Self {
        let labels = variation.points.iter().map(|point| {
            let settings = point.settings.iter();
            let words = settings.map(|s| facade::setting_label(&s.key, &s.written()));
            words.collect::<Vec<_>>().join(", ")
        });
        let keys = variation.keys.iter().map(|key| key.path.as_str());
        Self {
            path,
            keys: keys.collect::<Vec<_>>().join(" and "),
            runs: labels.zip(variation.requests()).collect(),
        }
    }
}
