//! A page, rendered.

mod figures;
mod questions;
mod ties;

use std::rc::Rc;

use pulldown_cmark::{Event, Parser, Tag, TagEnd, html as markdown_html};

use crate::build::Builder;
use crate::fault::Fault;
use crate::figure::Figure;
use crate::html::{escaped, slug};
use crate::links;
use crate::markdown::{Marked, block_kind, line_at, options};
use crate::read::{Edition, Source};
use crate::solved::Solved;

/// A page as HTML, and what belongs to it.
#[derive(Debug, Default)]
pub(crate) struct Rendered {
    pub(crate) body: String,
    /// The headings, for the list on the page.
    pub(crate) headings: Vec<(String, String)>,
    /// The ids of the elements that links can lead to.
    pub(crate) ids: Vec<String>,
    /// Links to other pages: the line, the folder and what stands behind #.
    pub(crate) links: Vec<(usize, String, String)>,
    /// Pictures, by their names beside the page.
    pub(crate) pictures: Vec<(String, Vec<u8>)>,
    /// Files that several pages may have, by their paths in the site.
    pub(crate) shared: Vec<(String, Vec<u8>)>,
    /// The words of the text, for the search.
    pub(crate) plain: String,
}

/// Renders a page.
pub(crate) struct Page<'a> {
    builder: &'a Builder<'a>,
    edition: &'a Edition,
    source: &'a Source,
    marked: Marked,
    ids: Vec<String>,
    /// The figures that stand before the place that is rendered.
    passed: usize,
    exercises: usize,
    steps: usize,
    out: Rendered,
    faults: Vec<Fault>,
}

impl<'a> Page<'a> {
    pub(crate) fn new(builder: &'a Builder<'a>, edition: &'a Edition, source: &'a Source) -> Self {
        Self {
            builder,
            edition,
            source,
            marked: Marked::new(&source.text, source.lines),
            ids: source.figures.iter().map(|figure| figure.id.clone()).collect(),
            passed: 0,
            exercises: 0,
            steps: 0,
            out: Rendered::default(),
            faults: Vec::new(),
        }
    }

    pub(crate) fn render(mut self) -> (Rendered, Vec<Fault>) {
        let text = self.marked.text.clone();
        self.out.body = self.markdown(&text, self.source.lines);
        (self.out, self.faults)
    }

    fn fault(&mut self, line: usize, text: impl Into<String>) {
        self.faults.push(Fault::new(&self.source.file, line, text));
    }

    /// The figure that a place belongs to: the one that is named, else the last above, else the first.
    fn figure(&self, id: Option<&str>) -> Result<&'a Figure, String> {
        let source: &'a Source = self.source;
        let found = match id {
            Some(id) => source.figures.iter().find(|figure| figure.id == id),
            None => source.figures.get(self.passed.saturating_sub(1)),
        };
        found.ok_or_else(|| match id {
            Some(id) => format!("the page has no figure '{id}'"),
            None => "the page has no figure".to_owned(),
        })
    }

    fn solved(&self, figure: &Figure) -> Result<Rc<Solved>, String> {
        self.builder.solved(&figure.definition)
    }

    /// Markdown as HTML; `before` lines stand above it in the file.
    fn markdown(&mut self, text: &str, before: usize) -> String {
        let mut events: Vec<Event<'_>> = Vec::new();
        // The block that is being read: its kind, line and text.
        let mut block: Option<(String, usize, String)> = None;
        let mut heading: Option<String> = None;
        let mut is_code = false;
        for (event, range) in Parser::new_ext(text, options()).into_offset_iter() {
            let line = line_at(text, range.start, before);
            match event {
                Event::Start(Tag::CodeBlock(ref kind)) => match block_kind(kind) {
                    Some(name) => block = Some((name.to_owned(), line, String::new())),
                    None => {
                        is_code = true;
                        events.push(event);
                    }
                },
                Event::End(TagEnd::CodeBlock) => match block.take() {
                    Some((kind, line, inner)) => {
                        let html = self.block(&kind, line, &inner);
                        events.push(Event::Html(html.into()));
                    }
                    None => {
                        is_code = false;
                        events.push(event);
                    }
                },
                Event::Text(piece) => {
                    if let Some((_, _, inner)) = &mut block {
                        inner.push_str(&piece);
                    } else if is_code {
                        events.push(Event::Text(self.marked.restored(&piece).into()));
                    } else {
                        let html = self.text(&piece);
                        if let Some(heading) = &mut heading {
                            heading.push_str(&html);
                        } else {
                            events.push(Event::InlineHtml(html.into()));
                        }
                    }
                }
                Event::Code(piece) if heading.is_some() => {
                    let code = format!("<code>{}</code>", escaped(&self.marked.restored(&piece)));
                    heading.iter_mut().for_each(|heading| heading.push_str(&code));
                }
                Event::Code(piece) => events.push(Event::Code(self.marked.restored(&piece).into())),
                Event::InlineMath(latex) | Event::DisplayMath(latex) => {
                    let is_display = text.get(range.clone()).is_some_and(|text| text.starts_with("$$"));
                    let html = self.formula(&latex, is_display, line);
                    match &mut heading {
                        Some(heading) => heading.push_str(&html),
                        None => events.push(Event::InlineHtml(html.into())),
                    }
                }
                Event::Html(_) | Event::InlineHtml(_) => {
                    self.fault(line, "HTML is not supported in pages: write Markdown");
                }
                Event::Start(Tag::Heading { .. }) => heading = Some(String::new()),
                Event::End(TagEnd::Heading(level)) => {
                    let inner = heading.take().unwrap_or_default();
                    let html = self.heading(level as usize, &inner);
                    events.push(Event::Html(html.into()));
                }
                Event::Start(Tag::Link { link_type, dest_url, title, id }) => {
                    let dest_url = self.link(&dest_url, line).into();
                    events.push(Event::Start(Tag::Link { link_type, dest_url, title, id }));
                }
                // A table of formulas can be wider than a small window: it scrolls alone, by keys too.
                Event::Start(Tag::Table(_)) => {
                    let name = escaped(self.edition.words.get("table"));
                    let opened =
                        format!("<div class=\"table\" role=\"region\" tabindex=\"0\" aria-label=\"{name}\">");
                    events.extend([Event::Html(opened.into()), event]);
                }
                Event::End(TagEnd::Table) => events.extend([event, Event::Html("</div>".into())]),
                Event::Start(Tag::Image { .. }) => {
                    self.fault(line, "pictures are not supported in pages: a figure is a definition");
                }
                Event::End(TagEnd::Image) => {}
                Event::SoftBreak if heading.is_some() => {}
                other if heading.is_some() => {
                    // Emphasis in headings says nothing more.
                    let _ = other;
                }
                other => events.push(other),
            }
        }
        let mut html = String::new();
        markdown_html::push_html(&mut html, events.into_iter());
        html
    }

    /// Markdown of a line or two, without a paragraph around it.
    fn words(&mut self, text: &str, line: usize) -> String {
        let html = self.markdown(text, line.saturating_sub(1));
        let html = html.trim();
        match html.strip_prefix("<p>").and_then(|rest| rest.strip_suffix("</p>")) {
            Some(inner) if !inner.contains("<p>") => inner.to_owned(),
            _ => html.to_owned(),
        }
    }

    fn heading(&mut self, level: usize, inner: &str) -> String {
        let mut id = slug(&without_tags(inner));
        while self.out.ids.contains(&id) {
            id.push_str("-2");
        }
        self.out.ids.push(id.clone());
        let level = level.clamp(2, 4);
        if level == 2 {
            self.out.headings.push((id.clone(), without_tags(inner)));
        }
        format!("<h{level} id=\"{id}\">{inner}</h{level}>\n")
    }

    fn link(&mut self, target: &str, line: usize) -> String {
        match links::read(target) {
            links::Target::Elsewhere => target.to_owned(),
            links::Target::Here(id) => {
                self.out.links.push((line, self.source.folder.clone(), id));
                target.to_owned()
            }
            links::Target::Page(folder, id) => {
                let up = "../".repeat(self.source.folder.split('/').count());
                let behind = if id.is_empty() { String::new() } else { format!("#{id}") };
                let address = format!("{up}{folder}/index.html{behind}");
                self.out.links.push((line, folder, id));
                address
            }
            links::Target::Wrong(why) => {
                self.fault(line, format!("'{target}': {why}"));
                String::new()
            }
        }
    }

    /// Text with its marks as elements.
    fn text(&mut self, piece: &str) -> String {
        let mut html = String::new();
        let mut found: Vec<(String, usize)> = Vec::new();
        // A mark leaves a sign in the text that no page has.
        self.marked.each(
            piece,
            &mut (&mut html, &mut found),
            |(html, _), text| html.push_str(&escaped(text)),
            |(html, found), mark, line| {
                html.push('\0');
                found.push((mark.to_owned(), line));
            },
        );
        let mut parts = html.split('\0');
        let mut out = parts.next().unwrap_or_default().to_owned();
        self.out.plain.push_str(&out);
        for (part, (mark, line)) in parts.zip(found) {
            out.push_str(&self.mark(&mark, line));
            out.push_str(part);
            self.out.plain.push(' ');
            self.out.plain.push_str(part);
        }
        out
    }

    fn block(&mut self, kind: &str, line: usize, text: &str) -> String {
        match kind {
            "figure" => self.figure_block(),
            "steps" => self.steps_block(),
            "exercise" => self.exercise_block(),
            _ => self.predict_block(line, text),
        }
    }

    /// A value of a block, with the marks taken out as they were when the page was read.
    fn entry(&mut self, figure: &crate::block::Block, key: &str) -> String {
        let Some(value) = figure.get(key) else { return String::new() };
        let line = figure.line_of(key);
        // Blocks were read with their marks: these are numbered behind those of the page.
        let own = Marked::new(value, line.saturating_sub(1));
        let page = std::mem::replace(&mut self.marked, own);
        let text = self.marked.text.clone();
        let html = self.words(&text, line);
        self.marked = page;
        html
    }
}

fn without_tags(html: &str) -> String {
    let mut out = String::new();
    let mut is_inside = false;
    for c in html.chars() {
        match c {
            '<' => is_inside = true,
            '>' => is_inside = false,
            c if !is_inside => out.push(c),
            _ => {}
        }
    }
    out
}
