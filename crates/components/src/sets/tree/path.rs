//! Paths as data, and masks on them.

use std::collections::HashMap;
use std::sync::Arc;

use katydid_component::{Context, List, Message, component};
use katydid_data::{Path, Tree};

use super::mask::Mask;
use super::whole;
use crate::sets::room;

/// Makes a path of integers.
#[component("946cb61e-18d2-45e3-8840-67b0efa26528", name = "Construct Path", nick = "Path", at = "Sets/Tree")]
#[output("Branch", "B", "The path.")]
fn construct_path(
    /// The elements of the path, 0 or more each.
    #[port("Indices", "I")]
    indices: List<i32>,
) -> Result<Path, Message> {
    if let Some(negative) = indices.present().find(|&i| i < 0) {
        return Err(Message::error(format!("A path has no negative elements: {negative}")));
    }
    let path: Path = indices.present().collect();
    if path.is_empty() {
        return Err(Message::error("There are no integers to make a path of"));
    }
    Ok(path)
}

/// Takes a path apart into its integers.
#[component(
    "df6d9197-9a6e-41a2-9c9d-d2221accb49e",
    name = "Deconstruct Path",
    nick = "DPath",
    at = "Sets/Tree"
)]
#[output("Indices", "I", "The elements of the path.")]
fn deconstruct_path(
    /// The path.
    #[port("Branch", "B")]
    branch: Path,
) -> Vec<i32> {
    branch.elements().to_vec()
}

/// Tells whether a path fits a mask, such as `{0;?;*}` or `{!(2,6);0 to 4}`.
///
/// In a mask `*` stands for any number of elements and `?` for one; `!` means not. A part for items plays no
/// role here.
#[component(
    "1d8b0e2c-e772-4fa9-b7f7-b158251b34b8",
    name = "Path Compare",
    nick = "Compare",
    at = "Sets/Tree"
)]
#[output("Comparison", "C", "True when the path fits.")]
fn path_compare(
    /// The path.
    #[port("Path", "P")]
    path: Path,
    /// The mask.
    #[port("Mask", "M")]
    mask: Arc<str>,
) -> Result<bool, Message> {
    Ok(Mask::parse(&mask)?.fits_path(path.elements()))
}

/// So many masks are read between two questions whether to go on.
const MASKS_AT_ONCE: usize = 1024;

fn masks(context: &Context<'_>, texts: &List<'_, Arc<str>>) -> Result<Vec<Mask>, Message> {
    context.bytes(texts.len().saturating_mul(size_of::<Mask>()))?;
    let mut masks = Vec::with_capacity(texts.len());
    for text in texts.present() {
        if masks.len() % MASKS_AT_ONCE == 0 {
            context.check()?;
        }
        masks.push(Mask::parse(&text)?);
    }
    Ok(masks)
}

/// Splits a tree in two by masks, such as `{0;?}[0,2,...]`: what fits any of them, and the rest.
///
/// A branch that fits only in part is in both trees at its full length, with nulls in the places of what is in
/// the other; a branch that belongs to one tree as a whole is in that one alone.
#[component("d8b1e7ac-cd31-4748-b262-e07e53068afc", name = "Split Tree", nick = "Split", at = "Sets/Tree")]
#[output("Positive", "P", "What fits a mask.")]
#[output("Negative", "N", "What fits none.")]
fn split_tree(
    context: &Context<'_>,
    /// The tree.
    #[port("Data", "D")]
    data: &Tree,
    /// Masks; one that fits is enough.
    #[port("Masks", "M")]
    texts: List<Arc<str>>,
) -> Result<(Tree, Tree), Message> {
    room(context, data.item_count().saturating_mul(2))?;
    let masks = masks(context, &texts)?;
    let mut sides = [Side::default(), Side::default()];
    for branch in data.branches() {
        context.check()?;
        let fitting: Vec<&Mask> = masks.iter().filter(|m| m.fits_path(branch.path().elements())).collect();
        let fits = |i: usize| fitting.iter().any(|mask| mask.fits_item(i));
        let flags: Vec<bool> = if fitting.iter().all(|mask| mask.has_items()) {
            (0..branch.len()).map(fits).collect()
        } else {
            vec![true; branch.len()]
        };
        for (side, wanted) in sides.iter_mut().zip([true, false]) {
            let any = match flags.is_empty() {
                true => wanted != fitting.is_empty(),
                false => flags.contains(&wanted),
            };
            if any {
                // An index outside all items gathers a null.
                let places = branch.range().zip(&flags);
                side.indices.extend(places.map(|(at, &flag)| if flag == wanted { at } else { usize::MAX }));
                side.paths.push(branch.path().clone());
                side.ends.push(side.indices.len());
            }
        }
    }
    let [positive, negative] =
        sides.map(|side| Tree::from_parts(side.paths, side.ends, data.column().gather(&side.indices)));
    Ok((positive, negative))
}

#[derive(Default)]
struct Side {
    paths: Vec<Path>,
    ends: Vec<usize>,
    indices: Vec<usize>,
}

/// Masks to be tried in order: those that name one path are looked up, not tried.
struct Masks {
    exact: HashMap<Vec<i32>, usize>,
    others: Vec<(usize, Mask)>,
}

impl Masks {
    fn new(context: &Context<'_>, masks: Vec<Mask>) -> Result<Self, Message> {
        // The elements of a path are allocated by themselves.
        let each = size_of::<(Vec<i32>, usize)>() + 2 * size_of::<usize>();
        context.bytes(masks.len().saturating_mul(2 * each))?;
        let (mut exact, mut others) = (HashMap::with_capacity(masks.len()), Vec::new());
        for (k, mask) in masks.into_iter().enumerate() {
            match mask.only_path() {
                Some(path) => {
                    exact.entry(path).or_insert(k);
                }
                None => others.push((k, mask)),
            }
        }
        Ok(Self { exact, others })
    }

    /// The place of the first mask that fits a path.
    fn first_fit(&self, path: &[i32]) -> Option<usize> {
        let exact = self.exact.get(path).copied();
        let before = self.others.iter().take_while(|(k, _)| exact.is_none_or(|exact| *k < exact));
        before.clone().find(|(_, mask)| mask.fits_path(path)).map(|(k, _)| *k).or(exact)
    }
}

/// Gives branches other paths: those that fit a mask go to the path at the same place in the other list.
///
/// The first mask that fits counts; the last path serves for all further masks. Branches that come to the same
/// path are joined in order, and those that fit no mask stay where they are.
#[component(
    "bfaaf799-77dc-4f31-9ad8-2f7d1a80aeb0",
    name = "Replace Paths",
    nick = "Replace",
    at = "Sets/Tree"
)]
#[output("Data", "D", "The tree with the new paths.")]
fn replace_paths(
    context: &Context<'_>,
    /// The tree.
    #[port("Data", "D")]
    data: &Tree,
    /// Masks for the paths to be replaced; `*` for all.
    #[port("Search", "S", default = "*")]
    search: List<Arc<str>>,
    /// The new path for each mask.
    #[port("Replace", "R")]
    replace: List<Path>,
) -> Result<Tree, Message> {
    whole(context, data)?;
    let masks = masks(context, &search)?;
    let paths: Vec<Path> = replace.present().collect();
    let Some(last) = paths.last() else { return Err(Message::error("There is no new path")) };
    let masks = Masks::new(context, masks)?;
    let mut renamed = Vec::with_capacity(data.branch_count());
    for path in data.paths() {
        context.check()?;
        let found = masks.first_fit(path.elements());
        renamed.push(found.map_or(path, |k| paths.get(k).unwrap_or(last)).clone());
    }
    Ok(data.with_paths(renamed))
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;

    /// Whatever masks stand before or behind one that names a single path, the first that fits counts.
    #[test]
    fn the_first_mask_that_fits_counts() {
        let replaced = |masks: [&str; 3]| {
            let tree = Trial::of("Replace Paths").branches([("{0;1}", [1]), ("{0;2}", [2])]);
            tree.list(masks).list(["{7}", "{8}", "{9}"]).texts(0)
        };
        assert_eq!(replaced(["{0;1}", "*", "{0;2}"]), ["{7}: 1", "{8}: 2"]);
        assert_eq!(replaced(["{0;?}", "{0;1}", "{0;2}"]), ["{7}: 1, 2"]);
        assert_eq!(replaced(["{1;?}", "{0;2}", "{0;2}"]), ["{0;1}: 1", "{8}: 2"]);
    }

    #[test]
    fn paths_are_made_and_taken_apart() {
        assert_eq!(Trial::of("Construct Path").list([0, 4]).texts(0), ["{0}: {0;4}"]);
        assert_eq!(
            Trial::of("Construct Path").list([0, -4]).message(),
            "A path has no negative elements: -4"
        );
        assert!(!Trial::of("Construct Path").list::<i32>([]).message().is_empty());
        assert_eq!(Trial::of("Deconstruct Path").item("{3;1}").texts(0), ["{0;0}: 3, 1"]);
    }

    #[test]
    fn comparing_with_masks() {
        let compare = |mask: &str| Trial::of("Path Compare").list(["{0;1}", "{0;1;2}"]).item(mask);
        assert_eq!(compare("{0;?}").texts(0), ["{0}: True, False"]);
        assert_eq!(compare("{0;*}").texts(0), ["{0}: True, True"]);
        assert!(compare("{0").message().contains("'}' is expected"));
    }

    #[test]
    fn splitting_by_masks() {
        let split = |masks: &[&str], k: usize| {
            let tree = Trial::of("Split Tree").branches([("{0}", [1, 2, 3]), ("{1}", [4, 5, 6])]);
            tree.list(masks.iter().copied()).texts(k)
        };
        assert_eq!(split(&["{1}"], 0), ["{1}: 4, 5, 6"]);
        assert_eq!(split(&["{1}"], 1), ["{0}: 1, 2, 3"]);
        assert_eq!(split(&["{1}[1]"], 0), ["{1}: null, 5, null"]);
        assert_eq!(split(&["{1}[1]"], 1), ["{0}: 1, 2, 3", "{1}: 4, null, 6"]);
        assert_eq!(split(&["{1}[1]", "{0}"], 0), ["{0}: 1, 2, 3", "{1}: null, 5, null"]);
        assert_eq!(split(&["{*}[0,2,...]"], 0), ["{0}: 1, null, 3", "{1}: 4, null, 6"]);
        let empty = |k: usize| Trial::of("Split Tree").list::<f64>([]).item("{0}[1]").texts(k);
        assert_eq!((empty(0).len(), empty(1).len()), (1, 0));
    }

    #[test]
    fn replacing_paths() {
        let tree = || Trial::of("Replace Paths").branches([("{0}", [1]), ("{1}", [2]), ("{5}", [3])]);
        assert_eq!(tree().default().item("{9}").texts(0), ["{9}: 1, 2, 3"]);
        assert_eq!(tree().list(["{0}", "{1}"]).list(["{1}", "{0}"]).texts(0), ["{0}: 2", "{1}: 1", "{5}: 3"]);
        assert_eq!(tree().list(["{0}", "{5}"]).item("{7}").texts(0), ["{1}: 2", "{7}: 1, 3"]);
        assert_eq!(tree().default().list::<f64>([]).message(), "There is no new path");
    }
}
