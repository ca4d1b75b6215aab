//! Sets / Text: joining, cutting and replacing.

mod compare;
mod format;
mod on_surface;
mod pattern;

use std::sync::Arc;

use katydid_component::{Context, List, ManyItems, Message, component};

/// Joins texts, one behind the other. Inputs without data and nulls count as empty.
#[component(
    "2013e425-8713-42e2-a661-b57e78840337",
    name = "Concatenate",
    nick = "Concat",
    at = "Sets/Text",
    also("01cbd6e3-ccbe-4c24-baeb-46e10553e18b")
)]
#[output("Result", "R", "The joined text.")]
fn concatenate(
    context: &Context<'_>,
    /// A text.
    #[port("Fragment A", "A", optional)]
    fragments: ManyItems<Arc<str>>,
) -> Result<Arc<str>, Message> {
    context.bytes(fragments.iter().flatten().map(|f| f.len()).sum())?;
    Ok(fragments.iter().flatten().map(|f| &**f).collect::<String>().into())
}

/// Joins a list of texts to one, with a text of your choice between each two. Nulls are skipped.
#[component("1274d51a-81e6-4ccf-ad1f-0edf4c769cac", name = "Text Join", nick = "Join", at = "Sets/Text")]
#[output("Result", "R", "The joined text.")]
fn text_join(
    context: &Context<'_>,
    /// The texts.
    #[port("Text", "T")]
    texts: List<Arc<str>>,
    /// What stands between them; nothing when left out.
    #[port("Join", "J")]
    join: Option<Arc<str>>,
) -> Result<Arc<str>, Message> {
    let join = join.as_deref().unwrap_or_default();
    let length = texts.present().map(|t| t.len().saturating_add(join.len()));
    context.bytes(length.fold(0, usize::saturating_add))?;
    let texts: Vec<Arc<str>> = texts.present().collect();
    Ok(texts.join(join).into())
}

/// Cuts a text at separators, each a single character. Two separators side by side have an empty text between
/// them.
#[component("04887d01-504c-480e-b2a2-01ea19cc5922", name = "Text Split", nick = "Split", at = "Sets/Text")]
#[output("Result", "R", "The pieces, without the separators.")]
fn text_split(
    context: &Context<'_>,
    /// The text.
    #[port("Text", "T")]
    text: Arc<str>,
    /// The separators. Each of its characters is one; without any the text stays whole.
    #[port("Separators", "C")]
    separators: Arc<str>,
) -> Result<Vec<Arc<str>>, Message> {
    let separators: Vec<char> = separators.chars().collect();
    let pieces = || text.split(|c| separators.contains(&c));
    context.items(pieces().count())?;
    context.bytes(text.len())?;
    Ok(pieces().map(Arc::from).collect())
}

/// Takes a text apart into its characters.
#[component("86503240-d884-43f9-9323-efe30488a6e1", name = "Characters", nick = "Chars", at = "Sets/Text")]
#[output("Result", "C", "The characters, each a text.")]
#[output("Unicode", "U", "Their Unicode numbers.")]
fn characters(
    context: &Context<'_>,
    /// The text.
    #[port("Text", "T")]
    text: Arc<str>,
) -> Result<(Vec<Arc<str>>, Vec<i32>), Message> {
    context.items(text.chars().count().saturating_mul(2))?;
    let mut buffer = [0; 4];
    let characters = text.chars().map(|c| Arc::from(&*c.encode_utf8(&mut buffer))).collect();
    // A character's number has 21 bits at most.
    Ok((characters, text.chars().map(|c| c as i32).collect()))
}

/// The length of a text in units of UTF-16: one for most characters, two for rare ones such as pictograms.
#[component("dca05f6f-e3d9-42e3-b3bb-eb20363fb335", name = "Text Length", nick = "Len", at = "Sets/Text")]
#[output("Length", "L", "The length.")]
fn text_length(
    /// The text.
    #[port("Text", "T")]
    text: Arc<str>,
) -> i32 {
    i32::try_from(text.encode_utf16().count()).unwrap_or(i32::MAX)
}

/// Replaces a piece of a text by another, everywhere it stands.
///
/// When the component is set to repeat, it goes on until the piece stands nowhere; that is an error when the
/// replacement holds the piece itself.
#[component("4df8df00-3635-45bd-95e6-f9206296c110", name = "Replace Text", nick = "Rep", at = "Sets/Text")]
#[output("Result", "R", "The new text.")]
fn replace_text(
    context: &Context<'_>,
    /// The text.
    #[port("String", "String")]
    text: Arc<str>,
    /// The piece to look for.
    #[port("Find", "F")]
    find: Arc<str>,
    /// What stands in its place; left out, the piece is removed.
    #[port("Replace", "R")]
    replacement: Option<Arc<str>>,
) -> Result<Arc<str>, Message> {
    let replacement = replacement.as_deref().unwrap_or_default();
    if find.is_empty() {
        return Err(Message::error("The piece to look for is empty"));
    }
    let repeat = context.settings().bool("RecursiveReplace") == Some(true);
    if repeat && replacement.contains(&*find) {
        return Err(Message::error("The replacement holds the piece to look for: repeating would never end"));
    }
    let mut text = text;
    loop {
        let times = text.matches(&*find).count();
        if times == 0 {
            return Ok(text);
        }
        context.check()?;
        context.bytes(text.len().saturating_add(times.saturating_mul(replacement.len())))?;
        text = text.replace(&*find, replacement).into();
        if !repeat {
            return Ok(text);
        }
    }
}

/// Cuts a piece out of a text. A piece that reaches beyond the end stops there.
#[component(
    "07e0811f-034a-4504-bca0-2d03b2c46217",
    name = "Text Fragment",
    nick = "Fragment",
    at = "Sets/Text"
)]
#[output("Fragment", "F", "The piece.")]
fn text_fragment(
    context: &Context<'_>,
    /// The text.
    #[port("Text", "T")]
    text: Arc<str>,
    /// Where the piece begins: 0 is the first character.
    #[port("Start", "i", default = 2)]
    start: i32,
    /// How many characters it has; left out, all to the end.
    #[port("Count", "N")]
    count: Option<i32>,
) -> Result<Arc<str>, Message> {
    let start =
        usize::try_from(start).map_err(|_| Message::error(format!("The start {start} is negative")))?;
    let negative = |n| Message::error(format!("The count {n} is negative"));
    let count = count.map(|n| usize::try_from(n).map_err(|_| negative(n))).transpose()?.unwrap_or(usize::MAX);
    context.bytes(text.len().min(count.saturating_mul(4)))?;
    Ok(text.chars().skip(start).take(count).collect::<String>().into())
}

/// Removes white space from the ends of a text.
#[component("e4cb7168-5e32-4c54-b425-5a31c6fd685a", name = "Text Trim", nick = "Trim", at = "Sets/Text")]
#[output("Result", "R", "The text without it.")]
fn text_trim(
    /// The text.
    #[port("Text", "T")]
    text: Arc<str>,
    /// Whether to trim its start.
    #[port("Start", "S", default = true)]
    start: bool,
    /// Whether to trim its end.
    #[port("End", "E", default = true)]
    end: bool,
) -> Arc<str> {
    let trimmed = if start { text.trim_start() } else { &text };
    let trimmed = if end { trimmed.trim_end() } else { trimmed };
    if trimmed.len() == text.len() { Arc::clone(&text) } else { trimmed.into() }
}

#[cfg(test)]
mod tests {
    use katydid_component::Limits;
    use katydid_component::testing::Trial;
    use katydid_data::Tree;

    #[test]
    fn joining() {
        assert_eq!(Trial::of("Concatenate").list(["A", "B", "C"]).item("1").texts(0), ["{0}: A1, B1, C1"]);
        let tree = Trial::of("Concatenate")
            .branches([("{0;0}", ["A", "B"]), ("{0;1}", ["X", "Y"])])
            .list(["1", "2"]);
        assert_eq!(tree.texts(0), ["{0;0}: A1, B2", "{0;1}: X1, Y2"]);
        assert_eq!(Trial::of("Concatenate").item(1.5).tree(Tree::empty()).item("m").texts(0), ["{0}: 1.5m"]);
        assert_eq!(
            Trial::of("Text Join").gaps([Some("a"), None, Some("b")]).item("-").texts(0),
            ["{0}: a-b"]
        );
        assert_eq!(Trial::of("Text Join").list(["a", "b"]).texts(0), ["{0}: ab"]);
        let limits = Limits { bytes: 5, ..Limits::default() };
        assert!(
            Trial::of("Concatenate").item("abc").item("def").limits(limits).message().contains("5 bytes")
        );
    }

    #[test]
    fn cutting() {
        let pieces = Trial::of("Text Split").item("(a,b),").item("(),").run();
        assert_eq!(pieces.outputs[0].item_count(), 5);
        assert_eq!(Trial::of("Text Split").item("a b").item("").texts(0), ["{0;0}: a b"]);
        assert_eq!(Trial::of("Characters").item("aé").texts(0), ["{0;0}: a, é"]);
        assert_eq!(Trial::of("Characters").item("aé").texts(1), ["{0;0}: 97, 233"]);
        assert_eq!(Trial::of("Text Length").list(["", "né", "😀"]).texts(0), ["{0}: 0, 2, 2"]);
        let cut = |start: i32, n: i32| {
            Trial::of("Text Fragment").item("katydid").item(start).item(n).texts(0).concat()
        };
        assert_eq!([cut(2, 3), cut(5, 9), cut(9, 1)], ["{0}: tyd", "{0}: id", "{0}:"]);
        assert_eq!(Trial::of("Text Fragment").item("katydid").item(3).texts(0), ["{0}: ydid"]);
        assert_eq!(Trial::of("Text Fragment").item("k").item(-1).message(), "The start -1 is negative");
        let trim = |s: bool, e: bool| {
            Trial::of("Text Trim").item(" x ").item(s).item(e).run().outputs[0].column().get(0)
        };
        assert_eq!(trim(true, true), Some("x".into()));
        assert_eq!(trim(false, true), Some(" x".into()));
    }

    #[test]
    fn replacing() {
        let replace = || Trial::of("Replace Text").item("a00b000").item("00");
        assert_eq!(replace().item("0").texts(0), ["{0}: a0b00"]);
        assert_eq!(replace().texts(0), ["{0}: ab0"]);
        assert_eq!(replace().item("0").setting("RecursiveReplace", true).texts(0), ["{0}: a0b0"]);
        assert!(replace().item("100").setting("RecursiveReplace", true).message().contains("never end"));
        assert_eq!(Trial::of("Replace Text").item("a").item("").message(), "The piece to look for is empty");
    }
}
