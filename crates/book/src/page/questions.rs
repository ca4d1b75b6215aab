//! Steps, predictions and exercises.

use katydid_session::protocol::ExplanationView;
use serde_json::{Value as Json, json};

use super::Page;
use crate::exercise::{Check, Exercise, Side};
use crate::fault::Fault;
use crate::figure::Figure;
use crate::html::{attributes, data, escaped};
use crate::read::Source;
use crate::steps;

impl<'a> Page<'a> {
    pub(super) fn steps_block(&mut self) -> String {
        let source: &'a Source = self.source;
        let Some(block) = source.steps.get(self.steps) else { return String::new() };
        self.steps += 1;
        let made = self.figure(block.figure.as_deref()).and_then(|figure| {
            let solved = self.solved(figure)?;
            let none = || format!("the definition has no object '{}'", block.object);
            let place = solved.object(&block.object).ok_or_else(none)?;
            let told = katydid_session::explain(solved.session.engine(), place, block.algorithm)?;
            let id = solved.session.document().objects.get(place).map(|object| object.id.to_string());
            let pairs = [
                ("data-figure", Some(figure.id.clone())),
                ("data-object", id),
                ("data-algorithm", Some(told.algorithm.name().to_owned())),
            ];
            let listed = steps::listed(&ExplanationView::from(&told));
            Ok(format!("<div class=\"steps\"{}>{listed}</div>\n", attributes(&pairs)))
        });
        made.unwrap_or_else(|why| {
            let line = block.block.line_of("object");
            self.faults.push(Fault::new(&block.block.file, line, why));
            String::new()
        })
    }

    pub(super) fn predict_block(&mut self, line: usize, text: &str) -> String {
        // The line between the question and the answer.
        let mut before = Vec::new();
        let mut after: Option<Vec<&str>> = None;
        for row in text.lines() {
            match &mut after {
                None if row.trim() == "---" => after = Some(Vec::new()),
                None => before.push(row),
                Some(after) => after.push(row),
            }
        }
        let Some(after) = after else {
            self.fault(line, "a prediction has an answer behind a line of ---");
            return String::new();
        };
        let choice = |row: &&str| row.starts_with("( ) ") || row.starts_with("(x) ");
        let choices: Vec<(usize, &str)> =
            before.iter().enumerate().filter(|(_, row)| choice(row)).map(|(i, row)| (i, *row)).collect();
        let question: Vec<&str> = before.iter().map(|row| if choice(row) { "" } else { row }).collect();
        if !choices.is_empty() && choices.iter().filter(|(_, row)| row.starts_with("(x)")).count() != 1 {
            self.fault(line, "one of the choices is right: (x)");
        }
        let words = self.edition.words.clone();
        let question = self.markdown(&question.join("\n"), line);
        let items: String = choices
            .iter()
            .map(|(i, row)| {
                let right = if row.starts_with("(x)") { " data-right=\"yes\"" } else { "" };
                format!("<li{right}>{}</li>", self.words(&row[4..], line + 1 + i))
            })
            .collect();
        let list =
            if items.is_empty() { String::new() } else { format!("<ul class=\"choices\">{items}</ul>") };
        let answer = self.markdown(&after.join("\n"), line + before.len() + 1);
        format!(
            "<section class=\"predict\" aria-label=\"{}\">{question}{list}<details><summary>{}</summary>{answer}</details></section>\n",
            escaped(words.get("predict")),
            escaped(words.get("show")),
        )
    }

    pub(super) fn exercise_block(&mut self) -> String {
        let source: &'a Source = self.source;
        let Some(exercise) = source.exercises.get(self.exercises) else { return String::new() };
        self.exercises += 1;
        let made = self.figure(exercise.figure.as_deref()).and_then(|figure| {
            let solved = self.solved(figure)?;
            let checks = exercise
                .checks
                .iter()
                .map(|check| self.check(check, figure))
                .collect::<Result<Vec<_>, _>>()?;
            if self.edition.folder.is_empty() {
                exercise.tried(&self.builder.text(&figure.definition)?, &solved)?;
            }
            Ok(json!({"figure": figure.id, "checks": checks, "asks": exercise.asks()}))
        });
        let told = match made {
            Ok(told) => told,
            Err(why) => {
                let line = exercise.block.line_of("check");
                self.faults.push(Fault::new(&exercise.block.file, line, why));
                return String::new();
            }
        };
        let task = self.entry(&exercise.block, "task");
        let hint = self.entry(&exercise.block, "hint");
        let words = &self.edition.words;
        let hint = if exercise.hint.is_empty() {
            String::new()
        } else {
            format!("<details><summary>{}</summary><p>{hint}</p></details>", escaped(words.get("hint")))
        };
        self.out.ids.push(exercise.id.clone());
        format!(
            "<section class=\"exercise\" id=\"{}\" aria-label=\"{}\"><script type=\"application/json\">{}</script><p>{task}</p>{hint}\
             <details><summary>{}</summary><p>{}</p></details></section>\n",
            escaped(&exercise.id),
            escaped(words.get("exercise")),
            data(&told),
            escaped(words.get("solution")),
            escaped(&solution(exercise)),
        )
    }

    pub(super) fn check(&self, check: &Check, figure: &Figure) -> Result<Json, String> {
        let side = |side: &Side| -> Result<Json, String> {
            match side {
                Side::Answer => Ok(json!({"is": "answer"})),
                Side::Constant(value) => Ok(json!({"is": "constant", "value": value})),
                Side::Value(reference) => {
                    let solved = self.solved(figure)?;
                    let at = solved.output(&reference.name)?;
                    let id = solved.session.document().objects.get(at.0).map(|object| object.id.to_string());
                    Ok(json!({
                        "is": "value", "object": id, "output": at.1, "item": reference.item, "axis": reference.axis,
                    }))
                }
            }
        };
        Ok(json!({
            "left": side(&check.left)?,
            "relation": check.relation.to_string(),
            "right": side(&check.right)?,
            "tolerance": check.tolerance,
        }))
    }
}

fn solution(exercise: &Exercise) -> String {
    let one = |given: &crate::solved::Given| match given.index {
        Some(index) => format!("{}[{index}] = {}", given.name, given.value),
        None => format!("{} = {}", given.name, given.value),
    };
    exercise.solution.iter().map(one).collect::<Vec<_>>().join(", ")
}
