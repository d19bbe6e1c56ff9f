//! Expressions of named numbers: `1.05 * depth_m`, `sqrt(radius_m^2 + depth_m^2)`. The crate `exmex` evaluates them; what it reads otherwise
//! than engineers do is refused.

use exmex::{
    BinOp, Express, FlatEx, MakeOperators, MatchLiteral, Operator, literal_matcher_from_pattern,
};

literal_matcher_from_pattern!(
    DecimalNumbers,
    r"^([0-9]+\.?[0-9]*|\.[0-9]+)([eE][+-]?[0-9]+)?"
);

/// Longest expression \[bytes\].
const LONGEST: usize = 200;

/// A function of one number.
type OfOne = fn(f64) -> f64;

/// Functions of one number, as they are written.
const FUNCTIONS: [(&str, OfOne); 18] = [
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

/// A function of two numbers.
type OfTwo = fn(f64, f64) -> f64;

/// Functions of two numbers, as they are written.
const FUNCTIONS_OF_TWO: [(&str, OfTwo); 3] =
    [("min", f64::min), ("max", f64::max), ("atan2", f64::atan2)];

/// The ratio of a circle's circumference to its diameter.
const PI: &str = "pi";

/// The operators, functions and constants.
#[derive(Debug, Clone)]
struct Operators;

impl MakeOperators<f64> for Operators {
    fn make<'a>() -> Vec<Operator<'a, f64>> {
        let binary = |apply: OfTwo, prio, is_commutative| BinOp {
            apply,
            prio,
            is_commutative,
        };
        let mut all = vec![
            Operator::make_bin("^", binary(f64::powf, 4, false)),
            Operator::make_bin("*", binary(|a, b| a * b, 2, true)),
            Operator::make_bin("/", binary(|a, b| a / b, 3, false)),
            Operator::make_bin_unary("+", binary(|a, b| a + b, 0, true), |a| a),
            Operator::make_bin_unary("-", binary(|a, b| a - b, 1, false), |a| -a),
            Operator::make_constant(PI, std::f64::consts::PI),
        ];
        all.extend(FUNCTIONS.map(|(name, apply)| Operator::make_unary(name, apply)));
        let two = FUNCTIONS_OF_TWO.map(|(name, apply)| (name, binary(apply, 0, false)));
        all.extend(two.map(|(name, apply)| Operator::make_bin(name, apply)));
        all
    }
}

/// An expression that can be evaluated.
#[derive(Debug, Clone)]
pub(super) struct Expression(FlatEx<f64, Operators, DecimalNumbers>);

impl Expression {
    /// Reads an expression.
    ///
    /// # Errors
    /// What is wrong with it.
    pub(super) fn read(text: &str) -> Result<Self, String> {
        if text.len() > LONGEST {
            return Err(format!(
                "the expression is longer than {LONGEST} characters"
            ));
        }
        if let Some(fault) = ambiguous_power(text) {
            return Err(fault);
        }
        let read = FlatEx::parse(text).map(Self);
        read.map_err(|error| fault(text, error.msg()))
    }

    /// The names in it, each once.
    pub(super) fn names(&self) -> &[String] {
        self.0.var_names()
    }

    /// Its value where its names have these values, in the order of [`names`](Self::names).
    pub(super) fn value(&self, of_names: &[f64]) -> f64 {
        self.0.eval(of_names).unwrap_or(f64::NAN)
    }
}

/// What is wrong, in the words of `exmex`, and what it cannot read.
fn fault(text: &str, words: &str) -> String {
    let words = words.trim_end_matches('.');
    match text.matches(',').count() > 1 {
        // Refused by `exmex`: the second argument may hold no comma.
        true => {
            format!("{words}; min, max and atan2 may hold each other as their first argument only")
        }
        false => words.to_owned(),
    }
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
    let of_one = FUNCTIONS.iter().any(|(known, _)| *known == name);
    of_one || name == PI || FUNCTIONS_OF_TWO.iter().any(|(known, _)| *known == name)
}

/// The functions and the constant, for people.
pub(super) fn vocabulary() -> String {
    let of_one = FUNCTIONS.iter().map(|(name, _)| *name);
    let names = of_one.chain(FUNCTIONS_OF_TWO.iter().map(|(name, _)| *name));
    let names: Vec<&str> = names.chain([PI]).collect();
    format!("+ - * / ^ and {}", names.join(" "))
}

/// `-a^2` and `a^b^c`, which `exmex` reads as `(-a)^2` and `(a^b)^c`: the reader has to say which is meant.
fn ambiguous_power(text: &str) -> Option<String> {
    let bytes = text.as_bytes();
    let powers = bytes.iter().enumerate().filter(|(_, byte)| **byte == b'^');
    powers.into_iter().find_map(|(at, _)| {
        let base = base_of_power(&text[..at]);
        let before = text[..base].trim_end();
        let sign = before.strip_suffix(['-', '+']).map(str::trim_end);
        let is_unary = sign.is_some_and(|rest| {
            rest.is_empty() || rest.ends_with(['(', ',', '*', '/', '^', '+', '-'])
        });
        let words = text[base..at].trim();
        if is_unary {
            return Some(format!(
                "a sign before a power can be read in two ways: write -({words}^...) or (-{words})^..."
            ));
        }
        before.ends_with('^').then(|| {
            "a power of a power can be read in two ways: write (a^b)^c or a^(b^c)".to_owned()
        })
    })
}

/// Where the base of a power begins, whose text ends here: a number, a name, or what is in parentheses with its function.
fn base_of_power(text: &str) -> usize {
    let text = text.trim_end();
    let mut depth = 0_usize;
    let mut begin = text.len();
    if text.ends_with(')') {
        for (at, letter) in text.char_indices().rev() {
            match letter {
                ')' => depth += 1,
                '(' => depth = depth.saturating_sub(1),
                _ => {}
            }
            begin = at;
            if depth == 0 {
                break;
            }
        }
    }
    let word = |letter: char| letter.is_alphanumeric() || letter == '_' || letter == '.';
    text[..begin].trim_end_matches(word).len()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn value(text: &str) -> f64 {
        let read = Expression::read(text).unwrap();
        assert_eq!(read.names(), &[] as &[String], "{text}");
        read.value(&[])
    }

    #[test]
    fn expressions_have_the_values_of_engineers() {
        for (text, expected) in [
            ("1.05 * 200", 210.0),
            ("2 + 3 * 4", 14.0),
            ("12 / 3 * 2", 8.0),
            ("12 / (3 * 2)", 2.0),
            ("10 - 4 + 1", 7.0),
            ("10 - (4 + 1)", 5.0),
            ("10 - 4 - 3", 3.0),
            ("24 / 4 / 3", 2.0),
            ("2 * 3^2", 18.0),
            ("2 - 3^2", -7.0),
            ("-(3^2)", -9.0),
            ("(-3)^2", 9.0),
            ("1.5e3 + 2E-1", 1500.2),
            (".5 + 1.", 1.5),
            ("sqrt(3^2 + 4^2)", 5.0),
            ("max(min(5, 3), 2)", 3.0),
            ("sin(30 * pi / 180)", 0.5),
            ("atan2(1, 1) * 4", std::f64::consts::PI),
            ("sinh(asinh(2))", 2.0),
            ("round(2.6) + floor(-0.5) + ceil(0.2)", 3.0),
            ("-2 * -3", 6.0),
        ] {
            let found = value(text);
            assert!((found - expected).abs() < 1e-12, "{text}: {found}");
        }
    }

    #[test]
    fn what_can_be_read_in_two_ways_is_refused() {
        for text in [
            "-3^2",
            "2 * -3^2",
            "(-x^2)",
            "- sqrt(x)^2",
            "-(1 + x)^2",
            "2^3^2",
            "min(1, -x ^ 2)",
        ] {
            let fault = Expression::read(text).unwrap_err();
            assert!(fault.contains("in two ways"), "{text}: {fault}");
        }
        for text in ["5 - x^2", "(-x)^2", "-(x^2)", "2^(3^2)", "x^-2", "a*b^2"] {
            assert!(Expression::read(text).is_ok(), "{text}");
        }
    }

    #[test]
    fn names_are_listed_and_valued() {
        let read = Expression::read("depth_m * 2 + b - depth_m").unwrap();
        assert_eq!(read.names(), ["b", "depth_m"]);
        assert_eq!(read.value(&[1.0, 10.0]), 11.0);
    }

    #[test]
    fn hostile_texts_are_refused_without_a_panic() {
        let nested = format!("{}1{}", "(".repeat(95), ")".repeat(95));
        assert_eq!(value(&nested), 1.0);
        for text in [
            "",
            " ",
            "(",
            ")",
            "1 +",
            "* 2",
            "1 2",
            "a b",
            "sin",
            "sin(",
            "max(1)",
            "1..2",
            "é^",
            "^",
            "()^2",
            ")^(",
            "{x}",
            "\"a\"",
            "1 ; 2",
            "min(1,2,3)",
            "25 m",
            "ρ",
            "x=1",
        ] {
            if let Ok(read) = Expression::read(text) {
                let names = vec![1.0; read.names().len()];
                let _finite_or_not = read.value(&names);
            }
        }
        assert!(Expression::read(&"1+".repeat(200)).is_err());
        let nested = Expression::read("max(2, min(5, 3))").unwrap_err();
        assert!(nested.contains("as their first argument only"), "{nested}");
    }
}
