//! Switch statements and switch expressions.

use std::sync::Arc;

use super::{Binder, Cases, Item, Jump, make};
use crate::bound::{Const, Expr, Kind, Label, Stmt, StmtKind};
use crate::sema::Ty;
use crate::source::Pos;
use crate::syntax::ast::{self, Arm, CaseLabel, ExprKind, Passing, PatternKind, Section};

impl Binder<'_> {
    pub(super) fn switch(&mut self, pos: Pos, subject: &ast::Expr, sections: &[Section]) -> Stmt {
        let value = self.real_value(subject);
        let end = self.label();
        let depth = self.functions.len() as u32;
        self.jumps.push(Jump { brk: Some(end), cont: None, depth });
        let labels: Vec<Label> = sections.iter().map(|_| self.label()).collect();
        self.collect_cases(&value, sections, &labels);
        let (stmts, locals) = self.in_scope(|b| {
            let local = b.new_local("", value.ty, Passing::Value);
            let place = b.local(local, pos);
            let ty = value.ty;
            let mut stmts =
                vec![b.expression_stmt(
                    pos,
                    make(ty, pos, Kind::Assign(Box::new(place.clone()), Box::new(value))),
                )];
            let mut bodies = Vec::new();
            let mut default = end;
            for (section, label) in sections.iter().zip(&labels) {
                let ((tests, body), locals) =
                    b.in_scope(|b| b.section(&place, section, *label, &mut default));
                stmts.extend(tests);
                // The tests set variables that the body uses: they live in the whole switch.
                if let Some(scope) = b.scopes.last_mut() {
                    scope.locals.extend(locals);
                }
                if super::method::ends(&body) && !section.stmts.is_empty() {
                    let shown = match section.labels.last() {
                        Some(CaseLabel::Default(_)) => "default:".to_owned(),
                        _ => "case".to_owned(),
                    };
                    let at = section.labels.first().map_or(pos, label_pos);
                    b.fault(
                        at,
                        163,
                        format!("Control cannot fall through from one case label ('{shown}') to another"),
                    );
                }
                bodies.push(Stmt { pos, kind: StmtKind::Label(*label) });
                bodies.push(body);
                bodies.push(Stmt { pos, kind: StmtKind::Goto(end) });
            }
            stmts.push(Stmt { pos, kind: StmtKind::Goto(default) });
            stmts.extend(bodies);
            stmts.push(Stmt { pos, kind: StmtKind::Label(end) });
            stmts
        });
        self.cases.pop();
        self.jumps.pop();
        Stmt { pos, kind: StmtKind::Block(locals, stmts) }
    }

    /// Which constants `goto case` finds, and what is written twice.
    fn collect_cases(&mut self, value: &Expr, sections: &[Section], labels: &[Label]) {
        let mut cases = Cases { ty: Some(value.ty), ..Cases::default() };
        for (section, label) in sections.iter().zip(labels) {
            for case in &section.labels {
                match case {
                    CaseLabel::Default(pos) => {
                        if cases.default.is_some() {
                            self.fault(
                                *pos,
                                152,
                                "The switch statement contains multiple cases with the label value 'default'",
                            );
                        }
                        cases.default = Some(*label);
                    }
                    CaseLabel::Case(pattern, None) => {
                        let PatternKind::Value(e) = &pattern.kind else { continue };
                        let inner = self.sema.nullable_of(value.ty).unwrap_or(value.ty);
                        let folded = self.speculate(|b| {
                            let item = b.item(e);
                            b.convert(item, inner, e.pos)
                        });
                        let Some(Expr { kind: Kind::Const(constant), .. }) = folded else { continue };
                        if cases.constants.iter().any(|(c, _)| *c == constant) {
                            let shown = match &constant {
                                Const::Int(n) => n.to_string(),
                                Const::Str(s) => String::from_utf16_lossy(s),
                                other => format!("{other:?}"),
                            };
                            self.fault(pattern.pos, 152, format!("The switch statement contains multiple cases with the label value '{shown}'"));
                        }
                        cases.constants.push((constant, *label));
                    }
                    CaseLabel::Case(..) => {}
                }
            }
        }
        self.cases.push(cases);
    }

    fn section(
        &mut self,
        place: &Expr,
        section: &Section,
        label: Label,
        default: &mut Label,
    ) -> (Vec<Stmt>, Stmt) {
        let mut tests = Vec::new();
        let mut pos = place.pos;
        for case in &section.labels {
            match case {
                CaseLabel::Default(at) => {
                    pos = *at;
                    *default = label;
                }
                CaseLabel::Case(pattern, guard) => {
                    pos = pattern.pos;
                    let mut test = self.test(place, pattern);
                    if let Some(guard) = guard {
                        let guard = self.condition(guard);
                        test = make(self.sema.known.bool, pos, Kind::And(Box::new(test), Box::new(guard)));
                    }
                    let jump = Stmt { pos, kind: StmtKind::Goto(label) };
                    tests.push(Stmt { pos, kind: StmtKind::If(test, Box::new(jump), None) });
                }
            }
        }
        let (stmts, locals) = self.in_scope(|b| b.statements(&section.stmts));
        (tests, Stmt { pos, kind: StmtKind::Block(locals, stmts) })
    }

    pub(super) fn goto_case(&mut self, pos: Pos, value: Option<&ast::Expr>) -> StmtKind {
        let Some(cases) = self.cases.last() else {
            self.fault(pos, 153, "A goto case is only valid inside a switch statement");
            return StmtKind::Several(Vec::new());
        };
        let (default, ty) = (cases.default, cases.ty);
        let found = match value {
            None => default,
            Some(e) => {
                let item = self.item(e);
                let ty = ty.unwrap_or(Ty::ERROR);
                let value = self.convert(item, ty, e.pos);
                match value.kind {
                    Kind::Const(constant) => self
                        .cases
                        .last()
                        .and_then(|c| c.constants.iter().find(|(c, _)| *c == constant).map(|(_, l)| *l)),
                    _ => None,
                }
            }
        };
        match found {
            Some(label) => StmtKind::Goto(label),
            None => {
                self.fault(pos, 159, "No such label within the scope of the goto statement");
                StmtKind::Several(Vec::new())
            }
        }
    }

    pub(super) fn switch_expression(&mut self, e: &ast::Expr, subject: &ast::Expr, arms: &[Arm]) -> Item {
        // Without an expected type it takes the common one of its arms.
        let mut items = Vec::new();
        let value = self.real_value(subject);
        if value.ty == Ty::ERROR {
            return Item::Value(value);
        }
        let (_, held) = self.held(value.ty, e.pos);
        for arm in arms {
            let item = self.speculate(|b| {
                b.in_scope(|b| {
                    b.test(&held, &arm.pattern);
                    let item = b.item(&arm.value);
                    match item {
                        Item::Tuple(..) => {
                            let at = arm.value.pos;
                            Item::Value(b.as_value(item, at))
                        }
                        item => item,
                    }
                })
                .0
            });
            if let Some(item) = item {
                items.push(item);
            }
        }
        match self.common_type(&items) {
            Some(ty) if ty != Ty::ERROR => Item::Value(self.switch_as(e.pos, subject, arms, ty)),
            _ => Item::Untyped(e.pos, Arc::new(e.clone())),
        }
    }

    fn switch_as(&mut self, pos: Pos, subject: &ast::Expr, arms: &[Arm], ty: Ty) -> Expr {
        let value = self.real_value(subject);
        let (number, held) = self.held(value.ty, pos);
        let failure = self.library_exception(pos, "SwitchExpressionException");
        let mut chain = make(ty, pos, Kind::Throw(Box::new(failure)));
        let mut made = Vec::new();
        for arm in arms {
            let ((test, result), locals) = self.in_scope(|b| {
                let mut test = b.test(&held, &arm.pattern);
                if let Some(guard) = &arm.guard {
                    let guard = b.condition(guard);
                    test = make(b.sema.known.bool, pos, Kind::And(Box::new(test), Box::new(guard)));
                }
                let item = b.item(&arm.value);
                (test, b.convert(item, ty, arm.value.pos))
            });
            if let Some(scope) = self.scopes.last_mut() {
                scope.locals.extend(locals);
            }
            made.push((test, result));
        }
        for (test, result) in made.into_iter().rev() {
            chain = make(ty, pos, Kind::Choice(Box::new(test), Box::new(result), Box::new(chain)));
        }
        make(ty, pos, Kind::Deconstruct(Box::new(value), number, vec![chain]))
    }

    /// A new exception of the library.
    pub(super) fn library_exception(&mut self, pos: Pos, name: &str) -> Expr {
        let ty = self.system(name);
        match self.constructor(pos, ty, &[]) {
            Some((method, args)) => make(ty, pos, Kind::New(method, args)),
            None => self.wrong(pos),
        }
    }

    /// A condition or switch for an expected type.
    pub(super) fn untyped(&mut self, e: &ast::Expr, to: Ty) -> Expr {
        match &e.kind {
            ExprKind::Switch(subject, arms) => self.switch_as(e.pos, subject, arms, to),
            ExprKind::Choice(c, a, b) => {
                let condition = self.condition(c);
                let yes = self.item(a);
                let no = self.item(b);
                self.choice_of(e.pos, condition, (yes, a.pos), (no, b.pos), to)
            }
            ExprKind::Bracketed(inner) => self.untyped(inner, to),
            _ => self.wrong(e.pos),
        }
    }
}

fn label_pos(label: &CaseLabel) -> Pos {
    match label {
        CaseLabel::Case(pattern, _) => pattern.pos,
        CaseLabel::Default(pos) => *pos,
    }
}
