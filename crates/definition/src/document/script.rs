use base64::{Engine, engine::general_purpose::STANDARD as BASE64};
use uuid::Uuid;

use super::{Object, ids};
use crate::archive::Chunk;

/// The source text of a script component.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Script {
    /// The language.
    pub language: ScriptLanguage,
    /// The text; empty when it comes over a wire.
    pub text: String,
    /// Further members of the class, beside the text (C# and VB of Grasshopper 1).
    pub additional: String,
    /// Further imports (C# and VB of Grasshopper 1).
    pub using: String,
    /// Whether the text comes in over a wire and not from here.
    pub from_wire: bool,
}

impl Script {
    /// Whether it is in Python, of either kind.
    pub fn is_python(&self) -> bool {
        matches!(self.language, ScriptLanguage::Python3 | ScriptLanguage::IronPython)
    }
}

/// The language of a script.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum ScriptLanguage {
    /// C#.
    CSharp,
    /// Visual Basic.
    VisualBasic,
    /// Python 3.
    Python3,
    /// IronPython 2.7.
    IronPython,
    /// Another, by the name Rhino 8 gives it.
    Other(String),
}

impl ScriptLanguage {
    /// The language that the first line of a text names, as Rhino 8's editor writes it: `#! python 3`, `// #! csharp`. None
    /// where it names none that is known.
    pub fn named_in(text: &str) -> Option<Self> {
        let line = text.trim_start_matches('\u{feff}').lines().find(|line| !line.trim().is_empty())?;
        let named = line.trim().trim_start_matches(['/', '\'']).trim_start().strip_prefix("#!")?;
        let mut words = named.split_ascii_whitespace();
        let (name, version) = (words.next()?.to_ascii_lowercase(), words.next().unwrap_or_default());
        match name.as_str() {
            "python" | "python3" if !version.starts_with('2') => Some(Self::Python3),
            "python" | "python2" | "ironpython" => Some(Self::IronPython),
            "csharp" | "c#" => Some(Self::CSharp),
            _ => None,
        }
    }
}

impl std::fmt::Display for ScriptLanguage {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::CSharp => "C#",
            Self::VisualBasic => "VB",
            Self::Python3 => "Python 3",
            Self::IronPython => "IronPython 2",
            Self::Other(name) => name,
        })
    }
}

impl Object {
    /// The script, when the object is a script component.
    pub fn script(&self) -> Option<Script> {
        let container = self.container();
        if let Some(chunk) = container.child("Script") {
            return rhino_8(self.component, container, chunk);
        }
        if self.component == ids::RHINO_8_SCRIPT {
            // Without a text of its own the language, too, is that of what comes over the wire.
            let from_wire = container.bool("UsingScriptInputParam") == Some(true);
            let language = ScriptLanguage::Other("*.*.*".to_owned());
            return from_wire.then(|| plain(language, String::new(), true));
        }
        if self.component == ids::GH_PYTHON {
            let text = container.str("CodeInput").unwrap_or_default().to_owned();
            // Without a text of its own the component has a code input.
            let from_wire =
                container.str("CodeInput").is_none() || container.bool("HideInput") == Some(false);
            return Some(plain(ScriptLanguage::IronPython, text, from_wire));
        }
        let language = match self.component {
            ids::C_SHARP | ids::OLD_C_SHARP => ScriptLanguage::CSharp,
            ids::VB | ids::OLD_VB => ScriptLanguage::VisualBasic,
            _ => return None,
        };
        if let Some(code) = container.child("UserCode") {
            let lines: Vec<_> = code.list("Line").into_iter().filter_map(|(_, line)| line.as_str()).collect();
            return Some(plain(language, lines.join("\n"), false));
        }
        let text = |name| container.str(name).unwrap_or_default().to_owned();
        Some(Script {
            additional: text("AdditionalSource"),
            using: text("UsingSource"),
            ..plain(language, text("ScriptSource"), false)
        })
    }
}

fn plain(language: ScriptLanguage, text: String, from_wire: bool) -> Script {
    Script { language, text, additional: String::new(), using: String::new(), from_wire }
}

/// A Rhino 8 script: the text in base64, and the language by a dotted name that ends in it.
fn rhino_8(component: Uuid, container: &Chunk, chunk: &Chunk) -> Option<Script> {
    let spec = chunk.child("LanguageSpec");
    let taxon = spec.and_then(|spec| spec.str("Taxon")).unwrap_or_default();
    let version = spec.and_then(|spec| spec.str("Version")).unwrap_or_default();
    let language = match taxon.rsplit('.').next().unwrap_or_default() {
        "csharp" => ScriptLanguage::CSharp,
        "vb" | "visualbasic" => ScriptLanguage::VisualBasic,
        "python" if version.starts_with('2') || taxon.contains("ironpython") => ScriptLanguage::IronPython,
        "python" => ScriptLanguage::Python3,
        "" | "*" => match component {
            ids::RHINO_8_C_SHARP => ScriptLanguage::CSharp,
            ids::RHINO_8_PYTHON => ScriptLanguage::Python3,
            ids::RHINO_8_IRON_PYTHON => ScriptLanguage::IronPython,
            _ => ScriptLanguage::Other(taxon.to_owned()),
        },
        other => ScriptLanguage::Other(other.to_owned()),
    };
    let bytes = BASE64.decode(chunk.str("Text").unwrap_or_default().trim()).ok()?;
    let text = String::from_utf8(bytes).ok()?;
    let text = text.strip_prefix('\u{feff}').unwrap_or(&text).to_owned();
    Some(plain(language, text, container.bool("UsingScriptInputParam").unwrap_or(false)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_line_names_a_language() {
        let named = ScriptLanguage::named_in;
        assert_eq!(named("\n#! python 3\n\na = 1"), Some(ScriptLanguage::Python3));
        assert_eq!(named("#!python2"), Some(ScriptLanguage::IronPython));
        assert_eq!(named("#! python 2.7\n"), Some(ScriptLanguage::IronPython));
        assert_eq!(named("// #! csharp\nusing System;"), Some(ScriptLanguage::CSharp));
        assert_eq!(named("a = 1\n#! python 3"), None);
        assert_eq!(named(""), None);
    }
}
