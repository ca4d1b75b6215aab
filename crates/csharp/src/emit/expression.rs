//! Expressions.

use super::{Emitted, Emitter, Refused};
use crate::bind::wrap;
use crate::bound::{Const, Conv, Expr, Kind, Op as BinOp};
use crate::sema::{Prim, Ty};
use crate::vm::op::{Low, Op, Reg};
use crate::vm::value::Value;

impl Emitter<'_> {
    /// Evaluates; into a register when one is given, else wherever it is.
    pub(super) fn expr(&mut self, e: &Expr, want: Option<Reg>) -> Emitted<Reg> {
        if let Some(parts) = self.parts_of(e) {
            let d = self.target(want)?;
            self.build(d, parts);
            return Ok(d);
        }
        match &e.kind {
            Kind::Field(Some(of), field) if self.parts_of(of).is_some() => {
                let owner = self.ty(field.owner);
                if let Some(part) = self.part_of(of, owner, field.id) {
                    return Ok(self.moved(part, want));
                }
            }
            Kind::Local(id) => {
                if let Some((env, index)) = self.captured(*id)? {
                    let d = self.target(want)?;
                    self.op(Op::LoadField { d, o: env, i: index });
                    return Ok(d);
                }
                let Some(reg) = self.regs.get(id).copied() else {
                    return Err(Refused(e.pos, "A variable is used outside its block".to_owned()));
                };
                if self.is_reference_param(*id) {
                    let d = self.target(want)?;
                    self.op(Op::LoadRef { d, a: reg });
                    return Ok(d);
                }
                return Ok(self.moved(reg, want));
            }
            Kind::This => {
                let reg = self.this()?;
                return Ok(self.moved(reg, want));
            }
            Kind::Held(number) => {
                let Some(reg) = self.held.get(number).copied() else {
                    return Err(Refused(
                        e.pos,
                        "This use of a value inside a lambda is not supported".to_owned(),
                    ));
                };
                return Ok(self.moved(reg, want));
            }
            Kind::Convert(Conv::Same, inner) => return self.retyped(e, inner, want),
            Kind::Const(value) if want.is_none() => {
                if let Some(reg) = self.hoisted_constant(value, e.ty) {
                    return Ok(reg);
                }
            }
            _ => {}
        }
        let d = self.target(want)?;
        let kept = self.next;
        self.into(e, d)?;
        self.next = kept;
        Ok(d)
    }

    pub(super) fn target(&mut self, want: Option<Reg>) -> Emitted<Reg> {
        match want {
            Some(reg) => Ok(reg),
            None => self.alloc(),
        }
    }

    fn moved(&mut self, reg: Reg, want: Option<Reg>) -> Reg {
        match want {
            Some(d) if d != reg => {
                self.op(Op::Move { d, a: reg });
                d
            }
            _ => reg,
        }
    }

    /// A value that only changes its type; a struct that is boxed is copied.
    fn retyped(&mut self, e: &Expr, inner: &Expr, want: Option<Reg>) -> Emitted<Reg> {
        let (from, to) = (self.ty(inner.ty), self.ty(e.ty));
        if from != to && self.program.sema.is_struct(from) {
            return self.copied(inner, want);
        }
        if self.program.sema.type_kind(from) == Some(crate::syntax::ast::TypeKind::Delegate)
            || !matches!(inner.kind, Kind::Lambda(_))
        {
            return self.expr(inner, want);
        }
        self.expr(inner, want)
    }

    /// Evaluates into a register of its own that nothing else uses.
    pub(super) fn fresh(&mut self, e: &Expr) -> Emitted<Reg> {
        let d = self.alloc()?;
        self.expr(e, Some(d))
    }

    /// Two operands; the first is kept safe when the second sets variables.
    pub(super) fn operands(&mut self, a: &Expr, b: &Expr) -> Emitted<(Reg, Reg)> {
        let first = if self.sets_locals(b) { self.fresh(a)? } else { self.expr(a, None)? };
        let second = self.expr(b, None)?;
        Ok((first, second))
    }

    /// Whether a struct comes out of a variable, so that who keeps it must copy it.
    fn is_place(e: &Expr) -> bool {
        match &e.kind {
            Kind::Local(_) | Kind::This | Kind::Held(_) | Kind::Field(..) | Kind::Element(..) => true,
            Kind::Convert(_, inner) => {
                Self::is_place(inner) || matches!(e.kind, Kind::Convert(Conv::Cast | Conv::FromNullable, _))
            }
            Kind::Deref(_) => true,
            Kind::Choice(_, a, b) | Kind::Coalesce(a, b) => Self::is_place(a) || Self::is_place(b),
            Kind::Conditional(_, _, b) | Kind::Block(_, b) => Self::is_place(b),
            Kind::Deconstruct(_, _, steps) => steps.last().is_some_and(Self::is_place),
            Kind::Assign(..) | Kind::Update(..) | Kind::As(..) => true,
            _ => false,
        }
    }

    /// Evaluates to a value that may be kept: structs are copied out of variables.
    pub(super) fn copied(&mut self, e: &Expr, want: Option<Reg>) -> Emitted<Reg> {
        let ty = self.ty(e.ty);
        let inner = self.program.sema.nullable_of(ty).unwrap_or(ty);
        // What is put together of its parts is new.
        if self.program.sema.is_struct(inner) && Self::is_place(e) && self.parts_of(e).is_none() {
            let a = self.expr(e, None)?;
            let d = self.target(want)?;
            self.op(Op::Copy { d, a });
            return Ok(d);
        }
        self.expr(e, want)
    }

    fn into(&mut self, e: &Expr, d: Reg) -> Emitted<()> {
        self.pos = e.pos;
        match &e.kind {
            Kind::Const(value) => self.constant_into(d, value, e.ty),
            Kind::Default(ty) => {
                let ty = self.ty(*ty);
                self.default_into(d, ty);
                Ok(())
            }
            Kind::Field(receiver, field) => self.field_into(d, receiver.as_deref(), *field),
            Kind::Element(array, indices) => self.element_into(d, array, indices),
            Kind::Length(array) => {
                let a = self.expr(array, None)?;
                self.op(Op::Length { d, a });
                Ok(())
            }
            Kind::Prop(receiver, args, getter, setter, is_virtual) => {
                let Some(getter) = getter else {
                    let id = setter.as_ref().map(|s| s.id);
                    let name =
                        id.map(|id| self.program.sema.method(id).name[4..].to_owned()).unwrap_or_default();
                    return Err(Refused(
                        e.pos,
                        format!(
                            "The property or indexer '{name}' cannot be used in this context because it lacks the get accessor"
                        ),
                    ));
                };
                self.call_into(d, receiver.as_deref(), getter, args, *is_virtual, e)
            }
            Kind::Call(receiver, method, args, is_virtual) => {
                self.call_into(d, receiver.as_deref(), method, args, *is_virtual, e)
            }
            Kind::Invoke(delegate, args) => self.invoke_into(d, delegate, args),
            Kind::New(method, args) => self.new_into(d, method, args),
            Kind::NewArray(element, sizes) => {
                let element = self.ty(*element);
                let first = self.row(sizes)?;
                let rank = sizes.len() as u16;
                let ty = self.program.sema.array(element, rank as u8);
                self.layout_of(element);
                self.op(Op::NewArray { d, first, rank, ty });
                Ok(())
            }
            Kind::ArrayOf(element, values, lengths) => self.array_into(d, *element, values, lengths),
            Kind::Binary(op, prim, checked, a, b) => self.binary_into(d, (*op, *prim, *checked), a, b),
            Kind::Lifted(a, b, first, inner, missing) => self.lifted_into(d, a, b, *first, inner, missing),
            Kind::SameObject(same, a, b) => {
                let (a, b) = self.operands(a, b)?;
                self.op(Op::Same { d, a, b });
                self.negate_unless(*same, d);
                Ok(())
            }
            Kind::IsNull(is, inner) => {
                let a = self.expr(inner, None)?;
                self.op(Op::IsNull { d, a });
                self.negate_unless(*is, d);
                Ok(())
            }
            Kind::Negate(Prim::Decimal, _, inner) => {
                let a = self.expr(inner, None)?;
                self.op(Op::DecimalNeg { d, a });
                Ok(())
            }
            Kind::Negate(prim, checked, inner) => {
                let a = self.expr(inner, None)?;
                self.op(Op::Neg { prim: *prim, checked: *checked, d, a });
                Ok(())
            }
            Kind::Complement(prim, inner) => {
                let a = self.expr(inner, None)?;
                self.op(Op::Complement { prim: *prim, d, a });
                Ok(())
            }
            Kind::Not(inner) => {
                let a = self.expr(inner, None)?;
                self.op(Op::Not { d, a });
                Ok(())
            }
            Kind::And(..) | Kind::Or(..) => {
                let (no, end) = (self.mark(), self.mark());
                self.branch(e, no, false)?;
                self.truth(d, true);
                self.jump(end);
                self.set(no);
                self.truth(d, false);
                self.set(end);
                Ok(())
            }
            Kind::Convert(conv, inner) => self.convert_into(d, conv, inner, e.ty),
            Kind::Concat(parts) => {
                let first = self.row(parts)?;
                self.pos = e.pos;
                self.op(Op::Concat { d, first, n: parts.len() as u16 });
                Ok(())
            }
            Kind::Text(inner) => self.text_into(d, inner),
            Kind::Assign(place, value) => self.assign_into(d, place, value),
            Kind::Update(place, number, value, post) => self.update_into(d, place, *number, value, *post),
            Kind::Choice(c, a, b) => {
                let (no, end) = (self.mark(), self.mark());
                self.branch(c, no, false)?;
                self.expr(a, Some(d))?;
                self.jump(end);
                self.set(no);
                self.expr(b, Some(d))?;
                self.set(end);
                Ok(())
            }
            Kind::Coalesce(a, b) => {
                let (null, end) = (self.mark(), self.mark());
                self.expr(a, Some(d))?;
                self.op(Op::JumpNull { a: d, to: null.0 });
                self.jump(end);
                self.set(null);
                self.expr(b, Some(d))?;
                self.set(end);
                Ok(())
            }
            Kind::Conditional(receiver, number, chain) => {
                let a = self.alloc()?;
                self.expr(receiver, Some(a))?;
                let (null, end) = (self.mark(), self.mark());
                self.op(Op::JumpNull { a, to: null.0 });
                self.held.insert(*number, a);
                self.expr(chain, Some(d))?;
                self.jump(end);
                self.set(null);
                let k = self.constant(Value::Null);
                self.op(Op::Const { d, k });
                self.set(end);
                Ok(())
            }
            Kind::Initialise(object, number, steps) => {
                let a = self.alloc()?;
                self.expr(object, Some(a))?;
                self.held.insert(*number, a);
                for step in steps {
                    let kept = self.next;
                    self.expr(step, None)?;
                    self.next = kept;
                }
                self.op(Op::Move { d, a });
                Ok(())
            }
            Kind::Deconstruct(value, number, steps) => {
                let a = self.alloc()?;
                self.copied(value, Some(a))?;
                self.held.insert(*number, a);
                let Some((last, before)) = steps.split_last() else { return Ok(()) };
                for step in before {
                    let kept = self.next;
                    self.expr(step, None)?;
                    self.next = kept;
                }
                self.expr(last, Some(d))?;
                Ok(())
            }
            Kind::Is(inner, ty) => {
                let a = self.expr(inner, None)?;
                let ty = self.ty(*ty);
                self.op(Op::Is { d, a, ty });
                Ok(())
            }
            Kind::As(inner, ty) => {
                let a = self.expr(inner, None)?;
                let ty = self.ty(*ty);
                self.op(Op::As { d, a, ty });
                Ok(())
            }
            Kind::Lambda(lambda) => self.lambda_into(d, lambda, e.ty),
            Kind::TypeOf(ty) => {
                let ty = self.ty(*ty);
                self.op(Op::TypeOf { d, ty });
                Ok(())
            }
            Kind::Ref(place) => self.reference(d, place),
            Kind::Deref(inner) => {
                let a = self.expr(inner, None)?;
                self.pos = e.pos;
                self.op(Op::LoadRef { d, a });
                Ok(())
            }
            Kind::Bind(local, place) => {
                let Some(reg) = self.regs.get(local).copied() else {
                    return Err(Refused(e.pos, "A variable is used outside its block".to_owned()));
                };
                self.reference(reg, place)
            }
            Kind::Throw(inner) => {
                let a = self.expr(inner, None)?;
                self.op(Op::Throw { a });
                Ok(())
            }
            Kind::Tuple(values) => {
                let ty = self.ty(e.ty);
                let first = self.row(values)?;
                self.layout_of(ty);
                self.op(Op::New { d, ty });
                for i in 0..values.len() {
                    self.op(Op::StoreField { o: d, i: i as Reg, v: first + i as Reg });
                }
                Ok(())
            }
            Kind::Block(stmts, value) => {
                for stmt in stmts {
                    self.stmt(stmt)?;
                }
                self.expr(value, Some(d))?;
                Ok(())
            }
            Kind::Dynamic(op, operands) => self.dynamic_into(d, op, operands, e.pos),
            Kind::Error => Err(Refused(e.pos, "There is an error in the source".to_owned())),
            Kind::Local(_) | Kind::This | Kind::Held(_) => {
                self.expr(e, Some(d))?;
                Ok(())
            }
        }
    }

    /// The register of a number in a loop.
    fn hoisted_constant(&mut self, value: &Const, ty: Ty) -> Option<Reg> {
        self.hoisted.as_ref()?;
        let ty = self.ty(ty);
        if self.program.sema.is_enum(ty) {
            return None;
        }
        let value = match (value, self.program.sema.prim(ty)?) {
            (Const::Int(n), prim @ (Prim::I32 | Prim::I64)) => number(*n, prim),
            (Const::Double(x), Prim::F64) => Value::F64(*x),
            (Const::Bool(x), Prim::Bool) => Value::Bool(*x),
            _ => return None,
        };
        self.hoisted(value)
    }

    fn truth(&mut self, d: Reg, value: bool) {
        let k = self.constant(Value::Bool(value));
        self.op(Op::Const { d, k });
    }

    fn negate_unless(&mut self, is: bool, d: Reg) {
        if !is {
            self.op(Op::Not { d, a: d });
        }
    }

    /// Values in registers in a row.
    pub(super) fn row(&mut self, values: &[Expr]) -> Emitted<Reg> {
        let first = self.allocs(values.len() as u32)?;
        for (i, value) in values.iter().enumerate() {
            self.copied(value, Some(first + i as Reg))?;
        }
        Ok(first)
    }

    /// Objects of a struct are made by its layout, which must be there.
    pub(super) fn layout_of(&mut self, ty: Ty) {
        self.program.layout(ty);
    }

    fn constant_into(&mut self, d: Reg, value: &Const, ty: Ty) -> Emitted<()> {
        let ty = self.ty(ty);
        if let Const::Str(text) = value {
            let k = self.text_constant(text);
            self.op(Op::Const { d, k });
            return Ok(());
        }
        if let Const::Decimal(x) = value {
            // Two constants in a row, never shared with others.
            let k = self.f.consts.len() as u32;
            self.f.consts.extend(crate::decimal::halves(*x).map(Value::U64));
            self.op(Op::DecimalConst { d, k });
            return Ok(());
        }
        let prim = self.program.sema.underlying(ty);
        let value = match (value, prim) {
            (Const::Int(n), Some(prim)) if self.program.sema.is_enum(ty) => {
                Value::Enum(ty, wrap(*n, prim) as i64)
            }
            (Const::Int(n), Some(prim)) => number(*n, prim),
            (Const::Null, Some(_)) => {
                self.default_into(d, ty);
                return Ok(());
            }
            (Const::Bool(b), _) => Value::Bool(*b),
            (Const::Double(x), _) => Value::F64(*x),
            (Const::Float(x), _) => Value::F32(*x),
            (Const::Int(n), None) => number(*n, Prim::I32),
            _ => Value::Null,
        };
        if let Value::I32(v) = value {
            self.op(Op::Int { d, v });
            return Ok(());
        }
        let k = self.constant(value);
        self.op(Op::Const { d, k });
        Ok(())
    }

    fn binary_into(
        &mut self,
        d: Reg,
        (op, prim, checked): (BinOp, Prim, bool),
        a: &Expr,
        b: &Expr,
    ) -> Emitted<()> {
        let pos = self.pos;
        if prim == Prim::Decimal {
            let (a, b) = self.operands(a, b)?;
            self.pos = pos;
            self.op(Op::Decimals { op, d, a, b });
            return Ok(());
        }
        if prim == Prim::I32
            && !checked
            && matches!(op, BinOp::Add | BinOp::Sub)
            && let Kind::Const(Const::Int(n)) = b.kind
        {
            let a = self.expr(a, None)?;
            let k = if op == BinOp::Add { n as i32 } else { (n as i32).wrapping_neg() };
            if let (Ok(d), Ok(a)) = (Low::try_from(d), Low::try_from(a)) {
                self.pos = pos;
                self.op(Op::AddIK { d, a, k });
                return Ok(());
            }
            let b = self.expr(b, None)?;
            self.pos = pos;
            self.op(Op::Arith { op, prim, checked, d, a, b });
            return Ok(());
        }
        let (a, b) = self.operands(a, b)?;
        self.pos = pos;
        self.op(Op::Arith { op, prim, checked, d, a, b });
        Ok(())
    }

    /// Both values must be there; `==` of two that are missing holds.
    fn lifted_into(
        &mut self,
        d: Reg,
        a: &Expr,
        b: &Expr,
        first: u32,
        inner: &Expr,
        missing: &Const,
    ) -> Emitted<()> {
        let x = self.fresh(a)?;
        let y = self.fresh(b)?;
        self.held.insert(first, x);
        self.held.insert(first + 1, y);
        let (none, end) = (self.mark(), self.mark());
        self.op(Op::JumpNull { a: x, to: none.0 });
        self.op(Op::JumpNull { a: y, to: none.0 });
        self.expr(inner, Some(d))?;
        self.jump(end);
        self.set(none);
        match (missing, equality_of(inner)) {
            (Const::Bool(unequal), true) => {
                // Equal when both are missing.
                self.op(Op::Same { d, a: x, b: y });
                if *unequal {
                    self.op(Op::Not { d, a: d });
                }
            }
            _ => {
                let ty = inner.ty;
                self.constant_into(d, missing, if matches!(missing, Const::Null) { Ty::NULL } else { ty })?;
            }
        }
        self.set(end);
        Ok(())
    }

    fn convert_into(&mut self, d: Reg, conv: &Conv, inner: &Expr, to: Ty) -> Emitted<()> {
        let pos = self.pos;
        let a = self.expr(inner, None)?;
        self.pos = pos;
        match conv {
            Conv::Same => self.op(Op::Move { d, a }),
            Conv::Number(from, to, checked) => {
                self.op(match (*from, *to) {
                    (Prim::Decimal, Prim::Decimal) => Op::Move { d, a },
                    (Prim::Decimal, to) => Op::DecimalTo { to, d, a },
                    (_, Prim::Decimal) => Op::DecimalOf { d, a },
                    (from, to) => Op::Convert { from, to, checked: *checked, d, a },
                });
            }
            Conv::ToEnum => {
                let ty = self.ty(to);
                self.op(Op::ToEnum { d, a, ty });
            }
            Conv::FromEnum(prim) => self.op(Op::FromEnum { d, a, prim: *prim }),
            Conv::Cast => {
                let ty = self.ty(to);
                self.op(Op::Cast { d, a, ty });
            }
            Conv::FromNullable => self.op(Op::FromNullable { d, a }),
        }
        Ok(())
    }

    fn array_into(&mut self, d: Reg, element: Ty, values: &[Expr], lengths: &[u32]) -> Emitted<()> {
        let element = self.ty(element);
        let rank = lengths.len().max(1) as u8;
        let ty = self.program.sema.array(element, rank);
        self.layout_of(element);
        if values.len() > 64 {
            // Long ones are set element by element.
            let first = self.alloc()?;
            let line = self.program.sema.array(element, 1);
            self.op(Op::Int { d: first, v: values.len() as i32 });
            self.op(Op::NewArray { d, first, rank: 1, ty: line });
            for (i, value) in values.iter().enumerate() {
                let kept = self.next;
                let index = self.alloc()?;
                self.op(Op::Int { d: index, v: i as i32 });
                let v = self.copied(value, None)?;
                self.op(Op::StoreElem { a: d, i: index, v });
                self.next = kept;
            }
            self.op(Op::SetType { a: d, ty });
        } else {
            let first = self.row(values)?;
            self.op(Op::ArrayOf { d, first, n: values.len() as u16, ty });
        }
        for (place, length) in lengths.iter().enumerate() {
            // The lengths go in one by one: a place in the high bits.
            let k = self.constant(Value::I64((place as i64) << 32 | i64::from(*length)));
            self.op(Op::SetDims { a: d, k });
        }
        Ok(())
    }
}

/// Whether what is lifted is `==` or `!=`.
fn equality_of(inner: &Expr) -> bool {
    match &inner.kind {
        Kind::Binary(BinOp::Eq | BinOp::Ne, ..) => true,
        Kind::Convert(_, inner) => equality_of(inner),
        Kind::Call(None, ..) => false,
        _ => false,
    }
}

/// A whole number as a value of a predefined type.
pub(crate) fn number(n: i128, prim: Prim) -> Value {
    match prim {
        Prim::Bool => Value::Bool(n != 0),
        Prim::Char => Value::Char(n as u16),
        Prim::I8 => Value::I8(n as i8),
        Prim::U8 => Value::U8(n as u8),
        Prim::I16 => Value::I16(n as i16),
        Prim::U16 => Value::U16(n as u16),
        Prim::I32 => Value::I32(n as i32),
        Prim::U32 => Value::U32(n as u32),
        Prim::I64 => Value::I64(n as i64),
        Prim::U64 => Value::U64(n as u64),
        Prim::F32 => Value::F32(n as f32),
        // Decimals are objects: no caller asks for one here.
        Prim::F64 | Prim::Decimal => Value::F64(n as f64),
    }
}
