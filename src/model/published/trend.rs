//! A published statement of how a result goes along a study.

use crate::case::schema::{Key, table};
use crate::case::{Direction, Finding, QuantityId, StudyKeys, Trend, of_study};

table! {
    /// A published statement of how a result goes along a study.
    #[derive(Debug, Clone, PartialEq)]
    pub struct PublishedTrend => PublishedTrendKeys {
        /// The statement, in words.
        name: String, "name";
        /// The study it is checked along.
        study: String, "study";
        /// The quantity, such as tension_n[mooring|b].max.
        quantity: String, "quantity";
        /// What the quantity does as the values of the study's key grow.
        expect: Direction, "expect";
        /// Where it is printed.
        source: String, "source";
        /// What else the reader must know.
        note: Option<String>, "note", absent "no note";
        /// Why the trend is out of reach; the row then reads DIFFERS instead of FAIL.
        out_of_reach: Option<String>, "out of reach", absent "within reach";
    }
}

impl Trend {
    /// The same by the name of its result.
    #[must_use]
    pub fn of_quantity(&self) -> PublishedTrend {
        let id = QuantityId::new(self.channel.clone(), self.statistic, self.within());
        PublishedTrend {
            name: self.name.clone(),
            study: self.study.clone(),
            quantity: id.numbered(self.nth).to_string(),
            expect: self.expect,
            source: self.source.clone(),
            note: self.note.clone(),
            out_of_reach: self.out_of_reach.clone(),
        }
    }
}

/// Checks of published trends: known quantities, as `unknown` says, and studies of the file.
pub fn check(
    list: &[(String, PublishedTrendKeys<'_>)],
    unknown: impl Fn(&Key<'_, String>) -> Option<Finding>,
    studies: &[(String, StudyKeys<'_>)],
) -> Vec<Finding> {
    let of_row = |(_, row): &(String, PublishedTrendKeys<'_>)| {
        [unknown(&row.quantity), of_study(studies, &row.study).err()]
    };
    list.iter().flat_map(of_row).flatten().collect()
}
