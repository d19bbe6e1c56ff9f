//! Whether a case is at a point of a study.

use super::model::{StudyPoint, StudyValue};
use super::schema::KeyValue;
use super::tree::TomlNode;

impl super::Case {
    /// Whether the case as it stands is at this point of a study: its key has that value here.
    #[must_use]
    pub fn stands_at(&self, at: &StudyPoint) -> bool {
        let study = self.study.iter().find(|study| study.name == at.study);
        let tree = TomlNode::parse(&super::write::write_all(self)).ok();
        let (Some(study), Some(tree)) = (study, tree) else {
            return false;
        };
        let key: Vec<&str> = study.key.split('.').collect();
        let here = tree.find(&key).and_then(StudyValue::read);
        here.as_ref() == Some(&at.value)
    }
}
