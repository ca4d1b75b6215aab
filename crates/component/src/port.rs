use katydid_data::{Kind, Tree, Value};
use uuid::Uuid;

use crate::{Call, Outcome};

/// How much of its data a port takes at a time.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Access {
    /// One item an iteration.
    Item,
    /// One branch an iteration.
    List,
    /// Everything at once.
    Tree,
}

/// One input or output of a component.
#[derive(Debug)]
pub struct Port {
    /// The name in full.
    pub name: &'static str,
    /// The short name on the capsule.
    pub nick: &'static str,
    /// What goes in or comes out: units, ranges.
    pub help: &'static str,
    /// The type of its items.
    pub kind: Kind,
    /// How much of its data it takes at a time.
    pub access: Access,
    /// Whether the component runs without data here.
    pub optional: bool,
    /// Whether this port stands for any number of ports of its kind.
    pub many: bool,
    /// The data it has when nothing is given.
    pub default: Option<fn() -> Tree>,
}

/// A component: its names, its ports and the function behind it.
#[derive(Debug)]
pub struct Component {
    /// The type's id, as Grasshopper's files have it.
    pub guid: Uuid,
    /// Ids of earlier versions that mean the same.
    pub also: &'static [Uuid],
    /// The name in full.
    pub name: &'static str,
    /// The short name on the capsule.
    pub nick: &'static str,
    /// The tab it stands in.
    pub tab: &'static str,
    /// The panel of that tab.
    pub panel: &'static str,
    /// What it does, for its user.
    pub help: &'static str,
    /// Whether it is a parameter, slider or panel: an object that is its own port.
    pub floating: bool,
    /// Whether it is an earlier version with other ports: kept for old files, not offered by name.
    pub old: bool,
    /// The inputs; one that stands for many comes last.
    pub inputs: &'static [Port],
    /// The outputs; one that stands for many comes last.
    pub outputs: &'static [Port],
    /// Does the work on data that is cast to the ports' types.
    pub run: fn(&Call<'_>) -> Outcome,
}

inventory::collect!(Component);

impl Component {
    /// The port behind input `i`: past the fixed ones it is the one that stands for many.
    pub fn input(&self, i: usize) -> Option<&'static Port> {
        port(self.inputs, i)
    }

    /// The port behind output `i`.
    pub fn output(&self, i: usize) -> Option<&'static Port> {
        port(self.outputs, i)
    }

    /// Whether inputs can be added and removed.
    pub fn has_variable_inputs(&self) -> bool {
        self.inputs.last().is_some_and(|p| p.many)
    }
}

fn port(ports: &'static [Port], i: usize) -> Option<&'static Port> {
    ports.get(i).or_else(|| ports.last().filter(|p| p.many))
}

/// A list of default values at `{0}`.
pub fn default_tree<const N: usize>(values: [Value; N]) -> Tree {
    Tree::branch_at(katydid_data::Path::zero(), katydid_data::Column::of_values(values.to_vec(), None))
}
