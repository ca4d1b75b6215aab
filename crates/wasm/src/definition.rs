//! A definition that is opened, set, solved and read.

use katydid_data::{Column, Items, Tree};
use katydid_definition::document::{Object, Special};
use katydid_session::{Report, Session};
use katydid_solver::Summary;
use katydid_studio::{Form, Wishes};
use serde::Serialize;
use uuid::Uuid;

use crate::opening;

/// An input that can be set.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Put {
    /// The name that it is set by.
    pub name: String,
    /// The object: unlike names, ids are never the same.
    pub id: Uuid,
}

/// An output of an object.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
struct Given {
    /// The name of a group `RH_OUT:name` around the object; else the object's nickname and the port's.
    name: String,
    /// The port.
    id: Uuid,
    /// The object.
    object: Uuid,
    /// Whether a group marks it as an output of the definition.
    marked: bool,
}

/// The data of an output.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct Data {
    /// The type of the items.
    pub kind: &'static str,
    /// The paths of the branches, as `{0;1}`.
    pub paths: Vec<String>,
    /// Where each branch ends among the items.
    pub ends: Vec<usize>,
    /// How many items there are.
    pub count: usize,
}

/// A definition with its results.
#[derive(Debug)]
pub struct Definition {
    session: Session,
}

impl Definition {
    /// Reads a definition in any of the forms; nothing is solved yet.
    ///
    /// # Errors
    /// What is wrong with the bytes, and where.
    pub fn open(bytes: &[u8]) -> Result<Self, String> {
        let opened = opening::open(opening::form_of(bytes), bytes)?;
        Ok(Self { session: Session::new(opened.document, opening::options(opened.rules)) })
    }

    /// The inputs that can be set, in the order of the document.
    pub fn inputs(&self) -> Vec<Put> {
        katydid_session::inputs(self.session.document())
            .into_iter()
            .map(|(name, id)| Put { name, id })
            .collect()
    }

    fn marked_name(&self, object: &Object) -> Option<String> {
        self.session.document().objects.iter().find_map(|group| match group.special()? {
            Special::Group(group) if group.marks_output() && group.members.contains(&object.id) => {
                Some(group.marked_name().to_owned())
            }
            _ => None,
        })
    }

    fn given(&self) -> Vec<Given> {
        let mut all = Vec::new();
        for object in &self.session.document().objects {
            if object.outputs.is_empty() {
                continue;
            }
            let marked = self.marked_name(object);
            for port in &object.outputs {
                let own = if port.id == object.id {
                    object.title().to_owned()
                } else {
                    format!("{}.{}", object.title(), port.nickname)
                };
                let name = marked.clone().unwrap_or(own);
                all.push(Given { name, id: port.id, object: object.id, marked: marked.is_some() });
            }
        }
        all
    }

    /// The outputs of all objects, as JSON.
    pub fn outputs(&self) -> String {
        serde_json::to_string(&self.given()).unwrap_or_default()
    }

    /// Sets an input by its name or id. Gives the id of the object.
    ///
    /// # Errors
    /// When there is no such input, or several, or it does not take that value.
    pub fn set(&mut self, name: &str, value: &str) -> Result<Uuid, String> {
        self.session.set(name, value).map_err(|error| error.to_string())
    }

    /// Solves what has changed.
    pub fn solve(&mut self) -> Summary {
        self.session.solve()
    }

    /// Ends a solve after so many seconds; 0 for never.
    pub fn limit_seconds(&mut self, seconds: f64) {
        let time = std::time::Duration::try_from_secs_f64(seconds).ok().filter(|time| !time.is_zero());
        self.session.options_mut().limits.time = time;
    }

    /// The results, as `katydid run --json` prints them: with the texts that panels show, or with `values` numbers in
    /// full precision.
    pub fn report(&self, values: bool) -> Report {
        let items = if values { katydid_session::Items::Values } else { katydid_session::Items::Texts };
        self.session.report_with(items)
    }

    /// The data of an output by its id or its name.
    ///
    /// # Errors
    /// When there is no such output, there are several, or it is not solved.
    fn tree(&self, name: &str) -> Result<Tree, String> {
        let all = self.given();
        let by_id = Uuid::try_parse(name).ok();
        let is_meant = |given: &&Given| match by_id {
            Some(id) => given.id == id,
            None => given.name == name,
        };
        let found: Vec<&Given> = all.iter().filter(is_meant).collect();
        let given = match found.as_slice() {
            [one] => *one,
            [] => return Err(format!("no output is called '{name}'")),
            many => return Err(format!("{} outputs are called '{name}': use one of their ids", many.len())),
        };
        let objects = &self.session.document().objects;
        let at = objects.iter().position(|object| object.id == given.object);
        let k = at.and_then(|at| objects.get(at)?.outputs.iter().position(|port| port.id == given.id));
        let report = at.and_then(|at| self.session.engine().report(at));
        let tree = report.zip(k).and_then(|(report, k)| report.outputs.get(k).cloned());
        tree.ok_or_else(|| format!("'{name}' has no data: solve first"))
    }

    /// What an output holds, without its items.
    ///
    /// # Errors
    /// When there is no such output, or it is not solved.
    pub fn data(&self, name: &str) -> Result<Data, String> {
        let tree = self.tree(name)?;
        Ok(Data {
            kind: tree.column().kind().name(),
            paths: tree.paths().iter().map(ToString::to_string).collect(),
            ends: tree.shared_ends().as_ref().clone(),
            count: tree.item_count(),
        })
    }

    /// The items of an output as a panel shows them, as a JSON array; those that are null are `null`.
    ///
    /// # Errors
    /// When there is no such output, or it is not solved.
    pub fn texts(&self, name: &str) -> Result<String, String> {
        let tree = self.tree(name)?;
        let rules = self.session.engine().options().rules;
        let style = katydid_data::text::Style { units: rules.units, tolerance: rules.tolerance };
        let texts: Vec<Option<String>> = tree
            .column()
            .iter()
            .map(|value| value.map(|value| katydid_data::text::value(&value, &style)))
            .collect();
        serde_json::to_string(&texts).map_err(|error| error.to_string())
    }

    /// The items of an output as numbers: one for each number, integer or boolean, three for each point or vector;
    /// NaN for those that are null.
    ///
    /// # Errors
    /// When there is no such output, it is not solved, or its items are of another type.
    pub fn numbers(&self, name: &str) -> Result<Vec<f64>, String> {
        let tree = self.tree(name)?;
        numbers(tree.column()).ok_or_else(|| {
            format!("'{name}' holds {}, which is not made of numbers", tree.column().kind().name())
        })
    }

    /// A picture of what the definition makes, or with `canvas` of the definition itself.
    ///
    /// # Errors
    /// What is wrong with the wishes, or why it cannot be drawn.
    pub fn export(&self, wishes: &Wishes) -> Result<(Vec<u8>, &'static str), String> {
        katydid_studio::export(self.session.engine(), wishes)
    }

    /// The definition in a form.
    ///
    /// # Errors
    /// When it cannot be written in it.
    pub fn save(&self, form: Form) -> Result<Vec<u8>, String> {
        katydid_studio::write(form, self.session.document()).map(|(bytes, _)| bytes)
    }
}

fn numbers(column: &Column) -> Option<Vec<f64>> {
    let (mut all, wide) = match column.items() {
        Items::Numbers(items) => (items.as_ref().clone(), 1),
        Items::Integers(items) => (items.iter().map(|i| f64::from(*i)).collect(), 1),
        Items::Booleans(items) => (items.iter().map(|b| f64::from(u8::from(*b))).collect(), 1),
        Items::Points(items) => (items.iter().flat_map(|p| [p.x, p.y, p.z]).collect(), 3),
        Items::Vectors(items) => (items.iter().flat_map(|v| [v.x, v.y, v.z]).collect(), 3),
        _ => return None,
    };
    for (null, place) in column.null_mask().unwrap_or_default().iter().zip(all.chunks_mut(wide)) {
        if *null {
            place.fill(f64::NAN);
        }
    }
    Some(all)
}

#[cfg(test)]
mod tests {
    use super::*;

    const SUM: &str = "katydid 1\na = Number Slider(3.0, 0..10)\nb = Series(a, 2, 4)\n";

    #[test]
    fn a_series_by_its_numbers() {
        let mut definition = Definition::open(b"katydid 1\nmany = Series(1, 2, 4)\n").unwrap();
        definition.solve();
        let outputs = definition.outputs();
        let all: Vec<serde_json::Value> = serde_json::from_str(&outputs).unwrap();
        let id = all[0]["id"].as_str().unwrap();
        assert_eq!(definition.numbers(id).unwrap(), [1.0, 3.0, 5.0, 7.0]);
        assert_eq!(definition.data(id).unwrap().count, 4);
        assert_eq!(definition.texts(id).unwrap(), r#"["1","3","5","7"]"#);
        assert!(definition.numbers("nothing").is_err());
    }

    #[test]
    fn what_is_no_definition_is_refused() {
        for bytes in [&b""[..], b"katydid", b"<", b"\0\0\0", SUM.as_bytes().get(..12).unwrap()] {
            let _ = Definition::open(bytes);
        }
        assert!(Definition::open(b"no definition").is_err());
    }
}
