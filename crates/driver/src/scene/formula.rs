//! Expressions in the coordinates of the points of a body, and in the load factor of a step.

use crate::case::LOAD_FACTOR;
use exmex::{BinOp, Express, FlatEx, FloatOpsFactory, MakeOperators, MatchLiteral, Operator};
use peristat_assembly::body::PointBody;

/// Longest expression, in characters.
const LONGEST: usize = 4000;

exmex::literal_matcher_from_pattern!(Number, r"^(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?");

/// The operators of the parser without a minus in front of a factor: it would bind tighter than a power, and `-x^2` be (−x)². None
/// commutes: the parser folds constants of operators that do, and then applies the function around them to a part of its argument.
#[derive(Clone, Debug)]
struct Operators;

impl MakeOperators<f64> for Operators {
    fn make<'a>() -> Vec<Operator<'a, f64>> {
        let minus = || Operator::make_bin("-", BinOp { apply: |a, b| a - b, prio: 1, is_commutative: false });
        let in_order = |operator: Operator<'a, f64>| {
            let Ok(bin) = operator.bin() else { return operator };
            let bin = BinOp { is_commutative: false, ..bin };
            match operator.unary() {
                Ok(unary) => Operator::make_bin_unary(operator.repr(), bin, unary),
                Err(_) => Operator::make_bin(operator.repr(), bin),
            }
        };
        let with_two =
            |operator: Operator<'a, f64>| if operator.repr() == "-" { minus() } else { in_order(operator) };
        FloatOpsFactory::<f64>::make().into_iter().map(with_two).collect()
    }
}

/// Names that are no functions.
const NAMES: [&str; 7] = ["x", "y", "z", "pi", "e", "π", LOAD_FACTOR];

/// Where the load factor stands among the variables, behind the coordinates.
const FACTOR: usize = 3;

/// Refuses names that neither are known nor have parentheses behind them: `sin x^2` could mean two things.
fn check_names(text: &str) -> Result<(), String> {
    let mut rest = text;
    while let Some(start) = rest.find(|c: char| c.is_alphanumeric()) {
        let word = &rest[start..];
        let end = word.find(|c: char| !c.is_alphanumeric() && c != '_' && c != '.').unwrap_or(word.len());
        let (word, behind) = word.split_at(end);
        let is_number = word.starts_with(|c: char| c.is_ascii_digit());
        if !is_number && !NAMES.contains(&word) && !behind.trim_start().starts_with('(') {
            return Err(format!("there is no `{word}` in formulas, or it lacks its parentheses"));
        }
        rest = behind;
    }
    if text.contains(['{', '}', '[', ']']) { Err("brackets of formulas are round".into()) } else { Ok(()) }
}

/// Functions of two arguments.
const OF_TWO: [&str; 3] = ["min", "max", "atan2"];

/// The expression with functions of two arguments between them, in parentheses: the parser does not take them within each other.
fn with_infixes(text: &str) -> Result<String, String> {
    let (mut out, mut rest) = (String::with_capacity(2 * text.len()), text);
    while let Some(start) = rest.find(char::is_alphabetic) {
        let (before, word) = rest.split_at(start);
        let (name, behind) = word.split_at(word.find(|c: char| !c.is_alphanumeric()).unwrap_or(word.len()));
        out.push_str(before);
        rest = behind;
        if !OF_TWO.contains(&name) {
            out.push_str(name);
            continue;
        }
        let Some(([first, second], after)) = arguments(behind.trim_start()) else {
            return Err(format!("`{name}` has two arguments, `{name}(a, b)`"));
        };
        out.push_str(&format!("(({}) {name} ({}))", with_infixes(first)?, with_infixes(second)?));
        rest = after;
    }
    out.push_str(rest);
    Ok(out)
}

/// Two arguments in parentheses, and what is behind them.
fn arguments(text: &str) -> Option<([&str; 2], &str)> {
    let (mut depth, mut comma) = (0, None);
    for (k, c) in text.char_indices() {
        match c {
            '(' => depth += 1,
            ')' if depth == 1 => {
                let comma: usize = comma?;
                return Some(([&text[1..comma], &text[comma + 1..k]], &text[k + 1..]));
            }
            ')' => depth -= 1,
            ',' if depth == 1 && comma.replace(k).is_some() => return None,
            _ if depth == 0 => return None,
            _ => {}
        }
    }
    None
}

/// The expression with a zero before every minus that begins it or a part of it in parentheses, and no sign twice.
fn with_zeros(text: &str) -> Result<String, String> {
    let (mut out, mut before, mut powers) = (String::with_capacity(text.len() + 8), '(', vec![0]);
    for c in text.chars() {
        match c {
            '-' | '+' if before == '(' || before == ',' => out.push('0'),
            '-' | '+' if "*/^+-".contains(before) => {
                return Err(format!("a sign behind `{before}` needs parentheses"));
            }
            '(' => powers.push(0),
            ')' => drop(powers.pop()),
            _ => {}
        }
        if let Some(powers) = powers.last_mut() {
            *powers = if c == '^' {
                *powers + 1
            } else if "*/+-,".contains(c) {
                0
            } else {
                *powers
            };
            if *powers > 1 {
                return Err("a power of a power needs parentheses".into());
            }
        }
        if !c.is_whitespace() {
            before = c;
        }
        out.push(c);
    }
    Ok(out)
}

/// Values of an expression in x and y, and z of a solid, at the points of a body, images left out.
///
/// # Errors
/// What is wrong with the expression, or where it has no value.
pub(crate) fn values(text: &str, body: &PointBody) -> Result<Vec<f64>, String> {
    let formula = Formula::new(text, body.axes(), None)?;
    (0..body.points()).map(|k| formula.at(body.position(k))).collect()
}

/// A parsed expression.
#[derive(Clone, Debug)]
pub(crate) struct Formula {
    parsed: FlatEx<f64, Operators, Number>,
    /// For each of its variables the axis that it is a position on, or that it is the load factor.
    variables: Vec<usize>,
    factor: f64,
}

impl Formula {
    /// An expression in the first coordinates, and in the load factor where there is one.
    ///
    /// # Errors
    /// What is wrong with it.
    pub(crate) fn new(text: &str, coordinates: usize, factor: Option<f64>) -> Result<Self, String> {
        if text.chars().count() > LONGEST {
            return Err(format!("a formula has at most {LONGEST} characters"));
        }
        let text = text.replace(char::is_whitespace, " ");
        check_names(&text)?;
        // After the check no other name holds these letters.
        let parsed = with_infixes(&text.replace("pi", "PI")).and_then(|text| with_zeros(&text))?;
        let parsed = FlatEx::<f64, Operators, Number>::parse(&parsed)
            .map_err(|error| format!("this is no formula: {error}"))?;
        let axis = |name: &String| match name.as_str() {
            LOAD_FACTOR if factor.is_some() => Ok(FACTOR),
            LOAD_FACTOR => Err(format!(
                "`{LOAD_FACTOR}` is known to loads, and to motions of bodies and plates, that `steps` follow"
            )),
            "x" | "y" | "z" if coordinates == 0 => Err(format!("`{name}` is nothing that this varies with")),
            "x" => Ok(0),
            "y" if coordinates > 1 => Ok(1),
            "y" => Err("there is no `y` on a line".to_string()),
            "z" if coordinates > 2 => Ok(2),
            "z" if coordinates > 1 => Err("there is no `z` in the plane".to_string()),
            "z" => Err("there is no `z` on a line".to_string()),
            other => Err(format!("there is no `{other}` in formulas")),
        };
        let variables = parsed.var_names().iter().map(axis).collect::<Result<_, _>>()?;
        Ok(Self { parsed, variables, factor: factor.unwrap_or(1.0) })
    }

    /// Whether it has the same value everywhere.
    pub(crate) fn is_constant(&self) -> bool {
        self.variables.iter().all(|variable| *variable == FACTOR)
    }

    /// Its value at a position.
    ///
    /// # Errors
    /// It has none there.
    pub(crate) fn at(&self, place: [f64; 3]) -> Result<f64, String> {
        let [x, y, z] = place;
        let all = [x, y, z, self.factor];
        let values: Vec<f64> = self.variables.iter().map(|variable| all[*variable]).collect();
        let value = self.parsed.eval(&values).map_err(|error| error.to_string())?;
        match value.is_finite() {
            true => Ok(value),
            false => Err(format!("the formula is {value} at the point ({}, {})", place[0], place[1])),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(text: &str, x: f64, y: f64) -> Result<f64, String> {
        Formula::new(text, 2, None)?.at([x, y, 0.0])
    }

    #[test]
    fn the_load_factor_is_a_number_where_there_are_steps() {
        let at = |text: &str, factor| Formula::new(text, 2, factor)?.at([2.0, 3.0, 0.0]);
        assert_eq!(at("x*load_factor^2 + y", Some(0.5)), Ok(3.5));
        assert_eq!(at("max(load_factor, x)", Some(7.0)), Ok(7.0));
        assert!(at("load_factor*x", None).unwrap_err().contains("that `steps` follow"));
        assert!(Formula::new("2*load_factor", 2, Some(1.0)).unwrap().is_constant());
        assert!(Formula::new("2*x", 0, Some(1.0)).unwrap_err().contains("nothing that this varies with"));
    }

    #[test]
    fn expressions_mean_what_mathematics_says() {
        // By hand, at x = 2, y = 3.
        for (text, value) in [
            ("1e-3*x - 2*y^2", -17.998),
            ("-x^2", -4.0),
            ("y*(-x^2)", -12.0),
            ("+x - -0", f64::NAN),
            ("2^(-1)", 0.5),
            ("x-1-1", 0.0),
            ("12/3/2*x", 4.0),
            ("1.5E-3*y", 4.5e-3),
            ("sqrt(x^2 + y^2)", 13f64.sqrt()),
            ("atan2(y, -x)", 3f64.atan2(-2.0)),
            ("2*x^2/4*y", 6.0),
            ("(x^2)^2", 16.0),
            ("cos(pi*x) + log(e)", 2.0),
            ("sin (pi/x)\t+ min(x, y)", 3.0),
            ("7", 7.0),
            // Constants behind a variable, in a function.
            ("cos(x*2*pi)", 1.0),
            ("sin(x*3*2)", 12f64.sin()),
            ("sqrt(x^2 + y^2 + 1 + 2)", 4.0),
            ("sin(1 + y*pi + 2)", (3.0 + 3.0 * std::f64::consts::PI).sin()),
            ("abs(x - 3 - 4)*2*3", 30.0),
            ("exp(2*3*x/12)", 1f64.exp()),
            // Functions of two in functions of two.
            ("min(1, max(0, x))", 1.0),
            ("max(min(x, y), min(5, max(y, 1)))", 3.0),
            ("2*max(min(x + 1, y*2) - 1, 0)^2", 8.0),
            ("atan2(max(x, 0), -(x))", 2f64.atan2(-2.0)),
        ] {
            match at(text, 2.0, 3.0) {
                Ok(found) => assert!((found - value).abs() <= 1e-15 * value.abs(), "{text}: {found}"),
                Err(reason) => assert!(value.is_nan() && reason.contains("parentheses"), "{text}: {reason}"),
            }
        }
    }

    #[test]
    fn what_is_no_number_is_refused() {
        for (text, reason) in [
            ("", "no formula"),
            ("x y", "no formula"),
            ("(x", "no formula"),
            ("2*z", "no `z`"),
            ("2*-x", "parentheses"),
            ("x^y^2", "parentheses"),
            ("1/(x - 2)", "inf at the point (2, 3)"),
            ("sqrt(-x)", "NaN"),
            ("sin x^2", "parentheses"),
            ("x atan2 y", "parentheses"),
            ("pix", "no `pix`"),
            ("min(x)", "two arguments"),
            ("max(x, y, 1)", "two arguments"),
            ("min(x, y", "two arguments"),
            ("min()", "two arguments"),
            ("{x}", "round"),
            ("x; y", "formula"),
        ] {
            let found = at(text, 2.0, 3.0).unwrap_err();
            assert!(found.contains(reason), "{text}: {found}");
        }
        assert!(at(&"(".repeat(3000), 2.0, 3.0).is_err());
        assert!(at(&"x+".repeat(3000), 2.0, 3.0).unwrap_err().contains("4000"));
    }
}
