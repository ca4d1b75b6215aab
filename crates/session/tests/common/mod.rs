//! A document that is edited and solved as a user would.

#![allow(dead_code, reason = "each test uses a part")]

use katydid_component::registry;
use katydid_data::text;
use katydid_definition::document::{Document, Object};
use katydid_session::protocol::{Connection, Control, Edit, Event, RoundingView};
use katydid_session::{Change, Editor, Refusal, result_view};
use katydid_solver::{Engine, Options};
use uuid::Uuid;

/// A number with everything that a face, a solver and a journal have of it.
pub(crate) struct Studio {
    pub(crate) editor: Editor,
    pub(crate) engine: Engine,
    next: u128,
}

impl Studio {
    pub(crate) fn new(document: Document) -> Self {
        katydid_components::link();
        let editor = Editor::new(document.clone(), Default::default());
        Self { editor, engine: Engine::new(document, Options::default()), next: 0x5eed }
    }

    pub(crate) fn empty() -> Self {
        Self::new(Document::new())
    }

    pub(crate) fn id(&mut self) -> Uuid {
        self.next += 1;
        Uuid::from_u128(self.next << 64 | 1)
    }

    pub(crate) fn follow(&mut self, change: &Change) {
        change.bring_to(&mut self.engine).unwrap();
        assert_eq!(self.engine.document(), &**self.editor.document());
    }

    pub(crate) fn try_do(&mut self, edit: &Edit) -> Result<Change, Refusal> {
        let change = self.editor.apply(edit, None, &[])?;
        self.follow(&change);
        Ok(change)
    }

    #[track_caller]
    pub(crate) fn make(&mut self, edit: Edit) -> Change {
        self.try_do(&edit).unwrap_or_else(|refusal| panic!("{edit:?}: {refusal}"))
    }

    pub(crate) fn drag(&mut self, edit: &Edit, gesture: u64) -> Change {
        let change = self.editor.apply(edit, Some(gesture), &[]).unwrap();
        self.follow(&change);
        change
    }

    pub(crate) fn undo(&mut self) -> bool {
        let Some(change) = self.editor.undo() else { return false };
        self.follow(&change);
        true
    }

    pub(crate) fn redo(&mut self) -> bool {
        let Some(change) = self.editor.redo() else { return false };
        self.follow(&change);
        true
    }

    pub(crate) fn place(&mut self, name: &str, at: [f32; 2]) -> Uuid {
        let component = registry::by_name(name).unwrap_or_else(|| panic!("no {name}")).guid;
        self.place_as(component, at)
    }

    pub(crate) fn place_as(&mut self, component: Uuid, at: [f32; 2]) -> Uuid {
        let id = self.id();
        self.make(Edit::Place { id, component, at, with: None });
        id
    }

    pub(crate) fn slider(&mut self, value: f64, min: f64, max: f64) -> Uuid {
        let id = self.place("Number Slider", [0.0, 0.0]);
        let control =
            Control::Slider { value, min, max, rounding: RoundingView::Float, digits: 3, expression: None };
        self.make(Edit::Reshape { object: id, control });
        id
    }

    pub(crate) fn object(&self, id: Uuid) -> &Object {
        self.editor.document().objects.iter().find(|o| o.id == id).unwrap_or_else(|| panic!("no {id}"))
    }

    pub(crate) fn input(&self, id: Uuid, k: usize) -> Uuid {
        self.object(id).inputs[k].id
    }

    pub(crate) fn output(&self, id: Uuid, k: usize) -> Uuid {
        self.object(id).outputs[k].id
    }

    /// A wire from the first output of one object to an input of another.
    pub(crate) fn wire(&mut self, from: Uuid, to: Uuid, input: usize) {
        let (from, to) = (self.output(from, 0), self.input(to, input));
        self.make(Edit::Connect { from, to, how: Connection::Replace });
    }

    /// What an output holds, as a panel shows it.
    pub(crate) fn texts(&mut self, id: Uuid) -> Vec<String> {
        self.engine.solve();
        texts(&self.engine, id)
    }
}

/// What the first output of an object holds, as a panel shows it.
pub(crate) fn texts(engine: &Engine, id: Uuid) -> Vec<String> {
    let at = engine.document().objects.iter().position(|object| object.id == id).unwrap();
    let tree = &engine.report(at).unwrap().outputs[0];
    let style = text::Style::default();
    tree.column().iter().map(|item| text::item(item.as_ref(), &style)).collect()
}

/// Everything that the results show, by object.
pub(crate) fn results(engine: &Engine) -> Vec<String> {
    let all = engine.document().objects.iter().enumerate();
    all.map(|(at, object)| {
        let report = engine.report(at).unwrap();
        let mut view = result_view(object, report, &Default::default());
        view.milliseconds = 0.0;
        let items: Vec<Vec<_>> =
            report.outputs.iter().map(|tree| tree.column().iter().collect::<Vec<_>>()).collect();
        format!("{view:?} {items:?}")
    })
    .collect()
}

/// A face that follows a document by its patches only.
pub(crate) struct Mirror {
    pub(crate) objects: Vec<katydid_session::protocol::ObjectView>,
}

impl Mirror {
    pub(crate) fn new(editor: &Editor) -> Self {
        Self { objects: editor.state(&[]).unwrap().objects }
    }

    pub(crate) fn follow(&mut self, event: Option<Event>) {
        let Some(Event::Patch { put, removed, order, .. }) = event else { return };
        self.objects.retain(|object| !removed.contains(&object.id));
        for object in put {
            match self.objects.iter_mut().find(|old| old.id == object.id) {
                Some(old) => *old = object,
                None => self.objects.push(object),
            }
        }
        if let Some(order) = order {
            self.objects.sort_by_key(|object| order.iter().position(|id| *id == object.id));
        }
    }
}
