//! An exchange structure out of bytes.

use super::lexer::{Lexer, Token};
use super::{Instance, Structure, Value};
use crate::{Error, Result};

/// What is read at most.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Bounds {
    /// Entities in all data sections.
    pub(crate) entities: usize,
    /// Lists in lists.
    pub(crate) depth: usize,
}

/// The entities of all data sections.
pub(crate) fn parse(bytes: &[u8], bounds: Bounds) -> Result<Structure> {
    let mut parser = Parser { lexer: Lexer::new(bytes), token: Token::End, bounds };
    parser.advance()?;
    parser.file()
}

struct Parser<'a> {
    lexer: Lexer<'a>,
    token: Token,
    bounds: Bounds,
}

impl Parser<'_> {
    fn advance(&mut self) -> Result<Token> {
        let next = self.lexer.next()?;
        Ok(std::mem::replace(&mut self.token, next))
    }

    fn error(&self, why: impl Into<String>) -> Error {
        self.lexer.error(why)
    }

    fn is(&self, sign: u8) -> bool {
        self.token == Token::Sign(sign)
    }

    fn is_keyword(&self, word: &str) -> bool {
        matches!(&self.token, Token::Keyword(k) if k == word)
    }

    fn expect(&mut self, sign: u8) -> Result<()> {
        if self.is(sign) {
            return self.advance().map(drop);
        }
        Err(self.error(format!("'{}' is missing", char::from(sign))))
    }

    fn file(&mut self) -> Result<Structure> {
        if !self.is_keyword("ISO-10303-21") {
            return Err(self.error("this is no STEP file: it does not begin with ISO-10303-21"));
        }
        let mut structure = Structure::default();
        let mut sections = 0;
        loop {
            if self.is_keyword("DATA") {
                sections += 1;
                self.advance()?;
                if self.is(b'(') {
                    self.list(0)?;
                }
                self.expect(b';')?;
                self.section(&mut structure)?;
            } else if self.token == Token::End || self.is_keyword("END-ISO-10303-21") {
                break;
            } else {
                self.advance()?;
            }
        }
        if sections == 0 {
            return Err(self.error("there is no data section"));
        }
        Ok(structure)
    }

    fn section(&mut self, structure: &mut Structure) -> Result<()> {
        loop {
            match self.advance()? {
                Token::Name(id) => {
                    self.expect(b'=')?;
                    let instance = self.instance()?;
                    self.expect(b';')?;
                    if structure.instances.len() >= self.bounds.entities {
                        return Err(Error::TooLarge(format!("more than {} entities", self.bounds.entities)));
                    }
                    if structure.instances.insert(id, instance).is_some() {
                        return Err(Error::entity(id, "it is defined twice"));
                    }
                }
                Token::Keyword(word) if word == "ENDSEC" => return self.expect(b';'),
                Token::End => return Err(self.error("the data section does not end")),
                _ => return Err(self.error("an entity, #number, should begin here")),
            }
        }
    }

    fn instance(&mut self) -> Result<Instance> {
        let mut records = Vec::new();
        if self.is(b'(') {
            self.advance()?;
            while !self.is(b')') {
                records.push(self.record()?);
            }
            self.advance()?;
        } else {
            records.push(self.record()?);
        }
        Ok(Instance { records })
    }

    fn record(&mut self) -> Result<(String, Vec<Value>)> {
        match self.advance()? {
            Token::Keyword(word) => Ok((word, self.list(0)?)),
            _ => Err(self.error("the type of an entity is missing")),
        }
    }

    /// Values between brackets.
    fn list(&mut self, depth: usize) -> Result<Vec<Value>> {
        if depth > self.bounds.depth {
            return Err(self.error(format!("lists lie more than {} deep", self.bounds.depth)));
        }
        self.expect(b'(')?;
        let mut values = Vec::new();
        while !self.is(b')') {
            if !values.is_empty() {
                self.expect(b',')?;
            }
            values.push(self.value(depth)?);
        }
        self.advance()?;
        Ok(values)
    }

    fn value(&mut self, depth: usize) -> Result<Value> {
        if self.is(b'(') {
            return self.list(depth + 1).map(Value::List);
        }
        Ok(match self.advance()? {
            Token::Integer(n) => Value::Integer(n),
            Token::Real(x) => Value::Real(x),
            Token::Text(s) => Value::Text(s),
            Token::Word(w) => Value::Word(w),
            Token::Name(id) => Value::Reference(id),
            Token::Binary | Token::Sign(b'$' | b'*') => Value::Nothing,
            Token::Keyword(word) => {
                let mut values = self.list(depth + 1)?;
                if values.len() != 1 {
                    return Err(self.error(format!("{word} holds {} values, not one", values.len())));
                }
                Value::Typed(word, Box::new(values.pop().unwrap_or(Value::Nothing)))
            }
            Token::Sign(_) | Token::End => return Err(self.error("a value is missing")),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const BOUNDS: Bounds = Bounds { entities: 100, depth: 8 };

    fn data(text: &str) -> Result<Structure> {
        parse(
            format!("ISO-10303-21;\nHEADER;\nENDSEC;\nDATA;\n{text}\nENDSEC;\nEND-ISO-10303-21;").as_bytes(),
            BOUNDS,
        )
    }

    #[test]
    fn values_of_all_kinds_are_read() {
        let read =
            data("#1=A('it''s',.T.,$,*,-1,2.E3,#2,(1,(2.)),B(3.),\"0F\");\n/* c; */#2=(C()D(1));").unwrap();
        let a = &read.instances[&1].records[0];
        let wanted = vec![
            Value::Text("it's".into()),
            Value::Word("T".into()),
            Value::Nothing,
            Value::Nothing,
            Value::Integer(-1),
            Value::Real(2000.0),
            Value::Reference(2),
            Value::List(vec![Value::Integer(1), Value::List(vec![Value::Real(2.0)])]),
            Value::Typed("B".into(), Box::new(Value::Real(3.0))),
            Value::Nothing,
        ];
        assert_eq!(a, &("A".to_owned(), wanted));
        assert_eq!(read.instances[&2].records.len(), 2);
    }

    #[test]
    fn what_is_wrong_is_told_with_its_line() {
        let told = |text: &str| data(text).unwrap_err().to_string();
        assert_eq!(told("#1=A();\n#1=A();"), "#1: it is defined twice");
        assert_eq!(told("#1=A(\n'open);"), "line 8: a string does not end");
        assert!(told("#1=A(1 2);").contains("',' is missing"));
        assert!(told(&format!("#1=A{}{};", "(".repeat(20), ")".repeat(20))).contains("8 deep"));
        assert!(parse(b"solid", BOUNDS).unwrap_err().to_string().contains("no STEP file"));
        assert!(told("#1=A(1.e999);").contains("no number"));
    }
}
