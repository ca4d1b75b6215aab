//! The steps of an algorithm on a page.

use katydid_geometry::explain::Algorithm;
use katydid_session::protocol::{ExplanationView, NumberView, QuantityView, StepView};

use crate::block::Block;
use crate::fault::Fault;
use crate::html::escaped;
use crate::value::{Style, number};

pub(crate) const KEYS: [&str; 3] = ["object", "algorithm", "figure"];
/// Digits after the point of numbers that are no fractions.
const DIGITS: usize = 4;

/// The steps of the result of an object.
#[derive(Debug, Clone)]
pub(crate) struct Steps {
    pub(crate) object: String,
    pub(crate) algorithm: Option<Algorithm>,
    pub(crate) figure: Option<String>,
    pub(crate) block: Block,
}

impl Steps {
    pub(crate) fn read(block: &Block) -> Result<Self, Fault> {
        let algorithm = match block.get("algorithm") {
            None => None,
            Some(name) => Some(Algorithm::from_name(name).ok_or_else(|| {
                let known = Algorithm::ALL.map(Algorithm::name).join(", ");
                block.fault("algorithm", format!("'{name}' is none of {known}"))
            })?),
        };
        Ok(Self {
            object: block.needed("object")?.to_owned(),
            algorithm,
            figure: block.get("figure").map(str::to_owned),
            block: block.clone(),
        })
    }
}

/// An explanation as a list of rounds, each a list of steps. The page's script writes the same.
pub(crate) fn listed(told: &ExplanationView) -> String {
    let line = |quantity: &QuantityView| format!("<li>{}</li>", equation(quantity, ""));
    let lines = |list: &[QuantityView]| list.iter().map(line).collect::<String>();
    let rounds: String = told
        .rounds
        .iter()
        .map(|round| {
            format!(
                "<li><ul>{}</ul></li>",
                round
                    .iter()
                    .map(|step| format!("<li class=\"step\">{}</li>", written(step)))
                    .collect::<String>()
            )
        })
        .collect();
    format!(
        "<ul class=\"given\">{}</ul><ol class=\"rounds\">{rounds}</ol><ul class=\"result\">{}</ul>",
        lines(&told.given),
        lines(&told.result)
    )
}

fn written(step: &StepView) -> String {
    let mut rule = String::new();
    if !step.rule.is_empty() {
        rule = format!(" = {}", escaped(&step.rule));
    }
    for (place, term) in step.terms.iter().enumerate() {
        let sign = if place == 0 { " = " } else { " + " };
        let factor = numeral(&term.factor);
        let factor = if factor.starts_with('−') && place > 0 { format!("({factor})") } else { factor };
        rule.push_str(&format!("{sign}{} {}", escaped(&factor), name(&term.name)));
    }
    equation(&step.made, &rule)
}

fn equation(quantity: &QuantityView, rule: &str) -> String {
    let numbers: Vec<String> = quantity.numbers.iter().map(numeral).collect();
    let value = match numbers.as_slice() {
        [one] => one.clone(),
        many => format!("({})", many.join(", ")),
    };
    format!("{}{rule} = <b>{}</b>", name(&quantity.name), escaped(&value))
}

fn name(text: &str) -> String {
    format!("<i>{}</i>", escaped(text))
}

fn numeral(number_view: &NumberView) -> String {
    match &number_view.exact {
        Some(exact) => exact.replace('-', "−"),
        None => number(number_view.value, Style::Digits(DIGITS)),
    }
}
