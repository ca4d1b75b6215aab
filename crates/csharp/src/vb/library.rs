//! Functions and constants that VB has without a name before them (Microsoft.VisualBasic), which the library's `__VB`
//! has under the same names.

/// Functions.
const FUNCTIONS: &[&str] = &[
    "Abs",
    "Asc",
    "AscW",
    "Chr",
    "ChrW",
    "Fix",
    "Format",
    "Hex",
    "IIf",
    "InStr",
    "InStrRev",
    "IsNothing",
    "IsNumeric",
    "Join",
    "LBound",
    "LCase",
    "LTrim",
    "Left",
    "Len",
    "Mid",
    "Oct",
    "RTrim",
    "Replace",
    "Right",
    "Sgn",
    "Space",
    "Split",
    "Sqr",
    "StrComp",
    "StrDup",
    "StrReverse",
    "Trim",
    "UBound",
    "UCase",
    "Val",
];

/// Constants.
const CONSTANTS: &[&str] =
    &["vbCrLf", "vbLf", "vbCr", "vbTab", "vbNewLine", "vbNullString", "vbNullChar", "vbBack"];

/// How a name is written that nothing in the script declares; `called` says whether parentheses follow.
pub(super) fn library_name(name: &str, called: bool) -> Option<String> {
    let list = if called { FUNCTIONS } else { CONSTANTS };
    if !called && name.eq_ignore_ascii_case("err") {
        return Some("__VBError.Err".to_owned());
    }
    let found = list.iter().find(|own| own.eq_ignore_ascii_case(name));
    if called && name.eq_ignore_ascii_case("int") {
        return Some("__VB.Floor".to_owned());
    }
    found.map(|own| format!("__VB.{own}"))
}
