//! Variables, fields and elements: reading, setting, references.

use super::inline::Parts;
use super::{Emitted, Emitter, Refused};
use crate::bound::{Arg, Expr, FieldRef, Kind, MethodRef};
use crate::sema::Ty;
use crate::syntax::ast::Passing;
use crate::vm::op::{Op, Reg};

/// A place with everything evaluated that says where it is.
enum Place {
    Register(Reg),
    /// A struct whose fields stand in registers.
    Parts(Parts),
    Reference(Reg),
    Field(Reg, Reg),
    Static(u32),
    Element(Reg, Reg),
    Elements(Reg, Reg),
    Property(Option<Reg>, Vec<Reg>, Option<MethodRef>, Option<MethodRef>, bool, Ty),
    This(Reg),
}

impl Emitter<'_> {
    /// A static field, after its type's first values are set.
    fn static_field(&mut self, field: FieldRef) -> u32 {
        let owner = self.ty(field.owner);
        if let Some(i) = self.program.static_init(owner) {
            self.op(Op::Init { i });
        }
        self.program.static_base(owner) + self.program.sema.field(field.id).index
    }

    pub(super) fn field_into(&mut self, d: Reg, receiver: Option<&Expr>, field: FieldRef) -> Emitted<()> {
        match receiver {
            None => {
                let s = self.static_field(field);
                self.op(Op::LoadStatic { d, s });
                self.struct_there(d, field, s);
                Ok(())
            }
            Some(receiver) => {
                let pos = self.pos;
                let o = self.in_place(receiver)?;
                self.pos = pos;
                let owner = self.ty(field.owner);
                let i = self.program.field_index(owner, field.id);
                self.op(Op::LoadField { d, o, i });
                Ok(())
            }
        }
    }

    /// A static field of a struct is made when it is first looked at.
    fn struct_there(&mut self, d: Reg, field: FieldRef, s: u32) {
        let owner = self.ty(field.owner);
        let ty = self.program.field_type(owner, field.id);
        if !self.program.sema.is_struct(ty) {
            return;
        }
        let (make, there) = (self.mark(), self.mark());
        self.op(Op::JumpNull { a: d, to: make.0 });
        self.jump(there);
        self.set(make);
        self.default_into(d, ty);
        self.op(Op::StoreStatic { s, v: d });
        self.set(there);
    }

    pub(super) fn element_into(&mut self, d: Reg, array: &Expr, indices: &[Expr]) -> Emitted<()> {
        let pos = self.pos;
        if let [index] = indices {
            let (a, i) = self.operands(array, index)?;
            self.pos = pos;
            self.op(Op::LoadElem { d, a, i });
        } else {
            let a = self.fresh(array)?;
            let first = self.row(indices)?;
            self.pos = pos;
            self.op(Op::LoadElems { d, a, first });
        }
        Ok(())
    }

    /// A part of a place: as it is in a variable where nothing that is evaluated after it sets variables.
    fn part(&mut self, e: &Expr, later: &[&Expr]) -> Emitted<Reg> {
        if later.iter().any(|e| self.sets_locals(e)) { self.fresh(e) } else { self.expr(e, None) }
    }

    /// Evaluates what says where a place is, before the value that goes there.
    fn place(&mut self, e: &Expr, value: Option<&Expr>) -> Emitted<Place> {
        self.pos = e.pos;
        if let Some(parts) = self.parts_of(e) {
            return Ok(Place::Parts(parts));
        }
        if let Some(part) = self.part_there(e) {
            return Ok(Place::Register(part));
        }
        Ok(match &e.kind {
            Kind::Local(id) => {
                if let Some((env, index)) = self.captured(*id)? {
                    return Ok(Place::Field(env, index));
                }
                let Some(reg) = self.regs.get(id).copied() else {
                    return Err(Refused(e.pos, "A variable is used outside its block".to_owned()));
                };
                if self.is_reference_param(*id) { Place::Reference(reg) } else { Place::Register(reg) }
            }
            Kind::Held(number) => match self.held.get(number) {
                Some(reg) => Place::Register(*reg),
                None => {
                    return Err(Refused(
                        e.pos,
                        "This use of a value inside a lambda is not supported".to_owned(),
                    ));
                }
            },
            Kind::This => Place::This(self.this()?),
            Kind::Deref(inner) => Place::Reference(self.fresh(inner)?),
            Kind::Field(None, field) => Place::Static(self.static_field(*field)),
            Kind::Field(Some(receiver), field) => {
                let o = self.steady(receiver)?;
                let owner = self.ty(field.owner);
                let i = self.program.field_index(owner, field.id);
                Place::Field(o, i)
            }
            Kind::Element(array, indices) => match (&**indices, value) {
                ([index], Some(value)) => {
                    let a = self.part(array, &[index, value])?;
                    let i = self.part(index, &[value])?;
                    Place::Element(a, i)
                }
                ([index], None) => {
                    let (a, i) = (self.fresh(array)?, self.fresh(index)?);
                    Place::Element(a, i)
                }
                _ => {
                    let a = self.fresh(array)?;
                    let first = self.row(indices)?;
                    Place::Elements(a, first)
                }
            },
            Kind::Prop(receiver, args, getter, setter, is_virtual) => {
                let receiver_ty = receiver.as_ref().map_or(Ty::ERROR, |r| r.ty);
                // One index that is no struct may stay in its variable, as the object that has it.
                let plain = match (args.as_slice(), value, receiver) {
                    ([(Passing::Value, index)], Some(value), Some(object)) => {
                        let (index_ty, object_ty) = (self.ty(index.ty), self.ty(object.ty));
                        let plain =
                            !self.program.sema.is_struct(index_ty) && !self.program.sema.is_struct(object_ty);
                        plain.then_some((object, index, value))
                    }
                    _ => None,
                };
                if let Some((object, index, value)) = plain {
                    let o = self.part(object, &[index, value])?;
                    let regs = vec![self.part(index, &[value])?];
                    let (getter, setter) = (getter.clone(), setter.clone());
                    return Ok(Place::Property(Some(o), regs, getter, setter, *is_virtual, receiver_ty));
                }
                let receiver = match receiver {
                    Some(receiver) => Some(self.steady(receiver)?),
                    None => None,
                };
                let mut regs = Vec::new();
                for (_, arg) in args as &Vec<Arg> {
                    let reg = self.alloc()?;
                    self.copied(arg, Some(reg))?;
                    regs.push(reg);
                }
                Place::Property(receiver, regs, getter.clone(), setter.clone(), *is_virtual, receiver_ty)
            }
            Kind::Convert(_, inner) => return self.place(inner, value),
            _ => {
                return Err(Refused(
                    e.pos,
                    "The left-hand side of an assignment must be a variable, property or indexer".to_owned(),
                ));
            }
        })
    }

    /// A receiver in a register that stays as it is: a struct in its place, an object by reference.
    fn steady(&mut self, receiver: &Expr) -> Emitted<Reg> {
        match receiver.kind {
            Kind::This | Kind::Local(_) if self.program.sema.is_struct(receiver.ty) => {
                self.expr(receiver, None)
            }
            _ => self.fresh(receiver),
        }
    }

    fn load(&mut self, place: &Place, d: Reg) -> Emitted<()> {
        match place {
            Place::Register(a) | Place::This(a) => self.op(Op::Move { d, a: *a }),
            Place::Parts(parts) => self.build(d, *parts),
            Place::Reference(a) => self.op(Op::LoadRef { d, a: *a }),
            Place::Field(o, i) => self.op(Op::LoadField { d, o: *o, i: *i }),
            Place::Static(s) => self.op(Op::LoadStatic { d, s: *s }),
            Place::Element(a, i) => self.op(Op::LoadElem { d, a: *a, i: *i }),
            Place::Elements(a, first) => self.op(Op::LoadElems { d, a: *a, first: *first }),
            Place::Property(receiver, args, getter, _, is_virtual, ty) => {
                let Some(getter) = getter.clone() else {
                    return Err(Refused(
                        self.pos,
                        "The property or indexer lacks the get accessor".to_owned(),
                    ));
                };
                self.call_registers(d, *receiver, *ty, &getter, args, *is_virtual)?;
            }
        }
        Ok(())
    }

    /// Sets a place to a value of a type. The object of a struct in a field or an element stays: others may be at it.
    fn store(&mut self, place: &Place, v: Reg, ty: Ty) -> Emitted<()> {
        let ty = self.ty(ty);
        if self.program.sema.is_struct(ty) {
            let put = match *place {
                Place::Field(o, i) => Some(Op::PutField { o, i, v }),
                Place::Static(s) => Some(Op::PutStatic { s, v }),
                Place::Element(a, i) => Some(Op::PutElem { a, i, v }),
                Place::Elements(a, first) => Some(Op::PutElems { a, first, v }),
                Place::Reference(a) => Some(Op::PutRef { a, v }),
                _ => None,
            };
            if let Some(put) = put {
                self.op(put);
                return Ok(());
            }
        }
        match place {
            Place::Register(d) => self.op(Op::Move { d: *d, a: v }),
            Place::Parts(parts) => self.take_apart(*parts, v),
            Place::This(d) => self.op(Op::StoreRef { a: *d, v }),
            Place::Reference(a) => self.op(Op::StoreRef { a: *a, v }),
            Place::Field(o, i) => self.op(Op::StoreField { o: *o, i: *i, v }),
            Place::Static(s) => self.op(Op::StoreStatic { s: *s, v }),
            Place::Element(a, i) => self.op(Op::StoreElem { a: *a, i: *i, v }),
            Place::Elements(a, first) => self.op(Op::StoreElems { a: *a, first: *first, v }),
            Place::Property(receiver, args, getter, setter, is_virtual, ty) => {
                let mut args = args.clone();
                args.push(v);
                let ignored = self.alloc()?;
                match (setter.clone(), getter.clone()) {
                    (Some(setter), _) => {
                        self.call_registers(ignored, *receiver, *ty, &setter, &args, *is_virtual)?
                    }
                    (None, Some(getter)) => self.store_automatic(*receiver, &getter, v),
                    (None, None) => {}
                }
            }
        }
        Ok(())
    }

    /// A constructor sets the field of a property that has no setter.
    fn store_automatic(&mut self, receiver: Option<Reg>, getter: &MethodRef, v: Reg) {
        let crate::sema::Body::Auto(field, _) = self.program.sema.method(getter.id).body else { return };
        let owner = self.ty(getter.owner);
        match receiver {
            Some(o) => {
                let i = self.program.field_index(owner, field);
                self.op(Op::StoreField { o, i, v });
            }
            None => {
                let s = self.program.static_base(owner) + self.program.sema.field(field).index;
                self.op(Op::StoreStatic { s, v });
            }
        }
    }

    pub(super) fn assign_into(&mut self, d: Reg, place: &Expr, value: &Expr) -> Emitted<()> {
        let pos = self.pos;
        if let Some(parts) = self.parts_of(place) {
            self.assign_parts(parts, place, value)?;
            self.build(d, parts);
            return Ok(());
        }
        if let Kind::Local(id) = place.kind
            && !self.is_reference_param(id)
            && self.captured(id)?.is_none()
            && let Some(reg) = self.regs.get(&id).copied()
        {
            // Straight into the variable.
            if self.stays(id) {
                let a = self.copied(value, None)?;
                self.op(Op::StoreRef { a: reg, v: a });
            } else if self.sets_locals(value) || mentions(value, id) {
                let v = self.copied(value, None)?;
                self.op(Op::Move { d: reg, a: v });
            } else {
                self.copied(value, Some(reg))?;
            }
            if d != reg {
                self.op(Op::Move { d, a: reg });
            }
            return Ok(());
        }
        let v = self.alloc()?;
        let place = if self.is_of_variable(place) && self.sets_locals(value) {
            self.copied(value, Some(v))?;
            self.place(place, None)?
        } else {
            let place = self.place(place, Some(value))?;
            self.copied(value, Some(v))?;
            place
        };
        self.pos = pos;
        self.store(&place, v, value.ty)?;
        self.op(Op::Move { d, a: v });
        Ok(())
    }

    /// An assignment whose value nobody needs.
    fn assign_only(&mut self, place: &Expr, value: &Expr) -> Emitted<()> {
        let pos = self.pos;
        if self.is_of_variable(place) && self.sets_locals(value) {
            let v = self.fresh_copy(value)?;
            let place = self.place(place, None)?;
            self.pos = pos;
            return self.store(&place, v, value.ty);
        }
        let place = self.place(place, Some(value))?;
        let v = self.copied(value, None)?;
        self.pos = pos;
        self.store(&place, v, value.ty)
    }

    /// Whether a variable is a struct whose object stays when it is set: there are references to it or to its parts.
    pub(super) fn stays(&mut self, id: crate::bound::LocalId) -> bool {
        let body = self.body.clone();
        let Some(local) = body.locals.get(id.0 as usize).filter(|_| body.uses().stays.contains(&id)) else {
            return false;
        };
        let ty = self.ty(local.ty);
        self.program.sema.is_struct(ty)
            && !self.program.is_native_type(ty)
            && local.passing == Passing::Value
            && !local.is_reference
    }

    /// Whether a place is a field of a struct in a variable: it is the variable as the value leaves it.
    fn is_of_variable(&mut self, place: &Expr) -> bool {
        matches!(&place.kind, Kind::Field(Some(of), _) if self.is_struct_variable(of))
    }

    /// A value in a register that nothing else uses.
    fn fresh_copy(&mut self, value: &Expr) -> Emitted<Reg> {
        let d = self.alloc()?;
        self.copied(value, Some(d))
    }

    pub(super) fn update_into(
        &mut self,
        d: Reg,
        place: &Expr,
        number: u32,
        value: &Expr,
        post: bool,
    ) -> Emitted<()> {
        let pos = self.pos;
        if let Some(parts) = self.parts_of(place) {
            if post {
                self.build(d, parts);
            }
            self.update_parts(parts, number, value)?;
            if !post {
                self.build(d, parts);
            }
            return Ok(());
        }
        let written = place;
        let place = self.place(place, Some(value))?;
        if let (Place::Register(reg), false) = (&place, post) {
            // `i += 1` in the variable's own register.
            self.held.insert(number, *reg);
            let v = self.copied(value, None)?;
            self.pos = pos;
            if matches!(written.kind, Kind::Local(id) if self.stays(id)) {
                self.op(Op::StoreRef { a: *reg, v });
            } else if v != *reg {
                self.op(Op::Move { d: *reg, a: v });
            }
            if d != *reg {
                self.op(Op::Move { d, a: *reg });
            }
            return Ok(());
        }
        let old = self.alloc()?;
        self.load(&place, old)?;
        let ty = self.ty(value.ty);
        if post && self.program.sema.is_struct(ty) {
            // The struct that is there takes the new value, and the old one is the result.
            self.op(Op::Copy { d: old, a: old });
        }
        self.held.insert(number, old);
        let v = self.copied(value, None)?;
        let place = if self.is_of_variable(written) && self.sets_locals(value) {
            self.place(written, None)?
        } else {
            place
        };
        self.pos = pos;
        self.store(&place, v, ty)?;
        self.op(Op::Move { d, a: if post { old } else { v } });
        Ok(())
    }

    /// A statement's `i++`: nobody needs the value.
    pub(super) fn effect(&mut self, e: &Expr) -> Emitted<()> {
        let kept = self.next;
        match &e.kind {
            Kind::Update(place, number, value, _) => {
                self.pos = e.pos;
                if let Some(parts) = self.parts_of(place) {
                    self.update_parts(parts, *number, value)?;
                    self.next = kept;
                    return Ok(());
                }
                if let Some(reg) = self.register_of(place)?
                    && matches!(value.kind, Kind::Binary(..))
                {
                    self.held.insert(*number, reg);
                    if self.sets_locals(value) {
                        let v = self.expr(value, None)?;
                        self.op(Op::Move { d: reg, a: v });
                    } else {
                        self.expr(value, Some(reg))?;
                    }
                    self.next = kept;
                    return Ok(());
                }
                let d = self.alloc()?;
                self.update_into(d, place, *number, value, false)?;
            }
            Kind::Assign(place, value) => {
                self.pos = e.pos;
                if let Some(parts) = self.parts_of(place) {
                    self.assign_parts(parts, place, value)?;
                } else if let Kind::Local(id) = place.kind
                    && !self.is_reference_param(id)
                    && self.captured(id)?.is_none()
                    && let Some(reg) = self.regs.get(&id).copied()
                {
                    self.assign_into(reg, place, value)?;
                } else {
                    self.assign_only(place, value)?;
                }
            }
            _ => {
                self.expr(e, None)?;
            }
        }
        self.next = kept;
        Ok(())
    }

    /// The register of a variable, or of a field of one that is in its parts.
    fn register_of(&mut self, place: &Expr) -> Emitted<Option<Reg>> {
        if let Some(part) = self.part_there(place) {
            return Ok(Some(part));
        }
        match place.kind {
            Kind::Local(id) if !self.is_reference_param(id) && self.captured(id)?.is_none() => {
                Ok(self.regs.get(&id).copied())
            }
            _ => Ok(None),
        }
    }

    /// A reference to a variable, for `ref` and `out`.
    pub(super) fn reference(&mut self, d: Reg, e: &Expr) -> Emitted<()> {
        if let Kind::Field(Some(inner), field) = &e.kind {
            let o = self.expr(inner, None)?;
            let owner = self.ty(field.owner);
            let i = self.program.field_index(owner, field.id);
            self.op(Op::RefField { d, o, i });
            return Ok(());
        }
        let place = self.place(e, None)?;
        match place {
            // Variables that references are handed over to stand in one place (`Uses::whole`).
            Place::Parts(_) => {
                return Err(Refused(e.pos, "A reference to this variable is not supported".to_owned()));
            }
            // A struct that stays is its own reference.
            Place::Register(a) if matches!(e.kind, Kind::Local(id) if self.stays(id)) => {
                self.op(Op::Move { d, a });
            }
            Place::Register(a) => self.op(Op::RefLocal { d, a }),
            Place::Reference(a) | Place::This(a) => self.op(Op::Move { d, a }),
            Place::Field(o, i) => self.op(Op::RefField { d, o, i }),
            Place::Static(s) => {
                if let Kind::Field(None, field) = e.kind {
                    self.op(Op::LoadStatic { d, s });
                    self.struct_there(d, field, s);
                }
                self.op(Op::RefStatic { d, s });
            }
            Place::Element(a, i) => self.op(Op::RefElem { d, a, i }),
            Place::Elements(a, first) => self.op(Op::RefElems { d, a, first }),
            Place::Property(..) => {
                return Err(Refused(
                    e.pos,
                    "A property or indexer may not be passed as an out or ref parameter".to_owned(),
                ));
            }
        }
        Ok(())
    }
}

/// Whether a value looks at a variable more than as its own first operand.
fn mentions(e: &Expr, id: crate::bound::LocalId) -> bool {
    match &e.kind {
        Kind::Local(other) => *other == id,
        Kind::Const(_) | Kind::Default(_) | Kind::This | Kind::Held(_) => false,
        // Operands are read before the result is written.
        Kind::Binary(_, _, _, a, b) => {
            let leaf = |e: &Expr| matches!(e.kind, Kind::Local(_) | Kind::Const(_));
            !(leaf(a) && leaf(b)) && (mentions(a, id) || mentions(b, id))
        }
        _ => true,
    }
}
