//! The variants of a case that its studies and published values need, worked out behind the screen.

use crate::case::{Case, StudyPoint, TextDigest};
use crate::reference;
use crate::tui::facade;

/// A case at a point of a study.
#[derive(Debug, Clone)]
pub struct Variant {
    /// The point; absent: the case itself.
    pub at: Option<StudyPoint>,
    /// Its text.
    pub text: String,
    /// The digest of its text.
    pub digest: TextDigest,
    /// What the text says, or why there is no such case.
    pub case: Result<Box<Case>, String>,
}

/// The variants of a text.
#[derive(Debug, Clone, Default)]
pub struct VariantPlan {
    /// The text of the case.
    pub text: String,
    /// The variants, those that the published values need first.
    pub variants: Vec<Variant>,
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
            Variant {
                at,
                digest: TextDigest::of(&text),
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
    pub fn of_published_values(&self) -> &[Variant] {
        self.variants.get(..self.needed).unwrap_or_default()
    }

    /// The variants of a study.
    pub fn of_study<'a>(&'a self, name: &'a str) -> impl Iterator<Item = &'a Variant> {
        let of = move |v: &&Variant| v.at.as_ref().is_some_and(|at| at.study == name);
        self.variants.iter().filter(of)
    }
}
