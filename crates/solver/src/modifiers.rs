//! What a port does to its data after collecting it: expression, switches of its type, shape of the tree.

use std::sync::Arc;

use katydid_component::Message;
use katydid_data::{Column, Gather, Item, Items, Tree, Value, cast, formula};
use katydid_definition::document::{Mapping, Modifiers, Port, Side};
use katydid_expression::Expression;
use katydid_geometry::{Direction, Interval, Vector3};

/// Applies the modifiers in Grasshopper's order: expression, the type's own switches, simplify, flatten or
/// graft, reverse. An output is grafted before it is simplified, so that nothing of its new paths stays that all share.
pub(crate) fn apply(
    tree: Tree,
    port: &Port,
    side: Side,
    rules: &cast::Rules,
    messages: &mut Vec<Message>,
) -> Tree {
    let tree = items(tree, port, rules, messages);
    shape(tree, &port.modifiers, side)
}

fn items(mut tree: Tree, port: &Port, rules: &cast::Rules, messages: &mut Vec<Message>) -> Tree {
    let modifiers = &port.modifiers;
    if let Some(text) = modifiers.expression.as_deref().filter(|text| !text.trim().is_empty()) {
        match expression(tree.column(), text, &port.nickname) {
            Ok(column) => tree = tree.with_column(column),
            Err(message) => {
                messages.push(message);
                tree = tree.with_column(Column::nulls(tree.item_count()));
            }
        }
    }
    if modifiers.degrees {
        tree = map::<f64>(&tree, rules, f64::to_radians);
    }
    if modifiers.invert {
        tree = map::<bool>(&tree, rules, |b| !b);
    }
    if modifiers.unitize {
        tree = map::<Vector3>(&tree, rules, |v| v.unitized().unwrap_or(v));
    }
    if modifiers.reparameterize {
        let unit = |value: Value| match value {
            Value::Curve(curve) => match curve.with_domain(Interval::UNIT) {
                Ok(curve) => Value::from(curve),
                Err(_) => Value::Curve(curve),
            },
            Value::Surface(surface) => {
                let unit = surface.with_domain(Direction::U, Interval::UNIT);
                match unit.and_then(|s| s.with_domain(Direction::V, Interval::UNIT)) {
                    Ok(unit) => Value::from(unit),
                    Err(_) => Value::Surface(surface),
                }
            }
            Value::Brep(_) | Value::Kept(_) => unit_face(&value, rules).unwrap_or(value),
            other => other,
        };
        tree = map::<Value>(&tree, rules, unit);
    }
    tree
}

/// The only face of a brep over 0…1 in both directions, trimmed as it was; nothing for other breps.
fn unit_face(value: &Value, rules: &cast::Rules) -> Option<Value> {
    let brep = value.brep()?.ok()?;
    let ([face], Some(surface)) = (brep.faces(), brep.face_surface(0)) else { return None };
    let unit = surface.with_domain(Direction::U, Interval::UNIT);
    let unit = unit.and_then(|s| s.with_domain(Direction::V, Interval::UNIT)).ok()?;
    let made = brep.copied_trims(0, &unit, &rules.tolerance).ok()?;
    let [only] = <[_; 1]>::try_from(made).ok()?;
    Some(Value::from(if face.reversed { only.flipped() } else { only }))
}

/// Every item of type `T`, which the data is cast to, through `f`.
fn map<T: Item>(tree: &Tree, rules: &cast::Rules, f: impl Fn(T) -> T) -> Tree {
    let column = cast::column(tree.column(), T::KIND, rules).column;
    let mut gather = Gather::<T>::with_capacity(column.len());
    for i in 0..column.len() {
        gather.push(T::get(&column, i).map(&f));
    }
    tree.with_column(gather.finish())
}

/// The shape of the tree only.
fn shape(mut tree: Tree, modifiers: &Modifiers, side: Side) -> Tree {
    let graft_first = side == Side::Output && modifiers.mapping == Mapping::Graft;
    if modifiers.simplify && !graft_first {
        tree = tree.simplify(false);
    }
    match modifiers.mapping {
        Mapping::None => {}
        Mapping::Flatten => tree = tree.flatten(),
        Mapping::Graft => tree = tree.graft(),
    }
    if modifiers.simplify && graft_first {
        tree = tree.simplify(false);
    }
    if modifiers.reverse {
        tree = tree.reverse_branches();
    }
    tree
}

/// Runs a formula over a column. The item is `x` in it, and also goes by the name of its port.
fn expression(column: &Column, text: &str, name: &str) -> Result<Column, Message> {
    let in_port = |error: String| Message::error(format!("In the expression of the port: {error}"));
    let program = Expression::parse(text)
        .and_then(|parsed| parsed.bind(&["x", name]))
        .map_err(|error| in_port(error.render(text)))?;
    if let (Items::Numbers(numbers), false) = (column.items(), column.has_nulls())
        && let Some(Ok(results)) =
            program.evaluate_numbers(&[numbers.as_slice(), numbers.as_slice()], numbers.len())
    {
        return Ok(Column::new(Items::Numbers(Arc::new(results)), None));
    }
    let mut results = Gather::<Value>::with_capacity(column.len());
    for item in column.iter() {
        let Some(item) = item else {
            results.push(None);
            continue;
        };
        let variant = formula::variant(&item)
            .ok_or_else(|| in_port(format!("a {} cannot be used in a formula", item.kind())))?;
        let result =
            program.evaluate(&[variant.clone(), variant]).map_err(|error| in_port(error.render(text)))?;
        // A vector is a point to the formula: it comes back as what it was.
        results.push(formula::value(result).map(|value| match (&item, value) {
            (Value::Vector(_), Value::Point(p)) => Value::Vector(p.to_vector()),
            (_, value) => value,
        }));
    }
    Ok(results.finish())
}
