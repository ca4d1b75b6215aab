use std::sync::Arc;

use katydid_component::RhinoModel;
use katydid_data::Tree;
use katydid_data::cast::Rules;
use katydid_definition::document::{Document, Lookup, Object, PortRef};
use uuid::Uuid;

use crate::Refusal;

/// The data that ports have now: some edits keep it.
pub trait Results {
    /// The data of an output, after its modifiers; none while it is not solved.
    fn output(&self, port: Uuid, within: &[Uuid]) -> Option<Tree>;

    /// The Rhino model beside the document.
    fn model(&self) -> Option<&RhinoModel> {
        None
    }
}

/// No data at all.
#[derive(Debug, Clone, Copy, Default)]
pub struct NoResults;

impl Results for NoResults {
    fn output(&self, _: Uuid, _: &[Uuid]) -> Option<Tree> {
        None
    }
}

/// A document while it is edited: when the edit is refused, it is thrown away.
pub(crate) struct Draft<'a> {
    /// The document as far as the edit has come.
    pub(crate) document: Document,
    /// The clusters that lead to it.
    pub(crate) within: &'a [Uuid],
    /// The data of its ports.
    pub(crate) results: &'a dyn Results,
    /// Its units and tolerances.
    pub(crate) rules: Rules,
    /// The objects that a paste or copy made.
    pub(crate) made: Vec<Uuid>,
    lookup: Option<Arc<Lookup>>,
}

impl<'a> Draft<'a> {
    pub(crate) fn new(
        document: Document,
        lookup: Option<Arc<Lookup>>,
        within: &'a [Uuid],
        results: &'a dyn Results,
        rules: Rules,
    ) -> Self {
        Self { document, within, results, rules, made: Vec::new(), lookup }
    }

    /// Where the ids are. Edits that add, remove or reorder objects or ports call [`stir`](Self::stir).
    pub(crate) fn lookup(&mut self) -> Arc<Lookup> {
        let document = &self.document;
        Arc::clone(self.lookup.get_or_insert_with(|| Arc::new(document.lookup())))
    }

    /// The ids are elsewhere now.
    pub(crate) fn stir(&mut self) {
        self.lookup = None;
    }

    /// The place of an object, if it is there.
    pub(crate) fn place(&mut self, id: Uuid) -> Option<usize> {
        self.lookup().object(id)
    }

    /// Whether an object or port has that id.
    pub(crate) fn has(&mut self, id: Uuid) -> bool {
        let lookup = self.lookup();
        lookup.object(id).is_some() || lookup.input(id).is_some() || lookup.output(id).is_some()
    }

    /// The object with that id.
    pub(crate) fn object(&mut self, id: Uuid) -> Result<&mut Object, Refusal> {
        let at = self.place(id).ok_or(Refusal::NoObject(id))?;
        self.document.objects.get_mut(at).ok_or(Refusal::NoObject(id))
    }

    /// The input with that id.
    pub(crate) fn input(&mut self, id: Uuid) -> Result<PortRef, Refusal> {
        self.lookup().input(id).ok_or(Refusal::NoPort(id))
    }

    /// The object at a place that a lookup gave.
    pub(crate) fn at(&mut self, at: usize) -> Result<&mut Object, Refusal> {
        self.document.objects.get_mut(at).ok_or_else(|| Refusal::Senseless("the object is gone".to_owned()))
    }
}
