//! What decides between two readings of the same tokens (C# specification, grammar ambiguities).

use super::super::token::Tok;
use super::Parser;

impl Parser {
    /// Whether type arguments that end here are type arguments, and not a comparison.
    pub(super) fn after_type_args(&self) -> bool {
        match self.tok() {
            Tok::P(p) => matches!(
                *p,
                "(" | ")"
                    | "]"
                    | "}"
                    | ":"
                    | ";"
                    | ","
                    | "."
                    | "?"
                    | "=="
                    | "!="
                    | "|"
                    | "^"
                    | "&&"
                    | "||"
                    | "&"
                    | "["
                    | "{"
                    | "=>"
                    | "?."
            ),
            Tok::Eof => true,
            _ => false,
        }
    }

    /// Whether `?` behind a type belongs to it, and does not begin a condition.
    pub(super) fn ends_nullable(&self) -> bool {
        match self.ahead(1) {
            Tok::P(p) => {
                matches!(*p, ")" | ">" | "," | ";" | "]" | "[" | "{" | "}" | "=" | "=>" | "&&" | "||" | "?")
            }
            // `x is int? y : z` is not written; `int? x` is.
            Tok::Ident(_) => !self.question_is_choice(),
            Tok::Kw(word) => matches!(*word, "this" | "operator") && !self.question_is_choice(),
            _ => false,
        }
    }

    /// Whether a `:` belongs to the `?` here, in the same statement.
    fn question_is_choice(&self) -> bool {
        let (mut n, mut depth) = (1, 0_i32);
        // `T? name =` and `T? name;` are declarations.
        if matches!(self.ahead(1), Tok::Ident(_))
            && matches!(self.ahead(2), Tok::P("=" | ";" | "," | ")" | "{" | "=>" | "("))
            && !self.is_ahead(2, "(")
        {
            return false;
        }
        loop {
            match self.ahead(n) {
                Tok::P("(" | "[" | "{") => depth += 1,
                Tok::P(")" | "]" | "}") if depth == 0 => return false,
                Tok::P(")" | "]" | "}") => depth -= 1,
                Tok::P(";") | Tok::Eof => return false,
                // The constraints of a method that gives `T?`.
                Tok::Ident(word) if depth == 0 && &**word == "where" => return false,
                Tok::P(":") if depth == 0 => return true,
                _ => {}
            }
            n += 1;
        }
    }

    /// The number of tokens from an opening bracket to behind its partner.
    fn behind_brackets(&self) -> Option<usize> {
        let (mut n, mut depth) = (0, 0_u32);
        loop {
            match self.ahead(n) {
                Tok::P("(" | "[" | "{") => depth += 1,
                Tok::P(")" | "]" | "}") => {
                    depth -= 1;
                    if depth == 0 {
                        return Some(n + 1);
                    }
                }
                Tok::Eof => return None,
                _ => {}
            }
            n += 1;
        }
    }

    pub(super) fn is_lambda(&self) -> bool {
        match self.tok() {
            Tok::Ident(_) => self.is_ahead(1, "=>"),
            Tok::P("(") => self.behind_brackets().is_some_and(|n| self.is_ahead(n, "=>")),
            _ => false,
        }
    }

    /// Whether `(T)` that ends here is a cast: by what follows it.
    pub(super) fn after_cast(&self, predefined: bool) -> bool {
        match self.tok() {
            Tok::P("~" | "!" | "(")
            | Tok::Ident(_)
            | Tok::Int(..)
            | Tok::Double(_)
            | Tok::Float(_)
            | Tok::Decimal(_)
            | Tok::Char(_)
            | Tok::Str(_)
            | Tok::Interpolated(_) => true,
            Tok::P("-" | "+" | "++" | "--" | "[") => predefined && !self.is("["),
            Tok::Kw(word) => !matches!(*word, "is" | "as" | "in"),
            _ => false,
        }
    }

    /// Whether a declaration of a variable or local function begins here: a type, and a name behind it.
    pub(super) fn is_declaration(&mut self) -> bool {
        if self.predefined().is_some() && !self.is_ahead(1, ".") {
            return true;
        }
        if !matches!(self.tok(), Tok::Ident(_) | Tok::P("(") | Tok::Kw(_)) {
            return false;
        }
        let (at, depth) = (self.at, self.depth);
        let begins = self.type_ref().is_ok()
            && matches!(self.tok(), Tok::Ident(_))
            && (matches!(
                self.ahead(1),
                Tok::P("=" | ";" | "," | "(" | "<" | "[" | ":" | ")" | "{" | "}" | "=>")
            ) || matches!(self.ahead(1), Tok::Kw("in") | Tok::Eof | Tok::Ident(_) | Tok::Kw(_)));
        (self.at, self.depth) = (at, depth);
        begins
    }
}
