//! All pages of a book.

use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;

use rayon::prelude::*;
use serde_json::json;

use crate::assets::{self, Asset};
use crate::fault::{Fault, Faults};
use crate::figure::Figure;
use crate::html::escaped;
use crate::page::{Page, Rendered};
use crate::read::{Book, Edition, Source};
use crate::solved::Solved;

/// The files of a site, by their paths.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Site {
    /// The bytes of each.
    pub files: BTreeMap<String, Vec<u8>>,
    /// How many pages there are, in all languages.
    pub pages: usize,
    /// How many figures in the book's own language.
    pub figures: usize,
    /// Whether the script is there that makes figures move.
    pub has_script: bool,
}

/// What pages share while they are built.
pub(crate) struct Builder<'a> {
    book: &'a Book,
    solved: RefCell<BTreeMap<String, Result<Rc<Solved>, String>>>,
}

impl Book {
    /// Builds the pages.
    ///
    /// # Errors
    /// All that is wrong: names that no definition has, formulas that are none, links that lead nowhere, exercises whose
    /// solution fails.
    pub fn build(&self) -> Result<Site, Vec<Fault>> {
        let builder = Builder::new(self);
        let mut faults = Faults::default();
        let (style, scripts) = (assets::style(), assets::scripts());
        let script = scripts.first();
        let mut site = Site { has_script: script.is_some(), ..Site::default() };
        for edition in &self.editions {
            edition.build(&builder, &style, script, &mut site, &mut faults);
        }
        let own = self.editions.first().map(|edition| edition.pages.as_slice()).unwrap_or_default();
        for figure in own.iter().flat_map(|page| &page.figures) {
            site.figures += 1;
            if let Some(bytes) = self.files.get(&figure.definition) {
                site.files.insert(format!("files/{}", figure.definition), bytes.to_vec());
            }
        }
        for asset in std::iter::once(style).chain(scripts) {
            site.files.insert(asset.name, asset.bytes);
        }
        match faults.into_list() {
            none if none.is_empty() => Ok(site),
            faults => Err(faults),
        }
    }
}

impl<'a> Builder<'a> {
    fn new(book: &'a Book) -> Self {
        Self { book, solved: RefCell::default() }
    }

    /// The text of a definition.
    pub(crate) fn text(&self, path: &str) -> Result<String, String> {
        match self.book.files.text(path) {
            Some(text) => text.map(str::to_owned),
            None => Err("there is no such file in the book".to_owned()),
        }
    }

    /// A definition with its results: run once, whatever number of figures has it.
    pub(crate) fn solved(&self, path: &str) -> Result<Rc<Solved>, String> {
        if let Some(known) = self.solved.borrow().get(path) {
            return known.clone();
        }
        let solved = self.text(path).and_then(|text| Solved::run(&text, &[])).map(Rc::new);
        self.solved.borrow_mut().insert(path.to_owned(), solved.clone());
        solved
    }

    /// What a figure names and its definition has not.
    pub(crate) fn wrong(&self, figure: &Figure, solved: &Solved) -> Vec<(&'static str, String)> {
        let mut wrong = Vec::new();
        let none = |name: &str| format!("{} has no object '{name}'", figure.definition);
        for (name, _) in &figure.controls {
            if solved.slider(name).is_none() && !solved.is_toggle(name) {
                wrong.push((
                    "controls",
                    format!("'{name}' is no slider and no toggle of {}", figure.definition),
                ));
            }
        }
        let names = |key: &'static str, list: Vec<&String>| {
            list.into_iter()
                .filter(|name| solved.object(name).is_none())
                .map(move |name| (key, none(name)))
                .collect::<Vec<_>>()
        };
        wrong.extend(names("only", figure.only.iter().collect()));
        wrong.extend(names("colours", figure.colours.iter().map(|(name, _)| name).collect()));
        for name in &figure.drag {
            wrong.extend(solved.why_not_dragged(name).map(|why| ("drag", why)));
        }
        for widget in &figure.widgets {
            wrong.extend(solved.output(&widget.object).err().map(|why| ("widgets", why)));
            let sliders = widget.sliders().filter(|name| solved.slider(name).is_none());
            wrong.extend(sliders.map(|name| ("widgets", format!("'{name}' is no slider"))));
        }
        wrong.extend(
            solved.messages.iter().map(|message| ("definition", format!("{}: {message}", figure.definition))),
        );
        wrong
    }
}

impl Edition {
    fn build(
        &self,
        builder: &Builder<'_>,
        style: &Asset,
        script: Option<&Asset>,
        site: &mut Site,
        faults: &mut Faults,
    ) {
        // Pages share few definitions: each runs its own, side by side.
        let book = builder.book;
        let pages = self.pages.par_iter().map(|source| {
            let builder = Builder::new(book);
            Page::new(&builder, self, source).render()
        });
        let pages: Vec<(Rendered, Vec<Fault>)> = pages.collect();
        let mut rendered: Vec<(&Source, Rendered)> = Vec::with_capacity(pages.len());
        for (source, (page, list)) in self.pages.iter().zip(pages) {
            list.into_iter().for_each(|fault| faults.add(&fault.file, fault.line, fault.text));
            site.files.extend(page.shared.iter().cloned());
            rendered.push((source, page));
        }
        let ids: BTreeMap<&str, BTreeSet<&str>> = rendered
            .iter()
            .map(|(source, page)| (source.folder.as_str(), page.ids.iter().map(String::as_str).collect()))
            .collect();
        let root = if self.folder.is_empty() { String::new() } else { format!("{}/", self.folder) };
        for (place, (source, page)) in rendered.iter().enumerate() {
            for (line, folder, id) in &page.links {
                match ids.get(folder.as_str()) {
                    None => faults.add(&source.file, *line, format!("there is no page '{folder}'")),
                    Some(known) if !id.is_empty() && !known.contains(id.as_str()) => {
                        faults.add(&source.file, *line, format!("the page '{folder}' has no part '#{id}'"));
                    }
                    Some(_) => {}
                }
            }
            let html = self.page(builder, style, script, place, source, page);
            site.files.insert(format!("{root}{}/index.html", source.folder), html.into_bytes());
            for (name, bytes) in &page.pictures {
                site.files.insert(format!("{root}{}/{name}", source.folder), bytes.clone());
            }
            site.pages += 1;
        }
        let front = self.front(builder, style, script);
        site.files.insert(format!("{root}index.html"), front.into_bytes());
        site.files.insert(format!("{root}search.js"), search(&rendered).into_bytes());
    }

    /// The way from a page in `folder` to the root of the site.
    fn up(&self, folder: &str) -> String {
        let own = if folder.is_empty() { 0 } else { folder.split('/').count() };
        "../".repeat(own + usize::from(!self.folder.is_empty()))
    }

    fn page(
        &self,
        builder: &Builder<'_>,
        style: &Asset,
        script: Option<&Asset>,
        place: usize,
        source: &Source,
        page: &Rendered,
    ) -> String {
        let words = &self.words;
        let beside = |place: Option<usize>, key: &'static str, rel: &str| {
            let Some(other) = place.and_then(|place| self.pages.get(place)) else { return String::new() };
            let up = "../".repeat(source.folder.split('/').count());
            let (word, title) = (escaped(words.get(key)), escaped(&other.title));
            format!(
                "<a rel=\"{rel}\" href=\"{up}{}/index.html\"><small>{word}</small> {title}</a>",
                other.folder
            )
        };
        let guide = source
            .guide
            .as_ref()
            .map(|guide| format!(" <small>{} {}</small>", escaped(words.get("guide")), escaped(guide)));
        // The pages that the guide lacks have a name and no number.
        let row = if source.folder.contains('/') { String::new() } else { escaped(&source.folder) };
        let on_page: String = page
            .headings
            .iter()
            .map(|(id, title)| format!("<li><a href=\"#{id}\">{}</a></li>", title.trim()))
            .collect();
        let body = format!(
            "<article><header><p class=\"row\">{}{}</p><h1>{}</h1><p class=\"summary\">{}</p></header>\n\
             <nav class=\"on-page\" aria-label=\"{}\"><ul>{on_page}</ul></nav>\n{}</article>\n\
             <nav class=\"beside\" aria-label=\"{}\">{}{}</nav>\n",
            row,
            guide.unwrap_or_default(),
            escaped(&source.title),
            escaped(&source.summary),
            escaped(words.get("contents")),
            page.body,
            escaped(words.get("pages")),
            beside(place.checked_sub(1), "previous", "prev"),
            beside(Some(place + 1), "next", "next"),
        );
        self.around(builder, style, script, &source.folder, &source.title, &body)
    }

    fn front(&self, builder: &Builder<'_>, style: &Asset, script: Option<&Asset>) -> String {
        let mut text = String::new();
        pulldown_cmark::html::push_html(
            &mut text,
            pulldown_cmark::Parser::new_ext(&self.contents.text, crate::markdown::options()).filter(
                |event| {
                    !matches!(event, pulldown_cmark::Event::Html(_) | pulldown_cmark::Event::InlineHtml(_))
                },
            ),
        );
        let chapters: String = self
            .contents
            .chapters
            .iter()
            .map(|chapter| {
                let pages = chapter
                    .pages
                    .iter()
                    .filter_map(|(folder, _)| self.pages.iter().find(|page| page.folder == *folder));
                let list: String = pages
                    .map(|page| {
                        format!(
                            "<li><a href=\"{}/index.html\"><b>{}</b></a> <span>{}</span></li>",
                            page.folder,
                            escaped(&page.title),
                            escaped(&page.summary)
                        )
                    })
                    .collect();
                format!(
                    "<section><h2>{}</h2><ul class=\"chapter\">{list}</ul></section>\n",
                    escaped(&chapter.title)
                )
            })
            .collect();
        let body = format!(
            "<article><header><h1>{}</h1><p class=\"summary\">{}</p></header>{text}{chapters}</article>\n",
            escaped(&self.contents.title),
            escaped(&self.contents.summary)
        );
        self.around(builder, style, script, "", &self.contents.title, &body)
    }

    /// The head of a page, the contents beside it and its scripts.
    fn around(
        &self,
        builder: &Builder<'_>,
        style: &Asset,
        script: Option<&Asset>,
        folder: &str,
        title: &str,
        body: &str,
    ) -> String {
        let words = &self.words;
        let (site, own) =
            (self.up(folder), "../".repeat(if folder.is_empty() { 0 } else { folder.split('/').count() }));
        let contents: String = self
            .contents
            .chapters
            .iter()
            .map(|chapter| {
                let pages = chapter
                    .pages
                    .iter()
                    .filter_map(|(name, _)| self.pages.iter().find(|page| page.folder == *name));
                let list: String = pages
                    .map(|page| {
                        let now = if page.folder == folder { " aria-current=\"page\"" } else { "" };
                        format!(
                            "<li><a href=\"{own}{}/index.html\"{now}>{}</a></li>",
                            page.folder,
                            escaped(&page.title)
                        )
                    })
                    .collect();
                let open = if chapter.pages.iter().any(|(name, _)| name == folder) { " open" } else { "" };
                format!(
                    "<li><details{open}><summary>{}</summary><ul>{list}</ul></details></li>",
                    escaped(&chapter.title)
                )
            })
            .collect();
        let others: String = builder
            .book
            .editions
            .iter()
            .filter(|edition| edition.folder != self.folder)
            .filter(|edition| folder.is_empty() || edition.pages.iter().any(|page| page.folder == folder))
            .map(|edition| {
                let root =
                    if edition.folder.is_empty() { String::new() } else { format!("{}/", edition.folder) };
                let tail =
                    if folder.is_empty() { "index.html".to_owned() } else { format!("{folder}/index.html") };
                let language = escaped(edition.words.get("language"));
                let name = escaped(edition.words.get("name-of-language"));
                format!(
                    "<a lang=\"{language}\" hreflang=\"{language}\" href=\"{site}{root}{tail}\">{name}</a>"
                )
            })
            .collect();
        let (scripts, data) = match script {
            Some(script) => (
                format!(
                    "<script src=\"{own}search.js\" defer></script><script src=\"{site}{}\" type=\"module\"></script>",
                    script.name
                ),
                format!(
                    "<script type=\"application/json\" id=\"words\">{}</script>",
                    crate::html::data(&json!({
                        "words": words.to_json(), "root": site, "own": own, "page": folder,
                    }))
                ),
            ),
            None => Default::default(),
        };
        let full = if folder.is_empty() {
            escaped(title)
        } else {
            format!("{} – {}", escaped(title), escaped(&self.contents.title))
        };
        format!(
            "<!doctype html>\n<html lang=\"{language}\">\n<head>\n<meta charset=\"utf-8\">\n\
             <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<meta name=\"color-scheme\" content=\"light dark\">\n\
             <title>{full}</title>\n<link rel=\"icon\" href=\"data:,\">\n<link rel=\"stylesheet\" href=\"{site}{style}\">\n{scripts}\n</head>\n<body>\n\
             <a class=\"skip\" href=\"#text\">{skip}</a>\n\
             <header class=\"top\"><a class=\"book\" href=\"{own}index.html\">{book}</a><a class=\"to-contents\" href=\"#contents\">{word}</a><div id=\"tools\"></div>{others}</header>\n\
             <div class=\"sheet\"><main id=\"text\" tabindex=\"-1\">\n{body}</main>\n\
             <nav class=\"contents\" id=\"contents\" aria-label=\"{word}\"><ul>{contents}</ul></nav></div>\n{data}\n</body>\n</html>\n",
            language = escaped(words.get("language")),
            style = style.name,
            skip = escaped(words.get("skip")),
            book = escaped(&self.contents.title),
            word = escaped(words.get("contents")),
        )
    }
}

/// The index of the search: a script, so that pages opened from a folder can load it.
fn search(pages: &[(&Source, Rendered)]) -> String {
    let all: Vec<serde_json::Value> = pages
        .iter()
        .map(|(source, page)| {
            let text: BTreeSet<String> = page
                .plain
                .split(|c: char| !c.is_alphanumeric())
                .filter(|word| word.chars().count() > 2)
                .map(str::to_lowercase)
                .collect();
            json!([
                source.folder,
                source.title,
                source.summary,
                text.into_iter().collect::<Vec<_>>().join(" ")
            ])
        })
        .collect();
    format!("window.katydidSearch = {};\n", crate::html::data(&json!(all)))
}
