//! `On Error`, `Resume`, labels, and jumps out of loops that are not the innermost (VB specification, unstructured
//! exception handling and jump statements).
//!
//! In a function with `On Error` each statement stands in a `try` of its own. Its `catch` looks at the state of the
//! handler when it runs: none, go on behind the statement, or go to a label. `Resume` finds its statement again by a number.

use super::token::Kind;
use super::{Block, Writer, Wrong};

/// What the function that is being written needs.
#[derive(Debug, Default)]
pub(super) struct Handling {
    /// Whether it has `On Error`.
    on: bool,
    /// The labels that `On Error GoTo` names, by their numbers from 1.
    targets: Vec<String>,
    /// How many statements are guarded.
    guarded: usize,
    /// Whether `Resume` or `Resume Next` stands in it.
    resumes: bool,
    /// How many blocks stand around each block that is guarded as a whole.
    wrapped: Vec<usize>,
    /// Labels behind blocks, by how many blocks stand around them.
    exits: Vec<(usize, String)>,
    /// Labels at the ends of the bodies of loops.
    turns: Vec<(usize, String)>,
}

impl Handling {
    /// The label behind the block that was just closed.
    pub(super) fn left(&mut self, around: usize) -> Option<String> {
        take(&mut self.exits, around)
    }

    /// The label at the end of the loop that is about to be closed.
    pub(super) fn going_on(&mut self, around: usize) -> Option<String> {
        take(&mut self.turns, around)
    }
}

fn take(list: &mut Vec<(usize, String)>, around: usize) -> Option<String> {
    let at = list.iter().position(|(own, _)| *own == around)?;
    Some(list.remove(at).1)
}

/// A label as C# has it: none of the names that a script declares.
pub(super) fn label(name: &str) -> String {
    format!("__label_{}", name.to_lowercase())
}

/// The word of a loop.
fn loop_word(block: &Block) -> Option<&'static str> {
    match block {
        Block::For => Some("for"),
        Block::While => Some("while"),
        Block::Do => Some("do"),
        _ => None,
    }
}

impl Writer {
    /// Begins a function: looks for `On Error` up to its end.
    pub(super) fn begin_handling(&mut self, line: usize) {
        let mut on = false;
        let mut begins = false;
        for (i, token) in self.tokens.iter().enumerate().skip(self.at) {
            let heads = ["sub", "function", "public", "private", "protected", "friend", "class", "property"];
            if begins && heads.iter().any(|word| token.is(word)) {
                break;
            }
            on |= begins && token.is("on") && self.tokens.get(i + 1).is_some_and(|next| next.is("error"));
            begins = token.kind == Kind::End || i == 0;
        }
        // The first statement of a body has nothing before it.
        on |= self.is("on") && self.is_next("error");
        self.handling = Handling { on, ..Handling::default() };
        if on {
            self.put(line, "int __handler = 0, __failed = 0, __active = 0;");
        }
    }

    /// Ends it: where a handler and `Resume` go on.
    pub(super) fn end_handling(&mut self, leave: &str) {
        let done = std::mem::take(&mut self.handling);
        if !done.on {
            return;
        }
        let line = self.line();
        self.put(line, leave);
        let cases = |to: &mut dyn FnMut(usize) -> String, count: usize| -> String {
            (1..=count).map(|n| format!("case {n}: goto {};", to(n))).collect::<Vec<_>>().join(" ")
        };
        let targets = cases(&mut |n| done.targets[n - 1].clone(), done.targets.len());
        self.put(line, &format!("__handle: switch (__active) {{ {targets} default: break; }} {leave}"));
        if done.resumes {
            let next = cases(&mut |n| format!("__next{n}"), done.guarded);
            self.put(line, &format!("__resume_next: switch (__failed) {{ {next} default: break; }} {leave}"));
            let again = cases(&mut |n| format!("__again{n}"), done.guarded);
            self.put(line, &format!("__resume: switch (__failed) {{ {again} default: break; }} {leave}"));
        }
    }

    /// Whether what is written now is guarded: not in a function within an expression.
    pub(super) fn handles(&self) -> bool {
        self.handling.on && !self.blocks.contains(&Block::Lambda)
    }

    /// A statement of a function with `On Error`.
    pub(super) fn guarded_statement(&mut self, line: usize, first: &str) -> Result<(), Wrong> {
        match first {
            "on" | "resume" | "goto" | "exit" | "continue" | "else" | "elseif" | "case" | "catch"
            | "finally" | "dim" | "const" | "next" | "wend" | "loop" | "end" => {
                self.plain_statement(line, first)?;
            }
            "if" | "for" | "while" | "do" | "select" | "with" | "using" | "try" => {
                let around = self.blocks.len();
                self.put(line, "try {");
                self.handling.wrapped.push(around);
                self.plain_statement(line, first)?;
            }
            _ => {
                let number = self.begin_guard(line);
                self.plain_statement(line, first)?;
                self.end_guard(line, number);
                return Ok(());
            }
        }
        // Blocks that are closed again are guarded as a whole: what fails in their heads is behind them.
        while self.handling.wrapped.last() == Some(&self.blocks.len()) {
            self.handling.wrapped.pop();
            self.handling.guarded += 1;
            let number = self.handling.guarded;
            let line = self.line();
            self.put(line, &format!("}} {}", caught(number)));
            self.put(line, &format!("__again{number}: __next{number}: ;"));
        }
        Ok(())
    }

    fn begin_guard(&mut self, line: usize) -> usize {
        self.handling.guarded += 1;
        let number = self.handling.guarded;
        self.put(line, &format!("__again{number}: try {{"));
        number
    }

    fn end_guard(&mut self, line: usize, number: usize) {
        self.put(line, &format!("}} {} __next{number}: ;", caught(number)));
    }

    /// A variable whose first value may fail: it is there before.
    pub(super) fn guarded_variable(&mut self, line: usize, text: &str, name: &str) {
        let Some((kind, value)) = text.split_once(&format!(" {name} = ")) else {
            self.put(line, &format!("{text};"));
            return;
        };
        let is_plain = value == "null"
            || value.starts_with("default(")
            || value.chars().all(|c| c.is_ascii_digit() || c == '.')
            || value.starts_with('"') && !value.contains('(');
        if is_plain {
            self.put(line, &format!("{text};"));
            return;
        }
        let made = value.strip_prefix("new ").and_then(|rest| rest.split_once('(')).map(|(kind, _)| kind);
        let begin = match (kind, made) {
            ("var", Some(made)) if !made.contains(['[', '{']) => format!("{made} {name} = default({made});"),
            // The type is that of the value, which is not asked for.
            ("var", _) => format!("var {name} = __VB.Default(() => {value});"),
            _ => format!("{kind} {name} = default({kind});"),
        };
        self.put(line, &begin);
        let number = self.begin_guard(line);
        self.put(line, &format!("{name} = {value};"));
        self.end_guard(line, number);
    }

    /// A condition that may fail: behind it comes the first statement of the block.
    pub(super) fn guarded_test(&mut self, line: usize, test: &str) -> String {
        let name = self.fresh();
        self.put(line, &format!("bool {name} = true;"));
        let number = self.begin_guard(line);
        self.put(line, &format!("{name} = {test};"));
        self.end_guard(line, number);
        name
    }

    /// `On Error GoTo label`, `On Error GoTo 0`, `On Error GoTo -1`, `On Error Resume Next`.
    pub(super) fn on_error(&mut self, line: usize) -> Result<(), Wrong> {
        self.at += 1;
        self.expect("error")?;
        if !self.handles() {
            return Err((line, "'On Error' within an expression is not supported in VB".to_owned()));
        }
        if self.take("resume") {
            self.expect("next")?;
            self.put(line, "__VBError.Err.Clear(); __handler = -1;");
            return Ok(());
        }
        self.expect("goto")?;
        if self.take_op("-") {
            self.at += 1;
            self.put(line, "__VBError.Err.Clear(); __active = 0;");
            return Ok(());
        }
        if matches!(self.peek().map(|token| &token.kind), Some(Kind::Number(zero)) if zero == "0") {
            self.at += 1;
            self.put(line, "__VBError.Err.Clear(); __handler = 0;");
            return Ok(());
        }
        let to = self.label_name()?;
        let number = match self.handling.targets.iter().position(|own| *own == to) {
            Some(at) => at + 1,
            None => {
                self.handling.targets.push(to);
                self.handling.targets.len()
            }
        };
        self.put(line, &format!("__VBError.Err.Clear(); __handler = {number};"));
        Ok(())
    }

    /// `Resume`, `Resume Next`, `Resume label`.
    pub(super) fn resume(&mut self, line: usize) -> Result<(), Wrong> {
        self.at += 1;
        if !self.handles() {
            return Err((line, "'Resume' stands in a function without 'On Error'".to_owned()));
        }
        let to = if self.take("next") {
            self.handling.resumes = true;
            "__resume_next".to_owned()
        } else if self.at_end() {
            self.handling.resumes = true;
            "__resume".to_owned()
        } else {
            self.label_name()?
        };
        self.put(line, &format!("__VBError.Err.Resume(__active); __handler = __active; goto {to};"));
        Ok(())
    }

    /// A label that is jumped to.
    pub(super) fn label_name(&mut self) -> Result<String, Wrong> {
        match self.peek().map(|token| token.kind.clone()) {
            Some(Kind::Word(name) | Kind::Number(name)) => {
                self.at += 1;
                Ok(label(&name))
            }
            _ => Err(self.wrong("a label expected")),
        }
    }

    /// `Exit For` and the like, also of a loop that is not the innermost.
    pub(super) fn leave(&mut self, line: usize, what: &str) -> Result<String, Wrong> {
        let innermost = self.blocks.iter().rev().find_map(loop_word);
        if what != "select" && innermost == Some(what) {
            return Ok("break;".to_owned());
        }
        let found = self.blocks.iter().rposition(|block| match block {
            Block::Select(..) => what == "select",
            block => loop_word(block) == Some(what),
        });
        let Some(around) = found else {
            return Err((line, format!("'Exit {what}' stands in no '{what}'")));
        };
        let known = self.handling.exits.iter().find(|(own, _)| *own == around).map(|(_, name)| name.clone());
        let name = known.unwrap_or_else(|| {
            let name = self.fresh();
            self.handling.exits.push((around, name.clone()));
            name
        });
        Ok(format!("goto {name};"))
    }

    /// `Continue For` and the like. A jump to the end of the body, where the test of a `Do` stands.
    pub(super) fn go_on(&mut self, line: usize, what: &str) -> Result<String, Wrong> {
        let Some(around) = self.blocks.iter().rposition(|block| loop_word(block) == Some(what)) else {
            return Err((line, format!("'Continue {what}' stands in no '{what}'")));
        };
        if self.blocks.iter().rev().find_map(loop_word) == Some(what) && what != "do" {
            return Ok("continue;".to_owned());
        }
        let known = self.handling.turns.iter().find(|(own, _)| *own == around).map(|(_, name)| name.clone());
        let name = known.unwrap_or_else(|| {
            let name = self.fresh();
            self.handling.turns.push((around, name.clone()));
            name
        });
        Ok(format!("goto {name};"))
    }
}

/// What catches the fault of a guarded statement.
fn caught(number: usize) -> String {
    format!(
        "catch (Exception __e{number}) when (__handler != 0) {{ __VBError.Err.Set(__e{number}); \
         if (__handler > 0) {{ __failed = {number}; __active = __handler; __handler = 0; goto __handle; }} }}"
    )
}
