//! Objects to statements. What a statement does not say is found by building it again and comparing.

use std::collections::HashMap;
use std::sync::Arc;

use uuid::Uuid;

use super::ast::{Change, Edit, RawValue};
use super::build::{Insides, base, build};
use super::catalogue::{Catalogue, Facts, Known};
use super::labels::{self, Label};
use super::statement::{Names, inner_names};
use super::{derive, layout, parser, raw_value, residue, statement, text};
use crate::archive::{Chunk, Limits};
use crate::document::{ClusterContent, Document, Lookup, MOST_NESTED, Object};
use crate::{Error, Result};

/// A document as text.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Written {
    /// The text.
    pub text: String,
    /// What of the document is not in it, in plain words.
    pub left_out: Vec<String>,
}

/// Writes a document as text.
///
/// Everything is kept but what Grasshopper makes anew by itself: the thumbnail, the places of ports, what is selected,
/// and the descriptions of components that the catalogue has. What was there of these is told.
///
/// # Errors
/// When the document nests deeper than the text may.
pub fn write(document: &Document, catalogue: &dyn Catalogue) -> Result<Written> {
    let mut root = document.to_archive().root;
    if root.child("Definition").is_none() {
        // A cluster by itself becomes a document of its own.
        "Definition".clone_into(&mut root.name);
        root = Chunk { chunks: vec![root], ..base(false) };
    }
    let known = Known(catalogue);
    let mut told = Told::default();
    if root.child("Thumbnail").is_some() {
        root.remove_children("Thumbnail");
        told.thumbnail = true;
    }
    let mut sheet = Sheet::new(&document.objects, &known, None, 0);
    let body = sheet.module(root, &mut told)?;
    Ok(Written { text: layout::tidy(&format!("katydid 1\n{body}")), left_out: told.into_list() })
}

/// What was left out.
#[derive(Default)]
struct Told {
    thumbnail: bool,
    port_places: usize,
    descriptions: usize,
    selected: usize,
}

impl Told {
    fn into_list(self) -> Vec<String> {
        let mut list = Vec::new();
        let mut add = |n: usize, what: &str| {
            if n > 0 {
                list.push(what.replace("{n}", &n.to_string()));
            }
        };
        add(usize::from(self.thumbnail), "the thumbnail picture");
        add(self.port_places, "the places of {n} ports, which follow from their objects");
        add(
            self.descriptions,
            "{n} descriptions of components and ports, which the catalogue has in its own words",
        );
        add(self.selected, "which {n} objects are selected");
        list
    }
}

/// The bytes of a module, each piece once.
#[derive(Default)]
pub(super) struct Data {
    pieces: Vec<Vec<u8>>,
    numbers: HashMap<Vec<u8>, u32>,
}

impl Data {
    pub(super) fn keep(&mut self, bytes: &[u8]) -> u32 {
        if let Some(n) = self.numbers.get(bytes) {
            return *n;
        }
        self.pieces.push(bytes.to_vec());
        let n = u32::try_from(self.pieces.len()).unwrap_or(u32::MAX);
        self.numbers.insert(bytes.to_vec(), n);
        n
    }
}

/// What the statements do not say.
struct Residue {
    /// Of each object, what stands in its statement.
    settings: Vec<Vec<Edit>>,
    /// Of each object, what stands in the details.
    details: Vec<Vec<Edit>>,
    /// Of the tree around the objects.
    file: Vec<Edit>,
}

/// What is known of an object that is written.
pub(super) struct Entry<'a> {
    pub(super) object: &'a Object,
    pub(super) facts: Option<Arc<Facts>>,
    pub(super) label: Label,
    /// The inside of a cluster that can be opened.
    pub(super) inside: Option<Box<Document>>,
    /// Its ports stand in the statement one by one.
    pub(super) all_written: bool,
    pub(super) outputs: Names,
}

pub(super) struct Sheet<'a, 'k> {
    pub(super) entries: Vec<Entry<'a>>,
    pub(super) lookup: Lookup,
    pub(super) known: &'k Known<'k>,
    pub(super) data: Data,
    /// The cluster that it is the inside of.
    parent: Option<Uuid>,
    depth: usize,
}

impl<'a, 'k> Sheet<'a, 'k> {
    fn new(objects: &'a [Object], known: &'k Known<'k>, parent: Option<Uuid>, depth: usize) -> Self {
        let labels = labels::assign(objects, &statement::order(objects));
        let mut entries: Vec<Entry<'a>> = Vec::with_capacity(objects.len());
        for (object, label) in objects.iter().zip(labels) {
            let inside = inside(object, depth);
            let mut facts = known.by_guid(object.component);
            let mut all_written = false;
            if let (Some(inside), Some(found)) = (&inside, &facts) {
                let named = inner_names(object, found, inside).map(Arc::new);
                all_written = named.is_none();
                facts = named.or(facts);
            }
            all_written |= !statement::follows(object, facts.as_deref());
            let outputs = statement::output_names(object, facts.as_deref(), all_written);
            entries.push(Entry { object, facts, label, inside, all_written, outputs });
        }
        Self { entries, lookup: lookup(objects), known, data: Data::default(), parent, depth }
    }

    /// The text of a module without its first line. `root` is its tree.
    fn module(&mut self, mut root: Chunk, told: &mut Told) -> Result<String> {
        let objects = take_objects(&mut root, self.parent.is_some());
        let mut statements = Vec::new();
        for at in 0..self.entries.len() {
            statements.push(self.statement(at, told)?);
        }
        let order = statement::order_of(&self.entries);
        let head = self.head(&root);
        let tail = self.layout(&order) + &self.ids();
        let draft = self.assemble(&head, &statements, &order, &tail, &[], &[]);
        let Residue { settings, details, file } = self.residue(&draft, root, objects, told)?;
        for (statement, edits) in statements.iter_mut().zip(settings) {
            if !edits.is_empty() {
                // They stand before the inside of a cluster.
                let block = self.block(&edits);
                statement.0.insert_str(statement.1, &format!(" {{\n{block}}}"));
            }
        }
        Ok(self.assemble(&head, &statements, &order, &tail, &details, &file))
    }

    /// The statement of an object, and where in it settings belong.
    fn statement(&mut self, at: usize, told: &mut Told) -> Result<(String, usize)> {
        let mut text = statement::print(self, at);
        let end = text.len();
        let Some(entry) = self.entries.get(at) else { return Ok((text, end)) };
        if let Some(inside) = &entry.inside {
            let mut sheet = Sheet::new(&inside.objects, self.known, Some(entry.object.id), self.depth + 1);
            let body = sheet.module(inside.to_archive().root, told)?;
            text.push_str(" inside {\n");
            text.push_str(&body);
            text.push('}');
        }
        Ok((text, end))
    }

    /// Title and description.
    fn head(&self, root: &Chunk) -> String {
        let definition = if self.parent.is_some() { Some(root) } else { root.child("Definition") };
        let properties = definition.and_then(|definition| definition.child("DefinitionProperties"));
        let mut head = String::new();
        for (word, name) in [("title", "Name"), ("about", "Description")] {
            if let Some(text) = properties.and_then(|p| p.str(name)).filter(|text| !text.is_empty()) {
                head.push_str(&format!("{word} {}\n", raw_value::string_form(text, 0)));
            }
        }
        head
    }

    /// The places of all objects in drawing order; empty when no object has one and the order is that of the text.
    fn layout(&self, order: &[usize]) -> String {
        let placed = |entry: &Entry<'_>| entry.object.pivot.is_some() || entry.object.bounds.is_some();
        if !self.entries.iter().any(placed) && order.iter().copied().eq(0..self.entries.len()) {
            return String::new();
        }
        let mut text = "\nlayout {\n".to_owned();
        for entry in &self.entries {
            text.push_str(&format!("{}:", entry.label));
            let attributes = entry.object.container().child("Attributes");
            if let Some([x, y]) = attributes.and_then(|a| a.canvas_point("Pivot")) {
                text.push_str(&format!(" {} {}", raw_value::single(x), raw_value::single(y)));
            }
            if let Some(bounds) = attributes.and_then(|a| a.canvas_rectangle("Bounds")) {
                text.push_str(&format!(" [{}]", bounds.map(raw_value::single).join(" ")));
            }
            text.push('\n');
        }
        text.push_str("}\n");
        text
    }

    /// The ids that do not follow from the labels.
    fn ids(&self) -> String {
        let mut text = String::new();
        for entry in &self.entries {
            let object = entry.object;
            let usual = derive::id(self.parent.unwrap_or(derive::ROOT), &entry.label.key());
            let list = |ports: &[crate::document::Port], side: &str| {
                let ids: Vec<String> = ports
                    .iter()
                    .enumerate()
                    .map(|(k, port)| {
                        let derived = port.id == derive::id(object.id, &format!("{side} {k}"));
                        if derived { "_".to_owned() } else { format!("@{}", port.id) }
                    })
                    .collect();
                let last = ids.iter().rposition(|id| id != "_")?;
                Some(format!("[{}]", ids.get(..=last).unwrap_or_default().join(", ")))
            };
            let (inputs, outputs) = if object.is_floating() {
                (None, None)
            } else {
                (list(&object.inputs, "in"), list(&object.outputs, "out"))
            };
            let own = (object.id != usual).then(|| format!(" @{}", object.id));
            if own.is_some() || inputs.is_some() || outputs.is_some() {
                text.push_str(&format!("{}:{}", entry.label, own.unwrap_or_default()));
                text.extend(inputs.map(|ids| format!(" {ids}")));
                text.extend(outputs.map(|ids| format!(" -> {ids}")));
                text.push('\n');
            }
        }
        if text.is_empty() { text } else { format!("\nids {{\n{text}}}\n") }
    }

    fn assemble(
        &mut self,
        head: &str,
        statements: &[(String, usize)],
        order: &[usize],
        tail: &str,
        details: &[Vec<Edit>],
        file: &[Edit],
    ) -> String {
        let mut text = if self.parent.is_some() { head.to_owned() } else { format!("{head}\n") };
        for at in order {
            text.push_str(statements.get(*at).map_or("", |(text, _)| text.as_str()));
            text.push('\n');
        }
        text.push_str(tail);
        if details.iter().any(|edits| !edits.is_empty()) {
            text.push_str("\ndetails {\n");
            for (at, edits) in details.iter().enumerate().filter(|(_, edits)| !edits.is_empty()) {
                let block = self.block(edits);
                let label = self.entries.get(at).map(|entry| entry.label.to_string()).unwrap_or_default();
                text.push_str(&format!("{label} {{\n{block}}}\n"));
            }
            text.push_str("}\n");
        }
        if !file.is_empty() {
            let block = self.block(file);
            text.push_str(&format!("\nfile {{\n{block}}}\n"));
        }
        if !self.data.pieces.is_empty() {
            text.push_str("\ndata {\n");
            for (n, bytes) in (1..).zip(&self.data.pieces) {
                text.push_str(&format!("${n} = {}\n", base64_lines(bytes)));
            }
            text.push_str("}\n");
        }
        text
    }

    /// The lines of some changes.
    fn block(&mut self, edits: &[Edit]) -> String {
        let mut lines = String::new();
        for edit in edits {
            edit_line(&mut lines, edit, &mut |bytes| self.data.keep(bytes));
        }
        lines
    }

    /// Builds the draft and says what is missing: in the statements, in the details, around the objects.
    fn residue(&self, draft: &str, mut root: Chunk, objects: Vec<Chunk>, told: &mut Told) -> Result<Residue> {
        let broken = |reason: String| Error::Document { place: "the text form".to_owned(), reason };
        let mut faults = Vec::new();
        let module =
            parser::parse(draft).map_err(|faults| broken(super::Problems::of(draft, faults).to_string()))?;
        // The inside of a cluster has said by itself what is missing there.
        let mut built = build(&module, self.known, self.parent, Insides::Unpacked, &mut faults);
        if !faults.is_empty() {
            return Err(broken(super::Problems::of(draft, faults).to_string()));
        }
        let again = take_objects(&mut built, self.parent.is_some());
        let (mut settings, mut details) = (Vec::new(), Vec::new());
        for ((entry, mut new), mut old) in self.entries.iter().zip(again).zip(objects) {
            normalise(entry, &mut new, &mut old, told);
            let (container, rest) = (take_container(&mut old), take_container(&mut new));
            let mut top = residue::diff(&new, &old);
            top.iter_mut().for_each(|edit| edit.top = true);
            let (quiet, loud): (Vec<Edit>, Vec<Edit>) =
                residue::diff(&rest, &container).into_iter().partition(is_quiet);
            top.extend(quiet);
            settings.push(loud);
            details.push(top);
        }
        residue::sort(&mut root);
        residue::sort(&mut built);
        Ok(Residue { settings, details, file: residue::diff(&built, &root) })
    }
}

/// The inside of a cluster, when it can be opened and can be written back the same.
fn inside(object: &Object, depth: usize) -> Option<Box<Document>> {
    if depth + 1 >= MOST_NESTED {
        return None;
    }
    match object.cluster(&Limits::default())? {
        Ok(ClusterContent::Open { document, .. }) if document.tree().name == "Document" => {
            let sound = document.tree().index.is_none() && document.tree().child("Definition").is_none();
            sound.then_some(document)
        }
        _ => None,
    }
}

/// The maps from ids to ports.
fn lookup(objects: &[Object]) -> Lookup {
    let mut document = Document::new();
    document.objects = objects.to_vec();
    document.lookup()
}

/// Takes the objects out of a tree.
fn take_objects(root: &mut Chunk, nested: bool) -> Vec<Chunk> {
    let definition = if nested { Some(root) } else { root.child_mut("Definition") };
    let Some(list) = definition.and_then(|d| d.child_mut("DefinitionObjects")) else { return Vec::new() };
    let (objects, rest) = std::mem::take(&mut list.chunks).into_iter().partition(|c| c.name == "Object");
    list.chunks = rest;
    objects
}

fn take_container(object: &mut Chunk) -> Chunk {
    let found = object.chunks.iter().position(|c| c.name == "Container" && c.index.is_none());
    found.map(|k| object.chunks.remove(k)).unwrap_or_else(|| Chunk::new("Container"))
}

/// Evens out what is not kept, and what is kept elsewhere.
fn normalise(entry: &Entry<'_>, new: &mut Chunk, old: &mut Chunk, told: &mut Told) {
    (new.index, old.index) = (None, None);
    let (mut from, mut to) = (take_container(new), take_container(old));
    if entry.inside.is_some() {
        from.remove("ClusterDocument");
        to.remove("ClusterDocument");
    }
    if let Some(attributes) = to.child_mut("Attributes") {
        told.selected += usize::from(attributes.remove("Selected"));
    }
    describe(&from, &mut to, told);
    for name in ["param_input", "param_output"] {
        ports(&from, &mut to, name, told);
    }
    if let (Some(from), Some(to)) = (from.child("ParameterData"), to.child_mut("ParameterData")) {
        for name in ["InputParam", "OutputParam"] {
            ports(from, to, name, told);
        }
    }
    new.chunks.push(from);
    old.chunks.push(to);
    residue::sort(new);
    residue::sort(old);
}

/// Takes over the description of the catalogue.
fn describe(from: &Chunk, to: &mut Chunk, told: &mut Told) {
    let text = from.str("Description").filter(|text| !text.is_empty());
    if let Some(text) = text.filter(|text| to.str("Description") != Some(text)) {
        told.descriptions += usize::from(to.str("Description").is_some_and(|old| !old.is_empty()));
        to.set("Description", text);
    }
}

fn ports(from: &Chunk, to: &mut Chunk, name: &str, told: &mut Told) {
    for port in to.chunks.iter_mut().filter(|chunk| chunk.name == name) {
        told.port_places += usize::from(port.remove_children("Attributes"));
        let same = from.chunks.iter().find(|chunk| chunk.name == name && chunk.index == port.index);
        if let Some(same) = same {
            describe(same, port, told);
        }
    }
}

/// Whether a change says nothing about the design: it stands in the details.
fn is_quiet(edit: &Edit) -> bool {
    const PORTS: [&str; 5] = ["param_input", "param_output", "ParameterData", "PersistentData", "ParamMap"];
    const LOOKS: [&str; 19] = [
        "Attributes",
        "Description",
        "IconDisplay",
        "IconOverride",
        "InstanceGuid",
        "Name",
        "NickName",
        "Optional",
        "SourceCount",
        "ScrollRatio",
        "PanelProperties",
        "FileInfo",
        "Ca",
        "Cb",
        "Cc",
        "Cd",
        "Mark",
        "MarkCount",
        "UserText",
    ];
    let Some(first) = edit.path.first() else { return true };
    let slider = first.name == "Slider"
        && edit
            .path
            .last()
            .is_some_and(|step| ["Digits", "GripDisplay", "Snap", "SnapCount"].contains(&step.name.as_str()));
    slider || PORTS.contains(&first.name.as_str()) || LOOKS.contains(&first.name.as_str())
}

/// Writes one change as a line.
fn edit_line(line: &mut String, edit: &Edit, keep: &mut dyn FnMut(&[u8]) -> u32) {
    line.push_str(match &edit.change {
        Change::Add => "+ ",
        Change::Remove | Change::RemoveChunk => "- ",
        Change::Set(_) => "",
    });
    if edit.top {
        line.push('/');
    }
    for (k, step) in edit.path.iter().enumerate() {
        if k > 0 {
            line.push('/');
        }
        line.push_str(&labels::one_word(&step.name));
        if let Some(index) = step.index {
            line.push_str(&format!("[{index}]"));
        }
        if step.nth > 0 {
            line.push_str(&format!("~{}", step.nth));
        }
    }
    match &edit.change {
        Change::Add | Change::RemoveChunk => line.push('/'),
        Change::Remove => {}
        Change::Set(RawValue::Value(value)) => {
            let name = edit.path.last().map_or("", |step| step.name.as_str());
            line.push_str(" = ");
            line.push_str(&raw_value::print(value, name, 0, keep));
        }
        Change::Set(RawValue::Bytes(n)) => line.push_str(&format!(" = bytes ${n}")),
        Change::Set(RawValue::Bitmap(n)) => line.push_str(&format!(" = bitmap ${n}")),
    }
    line.push('\n');
}

/// Bytes as lines of base64.
fn base64_lines(bytes: &[u8]) -> String {
    use base64::{Engine, engine::general_purpose::STANDARD as BASE64};
    const WIDTH: usize = 96;
    let all = BASE64.encode(bytes);
    if all.len() <= WIDTH {
        return text::quote(&all, '"');
    }
    let lines: Vec<&str> =
        all.as_bytes().chunks(WIDTH).filter_map(|line| std::str::from_utf8(line).ok()).collect();
    text::raw(&lines.join("\n"), 0)
}
