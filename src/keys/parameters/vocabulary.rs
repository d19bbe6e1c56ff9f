//! The functions and the constant that expressions may use.

/// A function of one number.
pub(super) type Function = fn(f64) -> f64;

/// A function of two numbers.
pub(super) type FunctionOfTwo = fn(f64, f64) -> f64;

/// Functions of one number, as they are written.
const FUNCTIONS: [(&str, Function); 18] = [
    ("sqrt", f64::sqrt),
    ("abs", f64::abs),
    ("sin", f64::sin),
    ("cos", f64::cos),
    ("tan", f64::tan),
    ("asin", f64::asin),
    ("acos", f64::acos),
    ("atan", f64::atan),
    ("sinh", f64::sinh),
    ("cosh", f64::cosh),
    ("tanh", f64::tanh),
    ("asinh", f64::asinh),
    ("acosh", f64::acosh),
    ("exp", f64::exp),
    ("ln", f64::ln),
    ("floor", f64::floor),
    ("ceil", f64::ceil),
    ("round", f64::round),
];

/// Functions of two numbers, as they are written.
const FUNCTIONS_OF_TWO: [(&str, FunctionOfTwo); 3] =
    [("min", f64::min), ("max", f64::max), ("atan2", f64::atan2)];

/// The ratio of a circle's circumference to its diameter.
pub(super) const PI: &str = "pi";

/// The function of one number with a name.
pub(super) fn function(name: &str) -> Option<Function> {
    let mut known = FUNCTIONS.iter();
    known.find(|(known, _)| *known == name).map(|(_, of)| *of)
}

/// The function of two numbers with a name.
pub(super) fn function_of_two(name: &str) -> Option<FunctionOfTwo> {
    let mut known = FUNCTIONS_OF_TWO.iter();
    known.find(|(known, _)| *known == name).map(|(_, of)| *of)
}

/// Whether a name can stand in an expression, and is none of its functions and constants.
pub(super) fn is_name(name: &str) -> bool {
    let mut letters = name.chars();
    let first = letters.next();
    first.is_some_and(|letter| letter.is_ascii_alphabetic())
        && letters.all(|letter| letter.is_ascii_alphanumeric() || letter == '_')
        && !is_taken(name)
}

/// Whether a name is that of a function or of the constant.
pub(super) fn is_taken(name: &str) -> bool {
    function(name).is_some() || function_of_two(name).is_some() || name == PI
}

/// The operators, the functions and the constant, for people.
pub(super) fn vocabulary() -> String {
    let of_one = FUNCTIONS.iter().map(|(name, _)| *name);
    let names = of_one.chain(FUNCTIONS_OF_TWO.iter().map(|(name, _)| *name));
    let names: Vec<&str> = names.chain([PI]).collect();
    format!("+ - * / ^ and {}", names.join(" "))
}
