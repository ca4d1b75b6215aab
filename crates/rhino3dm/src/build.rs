//! Finding and making layers, groups, blocks and materials of a model by name.

use uuid::Uuid;

use crate::model::{Model, ModelObject};
use crate::unit_scale::{UnitScale, unit_number};
use crate::{Block, Group, Layer, Material, ObjectMode};

/// What stands between the names of a layer and its parent.
const SEPARATOR: &str = "::";

impl Model {
    /// The full name of a layer: the names from the top level down to it, joined by `::`.
    pub fn layer_path(&self, layer: usize) -> Option<String> {
        let mut current = self.layers.get(layer)?;
        let mut names = vec![current.name.as_str()];
        // Parents that run in a circle end after as many steps as there are layers.
        for _ in 0..self.layers.len() {
            let Some(parent) = current.parent.and_then(|id| self.layers.iter().find(|l| l.id == id)) else {
                break;
            };
            names.push(&parent.name);
            current = parent;
        }
        names.reverse();
        Some(names.join(SEPARATOR))
    }

    /// The layer of a full name such as `walls::inner`, found whatever the case of letters as programs do it, or
    /// made together with the parents that are missing. Empty names between the separators are passed over; of a
    /// path without any name the layer is called Default.
    ///
    /// ```
    /// let mut model = katydid_3dm::Model::default();
    /// let inner = model.layer_at("walls::inner");
    /// assert_eq!(model.layer_path(inner).as_deref(), Some("walls::inner"));
    /// assert_eq!(model.layer_at("Walls::inner"), inner);
    /// assert_eq!(model.layers.len(), 2);
    /// ```
    pub fn layer_at(&mut self, path: &str) -> usize {
        let mut names: Vec<&str> =
            path.split(SEPARATOR).map(str::trim).filter(|name| !name.is_empty()).collect();
        if names.is_empty() {
            names.push("Default");
        }
        let mut place = 0;
        let mut parent: Option<Uuid> = None;
        for name in names {
            place = self.layer_under(name, parent);
            parent = self.layer_id(place);
        }
        place
    }

    fn layer_under(&mut self, name: &str, parent: Option<Uuid>) -> usize {
        let wanted = name.to_lowercase();
        let same = |layer: &Layer| layer.parent == parent && layer.name.to_lowercase() == wanted;
        self.layers.iter().position(same).unwrap_or_else(|| {
            self.layers.push(Layer { parent, ..Layer::new(name) });
            self.layers.len() - 1
        })
    }

    /// The identifier of a layer, given to it now when it has none.
    fn layer_id(&mut self, place: usize) -> Option<Uuid> {
        let known: Vec<Uuid> = self.layers.iter().map(|layer| layer.id).collect();
        let layer = self.layers.get_mut(place)?;
        if layer.id.is_nil() {
            layer.id = unused_id("layer", &layer.name, place, &known);
        }
        Some(layer.id)
    }

    /// The group of a name, made when there is none.
    pub fn group_named(&mut self, name: &str) -> usize {
        self.groups.iter().position(|group| group.name == name).unwrap_or_else(|| {
            self.groups.push(Group::new(name));
            self.groups.len() - 1
        })
    }

    /// The groups of an object.
    pub fn groups_of(&self, object: &ModelObject) -> impl Iterator<Item = &Group> {
        object.attributes.groups.iter().filter_map(|group| self.groups.get(*group))
    }

    /// The objects of a group, an index into [`Model::groups`].
    pub fn in_group(&self, group: usize) -> impl Iterator<Item = &ModelObject> {
        self.objects.iter().filter(move |object| object.attributes.groups.contains(&group))
    }

    /// Adds a material, unless the same is there already; gives its place.
    pub fn add_material(&mut self, material: Material) -> usize {
        self.materials.iter().position(|known| *known == material).unwrap_or_else(|| {
            self.materials.push(material);
            self.materials.len() - 1
        })
    }

    /// The block definition of a name, found whatever the case of letters.
    pub fn block(&self, name: &str) -> Option<&Block> {
        let wanted = name.to_lowercase();
        self.blocks.iter().find(|block| block.name.to_lowercase() == wanted)
    }

    /// The block definition of an identifier, as references have it.
    pub fn block_by_id(&self, id: Uuid) -> Option<&Block> {
        self.blocks.iter().find(|block| block.id == id)
    }

    /// The member objects of a block definition in its order. Identifiers without an object are passed over.
    pub fn members(&self, block: &Block) -> impl Iterator<Item = &ModelObject> {
        let find = |id: &Uuid| self.objects.iter().find(|object| object.attributes.id == *id);
        block.members.iter().filter_map(find)
    }

    /// Adds a block definition with its member objects; gives its identifier, by which references name it. Members
    /// get the mode of members and, where they have none, an identifier. A name that is taken gets a number behind
    /// it, since names of blocks are unique.
    pub fn add_block(&mut self, name: &str, members: Vec<ModelObject>) -> Uuid {
        let mut known: Vec<Uuid> = self.objects.iter().map(|object| object.attributes.id).collect();
        let mut ids = Vec::with_capacity(members.len());
        for mut member in members {
            let attributes = &mut member.attributes;
            attributes.mode = ObjectMode::InDefinition;
            if attributes.id.is_nil() || known.contains(&attributes.id) {
                attributes.id = unused_id(name, &attributes.name, self.objects.len(), &known);
            }
            known.push(attributes.id);
            ids.push(attributes.id);
            self.objects.push(member);
        }
        let name = self.free_block_name(name);
        let blocks: Vec<Uuid> = self.blocks.iter().map(|block| block.id).collect();
        let id = unused_id("block", &name, self.blocks.len(), &blocks);
        let units = self.unit_scale.clone().unwrap_or_else(|| {
            let (number, metres) = unit_number(self.units);
            UnitScale { number, name: String::new(), metres }
        });
        self.blocks.push(Block { id, name, members: ids, units, ..Block::default() });
        id
    }

    fn free_block_name(&self, name: &str) -> String {
        let name = if name.trim().is_empty() { "Block" } else { name.trim() };
        let numbered = (2_u32..).map(|number| format!("{name} {number}"));
        let mut candidates = std::iter::once(name.to_owned()).chain(numbered);
        candidates.find(|candidate| self.block(candidate).is_none()).unwrap_or_default()
    }
}

/// An identifier of version 8 (custom, RFC 9562) from two texts and a number, that is none of those known.
fn unused_id(kind: &str, name: &str, number: usize, known: &[Uuid]) -> Uuid {
    let mut number = number as u64;
    loop {
        let text = format!("{kind}\0{name}");
        let id = crate::ids::made_id(number, text.as_bytes());
        if !known.contains(&id) {
            return id;
        }
        number = number.wrapping_add(1 << 32);
    }
}
