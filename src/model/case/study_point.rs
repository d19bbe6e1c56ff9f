//! Whether a file is at a point of a study.

use super::model::{Study, StudyPoint, StudyValue};
use super::schema::{KeyValue, TableType, WrittenKeys};
use super::tree::TomlNode;

/// Whether a file as it stands is at this point of one of its studies: its key has that value here.
#[must_use]
pub fn stands_at(content: &impl TableType, studies: &[Study], at: &StudyPoint) -> bool {
    let Some(study) = studies.iter().find(|study| study.name == at.study) else {
        return false;
    };
    let tree = TomlNode::of_table(&content.write(WrittenKeys::All));
    let key: Vec<&str> = study.key.split('.').collect();
    let here = tree.find(&key).and_then(StudyValue::read);
    here.as_ref() == Some(&at.value)
}
