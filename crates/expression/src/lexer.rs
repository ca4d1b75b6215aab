use crate::operator::Postfix;
use crate::symbols::Symbol;
use crate::{MAX_LENGTH, ParseError, ParseErrorKind, Span};

/// A word of the text with its place.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Token {
    pub(crate) kind: TokenKind,
    pub(crate) span: Span,
}

#[derive(Debug, Clone, PartialEq)]
pub(crate) enum TokenKind {
    Integer(i32),
    Number(f64),
    /// Digits with `i` right behind them.
    Imaginary(f64),
    Text(String),
    /// A name in lower case.
    Name(String),
    Operator(Symbol),
    Open(char),
    Close(char),
    Comma,
    End,
}

/// Cuts the text into tokens; the last one is always [`TokenKind::End`].
pub(crate) fn tokens(source: &str) -> Result<Vec<Token>, ParseError> {
    if source.len() > MAX_LENGTH {
        return Err(ParseError::new(Span::new(0, 1), ParseErrorKind::TooLong(MAX_LENGTH)));
    }
    let mut lexer = Lexer { source, at: 0 };
    let mut tokens = Vec::new();
    loop {
        let token = lexer.next()?;
        let end = token.kind == TokenKind::End;
        tokens.push(token);
        if end {
            return Ok(tokens);
        }
    }
}

struct Lexer<'a> {
    source: &'a str,
    at: usize,
}

impl Lexer<'_> {
    fn rest(&self) -> &str {
        self.source.get(self.at..).unwrap_or("")
    }

    fn peek(&self, n: usize) -> Option<char> {
        self.rest().chars().nth(n)
    }

    /// Moves on while `test` holds and tells how many bytes were passed.
    fn skip(&mut self, test: impl Fn(char) -> bool) -> usize {
        let rest = self.rest();
        let length = rest.find(|c| !test(c)).unwrap_or(rest.len());
        self.at += length;
        length
    }

    fn token(&self, start: usize, kind: TokenKind) -> Token {
        Token { kind, span: Span::new(start, self.at) }
    }

    fn next(&mut self) -> Result<Token, ParseError> {
        // Zero-width blanks come in with text pasted from web pages.
        self.skip(|c| c.is_whitespace() || matches!(c, '\u{200b}' | '\u{feff}'));
        let start = self.at;
        let Some(first) = self.peek(0) else {
            return Ok(self.token(start, TokenKind::End));
        };
        let second = self.peek(1);
        if first.is_ascii_digit() || (first == '.' && second.is_some_and(|c| c.is_ascii_digit())) {
            return self.number();
        }
        if is_name_start(first) {
            self.skip(is_name_part);
            let name = lower_case(Span::new(start, self.at).text(self.source));
            let kind = Symbol::word(&name).map_or(TokenKind::Name(name), TokenKind::Operator);
            return Ok(self.token(start, kind));
        }
        if first == '"' {
            return self.text();
        }
        if first == '.' {
            return self.member();
        }
        let kind = match first {
            '(' | '[' | '{' => TokenKind::Open(first),
            ')' | ']' | '}' => TokenKind::Close(first),
            ',' => TokenKind::Comma,
            _ => match Symbol::sign(first, second) {
                Some((symbol, count)) => {
                    self.at += self.rest().chars().take(count).map(char::len_utf8).sum::<usize>();
                    return Ok(self.token(start, TokenKind::Operator(symbol)));
                }
                None => {
                    let span = Span::new(start, start + first.len_utf8());
                    return Err(ParseError::new(span, ParseErrorKind::UnexpectedCharacter(first)));
                }
            },
        };
        self.at += first.len_utf8();
        Ok(self.token(start, kind))
    }

    fn number(&mut self) -> Result<Token, ParseError> {
        let start = self.at;
        let digit = |c: char| c.is_ascii_digit();
        self.skip(digit);
        let mut whole = true;
        // `1.X` is a member of 1, `1.` a number: the point belongs to the digits unless a letter follows.
        if self.peek(0) == Some('.') && !self.peek(1).is_some_and(is_name_start) {
            whole = false;
            self.at += 1;
            self.skip(digit);
        }
        if matches!(self.peek(0), Some('e' | 'E')) {
            let sign = usize::from(matches!(self.peek(1), Some('+' | '-' | '−')));
            if self.peek(1 + sign).is_some_and(|c| c.is_ascii_digit()) {
                whole = false;
                self.at += 1;
                self.skip(|c| matches!(c, '+' | '-' | '−'));
                self.skip(digit);
            }
        }
        let text = Span::new(start, self.at).text(self.source).replace('−', "-");
        let bad = |end| {
            let span = Span::new(start, end);
            ParseError::new(span, ParseErrorKind::BadNumber(span.text(self.source).into()))
        };
        let value = crate::parse_number(&text).ok_or_else(|| bad(self.at))?;
        let mut kind = match text.parse::<i32>() {
            Ok(integer) if whole => TokenKind::Integer(integer),
            _ => TokenKind::Number(value),
        };
        if matches!(self.peek(0), Some('i' | 'I')) && !self.peek(1).is_some_and(is_name_part) {
            self.at += 1;
            kind = TokenKind::Imaginary(value);
        }
        Ok(self.token(start, kind))
    }

    fn text(&mut self) -> Result<Token, ParseError> {
        let start = self.at;
        self.at += 1;
        let mut value = String::new();
        loop {
            let rest = self.rest();
            let Some(quote) = rest.find('"') else {
                let span = Span::new(start, start + 1);
                return Err(ParseError::new(span, ParseErrorKind::UnclosedText));
            };
            value.push_str(rest.get(..quote).unwrap_or(""));
            self.at += quote + 1;
            if self.peek(0) != Some('"') {
                return Ok(self.token(start, TokenKind::Text(value)));
            }
            value.push('"');
            self.at += 1;
        }
    }

    fn member(&mut self) -> Result<Token, ParseError> {
        let start = self.at;
        self.at += 1;
        self.skip(is_name_part);
        let span = Span::new(start, self.at);
        let name = span.text(self.source).trim_start_matches('.');
        let member = match lower_case(name).as_str() {
            "x" => Postfix::X,
            "y" => Postfix::Y,
            "z" => Postfix::Z,
            "o" => Postfix::Origin,
            "" => return Err(ParseError::new(span, ParseErrorKind::UnexpectedCharacter('.'))),
            _ => return Err(ParseError::new(span, ParseErrorKind::UnknownMember(name.into()))),
        };
        Ok(self.token(start, TokenKind::Operator(Symbol::After(member))))
    }
}

/// Names are letters of any script, digits, underscores and subscript digits, not starting with a digit.
fn is_name_start(c: char) -> bool {
    (c.is_alphabetic() || c == '_') && c != 'ⅈ'
}

fn is_name_part(c: char) -> bool {
    is_name_start(c) || c.is_ascii_digit() || ('₀'..='₉').contains(&c)
}

/// Lower case letter by letter, so that the same letters give the same name wherever they stand.
pub(crate) fn lower_case(name: &str) -> String {
    name.chars().flat_map(char::to_lowercase).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn kinds(source: &str) -> Vec<TokenKind> {
        let mut all: Vec<_> = tokens(source).unwrap().into_iter().map(|t| t.kind).collect();
        all.pop();
        all
    }

    #[test]
    fn numbers() {
        assert_eq!(kinds("12"), [TokenKind::Integer(12)]);
        assert_eq!(kinds("1.5 .5 1. 1e-3 2E+2"), [1.5, 0.5, 1.0, 0.001, 200.0].map(TokenKind::Number));
        assert_eq!(kinds("2147483647"), [TokenKind::Integer(i32::MAX)]);
        assert_eq!(kinds("2147483648"), [TokenKind::Number(2147483648.0)]);
        assert_eq!(kinds("3i"), [TokenKind::Imaginary(3.0)]);
        assert!(tokens("1e999").is_err());
        // An e without digits is a name after a number, which the parser refuses in its own words.
        assert_eq!(kinds("2e").len(), 2);
    }

    #[test]
    fn texts_keep_doubled_quotes_once() {
        assert_eq!(kinds(r#""a""b""#), [TokenKind::Text("a\"b".into())]);
        assert_eq!(tokens("\"a").unwrap_err().kind, ParseErrorKind::UnclosedText);
    }

    #[test]
    fn names_are_lower_case_and_of_any_script() {
        assert_eq!(kinds("rV_1"), [TokenKind::Name("rv_1".into())]);
        assert_eq!(kinds("Ωx²").len(), 2);
        assert_eq!(kinds("AND"), [TokenKind::Operator(Symbol::word("and").unwrap())]);
    }

    #[test]
    fn members_and_points_of_numbers() {
        assert_eq!(kinds("p.x").len(), 2);
        assert_eq!(kinds("1.X").len(), 2);
        assert!(matches!(tokens("p.w").unwrap_err().kind, ParseErrorKind::UnknownMember(n) if n == "w"));
    }
}
