//! Expressions of named numbers: `1.05 * depth_m`, `sqrt(radius_m^2 + depth_m^2)`.
//!
//! Operators of one rank are applied from left to right: `^` first, then `*` and `/`, then `+` and `-`. What engineers read in two ways is
//! refused. Every result on the way to the value must be finite, so that none is hidden by `min`, `max`, `atan` or a division. Reading
//! and evaluating go through the text once, without recursion.

use std::ops::Range;

use super::tokens::{Symbol, Token, tokens};
use super::vocabulary::{Function, FunctionOfTwo};

/// Longest expression \[bytes\].
const LONGEST: usize = 200;

/// An expression that can be evaluated.
#[derive(Debug, Clone)]
pub(super) struct Expression {
    text: String,
    names: Vec<String>,
    /// Operations in the order in which they are applied, operands first.
    steps: Vec<ExpressionStep>,
}

/// An operation, and the part of the text whose value it yields.
#[derive(Debug, Clone)]
struct ExpressionStep {
    operation: ExpressionOperation,
    part: Range<usize>,
}

/// What is done with the values computed last.
#[derive(Debug, Clone, Copy)]
enum ExpressionOperation {
    Number(f64),
    /// The value of a name, by its place among the names.
    Name(usize),
    Negated,
    Of(Function),
    OfTwo(FunctionOfTwo),
    Operator(char),
}

/// A part of an expression whose value is no finite number.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct NotFinite {
    /// The part, as it is written.
    pub(super) part: String,
    /// Its value: infinite, or not a number.
    pub(super) value: f64,
}

impl Expression {
    /// Reads an expression.
    ///
    /// # Errors
    /// What is wrong with it, and at which character.
    pub(super) fn read(text: &str) -> Result<Self, String> {
        if text.len() > LONGEST {
            return Err(format!(
                "the expression is longer than {LONGEST} characters"
            ));
        }
        let tokens = tokens(text)?;
        let mut names: Vec<String> = tokens.iter().filter_map(Token::name).collect();
        names.sort_unstable();
        names.dedup();
        let mut reading = ShuntingYard {
            text,
            names: &names,
            steps: Vec::new(),
            parts: Vec::new(),
            waiting: Vec::new(),
            wants_operand: true,
        };
        tokens.iter().try_for_each(|token| reading.take(token))?;
        let steps = reading.finish()?;
        Ok(Self {
            text: text.to_owned(),
            names,
            steps,
        })
    }

    /// The names in it, each once, in the order of the alphabet.
    pub(super) fn names(&self) -> &[String] {
        &self.names
    }

    /// Its value where its names have these values, in the order of [`names`](Self::names).
    ///
    /// # Errors
    /// The first part of it that is no finite number.
    pub(super) fn value(&self, of_names: &[f64]) -> Result<f64, NotFinite> {
        let mut values: Vec<f64> = Vec::with_capacity(self.steps.len());
        let mut last = f64::NAN;
        for ExpressionStep { operation, part } in &self.steps {
            let mut operand = || values.pop().unwrap_or(f64::NAN);
            last = match operation {
                ExpressionOperation::Number(value) => *value,
                ExpressionOperation::Name(at) => of_names.get(*at).copied().unwrap_or(f64::NAN),
                ExpressionOperation::Negated => -operand(),
                ExpressionOperation::Of(function) => function(operand()),
                ExpressionOperation::OfTwo(function) => {
                    let (right, left) = (operand(), operand());
                    function(left, right)
                }
                ExpressionOperation::Operator(sign) => {
                    let (right, left) = (operand(), operand());
                    applied(*sign, left, right)
                }
            };
            if !last.is_finite() {
                return Err(NotFinite {
                    part: self.text[part.clone()].to_owned(),
                    value: last,
                });
            }
            values.push(last);
        }
        Ok(last)
    }
}

/// The value of an operator between two numbers.
fn applied(sign: char, left: f64, right: f64) -> f64 {
    match sign {
        '+' => left + right,
        '-' => left - right,
        '*' => left * right,
        '/' => left / right,
        _ => left.powf(right),
    }
}

/// How strongly an operator binds.
const fn rank(sign: char) -> u8 {
    match sign {
        '+' | '-' => 1,
        '*' | '/' => 2,
        _ => 3,
    }
}

/// What waits for its operands, or for the end of its parentheses.
#[derive(Debug, Clone, Copy)]
enum Waiting {
    Operator(char),
    /// A sign before an operand, with its place.
    Sign {
        is_minus: bool,
        at: usize,
    },
    /// Parentheses, where they begin with their function, and how many values they have so far.
    Parentheses {
        of: Called,
        at: usize,
        values: usize,
    },
}

/// What parentheses belong to.
#[derive(Debug, Clone, Copy)]
enum Called {
    Nothing,
    One(Function),
    Two(FunctionOfTwo),
}

/// The way through the tokens of an expression, operators waiting until both of their operands are known (Dijkstra's shunting yard).
struct ShuntingYard<'a> {
    text: &'a str,
    names: &'a [String],
    steps: Vec<ExpressionStep>,
    /// The parts of the text whose values are not used yet.
    parts: Vec<Range<usize>>,
    waiting: Vec<Waiting>,
    wants_operand: bool,
}

impl ShuntingYard<'_> {
    fn take(&mut self, token: &Token<'_>) -> Result<(), String> {
        let part = token.place.clone();
        match token.symbol {
            Symbol::Sign(sign @ ('+' | '-')) if self.wants_operand => {
                let (is_minus, at) = (sign == '-', part.start);
                self.waiting.push(Waiting::Sign { is_minus, at });
                Ok(())
            }
            Symbol::Sign(sign) => self.operator(sign, &part),
            Symbol::Comma => self.comma(&part),
            Symbol::Close => self.close(&part),
            Symbol::Open => self.open(Called::Nothing, &part),
            Symbol::Function(function) => self.open(Called::One(function), &part),
            Symbol::FunctionOfTwo(function) => self.open(Called::Two(function), &part),
            Symbol::Number(value) => self.operand(ExpressionOperation::Number(value), part),
            Symbol::Name(name) => {
                let at = self
                    .names
                    .binary_search_by(|known| known.as_str().cmp(name));
                self.operand(ExpressionOperation::Name(at.unwrap_or(usize::MAX)), part)
            }
        }
    }

    fn operand(
        &mut self,
        operation: ExpressionOperation,
        part: Range<usize>,
    ) -> Result<(), String> {
        self.operand_fits(&part)?;
        self.wants_operand = false;
        self.push(operation, part);
        Ok(())
    }

    fn operand_fits(&self, part: &Range<usize>) -> Result<(), String> {
        match self.wants_operand {
            true => Ok(()),
            false => Err(format!("an operator is missing {}", self.before(part))),
        }
    }

    fn open(&mut self, of: Called, part: &Range<usize>) -> Result<(), String> {
        self.operand_fits(part)?;
        let (at, values) = (part.start, 1);
        self.waiting.push(Waiting::Parentheses { of, at, values });
        Ok(())
    }

    fn operator(&mut self, sign: char, part: &Range<usize>) -> Result<(), String> {
        self.operand_is_there(part)?;
        if sign == '^' {
            self.power_is_clear()?;
        }
        self.apply_while(|waiting| match waiting {
            Waiting::Operator(before) => rank(before) >= rank(sign),
            Waiting::Sign { .. } => true,
            Waiting::Parentheses { .. } => false,
        });
        self.waiting.push(Waiting::Operator(sign));
        self.wants_operand = true;
        Ok(())
    }

    fn operand_is_there(&self, part: &Range<usize>) -> Result<(), String> {
        match self.wants_operand {
            false => Ok(()),
            true => Err(format!(
                "a number or a name is missing {}",
                self.before(part)
            )),
        }
    }

    /// Whether a power is read in one way: not that of `-a^2`, which some read as `(-a)^2`, nor that of `a^b^c`, which some read as `(a^b)^c`.
    fn power_is_clear(&self) -> Result<(), String> {
        match self.waiting.last() {
            Some(Waiting::Sign { .. }) => {
                let base = self
                    .parts
                    .last()
                    .map_or("", |part| &self.text[part.clone()]);
                Err(format!(
                    "a sign before a power can be read in two ways: write -({base}^...) or (-{base})^..."
                ))
            }
            Some(Waiting::Operator('^')) => Err(
                "a power of a power can be read in two ways: write (a^b)^c or a^(b^c)".to_owned(),
            ),
            _ => Ok(()),
        }
    }

    fn comma(&mut self, part: &Range<usize>) -> Result<(), String> {
        self.operand_is_there(part)?;
        self.apply_all();
        match self.waiting.last_mut() {
            Some(Waiting::Parentheses {
                of: Called::Two(_),
                values,
                ..
            }) => {
                *values += 1;
                self.wants_operand = true;
                Ok(())
            }
            _ => Err(format!(
                "a comma stands between the two values of min, max and atan2 only (character {}); write a decimal point",
                self.character(part.start)
            )),
        }
    }

    fn close(&mut self, part: &Range<usize>) -> Result<(), String> {
        self.operand_is_there(part)?;
        self.apply_all();
        let Some(Waiting::Parentheses { of, at, values }) = self.waiting.pop() else {
            return Err(format!(
                "`)` closes nothing (character {})",
                self.character(part.start)
            ));
        };
        let part = at..part.end;
        match of {
            Called::Nothing => {
                if let Some(inner) = self.parts.last_mut() {
                    *inner = part;
                }
            }
            Called::One(function) => self.apply(ExpressionOperation::Of(function), 1, part),
            Called::Two(function) if values == 2 => {
                self.apply(ExpressionOperation::OfTwo(function), 2, part);
            }
            Called::Two(_) => {
                let call = &self.text[part];
                return Err(format!("`{call}` has {values} of the 2 values it takes"));
            }
        }
        Ok(())
    }

    fn finish(mut self) -> Result<Vec<ExpressionStep>, String> {
        if self.steps.is_empty() && self.waiting.is_empty() {
            return Err("it is empty".to_owned());
        }
        if self.wants_operand {
            return Err("a number or a name is missing at its end".to_owned());
        }
        self.apply_all();
        match self.waiting.last() {
            Some(Waiting::Parentheses { at, .. }) => Err(format!(
                "`)` is missing for the parentheses at character {}",
                self.character(*at)
            )),
            _ => Ok(self.steps),
        }
    }

    /// Applies what waits since the last parentheses.
    fn apply_all(&mut self) {
        self.apply_while(|waiting| !matches!(waiting, Waiting::Parentheses { .. }));
    }

    fn apply_while(&mut self, binds: impl Fn(Waiting) -> bool) {
        while let Some(waiting) = self.waiting.pop_if(|waiting| binds(*waiting)) {
            let part = self.parts.last().cloned().unwrap_or_default();
            match waiting {
                Waiting::Sign { is_minus: true, at } => {
                    self.apply(ExpressionOperation::Negated, 1, at..part.end);
                }
                Waiting::Operator(sign) => {
                    let left = self.parts.iter().rev().nth(1);
                    let start = left.map_or(part.start, |left| left.start);
                    self.apply(ExpressionOperation::Operator(sign), 2, start..part.end);
                }
                Waiting::Sign { .. } | Waiting::Parentheses { .. } => {}
            }
        }
    }

    /// Uses so many values for a new one.
    fn apply(&mut self, operation: ExpressionOperation, operands: usize, part: Range<usize>) {
        self.parts
            .truncate(self.parts.len().saturating_sub(operands));
        self.push(operation, part);
    }

    fn push(&mut self, operation: ExpressionOperation, part: Range<usize>) {
        self.parts.push(part.clone());
        self.steps.push(ExpressionStep { operation, part });
    }

    fn before(&self, part: &Range<usize>) -> String {
        let character = self.character(part.start);
        format!(
            "before `{}` (character {character})",
            &self.text[part.clone()]
        )
    }

    /// The character at a byte, from 1.
    fn character(&self, at: usize) -> usize {
        self.text[..at].chars().count() + 1
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn value(text: &str) -> f64 {
        let read = Expression::read(text).unwrap();
        assert_eq!(read.names(), &[] as &[String], "{text}");
        read.value(&[]).unwrap()
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
            ("8 * 6 / 4 - 2 + 5", 15.0),
            ("sin(30 * pi / 180)", 0.5),
            ("atan2(1, 1) * 4", std::f64::consts::PI),
            ("sinh(asinh(2))", 2.0),
            ("round(2.6) + floor(-0.5) + ceil(0.2)", 3.0),
            ("-2 * -3", 6.0),
            ("2^-3 * 4", 0.5),
            ("+ - -3", 3.0),
            ("{pi} / pi", 1.0),
            ("min(2, max(5, min(1, 3)))", 2.0),
            ("1e3/1E+3+5.-.5", 5.5),
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
        assert_eq!(read.value(&[1.0, 10.0]), Ok(11.0));
    }

    #[test]
    fn what_is_no_expression_is_refused_at_its_place() {
        let nested = format!("{}1{}", "(".repeat(95), ")".repeat(95));
        assert_eq!(value(&nested), 1.0);
        for (text, why) in [
            ("", "it is empty"),
            (" ", "it is empty"),
            ("(", "missing at its end"),
            (")", "missing before `)` (character 1)"),
            ("1 +", "missing at its end"),
            ("* 2", "missing before `*`"),
            ("1 2", "an operator is missing before `2` (character 3)"),
            ("a b", "an operator is missing before `b`"),
            ("2p", "an operator is missing before `p`"),
            ("2(p)", "an operator is missing before `(`"),
            ("sin", "`sin` takes its values in parentheses: sin(...)"),
            ("sin x", "in parentheses"),
            ("sin(", "missing at its end"),
            ("sin(1", "`)` is missing for the parentheses at character 1"),
            ("(1))", "`)` closes nothing (character 4)"),
            ("max(1)", "`max(1)` has 1 of the 2 values it takes"),
            ("min(1,2,3)", "`min(1,2,3)` has 3 of the 2 values it takes"),
            ("sin(1,2)", "a comma stands between"),
            ("1,5 * p", "write a decimal point"),
            ("1..2", "an operator is missing before `.2`"),
            (".", "`.` is no part of an expression (character 1)"),
            ("é^", "missing at its end"),
            ("^", "missing before `^`"),
            ("()^2", "missing before `)`"),
            (")^(", "missing before `)`"),
            ("{x", "`{` is not closed by `}` (character 1)"),
            ("2 * {x", "`{` is not closed by `}` (character 5)"),
            ("x}", "`}` is no part of an expression"),
            ("\"a\"", "`\"` is no part"),
            ("1 ; 2", "`;` is no part of an expression (character 3)"),
            ("25 m", "an operator is missing before `m`"),
            ("x=1", "`=` is no part"),
        ] {
            let fault = Expression::read(text).unwrap_err();
            assert!(fault.contains(why), "{text}: {fault}");
        }
        assert!(Expression::read(&"1+".repeat(200)).is_err());
        for text in ["ρ", "-".repeat(199).as_str()] {
            drop(Expression::read(text));
        }
    }

    #[test]
    fn no_part_of_an_expression_hides_that_it_is_no_number() {
        for (text, part, is_nan) in [
            ("min(sqrt(x - 1), 9)", "sqrt(x - 1)", true),
            ("max(9, sqrt(x - 1))", "sqrt(x - 1)", true),
            ("atan(1 / x)", "1 / x", false),
            ("exp(-(1 / x))", "1 / x", false),
            ("1 / (1 / x)", "1 / x", false),
            ("0 * ln(x)", "ln(x)", false),
            ("1 / exp(1e3 + x)", "exp(1e3 + x)", false),
            ("min(1e999, 2)", "1e999", false),
            ("tanh(-1e300 * 1e300 + x)", "-1e300 * 1e300", false),
            ("x + asin(2)", "asin(2)", true),
            ("(x / x)^0", "x / x", true),
            ("x^-1", "x^-1", false),
        ] {
            let read = Expression::read(text).unwrap();
            let found = read.value(&[0.0]).unwrap_err();
            assert_eq!(found.part, part, "{text}");
            assert_eq!(found.value.is_nan(), is_nan, "{text}: {found:?}");
        }
    }
}
