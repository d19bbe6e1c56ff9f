//! Tables of load cases, of a line or of a system.

use super::validation_data::StudyValue;
use crate::case::fields::ValueType::Name;
use crate::case::fields::of;
use crate::case::schema::table;

table! {
    /// Load cases: the values of one key, or the rows of a file. `seacable sweep` computes all combinations of the tables.
    #[derive(Debug, Clone, PartialEq)]
    pub struct LoadCaseInputs => LoadCaseKeys {
        /// The key path that is set, such as waves.height_m.
        key: Option<String>, "key", absent "the columns of the file";
        /// Its values, in the unit of the key, or words that it takes.
        values: Option<Vec<StudyValue>>, "values", absent "not used";
        /// Its values as a range: 2..8/4 are four in even steps, 1..100/3log three in even ratios.
        range: Option<String>, "range", absent "not used";
        /// Tables with the same word here go together row by row, and are not combined with each other.
        zip: Option<String>, "zip", kind Name, absent "combined with every other table";
        /// Probability of each value; they add up to 1.
        probability: Option<Vec<f64>>, "probabilities", range of(0.0, 1.0), absent "all alike where another table states them";
        /// CSV file with a row for each load case: a column for each key path, and probability or occurrences where they are known.
        file: Option<String>, "file of load cases", absent "not used";
    }
}
