//! A book, read and checked as far as that goes without running it.

use std::collections::BTreeMap;

use crate::block::Block;
use crate::contents::Contents;
use crate::exercise::{self, Exercise};
use crate::fault::{Fault, Faults};
use crate::figure::{self, Figure};
use crate::files::Files;
use crate::front::Front;
use crate::markdown::{self, Part};
use crate::steps::{self, Steps};
use crate::words::Words;

/// A book.
#[derive(Debug)]
pub struct Book {
    pub(crate) files: Files,
    /// The book's own language first.
    pub(crate) editions: Vec<Edition>,
}

/// A book in one language.
#[derive(Debug)]
pub(crate) struct Edition {
    /// The folder of the language; empty for the book's own.
    pub(crate) folder: String,
    pub(crate) words: Words,
    pub(crate) contents: Contents,
    pub(crate) pages: Vec<Source>,
}

/// A page as it is written.
#[derive(Debug)]
pub(crate) struct Source {
    /// `V4`, `more/frenet`: the same in all languages.
    pub(crate) folder: String,
    pub(crate) file: String,
    pub(crate) title: String,
    pub(crate) summary: String,
    pub(crate) guide: Option<String>,
    pub(crate) text: String,
    /// The lines before the text.
    pub(crate) lines: usize,
    pub(crate) parts: Vec<Part>,
    pub(crate) figures: Vec<Figure>,
    pub(crate) exercises: Vec<Exercise>,
    pub(crate) steps: Vec<Steps>,
}

impl Book {
    /// Reads a book.
    ///
    /// # Errors
    /// All that is wrong with its pages, in the order of files and lines.
    pub fn read(files: Files) -> Result<Self, Vec<Fault>> {
        let mut faults = Faults::default();
        let mut folders = vec![String::new()];
        folders.extend(files.paths().filter_map(|path| path.strip_suffix("/contents.md")).map(str::to_owned));
        let mut editions: Vec<Edition> = Vec::new();
        for folder in folders {
            if let Some(edition) = Edition::read(&files, folder, editions.first(), &mut faults) {
                editions.push(edition);
            }
        }
        match faults.into_list() {
            none if none.is_empty() => Ok(Self { files, editions }),
            faults => Err(faults),
        }
    }

    /// The folders of the pages of the book's own language, in their order.
    pub fn pages(&self) -> Vec<&str> {
        self.editions
            .first()
            .map(|first| first.pages.iter().map(|page| page.folder.as_str()).collect())
            .unwrap_or_default()
    }

    /// The numbers of the guide's figures for which some page has one.
    pub fn numbers(&self) -> std::collections::BTreeSet<u32> {
        let pages = self.editions.first().map(|first| first.pages.as_slice()).unwrap_or_default();
        pages.iter().flat_map(|page| &page.figures).flat_map(|figure| &figure.numbers).copied().collect()
    }
}

impl Edition {
    fn read(files: &Files, folder: String, own: Option<&Self>, faults: &mut Faults) -> Option<Self> {
        let within =
            |path: &str| if folder.is_empty() { path.to_owned() } else { format!("{folder}/{path}") };
        let path = within("contents.md");
        let text = files
            .text(&path)
            .unwrap_or_else(|| Err("the book has no contents: this file is missing".to_owned()));
        let text = faults.keep(text.map_err(|why| Fault::new(&path, 0, why)))?;
        let contents = faults.keep(Contents::read(&path, text))?;
        let words = Words::read(files, &folder, faults);
        let mut pages: Vec<Source> = Vec::new();
        for (name, line) in contents.pages() {
            if pages.iter().any(|page| page.folder == *name) {
                faults.add(&path, *line, format!("'{name}' is there twice"));
                continue;
            }
            let file = within(&format!("{name}/page.md"));
            let Some(text) = files.text(&file) else {
                faults.add(&path, *line, format!("there is no page {file}"));
                continue;
            };
            let Some(text) = faults.keep(text.map_err(|why| Fault::new(&file, 0, why))) else { continue };
            let base = own.map(|own| own.pages.iter().find(|page| page.folder == *name));
            if base.is_some_and(|base| base.is_none()) {
                faults.add(&path, *line, format!("'{name}' is no page of the book's own language"));
                continue;
            }
            pages.extend(Source::read(name, &file, text, base.flatten(), faults));
        }
        Some(Self { folder, words, contents, pages })
    }
}

impl Source {
    fn read(folder: &str, file: &str, text: &str, base: Option<&Self>, faults: &mut Faults) -> Option<Self> {
        let (front, text) = faults.keep(Front::read(file, text))?;
        for key in front.values.keys().filter(|key| !["title", "summary", "guide"].contains(&key.as_str())) {
            faults.add(file, 1, format!("there is no key '{key}' in the head of a page"));
        }
        let title = faults.keep(front.needed(file, "title"))?;
        let summary = faults.keep(front.needed(file, "summary"))?;
        let parts = markdown::parts(text, front.lines);
        let mut page = Self {
            folder: folder.to_owned(),
            file: file.to_owned(),
            title,
            summary,
            guide: front.values.get("guide").cloned(),
            text: text.to_owned(),
            lines: front.lines,
            parts,
            figures: Vec::new(),
            exercises: Vec::new(),
            steps: Vec::new(),
        };
        page.blocks(base, faults);
        if let Some(base) = base {
            page.compare(base, faults);
        }
        Some(page)
    }

    /// Reads the blocks; in another language their words alone are the page's own.
    fn blocks(&mut self, base: Option<&Self>, faults: &mut Faults) {
        let (folder, file) = (self.folder.clone(), self.file.clone());
        let own: BTreeMap<&str, &Block> = base
            .into_iter()
            .flat_map(|base| {
                let figures = base.figures.iter().map(|figure| (figure.id.as_str(), &figure.block));
                figures.chain(base.exercises.iter().map(|exercise| (exercise.id.as_str(), &exercise.block)))
            })
            .collect();
        let whole = |block: Block, words: &[&str]| match block.get("id").and_then(|id| own.get(id)) {
            Some(other) => block.over(other, words),
            None => block,
        };
        let mut steps = Vec::new();
        let parts = self.parts.clone();
        for part in parts.iter().filter(|part| part.kind == "figure") {
            let block = Block::read(&file, part.line, &part.text, &figure::KEYS);
            let block = block.map(|block| whole(block, &figure::WORDS));
            let figure = faults.keep(block.and_then(|block| Figure::read(&folder, &block)));
            if let Some(figure) = figure {
                if self.figures.iter().any(|other| other.id == figure.id) {
                    faults.add(&file, part.line, format!("the id '{}' is there twice", figure.id));
                }
                self.figures.push(figure);
            }
        }
        let ids: Vec<String> = self.figures.iter().map(|figure| figure.id.clone()).collect();
        for part in &parts {
            match part.kind.as_str() {
                "exercise" => {
                    let block = Block::read(&file, part.line, &part.text, &exercise::KEYS);
                    let block = block.map(|block| whole(block, &exercise::WORDS));
                    self.exercises.extend(faults.keep(block.and_then(|block| Exercise::read(&block, &ids))));
                }
                "steps" => {
                    let block = Block::read(&file, part.line, &part.text, &steps::KEYS);
                    steps.extend(faults.keep(block.and_then(|block| Steps::read(&block))));
                }
                _ => {}
            }
        }
        // Steps have no words: in another language they are those of the book's own.
        self.steps = base
            .filter(|base| steps.is_empty() && !base.steps.is_empty())
            .map_or(steps, |base| base.steps.clone());
    }

    fn compare(&self, base: &Self, faults: &mut Faults) {
        let ids = |page: &Self| page.figures.iter().map(|figure| figure.id.clone()).collect::<Vec<_>>();
        if ids(self) != ids(base) {
            faults.add(&self.file, 0, format!("its figures are not those of {}", base.file));
        }
        let ids = |page: &Self| page.exercises.iter().map(|one| one.id.clone()).collect::<Vec<_>>();
        if ids(self) != ids(base) {
            faults.add(&self.file, 0, format!("its exercises are not those of {}", base.file));
        }
    }
}
