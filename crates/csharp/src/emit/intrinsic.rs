//! Members of the library that have an operation of their own: elements of lists and texts, functions of one number.

use super::{Emitted, Emitter};
use crate::bound::{Arg, Expr, MethodRef};
use crate::sema::Body;
use crate::syntax::ast::Passing;
use crate::vm::op::{LOW, Low, Op, Reg};
use crate::vm::real::Real;

/// A member that has one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Member {
    Item,
    SetItem,
    Add,
    Count,
    TextLength,
    TextItem,
    Real(Real),
}

fn member(key: &str) -> Option<Member> {
    Some(match key {
        "List.get_Item(Int32)" => Member::Item,
        "List.set_Item(Int32)" => Member::SetItem,
        "List.Add(T)" => Member::Add,
        "List.get_Count()" => Member::Count,
        "String.get_Length()" => Member::TextLength,
        "String.get_Item(Int32)" => Member::TextItem,
        key => Member::Real(Real::named(key.strip_prefix("Math.")?.strip_suffix("(Double)")?)?),
    })
}

impl Emitter<'_> {
    fn member_of(&self, method: &MethodRef) -> Option<Member> {
        match &self.program.sema.method(method.id).body {
            Body::Extern(key) if !self.program.host_keys.contains_key(key) => member(key),
            _ => None,
        }
    }

    /// A call as one operation; false where the member has none.
    pub(super) fn intrinsic(
        &mut self,
        d: Reg,
        receiver: Option<&Expr>,
        method: &MethodRef,
        args: &[Arg],
        e: &Expr,
    ) -> Emitted<bool> {
        let Some(member) = self.member_of(method) else { return Ok(false) };
        if !self.has_low(d) || args.iter().any(|(passing, _)| *passing != Passing::Value) {
            return Ok(false);
        }
        match (member, receiver, args) {
            (Member::Count | Member::TextLength, Some(o), []) => {
                let o = self.expr(o, None)?;
                self.pos = e.pos;
                Ok(self.member_op(member, [d, o, 0]))
            }
            (Member::Item | Member::TextItem, Some(o), [(_, index)]) => {
                let (o, i) = self.operands(o, index)?;
                self.pos = e.pos;
                if !self.member_op(member, [d, o, i]) {
                    return Ok(false);
                }
                if member == Member::Item {
                    self.copy_item(d, method);
                }
                Ok(true)
            }
            (Member::Add, Some(o), [(_, value)]) => {
                let o = if self.sets_locals(value) { self.fresh(o)? } else { self.expr(o, None)? };
                let v = self.copied(value, None)?;
                self.pos = e.pos;
                Ok(self.member_op(member, [o, v, 0]))
            }
            (Member::Real(_), None, [(_, x)]) => {
                let a = self.expr(x, None)?;
                self.pos = e.pos;
                Ok(self.member_op(member, [d, a, 0]))
            }
            _ => Ok(false),
        }
    }

    /// A call whose operands are in registers as one operation; false where there is none.
    pub(super) fn intrinsic_registers(
        &mut self,
        d: Reg,
        receiver: Option<Reg>,
        method: &MethodRef,
        args: &[Reg],
    ) -> bool {
        match (self.member_of(method), receiver, args) {
            (Some(Member::Item), Some(o), [i]) => {
                let done = self.member_op(Member::Item, [d, o, *i]);
                if done {
                    self.copy_item(d, method);
                }
                done
            }
            (Some(Member::SetItem), Some(o), [i, v]) => self.member_op(Member::SetItem, [o, *i, *v]),
            _ => false,
        }
    }

    /// An element of a list for a look at it that does not keep it: a struct in its place.
    pub(super) fn item_in_place(&mut self, e: &Expr) -> Emitted<Option<Reg>> {
        use crate::bound::Kind;
        let Kind::Prop(Some(o), args, Some(getter), _, false) = &e.kind else { return Ok(None) };
        let getter = self.method_ref(getter);
        let [(Passing::Value, index)] = args.as_slice() else { return Ok(None) };
        if self.member_of(&getter) != Some(Member::Item) {
            return Ok(None);
        }
        let d = self.alloc()?;
        let (o, i) = self.operands(o, index)?;
        self.pos = e.pos;
        Ok(self.member_op(Member::Item, [d, o, i]).then_some(d))
    }

    fn copy_item(&mut self, d: Reg, method: &MethodRef) {
        let element = self.program.sema.args_of(method.owner).first().copied();
        if let Some(element) = element.filter(|ty| self.program.sema.is_struct(*ty)) {
            self.program.layout(element);
            self.op(Op::Copy { d, a: d });
        }
    }

    /// Whether the registers that are taken next are low.
    pub(super) fn has_low(&self, d: Reg) -> bool {
        self.next + 8 < LOW as u32 && usize::from(d) < LOW
    }

    fn member_op(&mut self, member: Member, regs: [Reg; 3]) -> bool {
        let [Ok(a), Ok(b), Ok(c)] = regs.map(Low::try_from) else { return false };
        self.op(match member {
            Member::Item => Op::Item { d: a, l: b, i: c },
            Member::SetItem => Op::SetItem { l: a, i: b, v: c },
            Member::Add => Op::AddItem { l: a, v: b },
            Member::Count => Op::Count { d: a, l: b },
            Member::TextLength => Op::TextLength { d: a, t: b },
            Member::TextItem => Op::TextItem { d: a, t: b, i: c },
            Member::Real(f) => Op::Real { f, d: a, a: b },
        });
        true
    }
}
