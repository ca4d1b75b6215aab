//! Runs a component by name on data written down in a test.

use std::sync::Arc;

use katydid_data::{Column, Path, Tree, TreeBuilder, Value, text};
use katydid_definition::archive::{Chunk, ItemValue};

use crate::{Account, Budget, Call, Component, Files, Kept, Limits, Outbox, Outcome, RhinoModel, registry};

/// A component with its inputs.
///
/// ```
/// use katydid_component::{component, testing::Trial};
///
/// /// Twice a number.
/// #[component("00000000-0000-0000-0000-0000000000d2", name = "Doc Twice", nick = "2x", at = "Doc/Tests")]
/// #[output("Result", "R", "The double.")]
/// fn twice(
///     /// The number.
///     #[port("Number", "x")]
///     x: f64,
/// ) -> f64 {
///     2.0 * x
/// }
///
/// assert_eq!(Trial::of("Doc Twice").list([1.0, 2.5]).texts(0), ["{0}: 2, 5"]);
/// ```
#[derive(Debug)]
pub struct Trial {
    component: &'static Component,
    inputs: Vec<Tree>,
    names: Vec<String>,
    settings: Chunk,
    outputs: usize,
    limits: Limits,
    files: Files,
    outbox: Option<Arc<Outbox>>,
    kept: Option<Arc<Kept>>,
    model: Option<RhinoModel>,
}

impl Trial {
    /// A trial of the component with that name.
    ///
    /// # Panics
    /// When there is none.
    #[expect(clippy::panic, reason = "for tests")]
    pub fn of(name: &str) -> Self {
        let Some(component) = registry::by_name(name) else { panic!("no component is called {name}") };
        Self::with(component)
    }

    /// A trial of the component with that id.
    ///
    /// # Panics
    /// When there is none.
    #[expect(clippy::panic, reason = "for tests")]
    pub fn of_guid(guid: &str) -> Self {
        let found = uuid::Uuid::parse_str(guid).ok().and_then(registry::by_guid);
        let Some(component) = found else { panic!("no component has the id {guid}") };
        Self::with(component)
    }

    fn with(component: &'static Component) -> Self {
        Self {
            component,
            inputs: Vec::new(),
            names: Vec::new(),
            settings: Chunk::default(),
            outputs: component.outputs.len(),
            limits: Limits::default(),
            files: Files::default(),
            outbox: None,
            kept: None,
            model: None,
        }
    }

    /// The next input is one item at `{0}`.
    #[must_use]
    pub fn item(self, value: impl Into<Value>) -> Self {
        self.tree(Tree::item(value.into()))
    }

    /// The next input is a list at `{0}`.
    #[must_use]
    pub fn list<T: Into<Value>>(self, values: impl IntoIterator<Item = T>) -> Self {
        let values = values.into_iter().map(Into::into).collect();
        self.tree(Tree::branch_at(Path::zero(), Column::of_values(values, None)))
    }

    /// The next input is a list of values and nulls at `{0}`.
    #[must_use]
    pub fn gaps<T: Into<Value>>(self, values: impl IntoIterator<Item = Option<T>>) -> Self {
        let values = values.into_iter().map(|v| v.map(Into::into)).collect();
        self.tree(Tree::branch_at(Path::zero(), Column::of_options(values)))
    }

    /// The next input is a tree of branches.
    #[must_use]
    pub fn branches<T: Into<Value>, const N: usize>(
        self,
        branches: impl IntoIterator<Item = (&'static str, [T; N])>,
    ) -> Self {
        let mut builder = TreeBuilder::<Value>::new();
        for (path, items) in branches {
            builder.branch(path.parse().unwrap_or_default());
            items.into_iter().for_each(|item| builder.push(Some(item.into())));
        }
        self.tree(builder.finish())
    }

    /// The next input is this tree.
    #[must_use]
    pub fn tree(mut self, tree: Tree) -> Self {
        let rules = Default::default();
        let kind = self.component.input(self.inputs.len()).map_or(katydid_data::Kind::Generic, |p| p.kind);
        let column = katydid_data::cast::column(tree.column(), kind, &rules).column;
        self.inputs.push(tree.with_column(column));
        self
    }

    /// The next input has what it has when nothing is given.
    #[must_use]
    pub fn default(mut self) -> Self {
        let default = self.component.input(self.inputs.len()).and_then(|p| p.default);
        self.inputs.push(default.map_or_else(Tree::empty, |d| d()));
        self
    }

    /// The nicknames of the inputs.
    #[must_use]
    pub fn names<const N: usize>(mut self, names: [&str; N]) -> Self {
        self.names = names.map(str::to_owned).to_vec();
        self
    }

    /// Something that the object has stored.
    #[must_use]
    pub fn setting(mut self, name: &str, value: impl Into<ItemValue>) -> Self {
        self.settings.set(name, value);
        self
    }

    /// Everything that the object has stored.
    #[must_use]
    pub fn settings(mut self, settings: Chunk) -> Self {
        self.settings = settings;
        self
    }

    /// The number of outputs, where they can be added.
    #[must_use]
    pub fn outputs(mut self, n: usize) -> Self {
        self.outputs = n;
        self
    }

    /// What the component may use.
    #[must_use]
    pub fn limits(mut self, limits: Limits) -> Self {
        self.limits = limits;
        self
    }

    /// The Rhino model that the component may look into.
    #[must_use]
    pub fn model(mut self, model: RhinoModel) -> Self {
        self.model = Some(model);
        self
    }

    /// The files that it may read.
    #[must_use]
    pub fn files(mut self, files: Files) -> Self {
        self.files = files;
        self
    }

    /// The files that the component writes go there.
    #[must_use]
    pub fn outbox(mut self, outbox: &Arc<Outbox>) -> Self {
        self.outbox = Some(outbox.clone());
        self
    }

    /// What the component keeps from run to run stands there.
    #[must_use]
    pub fn kept(mut self, kept: &Arc<Kept>) -> Self {
        self.kept = Some(kept.clone());
        self
    }

    /// Runs it; inputs not given have their defaults.
    pub fn run(mut self) -> Outcome {
        while self.component.inputs.get(self.inputs.len()).is_some_and(|p| !p.many) {
            self = self.default();
        }
        let solve = Arc::new(Account::new(self.limits.solve_bytes));
        let budget = Budget::new(self.limits, Default::default(), Default::default(), solve);
        let call = Call {
            inputs: &self.inputs,
            input_names: &self.names,
            output_count: self.outputs,
            wanted: &[],
            settings: &self.settings,
            rules: Default::default(),
            budget: &budget,
            files: &self.files,
            outbox: self.outbox.as_deref(),
            kept: self.kept.as_deref(),
            model: self.model.as_ref(),
        };
        budget.token().during(|| (self.component.run)(&call))
    }

    /// Runs it, and gives the texts of one output, a line a branch: `{0;1}: 2, 5`.
    pub fn texts(self, output: usize) -> Vec<String> {
        texts(self.run().outputs.get(output).unwrap_or(&Tree::empty()))
    }

    /// Runs it, and gives the first message's text; empty when there is none.
    pub fn message(self) -> String {
        self.run().messages.into_iter().next().map(|m| m.text).unwrap_or_default()
    }
}

/// The texts of a tree, a line a branch: `{0;1}: 2, 5`.
pub fn texts(tree: &Tree) -> Vec<String> {
    let style = text::Style::default();
    tree.branches()
        .map(|branch| {
            let items: Vec<String> = branch.iter().map(|item| text::item(item.as_ref(), &style)).collect();
            format!("{}: {}", branch.path(), items.join(", ")).trim_end().to_owned()
        })
        .collect()
}
