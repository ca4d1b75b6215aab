//! Collects what objects show.

use katydid_data::cast::Rules;
use katydid_data::{Kind, Tree};
use katydid_definition::document::{Object, ids};

use crate::values::Values;
use crate::{Look, Scene, display, rows};

/// An object shows no more things than this: a screen has fewer places.
const MOST_THINGS: usize = 1_000_000;

/// Collects what objects show.
#[derive(Debug)]
pub struct Painter<'a> {
    /// What was collected.
    pub scene: Scene,
    pub(crate) values: Values,
    pub(crate) rules: &'a Rules,
    /// The look of what has no colours of its own.
    pub(crate) look: Look,
}

/// Whether an object shows anything: it runs, its preview is on, and it is more than a note.
pub fn is_shown(object: &Object) -> bool {
    !(object.hidden || object.locked || object.is_annotation())
}

impl<'a> Painter<'a> {
    /// For a picture: what is in one place several times is painted once.
    pub fn for_picture(rules: &'a Rules, look: Look) -> Self {
        Self { scene: Scene::default(), values: Values::new(true), rules, look }
    }

    /// For a scene whose objects can be told apart: each has all its things.
    pub fn for_objects(rules: &'a Rules, look: Look) -> Self {
        Self { scene: Scene::default(), values: Values::new(false), rules, look }
    }

    /// The look of what comes next and has no colours of its own.
    pub fn set_look(&mut self, look: Look) {
        self.look = look;
    }

    /// What could not be shown, in words.
    pub fn left_out(&self) -> &[String] {
        &self.values.left_out
    }

    /// Adds what an object shows: the geometry that it puts out, and what it draws and does not give on. `inputs` is
    /// asked for what it reads, where that is drawn.
    pub fn object(&mut self, object: &Object, outputs: &[Tree], inputs: impl FnOnce() -> Vec<Tree>) {
        if !is_shown(object) {
            return;
        }
        let most = self.scene.things.len().saturating_add(MOST_THINGS);
        // A panel hands geometry on, but shows it as text.
        if object.component != ids::PANEL {
            self.outputs(object, outputs, most);
        }
        if let Some((component, draw)) = display::of(object) {
            let trees = inputs();
            let access: Vec<_> = component.inputs.iter().map(|port| port.access).collect();
            rows::for_each(&trees, &access, |row| {
                if self.scene.things.len() >= most {
                    return self.stop(object);
                }
                self.scene.begin_branch(0, row.path);
                self.scene.begin_item(row.index);
                draw(self, object, row);
            });
        }
    }

    fn outputs(&mut self, object: &Object, outputs: &[Tree], most: usize) {
        for (k, (tree, port)) in outputs.iter().zip(&object.outputs).enumerate() {
            let kind = tree.column().kind();
            if port.hidden || !(kind.is_geometry() || matches!(kind, Kind::Generic | Kind::Content)) {
                continue;
            }
            for branch in tree.branches() {
                self.scene.begin_branch(k, branch.path());
                for (index, value) in branch.iter().enumerate() {
                    let Some(value) = value else { continue };
                    if self.scene.things.len() >= most {
                        return self.stop(object);
                    }
                    self.scene.begin_item(index);
                    self.values.add(&mut self.scene, &value, self.look, self.rules, object.title());
                }
            }
        }
    }

    fn stop(&mut self, object: &Object) {
        let why = format!("only the first {MOST_THINGS} things are shown");
        self.values.leave_out(object.title(), &why);
    }
}

/// Whether an object draws what it reads: its inputs are needed to show it.
pub fn draws_inputs(object: &Object) -> bool {
    display::of(object).is_some()
}
