//! Results of a document and of what is inside its clusters, as a face asks for them.

use katydid_component::RhinoModel;
use katydid_data::{Tree, text};
use katydid_definition::document::{Document, Object, ids};
use katydid_solver::ObjectReport;
use uuid::Uuid;

use crate::protocol::{Page, ResultView};
use crate::{Digits, Results, editor, result_view, rows};

/// Gives the report of an object by its id; none while it is not solved.
pub type Reports<'a> = dyn Fn(Uuid) -> Option<ObjectReport> + 'a;

/// A document with the reports of its objects, as far as they are solved. Copies of reports share their data.
pub struct Solution<'a> {
    document: &'a Document,
    report: &'a Reports<'a>,
    model: Option<&'a RhinoModel>,
}

impl std::fmt::Debug for Solution<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Solution").field("objects", &self.document.objects.len()).finish_non_exhaustive()
    }
}

/// The objects where `within` leads to, with their reports.
type Inside = Vec<(Object, Option<ObjectReport>)>;

impl<'a> Solution<'a> {
    /// The solution of a document.
    pub fn new(document: &'a Document, report: &'a Reports<'a>) -> Self {
        Self { document, report, model: None }
    }

    /// The same beside a Rhino model.
    pub fn beside(self, model: Option<&'a RhinoModel>) -> Self {
        Self { model, ..self }
    }

    fn inside(&self, within: &[Uuid]) -> Option<Inside> {
        let Some((first, rest)) = within.split_first() else {
            let objects = self.document.objects.iter();
            return Some(objects.map(|object| (object.clone(), (self.report)(object.id))).collect());
        };
        let mut cluster = self.document.objects.iter().find(|object| object.id == *first)?.clone();
        let mut report = (self.report)(*first)?;
        let mut rest = rest.iter();
        loop {
            let document = editor::content(&cluster).ok()?;
            let reports = report.inside.clone()?;
            // Somebody may have changed the inside since it was solved.
            if reports.len() != document.objects.len() {
                return None;
            }
            let mut all = document.objects.into_iter().zip(reports.iter().cloned().map(Some));
            let Some(next) = rest.next() else { return Some(all.collect()) };
            let (object, inner) = all.find(|(object, _)| object.id == *next)?;
            cluster = object;
            report = inner?;
        }
    }

    /// The results of the objects where `within` leads to; none where nothing is solved.
    pub fn views(&self, within: &[Uuid], style: &text::Style) -> Vec<ResultView> {
        let objects = self.inside(within).unwrap_or_default();
        objects
            .iter()
            .filter_map(|(object, report)| Some(result_view(object, report.as_ref()?, style)))
            .collect()
    }

    /// The data of a port: what an output gives, and what the wires of an input, or of a Param Viewer, bring.
    pub fn data(&self, port: Uuid, within: &[Uuid]) -> Option<Tree> {
        let objects = self.inside(within)?;
        let output = |id: Uuid| {
            let found = objects.iter().find_map(|(object, report)| {
                let k = object.outputs.iter().position(|port| port.id == id)?;
                Some((k, report.as_ref()?))
            });
            found.and_then(|(k, report)| report.outputs.get(k).cloned())
        };
        // A viewer shows what comes in, and gives its paths.
        let views =
            objects.iter().any(|(object, _)| object.component == ids::PARAM_VIEWER && object.id == port);
        if let Some(tree) = output(port).filter(|_| !views) {
            return Some(tree);
        }
        let input = objects.iter().flat_map(|(object, _)| &object.inputs).find(|input| input.id == port)?;
        let trees: Vec<Tree> = input.sources.iter().filter_map(|source| output(*source)).collect();
        Some(Tree::merge(trees.iter()))
    }

    /// Rows of the data of a port, as a panel shows them: from the first on so many (see [`rows`]).
    pub fn rows(
        &self,
        port: Uuid,
        within: &[Uuid],
        range: [u32; 2],
        digits: Digits,
        style: &text::Style,
    ) -> Option<Page> {
        Some(rows(&self.data(port, within)?, range, digits, style))
    }
}

impl Results for Solution<'_> {
    fn output(&self, port: Uuid, within: &[Uuid]) -> Option<Tree> {
        self.data(port, within)
    }

    fn model(&self) -> Option<&RhinoModel> {
        self.model
    }
}
