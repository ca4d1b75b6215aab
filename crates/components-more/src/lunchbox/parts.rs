//! LunchBox Util and Data: faces beside faces, and elements of XML by their names.

use std::sync::Arc as Shared;

use katydid_component::{Context, Message, component};
use katydid_data::{Tree, TreeBuilder, Value};
use katydid_geometry::Brep;
use quick_xml::events::Event;
use quick_xml::{Reader, escape};

/// The most faces of a Brep whose matrix is told: each has a row with a place for each.
const MOST_FACES: usize = 3000;

/// For each face of a Brep those that share an edge with it, rising.
fn neighbours(brep: &Brep) -> Vec<Vec<usize>> {
    let mut lists = vec![Vec::new(); brep.faces().len()];
    for edge in brep.edges().iter().filter(|edge| !edge.deleted) {
        let face = |trim: &usize| {
            let place = brep.trims().get(*trim)?.in_loop?;
            brep.loops().get(place)?.face
        };
        let faces: Vec<usize> = edge.trims.iter().filter_map(face).collect();
        for a in &faces {
            if let Some(list) = lists.get_mut(*a) {
                list.extend(faces.iter().filter(|b| *b != a));
            }
        }
    }
    for list in &mut lists {
        list.sort_unstable();
        list.dedup();
    }
    lists
}

/// The faces of a Brep with those that share an edge with each. Stands for LunchBox's Sort Adjacent Brep Faces.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1c84",
    name = "Sort Adjacent Brep Faces",
    nick = "Adjacent",
    at = "LunchBox/Util"
)]
#[output("Brep Face", "Face", "The faces.", kind = Brep)]
#[output("Adjacent Faces", "Adjacent", "A branch for each face: the faces beside it.", kind = Brep)]
#[output("Adjacent Faces Indices", "AdjIndex", "A branch for each face: the numbers of the faces beside it.", kind = Integer)]
#[output("Adjacency Matrix", "Matrix", "A branch for each face: for each face whether it is beside this one.", kind = Boolean)]
fn adjacent_faces(
    context: &Context<'_>,
    /// The Brep.
    #[port("Brep", "Brep")]
    brep: Shared<Brep>,
) -> Result<(Vec<Value>, Tree, Tree, Tree), Message> {
    let live: Vec<usize> =
        (0..brep.faces().len()).filter(|k| brep.faces().get(*k).is_some_and(|f| !f.deleted)).collect();
    if live.len() > MOST_FACES {
        return Err(Message::error(format!("The Brep has more than {MOST_FACES} faces")));
    }
    context.items(live.len().saturating_mul(live.len() + 10))?;
    let faces = live.iter().map(|k| brep.sub_brep(&[*k]).map(Value::from)).collect::<Result<Vec<_>, _>>()?;
    let lists = neighbours(&brep);
    let mut adjacent = TreeBuilder::<Value>::new();
    let mut indices = TreeBuilder::<i32>::new();
    let mut matrix = TreeBuilder::<bool>::new();
    for (row, place) in (0..).zip(&live) {
        let path = context.path().child(row);
        adjacent.branch(path.clone());
        indices.branch(path.clone());
        matrix.branch(path);
        let beside = lists.get(*place).map_or(&[][..], Vec::as_slice);
        for (number, (other, face)) in (0..).zip(live.iter().zip(&faces)) {
            let is_beside = beside.binary_search(other).is_ok();
            if is_beside {
                adjacent.push(Some(face.clone()));
                indices.push(Some(number));
            }
            matrix.push(Some(is_beside));
        }
    }
    Ok((faces, adjacent.finish(), indices.finish(), matrix.finish()))
}

/// An element that was found: where its content begins, and the texts in it so far.
struct Open {
    /// How deep it stands.
    depth: usize,
    /// Its number among those found.
    number: usize,
    start: usize,
}

fn broken(why: &dyn std::fmt::Display) -> Message {
    Message::error(format!("The XML is broken: {why}"))
}

/// The place of a reader in its text.
fn place(position: u64) -> usize {
    usize::try_from(position).unwrap_or(usize::MAX)
}

/// The elements of a name in a text of XML, in the order in which they begin: the texts in each, and what stands in it as XML.
/// Stands for LunchBox's Read XML by Tag.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1c93",
    name = "Read XML by Tag",
    nick = "XML",
    at = "LunchBox/Data"
)]
#[output(
    "XML InnerText",
    "InnerText",
    "For each element the texts in it and in all that stands in it, joined."
)]
#[output("XML Inner XML", "InnerXML", "For each element what stands in it, as XML.")]
fn read_xml(
    context: &Context<'_>,
    /// The XML.
    #[port("XML", "XML")]
    xml: Shared<str>,
    /// The name of the elements; `*` stands for all.
    #[port("XML Tag", "Tag", default = "*")]
    tag: Shared<str>,
) -> Result<(Vec<Value>, Vec<Value>), Message> {
    let mut reader = Reader::from_str(&xml);
    let mut open: Vec<Open> = Vec::new();
    let mut found: Vec<(String, String)> = Vec::new();
    let (mut depth, mut used) = (0_usize, 0_usize);
    loop {
        context.check()?;
        let before = place(reader.buffer_position());
        let text = match reader.read_event().map_err(|error| broken(&error))? {
            Event::Start(element) => {
                depth += 1;
                if is_named(element.name().as_ref(), &tag) {
                    let start = place(reader.buffer_position());
                    open.push(Open { depth, number: found.len(), start });
                    found.push(Default::default());
                }
                continue;
            }
            Event::Empty(element) => {
                if is_named(element.name().as_ref(), &tag) {
                    found.push(Default::default());
                }
                continue;
            }
            Event::End(_) => {
                if let Some(last) = open.pop_if(|last| last.depth == depth) {
                    let inner = xml.get(last.start..before).unwrap_or_default();
                    used = used.saturating_add(inner.len());
                    context.bytes(used)?;
                    if let Some(slot) = found.get_mut(last.number) {
                        inner.clone_into(&mut slot.1);
                    }
                }
                depth = depth.saturating_sub(1);
                continue;
            }
            Event::Text(text) => text.xml10_content().into_owned(),
            Event::CData(text) => text.xml10_content().into_owned(),
            Event::GeneralRef(name) => {
                let reference = format!("&{};", &*name);
                escape::unescape(&reference).map_err(|error| broken(&error))?.into_owned()
            }
            Event::Eof => break,
            _ => continue,
        };
        for element in &open {
            used = used.saturating_add(text.len());
            context.bytes(used)?;
            if let Some(slot) = found.get_mut(element.number) {
                slot.0.push_str(&text);
            }
        }
    }
    if depth > 0 {
        return Err(broken(&"an element does not end"));
    }
    context.items(found.len().saturating_mul(2))?;
    Ok(found.into_iter().map(|(text, inner)| (Value::text(text), Value::text(inner))).unzip())
}

fn is_named(name: &str, tag: &str) -> bool {
    tag == "*" || name == tag
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_geometry::{Box3, Interval, Plane};

    #[test]
    fn faces_of_a_box() {
        let side = Interval::new(0.0, 2.0);
        let cube = Box3 { plane: Plane::XY, x: side, y: side, z: side };
        let out = Trial::of("Sort Adjacent Brep Faces").item(cube).run().outputs;
        // Each face is beside four others, and opposite to one.
        assert_eq!(out[0].item_count(), 6);
        assert_eq!([out[1].branch_count(), out[1].item_count()], [6, 24]);
        assert_eq!([out[2].branch_count(), out[2].item_count()], [6, 24]);
        assert_eq!([out[3].branch_count(), out[3].item_count()], [6, 36]);
    }

    #[test]
    fn elements_by_name() {
        let text = "<a><b>x <c>y</c></b><b k='1'/><b><![CDATA[1 < 2]]> &amp; z</b></a>";
        let of = |tag: &str, k: usize| -> Vec<String> {
            let tree = Trial::of("Read XML by Tag").item(text).item(tag).run().outputs[k].clone();
            tree.column().iter().map(|item| format!("{item:?}")).collect()
        };
        let texts = |texts: &[&str]| -> Vec<String> {
            texts.iter().map(|text| format!("{:?}", Some(katydid_data::Value::text(*text)))).collect()
        };
        assert_eq!(of("b", 0), texts(&["x y", "", "1 < 2 & z"]));
        assert_eq!(of("b", 1), texts(&["x <c>y</c>", "", "<![CDATA[1 < 2]]> &amp; z"]));
        assert_eq!(of("c", 0), texts(&["y"]));
        assert_eq!(of("*", 0).len(), 5);
        assert!(of("d", 0).is_empty());
        for bad in ["<a><b></a>", "<a>", "<a k=>"] {
            let trial = Trial::of("Read XML by Tag").item(bad).item("a");
            assert!(trial.message().contains("broken") || bad == "<a k=>", "{bad}");
        }
    }
}
