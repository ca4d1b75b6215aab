//! Values in the text, numbers that are dragged, and formulas.

use super::Page;
use crate::fault::Fault;
use crate::html::{attributes, escaped};
use crate::maths::{self, Tie};
use crate::value::{Mark, Reference, Style};

impl Page<'_> {
    pub(super) fn mark(&mut self, mark: &str, line: usize) -> String {
        let result = Mark::read(&self.source.file, line, mark, &self.ids).and_then(|mark| {
            let told = |why: String| Fault::new(&self.source.file, line, why);
            match mark {
                Mark::Value(reference) => self.live(&reference).map_err(told),
                Mark::Drag(reference) => self.drag(&reference).map_err(told),
            }
        });
        match result {
            Ok(html) => html,
            Err(fault) => {
                self.faults.push(fault);
                String::new()
            }
        }
    }

    /// Where the script finds a value, and the value in words.
    pub(super) fn value(&self, reference: &Reference) -> Result<(String, String), String> {
        let figure = self.figure(reference.figure.as_deref())?;
        let solved = self.solved(figure)?;
        let at = solved.output(&reference.name)?;
        let (items, is_vector) = solved.items(at);
        let text = reference.written(&reference.pick(items)?, is_vector && reference.axis.is_none());
        let objects = &solved.session.document().objects;
        let id = objects.get(at.0).map(|object| object.id.to_string());
        let style = match reference.style {
            Style::Fraction => "fraction".to_owned(),
            Style::Digits(digits) => digits.to_string(),
        };
        let pairs = [
            ("data-figure", Some(figure.id.clone())),
            ("data-object", id),
            ("data-output", Some(at.1.to_string())),
            ("data-item", reference.item.map(|item| item.to_string())),
            ("data-axis", reference.axis.map(|axis| axis.to_string())),
            ("data-style", Some(style)),
            ("data-vector", is_vector.then(|| "yes".to_owned())),
        ];
        Ok((attributes(&pairs), text))
    }

    pub(super) fn live(&self, reference: &Reference) -> Result<String, String> {
        let (attributes, text) = self.value(reference)?;
        Ok(format!("<span class=\"live\"{attributes}>{}</span>", escaped(&text)))
    }

    pub(super) fn drag(&self, reference: &Reference) -> Result<String, String> {
        let figure = self.figure(reference.figure.as_deref())?;
        let solved = self.solved(figure)?;
        let slider =
            solved.slider(&reference.name).ok_or_else(|| format!("'{}' is no slider", reference.name))?;
        let pairs = [
            ("data-figure", Some(figure.id.clone())),
            ("data-name", Some(reference.name.clone())),
            ("data-min", Some(slider.min.to_string())),
            ("data-max", Some(slider.max.to_string())),
            ("data-step", Some(slider.step.to_string())),
        ];
        let text = crate::value::number(slider.value, reference.style);
        Ok(format!("<span class=\"drag\"{}>{}</span>", attributes(&pairs), escaped(&text)))
    }

    pub(super) fn formula(&mut self, latex: &str, is_display: bool, line: usize) -> String {
        let ids = self.ids.clone();
        let made = maths::mathml(latex, is_display, |tie| match tie {
            Tie::Link(name) => {
                let (figure, name) = match name.split_once(':') {
                    Some((id, name)) if ids.iter().any(|known| known == id.trim()) => {
                        (Some(id.trim()), name.trim())
                    }
                    _ => (None, name.as_str()),
                };
                let figure = self.figure(figure)?;
                let solved = self.solved(figure)?;
                let at =
                    solved.object(name).ok_or_else(|| format!("the definition has no object '{name}'"))?;
                let id = solved.session.document().objects.get(at).map(|object| object.id.to_string());
                let hue = figure.hue(name).map(|hue| format!("tie {}", hue.name()));
                let pairs = [
                    ("class", Some(hue.unwrap_or_else(|| "tie".to_owned()))),
                    ("data-figure", Some(figure.id.clone())),
                    ("data-tie", id),
                ];
                Ok((attributes(&pairs), None))
            }
            Tie::Live(text) => {
                let reference = Reference::read(text, &ids)?;
                let (attributes, text) = self.value(&reference)?;
                Ok((format!(" class=\"live\"{attributes}"), Some(text)))
            }
        });
        match made {
            Ok(html) if is_display => format!("<span class=\"formula\" tabindex=\"0\">{html}</span>"),
            Ok(html) => html,
            Err(why) => {
                self.fault(line, format!("formula: {why}"));
                String::new()
            }
        }
    }
}
