//! `for` and `foreach`.

use super::{Binder, Item, Jump, make};
use crate::bound::{Const, Conv, Expr, Kind, LocalId, Op, Stmt, StmtKind};
use crate::sema::{Prim, Ty};
use crate::source::Pos;
use crate::syntax::ast::{self, Designation, NamePart, Passing, TypeRefKind};

impl Binder<'_> {
    pub(super) fn for_loop(
        &mut self,
        pos: Pos,
        first: &[ast::Stmt],
        c: Option<&ast::Expr>,
        step: &[ast::Expr],
        body: &ast::Stmt,
    ) -> StmtKind {
        let (stmts, locals) = self.in_scope(|b| {
            let mut stmts: Vec<_> = first.iter().map(|s| b.statement(s)).collect();
            let condition = c.map(|c| b.condition(c));
            let (body, brk, cont) = b.loop_body(body);
            let step = step.iter().map(|e| b.value(e)).collect();
            stmts.push(Stmt { pos, kind: StmtKind::Loop(condition, Box::new(body), step, brk, cont) });
            stmts
        });
        StmtKind::Block(locals, stmts)
    }

    pub(super) fn foreach(
        &mut self,
        pos: Pos,
        ty: &ast::TypeRef,
        names: &Designation,
        source: &ast::Expr,
        body: &ast::Stmt,
    ) -> StmtKind {
        let item = self.item(source);
        if let Item::Methods(_) = &item {
            self.fault(
                source.pos,
                446,
                "Foreach cannot operate on a 'method group'. Did you intend to invoke the 'method group'?",
            );
            return StmtKind::Several(Vec::new());
        }
        let source = self.as_value(item, source.pos);
        let (stmts, locals) = self.in_scope(|b| b.foreach_in(pos, ty, names, source, body));
        StmtKind::Block(locals, stmts)
    }

    /// A variable that the source does not name, set to a value.
    fn keep(&mut self, pos: Pos, value: Expr, stmts: &mut Vec<Stmt>) -> Expr {
        let ty = value.ty;
        let local = self.new_local("", ty, Passing::Value);
        let place = self.local(local, pos);
        let set = make(ty, pos, Kind::Assign(Box::new(place.clone()), Box::new(value)));
        stmts.push(self.expression_stmt(pos, set));
        place
    }

    fn foreach_in(
        &mut self,
        pos: Pos,
        ty: &ast::TypeRef,
        names: &Designation,
        source: Expr,
        body: &ast::Stmt,
    ) -> Vec<Stmt> {
        let mut stmts = Vec::new();
        if source.ty == Ty::ERROR {
            // Names of the loop are still known in its body.
            let wrong = self.wrong(pos);
            let (body, ..) = self.body_with(pos, ty, names, wrong, body);
            stmts.push(body);
            return stmts;
        }
        let string = self.sema.known.string;
        if let crate::sema::Kind::Array(element, 1) = self.sema.types.kind(source.ty).clone() {
            let array = self.keep(pos, source, &mut stmts);
            let length = make(self.sema.known.int, pos, Kind::Length(Box::new(array.clone())));
            let at = |index: Expr| make(element, pos, Kind::Element(Box::new(array.clone()), vec![index]));
            self.counted(pos, length, at, ty, names, body, &mut stmts);
            return stmts;
        }
        let list = self.sema.library("System.Collections.Generic", "List", 1);
        if source.ty == string || (list.is_some() && self.sema.def_of(source.ty) == list) {
            self.foreach_indexed(pos, source, ty, names, body, &mut stmts);
            return stmts;
        }
        if source.ty == Ty::DYNAMIC {
            let plain = self.sema.known.plain_enumerable;
            let source = self.convert(Item::Value(source), plain, pos);
            // `var` is `dynamic` here (C# specification, 13.9.5.1).
            let part = NamePart { pos, name: "dynamic".into(), args: Vec::new(), open: 0 };
            let open = ast::TypeRef { pos, kind: TypeRefKind::Named(vec![part]) };
            let ty = if matches!(ty.kind, TypeRefKind::Var) { &open } else { ty };
            self.foreach_enumerated(pos, source, ty, names, body, &mut stmts);
            return stmts;
        }
        self.foreach_enumerated(pos, source, ty, names, body, &mut stmts);
        stmts
    }

    fn get(&mut self, pos: Pos, of: Expr, name: &str, args: Vec<Expr>) -> Expr {
        let part = NamePart { pos, name: name.into(), args: Vec::new(), open: 0 };
        match self.member_of(pos, of, &part) {
            Item::Methods(group) => {
                let found = group
                    .candidates
                    .iter()
                    .copied()
                    .find(|(_, id)| self.sema.method(*id).params.len() == args.len());
                let Some((owner, id)) = found else { return self.wrong(pos) };
                let by = self.sema.substitution(owner);
                let info = self.sema.method(id);
                let (ret, is_virtual) = (info.ret, info.is_virtual);
                let ret = self.sema.types.substitute(ret, &by);
                let args = args.into_iter().map(|a| (Passing::Value, a)).collect();
                let method = crate::bound::MethodRef { id, owner, args: Vec::new() };
                make(ret, pos, Kind::Call(group.receiver.map(Box::new), method, args, is_virtual))
            }
            item => self.as_value(item, pos),
        }
    }

    /// Texts and lists go by index; a list that changes meanwhile is found out.
    fn foreach_indexed(
        &mut self,
        pos: Pos,
        source: Expr,
        ty: &ast::TypeRef,
        names: &Designation,
        body: &ast::Stmt,
        stmts: &mut Vec<Stmt>,
    ) {
        let string = source.ty == self.sema.known.string;
        let kept = self.keep(pos, source, stmts);
        let element = |b: &mut Self, index: Expr| {
            let members = b.sema.members(kept.ty, &"Item".into());
            let found = members.into_iter().find_map(|(owner, m)| match m {
                crate::sema::Member::Prop(p) => Some((owner, p)),
                _ => None,
            });
            let Some((owner, id)) = found else { return b.wrong(pos) };
            b.prop(pos, Some(kept.clone()), owner, id, vec![(Passing::Value, index)], false)
        };
        let int = self.sema.known.int;
        let zero = make(int, pos, Kind::Const(Const::Int(0)));
        let index = self.keep(pos, zero, stmts);
        let condition = if string {
            // A text never changes: its length is asked once.
            let length = self.get(pos, kept.clone(), "Length", Vec::new());
            let length = self.keep(pos, length, stmts);
            let bool_ = self.sema.known.bool;
            make(
                bool_,
                pos,
                Kind::Binary(Op::Lt, Prim::I32, false, Box::new(index.clone()), Box::new(length)),
            )
        } else {
            let version = self.get(pos, kept.clone(), "__Version", Vec::new());
            let version = self.keep(pos, version, stmts);
            self.get(pos, kept.clone(), "__More", vec![index.clone(), version])
        };
        let value = element(self, index.clone());
        self.finish_counted(pos, condition, index, value, ty, names, body, stmts);
    }

    #[allow(clippy::too_many_arguments, reason = "the parts of a loop")]
    fn counted(
        &mut self,
        pos: Pos,
        length: Expr,
        at: impl Fn(Expr) -> Expr,
        ty: &ast::TypeRef,
        names: &Designation,
        body: &ast::Stmt,
        stmts: &mut Vec<Stmt>,
    ) {
        let (int, bool_) = (self.sema.known.int, self.sema.known.bool);
        let zero = make(int, pos, Kind::Const(Const::Int(0)));
        let index = self.keep(pos, zero, stmts);
        let condition = make(
            bool_,
            pos,
            Kind::Binary(Op::Lt, Prim::I32, false, Box::new(index.clone()), Box::new(length)),
        );
        let value = at(index.clone());
        self.finish_counted(pos, condition, index, value, ty, names, body, stmts);
    }

    #[allow(clippy::too_many_arguments, reason = "the parts of a loop")]
    fn finish_counted(
        &mut self,
        pos: Pos,
        condition: Expr,
        index: Expr,
        value: Expr,
        ty: &ast::TypeRef,
        names: &Designation,
        body: &ast::Stmt,
        stmts: &mut Vec<Stmt>,
    ) {
        let int = self.sema.known.int;
        let (body, brk, cont) = self.body_with(pos, ty, names, value, body);
        let one = make(int, pos, Kind::Const(Const::Int(1)));
        let next =
            make(int, pos, Kind::Binary(Op::Add, Prim::I32, false, Box::new(index.clone()), Box::new(one)));
        let step = make(int, pos, Kind::Assign(Box::new(index), Box::new(next)));
        stmts
            .push(Stmt { pos, kind: StmtKind::Loop(Some(condition), Box::new(body), vec![step], brk, cont) });
    }

    fn body_with(
        &mut self,
        pos: Pos,
        ty: &ast::TypeRef,
        names: &Designation,
        value: Expr,
        body: &ast::Stmt,
    ) -> (Stmt, crate::bound::Label, crate::bound::Label) {
        let (brk, cont) = (self.label(), self.label());
        let depth = self.functions.len() as u32;
        let (stmts, locals) = self.in_scope(|b| {
            let first = b.loop_variable(pos, ty, names, value);
            b.jumps.push(Jump { brk: Some(brk), cont: Some(cont), depth });
            let inner = b.inner(body);
            b.jumps.pop();
            vec![first, inner]
        });
        (Stmt { pos, kind: StmtKind::Block(locals, stmts) }, brk, cont)
    }

    fn loop_variable(&mut self, pos: Pos, ty: &ast::TypeRef, names: &Designation, value: Expr) -> Stmt {
        let Designation::Name(at, name) = names else { return self.deconstruct_into(pos, names, value) };
        let ty = if matches!(ty.kind, TypeRefKind::Var) { value.ty } else { self.resolve(ty) };
        let value = if value.ty == Ty::ERROR { value } else { self.cast(*at, Item::Value(value), ty) };
        let local: LocalId = self.declare(*at, name, ty, Passing::Value);
        self.readonly_locals.push(local);
        let place = self.local(local, *at);
        let set = make(ty, *at, Kind::Assign(Box::new(place), Box::new(value)));
        self.expression_stmt(*at, set)
    }

    fn foreach_enumerated(
        &mut self,
        pos: Pos,
        source: Expr,
        ty: &ast::TypeRef,
        names: &Designation,
        body: &ast::Stmt,
        stmts: &mut Vec<Stmt>,
    ) {
        let Some(enumerator) = self.enumerator(pos, source) else {
            let wrong = self.wrong(pos);
            let (body, ..) = self.body_with(pos, ty, names, wrong, body);
            stmts.push(body);
            return;
        };
        let enumerator = self.keep(pos, enumerator, stmts);
        let condition = self.get(pos, enumerator.clone(), "MoveNext", Vec::new());
        let value = self.get(pos, enumerator.clone(), "Current", Vec::new());
        let (body, brk, cont) = self.body_with(pos, ty, names, value, body);
        let run = Stmt { pos, kind: StmtKind::Loop(Some(condition), Box::new(body), Vec::new(), brk, cont) };
        let disposable = self.sema.known.disposable;
        if self.sema.implicit(enumerator.ty, disposable).is_some() {
            let dispose = self.dispose(pos, enumerator);
            stmts.push(Stmt { pos, kind: StmtKind::Try(Box::new(run), Vec::new(), Some(Box::new(dispose))) });
        } else {
            stmts.push(run);
        }
    }

    /// `source.GetEnumerator()`, by the type's own method or by an interface.
    fn enumerator(&mut self, pos: Pos, source: Expr) -> Option<Expr> {
        let ty = source.ty;
        let members = self.sema.members(ty, &"GetEnumerator".into());
        let own = members.into_iter().any(|(_, m)| matches!(m, crate::sema::Member::Method(id)
            if self.sema.method(id).params.is_empty() && self.sema.method(id).access == crate::sema::Access::Public));
        let interface = self.sema.type_kind(ty) == Some(ast::TypeKind::Interface);
        if own && !interface {
            return Some(self.get(pos, source, "GetEnumerator", Vec::new()));
        }
        let enumerable = self.sema.known.enumerable;
        let all = self.sema.interfaces(ty);
        let generic = all.iter().copied().find(|i| self.sema.def_of(*i) == Some(enumerable));
        let plain = self.sema.known.plain_enumerable;
        let as_ = generic.or_else(|| all.contains(&plain).then_some(plain));
        let Some(as_) = as_ else {
            let shown = self.show(ty);
            self.fault(pos, 1579, format!("foreach statement cannot operate on variables of type '{shown}' because '{shown}' does not contain a public definition for 'GetEnumerator'"));
            return None;
        };
        let made = make(as_, pos, Kind::Convert(Conv::Same, Box::new(source)));
        Some(self.get(pos, made, "GetEnumerator", Vec::new()))
    }
}
