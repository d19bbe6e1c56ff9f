//! A system at rest whose mesh is searched for: the segments of the lines that have no closed form.

use super::system_at_rest::{STATIC, SystemAtRest};
use crate::case::Method;
use crate::run::accuracy::searchable::{Asked, Searchable};
use crate::run::accuracy::steps::Steps;
use crate::system::discretised::{FEWEST, keeps_its_places};

impl Searchable for SystemAtRest {
    fn asked(&self) -> Option<Asked> {
        self.asked
    }

    /// None: nothing is marched.
    fn steps(&self) -> Steps {
        Steps {
            method: Method::Static,
            length: None,
            longest: None,
            tolerance: 1.0,
            rho: 1.0,
        }
    }

    fn chosen_step(&self) -> Result<f64, String> {
        Err(format!("the method `{STATIC}` takes no steps"))
    }

    fn stepped(&self, _: Steps) -> Self {
        self.clone()
    }

    fn segments(&self) -> Vec<usize> {
        let lines = self.meshed().zip(self.fewest());
        lines
            .map(|((_, line), fewest)| line.wanted_segments().max(fewest))
            .collect()
    }

    fn fewest(&self) -> Vec<usize> {
        self.meshed()
            .map(|(_, line)| FEWEST * line.sections.len().max(1))
            .collect()
    }

    fn segment_keys(&self) -> Vec<String> {
        self.meshed()
            .map(|(_, line)| format!("lines.{}.segments", line.name))
            .collect()
    }

    fn with_segments(&self, segments: &[usize]) -> Result<Self, String> {
        let meshed: Vec<usize> = self.meshed().map(|(number, _)| number).collect();
        Ok(self.with_file(|file| {
            for (number, segments) in meshed.into_iter().zip(segments) {
                file.lines[number].segments = Some(*segments);
            }
        }))
    }

    /// Where sections of a line meet is a node of every mesh.
    fn keeps_its_places(&self, coarser: usize) -> bool {
        self.meshed()
            .all(|(_, line)| keeps_its_places(&self.file, line, coarser))
    }

    fn companions(&self) -> &[String] {
        self.companions.as_deref().unwrap_or_default()
    }

    fn found_with(&self, companions: &[String]) -> Self {
        let mut found = self.asking(None, self.has_companions);
        found.companions = Some(companions.to_vec());
        found
    }

    /// The segments alone: a table `[solver]` would make a run in time of it.
    fn found_keys(&self, found: &Self) -> Vec<(String, String)> {
        let parts = self.segments().into_iter().zip(found.segments());
        let divided = self.segment_keys().into_iter().zip(parts);
        let divided = divided.filter(|(_, (own, found))| own != found);
        divided
            .map(|(key, (_, found))| (key, found.to_string()))
            .collect()
    }
}
