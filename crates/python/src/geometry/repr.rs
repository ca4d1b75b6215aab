//! Numbers in the texts that Python shows.

/// A number as Python writes it: the shortest that reads back the same.
pub(crate) fn number(x: f64) -> String {
    if x.is_nan() {
        return "nan".to_owned();
    }
    if x.is_infinite() {
        return if x > 0.0 { "inf" } else { "-inf" }.to_owned();
    }
    let text = format!("{x:?}");
    text.strip_suffix(".0").map_or(text.clone(), str::to_owned)
}

/// Numbers with commas between.
pub(crate) fn numbers(list: impl IntoIterator<Item = f64>) -> String {
    list.into_iter().map(number).collect::<Vec<_>>().join(", ")
}
