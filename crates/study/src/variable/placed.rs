//! Inputs put at numbers to all their digits, as differences need them.

use katydid_data::{Tree, Value};
use katydid_definition::document::Object;
use katydid_definition::document::special::{Rounding, Slider};
use katydid_session::edit_inside;
use katydid_solver::Engine;

use super::{Kind, Variable, rounded};

impl Variable {
    /// Makes a slider take numbers to 12 digits whose number goes through an expression, since what is given to it from outside
    /// would go past the expression; and everything inside a cluster, since nothing can be given to it from outside.
    pub(crate) fn refine(&self, engine: &mut Engine) {
        let (chunk, digits) = match &self.kind {
            Kind::Slider(Slider { rounding: Rounding::Real, expression, .. })
                if expression.is_some() || !self.within.is_empty() =>
            {
                ("Slider", "Digits")
            }
            Kind::Gene { .. } if !self.within.is_empty() => ("GeneData", "Decimals"),
            _ => return,
        };
        self.edit(engine, |object| {
            if let Some(chunk) = object.container_mut().child_mut(chunk) {
                chunk.set(digits, 12_i32);
            }
        });
    }

    /// Puts it at a number to all its digits, without a change of the document where that can be. `genes` are the numbers of
    /// its pool that are not as in the document.
    pub(crate) fn place(&self, engine: &mut Engine, x: f64, genes: &[(usize, f64)]) {
        let is_inside = !self.within.is_empty();
        match &self.kind {
            // A number outside the limits is refused where it comes from.
            Kind::Slider(slider) if is_inside || slider.expression.is_some() => {
                self.edit(engine, |object| drop(object.set_slider(x)));
            }
            Kind::Slider(_) => engine.give(self.object, 0, Some(Tree::item(Value::Number(x)))),
            Kind::Gene { index, .. } if is_inside => {
                self.edit(engine, |object| drop(object.set_gene(*index, x)));
            }
            Kind::Gene { pool, .. } => {
                let mut values: Vec<f64> = pool.values.iter().map(|x| rounded(*x, pool)).collect();
                for (index, x) in genes {
                    if let Some(value) = values.get_mut(*index) {
                        *value = *x;
                    }
                }
                engine.give(self.object, 0, Some(Tree::list(values)));
            }
            _ => {}
        }
    }

    /// Changes its object in an engine. What cannot be opened was refused when the variable was found.
    fn edit(&self, engine: &mut Engine, change: impl FnOnce(&mut Object)) {
        engine.edit(self.object, |object| drop(edit_inside(object, &self.within, change)));
    }
}
