//! Legends of the Gradient objects of a definition.

use katydid_data::{Tree, text};
use katydid_definition::document::{Document, Special};
use katydid_solver::Inputs;

use crate::Legend;
use crate::colour::of_archive as colour;

/// A picture explains so many gradients at most.
const MOST: usize = 4;

/// A legend for each Gradient: its colours, and the numbers at both ends.
pub fn legends(document: &Document, inputs: &Inputs<'_>) -> Vec<Legend> {
    let legend = |(index, object): (usize, &katydid_definition::document::Object)| {
        let Some(Special::Gradient(gradient)) = object.special() else { return None };
        // The first two inputs are the ends.
        let trees = inputs.of(index);
        let end = |k: usize, otherwise: f64| {
            let number = trees.get(k).map(Tree::column).and_then(|column| column.get(0));
            match number {
                Some(katydid_data::Value::Number(x)) => text::number(x),
                _ => text::number(otherwise),
            }
        };
        let grips =
            gradient.grips.iter().map(|grip| (grip.at, colour(grip.left), colour(grip.right))).collect();
        let name = if object.nickname == object.name { String::new() } else { object.nickname.clone() };
        Some(Legend::Scale { name, grips, low: end(0, 0.0), high: end(1, 1.0) })
    };
    document.objects.iter().enumerate().filter_map(legend).take(MOST).collect()
}
