//! Exercises whose answer the engine checks.

use serde_json::{Value as Json, json};

use crate::block::Block;
use crate::fault::Fault;
use crate::solved::{Given, Solved, point};
use crate::value::Reference;

pub(crate) const KEYS: [&str; 6] = ["id", "figure", "task", "check", "hint", "solution"];
pub(crate) const WORDS: [&str; 3] = ["id", "task", "hint"];
/// What is checked without a tolerance is a result of a few operations on doubles.
const USUAL_TOLERANCE: f64 = 1e-6;

/// An exercise.
#[derive(Debug, Clone)]
pub(crate) struct Exercise {
    pub(crate) id: String,
    pub(crate) figure: Option<String>,
    pub(crate) hint: String,
    pub(crate) checks: Vec<Check>,
    pub(crate) solution: Vec<Given>,
    pub(crate) block: Block,
}

/// What must hold.
#[derive(Debug, Clone)]
pub(crate) struct Check {
    pub(crate) left: Side,
    pub(crate) relation: char,
    pub(crate) right: Side,
    pub(crate) tolerance: f64,
}

/// One side of a check.
#[derive(Debug, Clone)]
pub(crate) enum Side {
    /// What the reader types.
    Answer,
    /// A value of the figure.
    Value(Reference),
    /// A number, a point, a boolean or a text.
    Constant(Json),
}

impl Exercise {
    pub(crate) fn read(block: &Block, ids: &[String]) -> Result<Self, Fault> {
        let checks: Vec<Check> = block
            .all("check")
            .map(|entry| {
                Check::read(&entry.value, ids).map_err(|why| Fault::new(&block.file, entry.line, why))
            })
            .collect::<Result<_, Fault>>()?;
        if checks.is_empty() {
            return Err(block.fault("check", "an exercise has at least one check"));
        }
        let solution = block
            .list("solution")
            .iter()
            .map(|text| Given::read(text).map_err(|why| block.fault("solution", why)))
            .collect::<Result<Vec<_>, Fault>>()?;
        if solution.is_empty() {
            return Err(block.fault("solution", "an exercise has a solution, so that it can be tried"));
        }
        block.needed("task")?;
        Ok(Self {
            id: block.needed("id")?.to_owned(),
            figure: block.get("figure").map(str::to_owned),
            hint: block.get("hint").unwrap_or_default().to_owned(),
            checks,
            solution,
            block: block.clone(),
        })
    }

    /// Whether the reader types a number.
    pub(crate) fn asks(&self) -> bool {
        self.checks.iter().any(|check| matches!(check.left, Side::Answer))
    }

    /// Tries the solution: it must hold, and the definition as it stands must not.
    pub(crate) fn tried(&self, definition: &str, start: &Solved) -> Result<(), String> {
        let (typed, given): (Vec<Given>, Vec<Given>) =
            self.solution.iter().cloned().partition(|one| one.name == "answer");
        let typed = typed.first().and_then(|one| one.value.parse::<f64>().ok());
        let end = Solved::run(definition, &given)?;
        if !self.holds(&end, typed)? {
            return Err("the solution does not pass the checks".to_owned());
        }
        if self.holds(start, None)? {
            return Err("the checks hold before anything is done".to_owned());
        }
        Ok(())
    }

    fn holds(&self, solved: &Solved, typed: Option<f64>) -> Result<bool, String> {
        let mut all = true;
        for check in &self.checks {
            all &= check.holds(solved, typed)?;
        }
        Ok(all)
    }
}

impl Check {
    fn read(text: &str, ids: &[String]) -> Result<Self, String> {
        let place = text.find(['=', '<', '>']).ok_or_else(|| format!("'{text}' has none of =, < and >"))?;
        let (left, rest) = text.split_at(place);
        let relation = rest.chars().next().unwrap_or('=');
        let rest = rest.trim_start_matches(['=', '<', '>']);
        let (right, tolerance) = match rest.split_once('±').or_else(|| rest.split_once("+-")) {
            Some((right, tolerance)) => {
                let told = tolerance.trim().parse::<f64>().ok().filter(|x| x.is_finite() && *x >= 0.0);
                (right, told.ok_or_else(|| format!("'{}' is no tolerance", tolerance.trim()))?)
            }
            None => (rest, USUAL_TOLERANCE),
        };
        let left = match left.trim() {
            "answer" => Side::Answer,
            name => Side::Value(Reference::read(name, ids)?),
        };
        Ok(Self { left, relation, right: Side::constant(right.trim(), ids)?, tolerance })
    }

    fn holds(&self, solved: &Solved, typed: Option<f64>) -> Result<bool, String> {
        let value = |side: &Side| match side {
            Side::Answer => Ok(typed.map_or(Json::Null, |x| json!(x))),
            Side::Constant(constant) => Ok(constant.clone()),
            Side::Value(reference) => {
                let at = solved.output(&reference.name)?;
                reference.pick(solved.items(at).0)
            }
        };
        let (left, right) = (value(&self.left)?, value(&self.right)?);
        Ok(related(&left, self.relation, &right, self.tolerance))
    }
}

impl Side {
    fn constant(text: &str, ids: &[String]) -> Result<Self, String> {
        if let Some(p) = point(text) {
            return Ok(Self::Constant(json!([p.x, p.y, p.z])));
        }
        if let Ok(x) = text.replace('−', "-").parse::<f64>() {
            return if x.is_finite() {
                Ok(Self::Constant(json!(x)))
            } else {
                Err(format!("'{text}' is no number"))
            };
        }
        if let Some(inner) = text.strip_prefix('"').and_then(|rest| rest.strip_suffix('"')) {
            return Ok(Self::Constant(json!(inner)));
        }
        match text {
            "true" => Ok(Self::Constant(json!(true))),
            "false" => Ok(Self::Constant(json!(false))),
            name => Reference::read(name, ids).map(Self::Value),
        }
    }
}

/// Whether two values are as they should be: numbers within a tolerance, lists of numbers one by one, all else the same.
fn related(left: &Json, relation: char, right: &Json, tolerance: f64) -> bool {
    match (left, right) {
        (Json::Number(a), Json::Number(b)) => {
            let (Some(a), Some(b)) = (a.as_f64(), b.as_f64()) else { return false };
            match relation {
                '<' => a < b,
                '>' => a > b,
                _ => (a - b).abs() <= tolerance,
            }
        }
        (Json::Array(a), Json::Array(b)) if relation == '=' => {
            a.len() == b.len() && a.iter().zip(b).all(|(a, b)| related(a, relation, b, tolerance))
        }
        _ => relation == '=' && left == right,
    }
}
