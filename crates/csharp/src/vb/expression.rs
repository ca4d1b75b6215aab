//! Expressions of VB as C#.

use super::library::library_name;
use super::token::Kind;
use super::{Block, Writer, Wrong, escaped};

/// How deep expressions may stand in one another.
const DEPTH: usize = 200;

/// The operators, those that bind least first, with how C# writes them.
const LEVELS: [&[(&str, &str)]; 9] = [
    &[("xor", "^")],
    &[("or", "|"), ("orelse", "||")],
    &[("and", "&"), ("andalso", "&&")],
    &[
        ("=", "=="),
        ("<>", "!="),
        ("<=", "<="),
        (">=", ">="),
        ("<", "<"),
        (">", ">"),
        ("is", "=="),
        ("isnot", "!="),
        ("like", ""),
    ],
    &[("<<", "<<"), (">>", ">>")],
    &[("&", "&")],
    &[("+", "+"), ("-", "-")],
    &[("mod", "%")],
    &[("\\", "\\")],
];
const TIMES: &[(&str, &str)] = &[("*", "*"), ("/", "/")];

impl Writer {
    pub(super) fn expression(&mut self) -> Result<String, Wrong> {
        self.deeper(|writer| writer.level(0))
    }

    /// Goes on one level deeper: what a text nests without end is refused.
    pub(super) fn deeper<T>(&mut self, work: impl FnOnce(&mut Self) -> Result<T, Wrong>) -> Result<T, Wrong> {
        self.depth += 1;
        if self.depth > DEPTH {
            return Err(self.wrong("the text is too deep"));
        }
        let given = work(self);
        self.depth -= 1;
        given
    }

    fn operator(&mut self, table: &[(&'static str, &'static str)]) -> Option<(&'static str, &'static str)> {
        let found = table.iter().find(|(own, _)| self.is(own) || self.is_op(own)).copied()?;
        self.at += 1;
        Some(found)
    }

    fn level(&mut self, level: usize) -> Result<String, Wrong> {
        let Some(table) = LEVELS.get(level) else { return self.product() };
        // `Not` binds less than a comparison.
        if level == 3 && self.take("not") {
            return Ok(format!("__VB.Not({})", self.deeper(|writer| writer.level(3))?));
        }
        let mut left = self.level(level + 1)?;
        while let Some((vb, cs)) = self.operator(table) {
            let right = self.level(level + 1)?;
            left = match vb {
                "&" => format!("__VB.Join({left}, {right})"),
                "\\" => format!("__VB.Whole({left}, {right})"),
                "like" => format!("__VB.Like({left}, {right})"),
                _ => format!("({left} {cs} {right})"),
            };
        }
        Ok(left)
    }

    fn product(&mut self) -> Result<String, Wrong> {
        let mut left = self.signed()?;
        while let Some((_, cs)) = self.operator(TIMES) {
            let right = self.signed()?;
            left = format!("({left} {cs} {right})");
        }
        Ok(left)
    }

    fn signed(&mut self) -> Result<String, Wrong> {
        if self.take_op("-") {
            return Ok(format!("(-{})", self.deeper(Self::signed)?));
        }
        if self.take_op("+") {
            return self.deeper(Self::signed);
        }
        let base = self.postfix()?;
        if self.take_op("^") {
            let exponent = self.deeper(Self::signed)?;
            return Ok(format!("Math.Pow({base}, {exponent})"));
        }
        Ok(base)
    }

    /// A value with what stands behind it: members, calls, elements.
    pub(super) fn postfix(&mut self) -> Result<String, Wrong> {
        let mut left = self.primary()?;
        loop {
            if self.take_op(".") {
                let name = escaped(&self.word()?);
                left = format!("{left}.{name}");
            } else if self.is_op("(") && self.is_next("of") {
                left.push_str(&self.type_arguments()?);
            } else if self.take_op("(") {
                left = format!("{left}({})", self.arguments()?);
            } else {
                return Ok(left);
            }
        }
    }

    /// The arguments up to the closing parenthesis.
    fn arguments(&mut self) -> Result<String, Wrong> {
        let mut all = Vec::new();
        while !self.take_op(")") {
            if self.tokens.get(self.at + 1).is_some_and(|token| token.is_op(":=")) {
                let name = escaped(&self.word()?);
                self.at += 1;
                all.push(format!("{name}: {}", self.expression()?));
            } else {
                all.push(self.expression()?);
            }
            if !self.is_op(")") {
                self.expect_op(",")?;
            }
        }
        Ok(all.join(", "))
    }

    fn primary(&mut self) -> Result<String, Wrong> {
        let kind = self.peek().map(|token| token.kind.clone());
        match kind {
            Some(Kind::Number(text)) => {
                self.at += 1;
                Ok(text)
            }
            Some(Kind::Text(text)) => {
                self.at += 1;
                Ok(format!("@\"{}\"", text.replace('"', "\"\"")))
            }
            Some(Kind::Char(c)) => {
                self.at += 1;
                Ok(match c {
                    '\'' | '\\' => format!("'\\{c}'"),
                    c => format!("'{c}'"),
                })
            }
            Some(Kind::Op("(")) => {
                self.at += 1;
                let inner = self.expression()?;
                self.expect_op(")")?;
                Ok(format!("({inner})"))
            }
            Some(Kind::Op(".")) => {
                let with = self.blocks.iter().rev().find_map(|block| match block {
                    Block::With(value) => Some(value.clone()),
                    _ => None,
                });
                // The dot is read by what takes members.
                with.ok_or_else(|| self.wrong("a leading dot stands in no 'With'"))
            }
            Some(Kind::Op("{")) => Ok(format!("new[] {}", self.braces()?)),
            Some(Kind::Word(name)) => self.named(&name),
            _ => Err(self.wrong("expression expected")),
        }
    }

    fn braces(&mut self) -> Result<String, Wrong> {
        self.expect_op("{")?;
        let mut all = Vec::new();
        while !self.take_op("}") {
            all.push(if self.is_op("{") { self.deeper(Self::braces)? } else { self.expression()? });
            if !self.is_op("}") {
                self.expect_op(",")?;
            }
        }
        Ok(format!("{{ {} }}", all.join(", ")))
    }

    fn named(&mut self, name: &str) -> Result<String, Wrong> {
        self.at += 1;
        let in_parentheses = self.is_op("(");
        Ok(match name.to_lowercase().as_str() {
            "true" => "true".into(),
            "false" => "false".into(),
            "nothing" => "null".into(),
            "me" => "this".into(),
            "mybase" => "base".into(),
            "new" => return self.creation(),
            "function" => return self.lambda(),
            "sub" => return self.action(),
            "addressof" => return self.deeper(Self::postfix),
            "typeof" => {
                let value = self.deeper(Self::postfix)?;
                self.expect("is")?;
                format!("({value} is {})", self.type_name()?)
            }
            "gettype" if in_parentheses => {
                self.at += 1;
                let name = self.type_name()?;
                self.expect_op(")")?;
                format!("typeof({name})")
            }
            "if" if in_parentheses => {
                self.at += 1;
                let parts = self.list(")")?;
                match parts.as_slice() {
                    [test, yes, no] => format!("({test} ? {yes} : {no})"),
                    [value, other] => format!("({value} ?? {other})"),
                    _ => return Err(self.wrong("If takes two or three operands")),
                }
            }
            cast @ ("ctype" | "directcast" | "trycast") if in_parentheses => {
                self.at += 1;
                let value = self.expression()?;
                self.expect_op(",")?;
                let kind = self.type_name()?;
                self.expect_op(")")?;
                match (cast, kind.as_str()) {
                    ("trycast", kind) => format!("({value} as {kind})"),
                    ("ctype", "int") => format!("__VB.Int({value})"),
                    ("ctype", "double") => format!("__VB.Dbl({value})"),
                    ("ctype", "string") => format!("__VB.Str({value})"),
                    (_, kind) => format!("(({kind})({value}))"),
                }
            }
            "cint" if in_parentheses => format!("__VB.Int({})", self.one()?),
            "clng" if in_parentheses => format!("Convert.ToInt64({})", self.one()?),
            "cdbl" if in_parentheses => format!("__VB.Dbl({})", self.one()?),
            "cdec" if in_parentheses => format!("Convert.ToDecimal({})", self.one()?),
            "csng" if in_parentheses => format!("Convert.ToSingle({})", self.one()?),
            "cstr" if in_parentheses => format!("__VB.Str({})", self.one()?),
            "cobj" if in_parentheses => format!("((object){})", self.one()?),
            "cchar" if in_parentheses => format!("Convert.ToChar({})", self.one()?),
            "cbyte" if in_parentheses => format!("Convert.ToByte({})", self.one()?),
            "cshort" if in_parentheses => format!("Convert.ToInt16({})", self.one()?),
            "cdate" if in_parentheses => format!("DateTime.Parse({})", self.one()?),
            "cbool" if in_parentheses => format!("Convert.ToBoolean({})", self.one()?),
            plain @ ("integer" | "string" | "double" | "boolean" | "object" | "long" | "single" | "char"
            | "date") => primitive(plain).unwrap_or("object").to_owned(),
            _ => {
                let is_own = self.names.contains_key(&name.to_lowercase());
                let behind_dot = self.at >= 2 && self.tokens.get(self.at - 2).is_some_and(|t| t.is_op("."));
                let library = if is_own || behind_dot { None } else { library_name(name, in_parentheses) };
                library.unwrap_or_else(|| self.spelled(name))
            }
        })
    }

    fn one(&mut self) -> Result<String, Wrong> {
        self.expect_op("(")?;
        let value = self.expression()?;
        self.expect_op(")")?;
        Ok(value)
    }

    pub(super) fn list(&mut self, end: &str) -> Result<Vec<String>, Wrong> {
        let mut all = Vec::new();
        while !self.take_op(end) {
            all.push(self.expression()?);
            if !self.is_op(end) {
                self.expect_op(",")?;
            }
        }
        Ok(all)
    }

    /// `New T(...)`, `New T() {...}`, `New List(Of T) From {...}`, `New T With {.X = ...}`.
    pub(super) fn creation(&mut self) -> Result<String, Wrong> {
        let kind = self.type_name()?;
        let mut arguments = Vec::new();
        if self.take_op("(") {
            arguments = self.list(")")?;
        }
        if self.is_op("{") {
            return Ok(format!("new {kind}[] {}", self.braces()?));
        }
        let joined = arguments.join(", ");
        if kind == "string" && arguments.len() == 1 {
            return Ok(format!("__VB.Str({joined})"));
        }
        if self.take("from") {
            return Ok(format!("new {kind}({joined}) {}", self.braces()?));
        }
        if self.take("with") {
            self.expect_op("{")?;
            let mut all = Vec::new();
            while !self.take_op("}") {
                self.expect_op(".")?;
                let name = escaped(&self.word()?);
                self.expect_op("=")?;
                all.push(format!("{name} = {}", self.expression()?));
                if !self.is_op("}") {
                    self.expect_op(",")?;
                }
            }
            return Ok(format!("new {kind}({joined}) {{ {} }}", all.join(", ")));
        }
        Ok(format!("new {kind}({joined})"))
    }

    /// Statements up to what closes them, as text of their own.
    fn nested(&mut self, block: Block, head: &str) -> Result<String, Wrong> {
        let line = self.line();
        let outer = std::mem::take(&mut self.lines);
        let (open, inline) = (self.blocks.len(), std::mem::take(&mut self.inline));
        self.lines = vec![String::new(); line];
        self.open(line, block, head);
        while self.blocks.len() > open {
            if self.peek().is_none() {
                return Err(self.wrong("the lambda has no end"));
            }
            self.deeper(Self::statement)?;
        }
        self.inline = inline;
        let made = std::mem::replace(&mut self.lines, outer);
        Ok(made.get(line.saturating_sub(1)..).unwrap_or_default().join("\n"))
    }

    /// `Sub(x) statement`, or statements up to `End Sub`.
    fn action(&mut self) -> Result<String, Wrong> {
        let names = self.lambda_names()?;
        if self.at_end() {
            return Ok(format!("(({names}) => {})", self.nested(Block::Sub, "{")?));
        }
        let line = self.line();
        let outer = std::mem::take(&mut self.lines);
        self.lines = vec![String::new(); line];
        self.deeper(Self::statement)?;
        let made = std::mem::replace(&mut self.lines, outer);
        Ok(format!("(({names}) => {{ {} }})", made.concat()))
    }

    /// `Function(x, y) x + y`, or statements up to `End Function`.
    fn lambda(&mut self) -> Result<String, Wrong> {
        let names = self.lambda_names()?;
        if self.take("as") {
            self.array_type()?;
        }
        if self.at_end() {
            let block = Block::Lambda;
            return Ok(format!("(({names}) => {})", self.nested(block, "{")?));
        }
        Ok(format!("(({names}) => {})", self.expression()?))
    }

    fn lambda_names(&mut self) -> Result<String, Wrong> {
        self.expect_op("(")?;
        let mut names = Vec::new();
        while !self.take_op(")") {
            let name = self.word()?;
            names.push(if self.take("as") {
                let kind = self.type_name()?;
                format!("{kind} {}", self.spelled(&name))
            } else {
                self.spelled(&name)
            });
            if !self.is_op(")") {
                self.expect_op(",")?;
            }
        }
        Ok(names.join(", "))
    }

    /// `(Of T, U)`
    fn type_arguments(&mut self) -> Result<String, Wrong> {
        self.expect_op("(")?;
        self.expect("of")?;
        let mut all = vec![self.deeper(Self::type_name)?];
        while self.take_op(",") {
            all.push(self.deeper(Self::type_name)?);
        }
        self.expect_op(")")?;
        Ok(format!("<{}>", all.join(", ")))
    }

    /// A type without array brackets.
    pub(super) fn type_name(&mut self) -> Result<String, Wrong> {
        let first = self.word()?;
        if let Some(plain) = primitive(&first.to_lowercase()) {
            return Ok(plain.to_owned());
        }
        let mut name = escaped(&first);
        loop {
            if self.take_op(".") {
                name = format!("{name}.{}", escaped(&self.word()?));
            } else if self.is_op("(") && self.is_next("of") {
                name.push_str(&self.type_arguments()?);
            } else {
                return Ok(name);
            }
        }
    }
}

fn primitive(name: &str) -> Option<&'static str> {
    Some(match name {
        "integer" => "int",
        "double" => "double",
        "string" => "string",
        "boolean" => "bool",
        // Members of an object are found when it runs.
        "object" => "dynamic",
        "long" => "long",
        "single" => "float",
        "short" => "short",
        "byte" => "byte",
        "char" => "char",
        "decimal" => "decimal",
        "date" => "DateTime",
        _ => return None,
    })
}
