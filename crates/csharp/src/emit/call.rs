//! Calls.

use super::{Emitted, Emitter};
use crate::bound::{Arg, DynamicOp, Expr, Kind, MethodRef};
use crate::program::{DynamicSite, Target};
use crate::sema::Ty;
use crate::source::Pos;
use crate::syntax::ast::Passing;
use crate::vm::op::{Op, Reg};

impl Emitter<'_> {
    pub(super) fn method_ref(&mut self, method: &MethodRef) -> MethodRef {
        MethodRef {
            id: method.id,
            owner: self.ty(method.owner),
            args: method.args.iter().map(|arg| self.ty(*arg)).collect(),
        }
    }

    /// Arguments into registers in a row.
    fn arguments(&mut self, first: Reg, args: &[Arg], copies: bool) -> Emitted<()> {
        for (i, (passing, arg)) in args.iter().enumerate() {
            let d = first + i as Reg;
            match passing {
                Passing::Ref | Passing::Out => self.reference(d, arg)?,
                Passing::In => self.in_reference(d, arg)?,
                Passing::Value if copies => {
                    self.copied(arg, Some(d))?;
                }
                Passing::Value => {
                    self.expr(arg, Some(d))?;
                }
            }
        }
        Ok(())
    }

    /// `in`: a variable by reference, any other value in one of its own.
    fn in_reference(&mut self, d: Reg, arg: &Expr) -> Emitted<()> {
        if matches!(arg.kind, Kind::Local(_) | Kind::Field(..) | Kind::Element(..)) {
            return self.reference(d, arg);
        }
        let a = self.fresh(arg)?;
        self.op(Op::RefLocal { d, a });
        Ok(())
    }

    pub(super) fn call_into(
        &mut self,
        d: Reg,
        receiver: Option<&Expr>,
        method: &MethodRef,
        args: &[Arg],
        is_virtual: bool,
        e: &Expr,
    ) -> Emitted<()> {
        let pos = e.pos;
        let mut method = self.method_ref(method);
        let mut is_virtual = is_virtual;
        if let Some(receiver) = receiver {
            let ty = self.ty(receiver.ty);
            self.settle(ty, &mut method, &mut is_virtual);
        }
        if !is_virtual
            && (self.intrinsic(d, receiver, &method, args, e)?
                || self.inline_call(d, receiver, &method, args, e)?
                || self.inline_steps(d, receiver, &method, args, e)?)
        {
            return Ok(());
        }
        let count = args.len() as u32 + u32::from(receiver.is_some());
        // What the library does to structs of its own neither keeps nor changes its arguments.
        let info = self.program.sema.method(method.id);
        let keeps = !(matches!(info.body, crate::sema::Body::Extern(_))
            && self.program.sema.def(info.owner).kind == crate::syntax::ast::TypeKind::Struct);
        let copies = keeps || !self.rest_is_quiet(args.iter().map(|(_, arg)| arg));
        // A struct in its parts is put together for the call, and taken apart again: the method may have changed it. Below
        // the window of the call it is not lost.
        let apart = match receiver.and_then(|receiver| self.parts_of(receiver)) {
            Some(parts) => Some((parts, self.alloc()?)),
            None => None,
        };
        let base = self.allocs(count.max(1))?;
        let mut first = base;
        let mut receiver_ty = Ty::ERROR;
        let mut late = false;
        if let Some(receiver) = receiver {
            receiver_ty = self.ty(receiver.ty);
            late = self.is_struct_variable(receiver) && args.iter().any(|(_, arg)| self.sets_locals(arg));
            if apart.is_none() && !late {
                self.receiver(base, receiver, &method)?;
            }
            first += 1;
        }
        self.arguments(first, args, copies)?;
        match (apart, receiver) {
            (Some((parts, whole)), _) => {
                self.build(whole, parts);
                self.op(Op::Move { d: base, a: whole });
            }
            (None, Some(receiver)) if late => self.receiver(base, receiver, &method)?,
            _ => {}
        }
        self.pos = pos;
        self.dispatch(base, receiver.is_some(), receiver_ty, &method, is_virtual, e)?;
        self.pos = pos;
        if let Some((parts, whole)) = apart {
            self.take_apart(parts, whole);
        }
        self.result(d, base, &method);
        Ok(())
    }

    /// Whether the object of a call is a struct in a variable, or one in such a struct: the call is given its place, so what
    /// the arguments do to it is seen.
    pub(super) fn is_struct_variable(&mut self, receiver: &Expr) -> bool {
        let ty = self.ty(receiver.ty);
        self.program.sema.is_struct(ty)
            && match &receiver.kind {
                Kind::Local(_) | Kind::This => true,
                Kind::Field(Some(of), _) => self.is_struct_variable(of),
                _ => false,
            }
    }

    /// The object that a method is called on: a struct in its place, unless it came from a property.
    fn receiver(&mut self, base: Reg, receiver: &Expr, method: &MethodRef) -> Emitted<()> {
        let _ = method;
        self.expr(receiver, Some(base))?;
        Ok(())
    }

    fn result(&mut self, d: Reg, base: Reg, method: &MethodRef) {
        let info = self.program.sema.method(method.id);
        if info.ret == Ty::VOID {
            return;
        }
        // The library gives what it holds; a struct of it is copied.
        let (ret, is_extern) = (info.ret, matches!(info.body, crate::sema::Body::Extern(_)));
        let generic = self.program.sema.is_param(ret);
        if is_extern && generic {
            let mut by = self.program.sema.substitution(method.owner);
            by.0.extend(
                crate::sema::Substitution::of(
                    &self.program.sema.method(method.id).type_params.clone(),
                    &method.args,
                )
                .0,
            );
            let ret = self.program.sema.types.substitute(ret, &by);
            if self.program.sema.is_struct(ret) {
                self.op(Op::Copy { d, a: base });
                return;
            }
        }
        if d != base {
            self.op(Op::Move { d, a: base });
        }
    }

    /// Which method is called is known for a struct, whatever it implements; the methods of `T?` see to a missing value
    /// themselves.
    pub(super) fn settle(&mut self, receiver: Ty, method: &mut MethodRef, is_virtual: &mut bool) {
        if *is_virtual
            && self.program.sema.is_value_type(receiver)
            && let Some(found) = self.program.sema.find_override(receiver, method)
        {
            *method = found;
            *is_virtual = false;
        }
    }

    fn dispatch(
        &mut self,
        base: Reg,
        has_receiver: bool,
        receiver_ty: Ty,
        method: &MethodRef,
        is_virtual: bool,
        e: &Expr,
    ) -> Emitted<()> {
        let mut method = method.clone();
        let mut is_virtual = is_virtual;
        let value_type = self.program.sema.is_value_type(receiver_ty);
        if has_receiver {
            self.settle(receiver_ty, &mut method, &mut is_virtual);
        }
        if is_virtual {
            let site = self.program.site(method);
            self.op(Op::CallVirtual { site, base });
            return Ok(());
        }
        if has_receiver && !value_type && !matches!(receiver_kind(e), Some(Kind::This)) {
            self.op(Op::NullCheck { a: base });
        }
        if !has_receiver && let Some(i) = self.program.static_init(method.owner) {
            self.op(Op::Init { i });
        }
        match self.program.target(&method) {
            Target::Function(f) => self.op(Op::Call { f, base }),
            Target::Native(n, ty) => {
                self.program.layout_if_struct(ty);
                self.op(Op::Native { n, base, ty });
            }
            Target::GenNext => self.op(Op::GenNext { base }),
            Target::GenDispose => self.op(Op::GenDispose { base }),
            Target::None => {
                let shown = self.program.sema.show_method(method.id);
                self.unsupported(base, &shown);
            }
        }
        Ok(())
    }

    /// A call whose receiver and arguments are in registers.
    pub(super) fn call_registers(
        &mut self,
        d: Reg,
        receiver: Option<Reg>,
        receiver_ty: Ty,
        method: &MethodRef,
        args: &[Reg],
        is_virtual: bool,
    ) -> Emitted<()> {
        let method = self.method_ref(method);
        if !is_virtual && self.intrinsic_registers(d, receiver, &method, args) {
            return Ok(());
        }
        let base = self.allocs(args.len() as u32 + 1)?;
        let mut at = base;
        if let Some(receiver) = receiver {
            self.op(Op::Move { d: at, a: receiver });
            at += 1;
        }
        for arg in args {
            self.op(Op::Move { d: at, a: *arg });
            at += 1;
        }
        let receiver_ty = self.ty(receiver_ty);
        let none = Expr { ty: Ty::ERROR, pos: self.pos, kind: Kind::Error };
        self.dispatch(base, receiver.is_some(), receiver_ty, &method, is_virtual, &none)?;
        self.result(d, base, &method);
        Ok(())
    }

    pub(super) fn invoke_into(&mut self, d: Reg, delegate: &Expr, args: &[Arg]) -> Emitted<()> {
        let pos = self.pos;
        let base = self.allocs(args.len() as u32 + 1)?;
        self.expr(delegate, Some(base))?;
        self.arguments(base + 1, args, true)?;
        self.pos = pos;
        self.op(Op::Invoke { base });
        if d != base {
            self.op(Op::Move { d, a: base });
        }
        Ok(())
    }

    /// An operation whose function is found when it runs, by the types of its operands.
    pub(super) fn dynamic_into(
        &mut self,
        d: Reg,
        op: &DynamicOp,
        operands: &[Expr],
        pos: Pos,
    ) -> Emitted<()> {
        let Some(def) = self.def else {
            self.unsupported(d, "An operation on 'dynamic' here");
            return Ok(());
        };
        let base = self.allocs(operands.len().max(1) as u32)?;
        for (i, operand) in operands.iter().enumerate() {
            if i == 0 {
                self.expr(operand, Some(base))?;
            } else {
                self.copied(operand, Some(base + i as Reg))?;
            }
        }
        self.pos = pos;
        let site = self.program.dynamics.len() as u32;
        let (op, operands) = (op.clone(), operands.len());
        self.program.dynamics.push(DynamicSite { op, def, operands, pos, cache: Vec::new() });
        self.op(Op::Dynamic { site, base });
        if d != base {
            self.op(Op::Move { d, a: base });
        }
        Ok(())
    }

    pub(super) fn new_into(&mut self, d: Reg, method: &MethodRef, args: &[Arg]) -> Emitted<()> {
        let pos = self.pos;
        let mut method = self.method_ref(method);
        if method.id.0 == u32::MAX {
            // `new T()`
            let ty = method.owner;
            if self.program.sema.is_value_type(ty) {
                self.default_into(d, ty);
                return Ok(());
            }
            let found = self.program.sema.def_of(ty).and_then(|def| {
                let list = self.program.sema.def(def).members.get(".ctor")?;
                list.iter().find_map(|m| match m {
                    crate::sema::Member::Method(id) if self.program.sema.method(*id).params.is_empty() => {
                        Some(*id)
                    }
                    _ => None,
                })
            });
            let Some(id) = found else {
                self.unsupported(d, "A constructor without parameters of this type");
                return Ok(());
            };
            method.id = id;
        }
        let ty = method.owner;
        if self.inline_new(d, &method, args, pos)? {
            return Ok(());
        }
        let base = self.allocs(args.len() as u32 + 1)?;
        if let Target::Native(n, _) = self.program.target(&method) {
            // The library makes the object; its arguments begin at the second register.
            self.arguments(base + 1, args, true)?;
            self.pos = pos;
            self.program.layout_if_struct(ty);
            let element = self.program.sema.args_of(ty).first().copied();
            if let Some(element) = element {
                self.program.layout_if_struct(element);
            }
            self.op(Op::Native { n, base, ty });
            if d != base {
                self.op(Op::Move { d, a: base });
            }
            return Ok(());
        }
        // Arguments first: what they throw comes before the object is made.
        self.arguments(base + 1, args, true)?;
        self.pos = pos;
        if let Some(i) = self.program.static_init(ty) {
            self.op(Op::Init { i });
        }
        self.layout_of(ty);
        let object = self.alloc()?;
        if self.program.is_native_type(ty) {
            self.native_object(object, ty)?;
        } else {
            self.op(Op::New { d: object, ty });
        }
        // The window of the call lies above, so that the object is not lost in it.
        let window = self.allocs(args.len() as u32 + 1)?;
        self.op(Op::Move { d: window, a: object });
        for i in 0..args.len() {
            self.op(Op::Move { d: window + 1 + i as Reg, a: base + 1 + i as Reg });
        }
        if let Target::Function(f) = self.program.target(&method) {
            self.op(Op::Call { f, base: window });
        }
        self.op(Op::Move { d, a: object });
        Ok(())
    }

    /// An object of the library, which a constructor written in C# then fills.
    fn native_object(&mut self, d: Reg, ty: Ty) -> Emitted<()> {
        let name = self
            .program
            .sema
            .def_of(ty)
            .map(|def| self.program.sema.def(def).name.to_string())
            .unwrap_or_default();
        let n = self.program.native(&format!("{name}.new()").into(), 1, &[]);
        let base = self.alloc()?;
        self.op(Op::Native { n, base, ty });
        self.op(Op::Move { d, a: base });
        Ok(())
    }

    /// The text of a value: what the library knows is written at once, everything else says it itself.
    pub(super) fn text_into(&mut self, d: Reg, inner: &Expr) -> Emitted<()> {
        let pos = self.pos;
        let ty = self.ty(inner.ty);
        let plain = self.program.sema.underlying(ty).is_some() || ty == self.program.sema.known.string;
        if plain {
            let a = self.expr(inner, None)?;
            self.pos = pos;
            self.op(Op::Text { d, a });
            return Ok(());
        }
        let base = self.alloc()?;
        self.expr(inner, Some(base))?;
        self.pos = pos;
        let (null, end) = (self.mark(), self.mark());
        self.op(Op::JumpNull { a: base, to: null.0 });
        let object = self.program.sema.known.object;
        let found = self.program.sema.members(object, &"ToString".into()).into_iter().find_map(
            |(owner, m)| match m {
                crate::sema::Member::Method(id) => Some(MethodRef { id, owner, args: Vec::new() }),
                _ => None,
            },
        );
        if let Some(method) = found {
            let site = self.program.site(method);
            self.op(Op::CallVirtual { site, base });
        }
        self.op(Op::Text { d, a: base });
        self.jump(end);
        self.set(null);
        self.op(Op::Text { d, a: base });
        self.set(end);
        Ok(())
    }
}

fn receiver_kind(e: &Expr) -> Option<&Kind> {
    match &e.kind {
        Kind::Call(Some(receiver), ..) | Kind::Prop(Some(receiver), ..) => match &receiver.kind {
            Kind::Convert(_, inner) => Some(&inner.kind),
            kind => Some(kind),
        },
        _ => None,
    }
}
