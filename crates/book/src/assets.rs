//! The style and the script of pages.

use rust_embed::Embed;

/// The script as the studio's build leaves it; where it was not built the pages are without one.
#[derive(Embed)]
#[folder = "$CARGO_MANIFEST_DIR/../../studio/dist/learn"]
#[include = "*.js"]
#[include = "*.css"]
#[allow_missing = true]
struct Script;

const STYLE: &str = include_str!("../assets/book.css");

/// A file that pages load, under a name that tells what is in it.
#[derive(Debug, Clone)]
pub(crate) struct Asset {
    pub(crate) name: String,
    pub(crate) bytes: Vec<u8>,
}

/// The style sheet: the colours, then the rules.
pub(crate) fn style() -> Asset {
    let (light, dark) = (crate::palette::variables(false), crate::palette::variables(true));
    let script = Script::get("learn.css").map(|file| file.data.into_owned()).unwrap_or_default();
    let text = format!(
        ":root{{{light}}}\n@media (prefers-color-scheme:dark){{:root:not([data-theme=light]){{{dark}}}}}\n\
         :root[data-theme=dark]{{{dark}}}\n{STYLE}{}",
        String::from_utf8_lossy(&script)
    );
    let hash = hash_of(&[text.as_bytes()]);
    Asset { name: format!("assets/book.{hash}.css"), bytes: text.into_bytes() }
}

/// The script and its parts, the one that pages load first; none where it was not built.
pub(crate) fn scripts() -> Vec<Asset> {
    let mut names: Vec<String> =
        Script::iter().filter(|name| name.ends_with(".js")).map(String::from).collect();
    names.sort_by_key(|name| (name != "learn.js", name.clone()));
    if names.first().is_none_or(|name| name != "learn.js") {
        return Vec::new();
    }
    let files: Vec<(String, Vec<u8>)> = names
        .into_iter()
        .filter_map(|name| Some((name.clone(), Script::get(&name)?.data.into_owned())))
        .collect();
    // The parts name each other: they stand together in a folder whose name tells what is in all of them.
    let hash = hash_of(&files.iter().map(|(_, bytes)| bytes.as_slice()).collect::<Vec<_>>());
    files.into_iter().map(|(name, bytes)| Asset { name: format!("assets/{hash}/{name}"), bytes }).collect()
}

fn hash_of(parts: &[&[u8]]) -> String {
    let mut hasher = blake3::Hasher::new();
    for part in parts {
        hasher.update(part);
    }
    hasher.finalize().to_hex().get(..10).unwrap_or_default().to_owned()
}
