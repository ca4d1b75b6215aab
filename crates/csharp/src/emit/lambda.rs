//! Lambdas: functions of their own, and objects that hold what they share with the function around.

use std::sync::Arc;

use super::{Emitted, Emitter};
use crate::bound::{Lambda, Origin};
use crate::sema::Ty;
use crate::vm::op::{Op, Reg};

impl Emitter<'_> {
    pub(super) fn lambda_into(&mut self, d: Reg, lambda: &Arc<Lambda>, ty: Ty) -> Emitted<()> {
        let env = self.innermost_env()?;
        let number = self.program.funcs.len() as u32;
        self.program.funcs.push(crate::vm::op::Function::default());
        self.program.sources.push(None);
        let envs = self.envs.iter().map(|env| super::Env { reg: None, ..env.clone() }).collect();
        let def = self.def;
        let mut inner = Emitter::new(self.program, self.body.clone(), self.by.clone());
        inner.def = def;
        inner.envs = envs;
        inner.in_lambda = true;
        inner.f.name = format!("lambda in {}", self.f.name);
        inner.next = 1;
        inner.f.regs = 1;
        for param in &lambda.params {
            let reg = inner.alloc()?;
            inner.regs.insert(*param, reg);
            inner.fixed.push(*param);
        }
        inner.f.params = inner.next;
        if let Some(element) = lambda.iterator {
            inner.f.generator = Some(inner.iterator_of(element));
        }
        inner.f.origin = match &lambda.origin {
            Origin::Method(method, receiver) => Origin::Method(inner.method_ref(method), *receiver),
            other => other.clone(),
        };
        inner.labels_of(&lambda.body, 0);
        inner.stmt(&lambda.body)?;
        inner.op(Op::ReturnVoid);
        let (function, texts) = inner.close()?;
        // Texts of constants are put into the heap by the function around: they are kept as its own.
        let mut shared = Vec::new();
        for (text, place) in texts {
            shared.push((place, text));
        }
        self.program.pending_texts.push((number, shared));
        self.program.link(number, function);
        let ty = self.ty(ty);
        self.op(Op::Lambda { d, f: number, env });
        self.op(Op::SetType { a: d, ty });
        Ok(())
    }
}
