//! A precedence-climbing (Pratt) parser that writes the tree in postfix order.

use crate::ast::{Node, NodeKind};
use crate::functions::Function;
use crate::lexer::{Token, TokenKind, tokens};
use crate::names;
use crate::operator::{Binary, Postfix, level};
use crate::{Expression, MAX_DEPTH, ParseError, ParseErrorKind, Span, Variant};

pub(crate) fn parse(source: &str) -> Result<Expression, ParseError> {
    let tokens = tokens(source)?;
    let mut parser = Parser { source, tokens, at: 0, depth: 0, nodes: Vec::new() };
    if parser.kind() == &TokenKind::End {
        return Err(ParseError::new(Span::new(0, source.len()), ParseErrorKind::Empty));
    }
    parser.expression(0)?;
    match parser.kind() {
        TokenKind::End => Ok(Expression { nodes: parser.nodes }),
        TokenKind::Close(c) => Err(ParseError::new(parser.span(), ParseErrorKind::StrayClose(*c))),
        _ => Err(parser.missing_operator()),
    }
}

struct Parser<'a> {
    source: &'a str,
    tokens: Vec<Token>,
    at: usize,
    depth: usize,
    nodes: Vec<Node>,
}

type Parsed<T = ()> = Result<T, ParseError>;

impl Parser<'_> {
    fn kind(&self) -> &TokenKind {
        self.tokens.get(self.at).map_or(&TokenKind::End, |t| &t.kind)
    }

    fn span(&self) -> Span {
        self.tokens.get(self.at).map_or(Span::new(self.source.len(), self.source.len()), |t| t.span)
    }

    fn advance(&mut self) -> Span {
        let span = self.span();
        self.at += 1;
        span
    }

    fn emit(&mut self, kind: NodeKind, span: Span) {
        self.nodes.push(Node { kind, span });
    }

    /// Runs `inner` one level deeper.
    fn deeper<T>(&mut self, inner: impl FnOnce(&mut Self) -> Parsed<T>) -> Parsed<T> {
        if self.depth >= MAX_DEPTH {
            return Err(ParseError::new(self.span(), ParseErrorKind::TooDeep(MAX_DEPTH)));
        }
        self.depth += 1;
        let result = inner(self);
        self.depth -= 1;
        result
    }

    /// Everything that binds at least as tightly as `least`. All chains go to the left.
    fn expression(&mut self, least: u8) -> Parsed {
        self.deeper(|p| {
            p.prefixed()?;
            while let TokenKind::Operator(symbol) = p.kind() {
                let Some(operator) = symbol.infix() else { return Err(p.missing_operator()) };
                if operator.level() < least {
                    break;
                }
                let span = p.advance();
                if operator == Binary::Power {
                    p.exponent()?;
                } else {
                    p.expression(operator.level() + 1)?;
                }
                p.emit(NodeKind::Binary(operator), span);
            }
            Ok(())
        })
    }

    /// `-x^2` is `-(x^2)`: signs bind looser than `^` …
    fn prefixed(&mut self) -> Parsed {
        let TokenKind::Operator(symbol) = self.kind() else { return self.primary() };
        let Some(operator) = symbol.prefix() else { return Err(self.missing_value()) };
        let span = self.advance();
        self.expression(level::PREFIX)?;
        self.emit(NodeKind::Prefix(operator), span);
        Ok(())
    }

    /// … but may stand right behind it: `a^-1*x` is `(a^(-1))*x`.
    fn exponent(&mut self) -> Parsed {
        let TokenKind::Operator(symbol) = self.kind() else { return self.primary() };
        let Some(operator) = symbol.prefix() else { return Err(self.missing_value()) };
        let span = self.advance();
        self.deeper(Self::exponent)?;
        self.emit(NodeKind::Prefix(operator), span);
        Ok(())
    }

    /// A literal, name, call or bracket with the postfix operators behind it.
    fn primary(&mut self) -> Parsed {
        let span = self.span();
        match self.kind().clone() {
            TokenKind::Integer(value) => self.literal(Variant::Integer(value)),
            TokenKind::Number(value) => self.literal(Variant::Number(value)),
            TokenKind::Imaginary(im) => self.literal(Variant::Complex { re: 0.0, im }),
            TokenKind::Text(text) => self.literal(Variant::text(text)),
            TokenKind::Name(name) => self.name(name)?,
            TokenKind::Open('(') => {
                self.advance();
                self.expression(0)?;
                self.close('(', span)?;
            }
            TokenKind::Open('[') => {
                self.advance();
                self.expression(0)?;
                self.close('[', span)?;
                self.emit(NodeKind::Postfix(Postfix::Unitize), span);
            }
            TokenKind::Open(open) => {
                self.advance();
                let count = self.list(open, span)?;
                let whole = span.to(self.previous_span());
                if !(2..=3).contains(&count) {
                    return Err(ParseError::new(whole, ParseErrorKind::PointSize(count)));
                }
                self.emit(NodeKind::Point(count), whole);
            }
            _ => return Err(self.missing_value()),
        }
        while let TokenKind::Operator(crate::symbols::Symbol::After(operator)) = *self.kind() {
            let span = self.advance();
            self.emit(NodeKind::Postfix(operator), span);
        }
        Ok(())
    }

    fn literal(&mut self, value: Variant) {
        let span = self.advance();
        self.emit(NodeKind::Literal(value), span);
    }

    fn name(&mut self, name: String) -> Parsed {
        let span = self.advance();
        let open = self.span();
        if self.kind() != &TokenKind::Open('(') {
            let kind = match name.as_str() {
                "true" => NodeKind::Literal(Variant::Boolean(true)),
                "false" => NodeKind::Literal(Variant::Boolean(false)),
                _ => NodeKind::Name(name),
            };
            self.emit(kind, span);
            return Ok(());
        }
        let Some(function) = Function::named(&name) else {
            let suggestion = names::nearest(&name, Function::all_names());
            let name = span.text(self.source).to_string();
            return Err(ParseError::new(span, ParseErrorKind::UnknownFunction { name, suggestion }));
        };
        self.advance();
        let given = self.list('(', open)?;
        let help = function.help();
        if given < help.least || given > help.most {
            let kind = ParseErrorKind::ArgumentCount {
                signature: help.signature,
                takes: help.count_in_words(),
                given,
            };
            return Err(ParseError::new(span.to(self.previous_span()), kind));
        }
        self.emit(NodeKind::Call(function, given), span);
        Ok(())
    }

    /// Values with commas between them, and the closing bracket; how many there were.
    fn list(&mut self, open: char, open_span: Span) -> Parsed<usize> {
        if self.kind() == &TokenKind::Close(partner(open)) {
            self.advance();
            return Ok(0);
        }
        let mut count = 0;
        loop {
            if self.kind() == &TokenKind::End {
                return Err(ParseError::new(open_span, ParseErrorKind::Unclosed(open)));
            }
            self.expression(0)?;
            count += 1;
            if self.kind() != &TokenKind::Comma {
                break;
            }
            self.advance();
        }
        self.close(open, open_span)?;
        Ok(count)
    }

    fn close(&mut self, open: char, open_span: Span) -> Parsed {
        let error = match *self.kind() {
            TokenKind::Close(c) if c == partner(open) => {
                self.advance();
                return Ok(());
            }
            TokenKind::End => ParseError::new(open_span, ParseErrorKind::Unclosed(open)),
            TokenKind::Close(close) => {
                ParseError::new(self.span(), ParseErrorKind::MismatchedClose { open, close })
            }
            _ => self.missing_operator(),
        };
        Err(error)
    }

    fn previous_span(&self) -> Span {
        self.at.checked_sub(1).and_then(|i| self.tokens.get(i)).map_or(Span::default(), |t| t.span)
    }

    /// What stands at the current place, in words.
    fn found(&self) -> String {
        match self.kind() {
            TokenKind::End => "the end of the expression".into(),
            _ => {
                let text = self.span().text(self.source);
                let short: String = text.chars().take(40).collect();
                format!("'{short}{}'", if short.len() < text.len() { "…" } else { "" })
            }
        }
    }

    fn missing_value(&self) -> ParseError {
        let kind = match self.kind() {
            // `(` before it would have been named already, so an end here belongs to an operator or nothing.
            TokenKind::Close(_) | TokenKind::End | TokenKind::Comma | TokenKind::Operator(_) => {
                ParseErrorKind::MissingValue { found: self.found() }
            }
            _ => ParseErrorKind::MissingOperator { found: self.found() },
        };
        ParseError::new(self.span(), kind)
    }

    fn missing_operator(&self) -> ParseError {
        let kind = match self.kind() {
            TokenKind::Comma => ParseErrorKind::StrayComma,
            _ => ParseErrorKind::MissingOperator { found: self.found() },
        };
        ParseError::new(self.span(), kind)
    }
}

fn partner(open: char) -> char {
    match open {
        '(' => ')',
        '[' => ']',
        _ => '}',
    }
}
