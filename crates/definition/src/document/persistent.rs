use super::stored::Stored;
use crate::archive::Chunk;

/// The values kept in a parameter: a tree of them.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Persistent {
    /// The branches, in the file's order.
    pub branches: Vec<Branch>,
}

/// One list of a [`Persistent`] tree.
#[derive(Debug, Clone, PartialEq)]
pub struct Branch {
    /// The path, `{0;1}` as `[0, 1]`.
    pub path: Vec<i32>,
    /// The items.
    pub items: Vec<Stored>,
}

impl Persistent {
    /// One list at path `{0}`.
    pub fn list(items: Vec<Stored>) -> Self {
        Self { branches: vec![Branch { path: vec![0], items }] }
    }

    /// One value at path `{0}`.
    pub fn item(item: Stored) -> Self {
        Self::list(vec![item])
    }

    /// How many items there are in all branches.
    pub fn count(&self) -> usize {
        self.branches.iter().map(|branch| branch.items.len()).sum()
    }

    /// Reads the values that a parameter's chunk holds.
    pub fn read(parameter: &Chunk) -> Option<Self> {
        let Some(data) = parameter.child("PersistentData") else {
            // Grasshopper 0.6 kept a plain list.
            let items: Vec<_> = parameter.children("Data").into_iter().map(Stored::read).collect();
            return if items.is_empty() { None } else { Some(Self::list(items)) };
        };
        let branch = |(b, chunk): (usize, &Chunk)| Branch {
            path: chunk
                .str("Path")
                .and_then(parse_path)
                .unwrap_or_else(|| vec![i32::try_from(b).unwrap_or(i32::MAX)]),
            items: items(chunk),
        };
        Some(Self { branches: data.children("Branch").into_iter().enumerate().map(branch).collect() })
    }

    /// The `PersistentData` chunk. With `type_names` every item says its type, as parameters that take more
    /// than one type need it.
    pub fn to_chunk(&self, type_names: bool) -> Chunk {
        let mut data = Chunk::new("PersistentData");
        data.set("Count", count(self.branches.len()));
        for (b, branch) in self.branches.iter().enumerate() {
            let mut chunk = Chunk::indexed("Branch", count(b));
            chunk.set("Count", count(branch.items.len()));
            chunk.set("Path", format_path(&branch.path));
            chunk.chunks = branch
                .items
                .iter()
                .enumerate()
                .map(|(i, item)| item.to_chunk("Item", count(i), type_names))
                .collect();
            data.chunks.push(chunk);
        }
        data
    }
}

/// How many items without a chunk a branch may announce: some writers leave nulls out, others lie.
const MOST_LEFT_OUT: usize = 10_000;

/// The items of a branch; those that its count promises and nobody wrote are null.
fn items(branch: &Chunk) -> Vec<Stored> {
    let chunks = branch.children("Item");
    let announced = branch.i32("Count").and_then(|count| usize::try_from(count).ok()).unwrap_or(0);
    let total = announced.clamp(chunks.len(), chunks.len() + MOST_LEFT_OUT);
    let mut items = Vec::with_capacity(total);
    let mut left_out = total - chunks.len();
    for chunk in chunks {
        let index = chunk.index.and_then(|index| usize::try_from(index).ok()).unwrap_or(0);
        while items.len() < index && left_out > 0 {
            items.push(Stored::Null);
            left_out -= 1;
        }
        items.push(Stored::read(chunk));
    }
    items.resize(total, Stored::Null);
    items
}

fn count(n: usize) -> i32 {
    i32::try_from(n).unwrap_or(i32::MAX)
}

/// Reads `{0;1}`; blanks do not matter, and `{}` is the path without elements.
pub fn parse_path(text: &str) -> Option<Vec<i32>> {
    let inside = text.trim().strip_prefix('{')?.strip_suffix('}')?.trim();
    if inside.is_empty() {
        return Some(Vec::new());
    }
    inside.split(';').map(|element| element.trim().parse().ok()).collect()
}

/// Writes `{0;1}`.
pub fn format_path(path: &[i32]) -> String {
    let elements: Vec<_> = path.iter().map(i32::to_string).collect();
    format!("{{{}}}", elements.join(";"))
}
