//! The table of the parameters, as it is declared for every kind of file.

use super::{AbsentValue, Field, Range, TableSchema, TableShape, ValueType};

/// The table of the parameters.
pub const PARAMETERS: &str = "parameters";

/// The key of a field of a table whose keys the user names.
pub const ANY_KEY: &str = "*";

/// The table of the parameters, as it is declared for every kind of file.
pub fn table() -> TableSchema {
    let help = "Named numbers, for values written as expressions: length_m = \"1.05 * depth_m\".";
    TableSchema::new(PARAMETERS.to_owned(), TableShape::One, false, help)
}

/// A parameter, as it is declared for every kind of file.
pub fn field() -> Field {
    let help = "Number, or an expression of other parameters in quotes. Its unit is for people: the name should end in it.";
    Field {
        absent: AbsentValue::Means("there is no such parameter"),
        range: Range::ANY,
        ..Field::new(ANY_KEY, ValueType::Number, "parameter", help).below(PARAMETERS)
    }
}
