//! Figures: the still, the values in words, and what a reader takes along.

use std::rc::Rc;

use serde_json::{Value as Json, json};

use super::Page;
use crate::figure::Figure;
use crate::html::{data, escaped};
use crate::read::Source;
use crate::solved::Solved;
use crate::still;

impl<'a> Page<'a> {
    pub(super) fn figure_block(&mut self) -> String {
        let source: &'a Source = self.source;
        let Some(figure) = source.figures.get(self.passed) else { return String::new() };
        self.passed += 1;
        let solved = match self.solved(figure) {
            Ok(solved) => solved,
            Err(why) => {
                let line = figure.block.line_of("definition");
                self.fault(line, format!("{}: {why}", figure.definition));
                return String::new();
            }
        };
        for (key, why) in self.builder.wrong(figure, &solved) {
            self.fault(figure.block.line_of(key), why);
        }
        let stage = self.stage(figure, &solved);
        let say = self.entry(&figure.block, "say");
        let caption = self.entry(&figure.block, "caption");
        let words = &self.edition.words;
        let numbers: Vec<String> = figure.numbers.iter().map(u32::to_string).collect();
        let guide = if numbers.is_empty() {
            String::new()
        } else {
            format!(" <small>({}: {})</small>", escaped(words.get("guide")), numbers.join(", "))
        };
        let mut told = figure.to_json();
        for control in told["controls"].as_array_mut().into_iter().flatten() {
            control["on"] = json!(control["name"].as_str().is_some_and(|name| solved.is_on(name)));
            let slider = control["name"].as_str().and_then(|name| solved.slider(name));
            control["slider"] = slider.map_or(
                Json::Null,
                |one| json!({"value": one.value, "min": one.min, "max": one.max, "step": one.step}),
            );
        }
        let up = self.up();
        told["file"] = json!(format!("{up}files/{}", figure.definition));
        told["alt"] = json!(figure.alt);
        told["size"] = json!(still::SIZE);
        let take = self.take(figure);
        self.out.shared.push((format!("files/{}.svg", figure.definition), still::graph(&solved)));
        let number = self.passed;
        self.out.ids.push(figure.id.clone());
        format!(
            "<figure class=\"figure\" id=\"{id}\">\n<katydid-figure>\n<script type=\"application/json\">{data}</script>\n{stage}\
             <p class=\"say\" aria-live=\"polite\">{say}</p>\n{take}</katydid-figure>\n\
             <figcaption><b>{word} {number}.</b> {caption}{guide}</figcaption>\n</figure>\n",
            id = figure.id,
            data = data(&told),
            word = escaped(words.get("figure")),
        )
    }

    pub(super) fn up(&self) -> String {
        let own = self.source.folder.split('/').count();
        "../".repeat(own + usize::from(!self.edition.folder.is_empty()))
    }

    /// The stills of a figure; they belong to the book's own language, and others show the same.
    pub(super) fn stage(&mut self, figure: &Figure, solved: &Solved) -> String {
        let mut html = String::new();
        for (is_dark, name) in [(false, "light"), (true, "dark")] {
            let Some(svg) = still::svg(figure, solved, is_dark) else { return String::new() };
            let file = format!("{}.{name}.svg", figure.id);
            let [width, height] = still::SIZE;
            html.push_str(&format!(
                "<img class=\"{name}\" src=\"{file}\" alt=\"{}\" width=\"{width}\" height=\"{height}\" loading=\"lazy\">",
                escaped(&figure.alt)
            ));
            self.out.pictures.push((file, svg));
        }
        format!("<div class=\"stage\">{html}</div>\n")
    }

    /// The definition as a file, and five lines of Python that run it.
    pub(super) fn take(&self, figure: &Figure) -> String {
        let words = &self.edition.words;
        let name = figure.definition.replace('/', "-");
        let set = figure.controls.first().map(|(name, _)| name.as_str());
        let python = python(&name, set, &self.builder.solved(&figure.definition));
        format!(
            "<details class=\"take\"><summary>{}</summary><p><a href=\"{}files/{}\" download=\"{name}\">{}</a></p>\
             <p>{}</p><pre class=\"python\" tabindex=\"0\"><code>{}</code></pre>\
             <p>{}</p><img class=\"graph\" src=\"{}files/{}.svg\" alt=\"{}\" loading=\"lazy\"></details>\n",
            escaped(words.get("take")),
            self.up(),
            figure.definition,
            escaped(words.get("take-definition")),
            escaped(words.get("take-python")),
            escaped(&python),
            escaped(words.get("take-graph")),
            self.up(),
            figure.definition,
            escaped(words.get("take-graph")),
        )
    }
}

/// Five lines that run the definition with one value changed.
fn python(file: &str, control: Option<&str>, solved: &Result<Rc<Solved>, String>) -> String {
    let value = control.and_then(|name| {
        let solved = solved.as_ref().ok()?;
        match solved.slider(name) {
            Some(slider) => Some(format!("{}", slider.value)),
            None if solved.is_toggle(name) => Some("True".to_owned()),
            None => None,
        }
    });
    let set = match (control, value) {
        (Some(name), Some(value)) => format!("result = definition.solve({{{name:?}: {value}}})"),
        _ => "result = definition.solve()".to_owned(),
    };
    format!(
        "import katydid\n\ndefinition = katydid.open({file:?})\n{set}\nopen(\"picture.png\", \"wb\").write(result.picture())"
    )
}
