//! Operations on `dynamic` values: each kind of operands has a function of its own, made when they first come.

use std::sync::Arc;

use super::state::{Raise, State};
use super::value::Value;
use crate::bind;
use crate::bound::DynamicOp;
use crate::program::{Key, Program};
use crate::sema::Ty;

/// The function that does an operation on the operands in these registers.
pub(super) fn target(program: &mut Program, st: &State, site: u32, at: usize) -> Result<u32, Raise> {
    let Some(found) = program.dynamics.get(site as usize) else { return Ok(0) };
    let count = found.operands;
    let mut types = Vec::with_capacity(count);
    for i in 0..count {
        let value = st.stack.get(at + i).copied().unwrap_or(Value::Null);
        types.push(st.type_of(value, &program.sema));
    }
    if let Some((_, function)) = found.cache.iter().find(|(known, _)| *known == types) {
        return Ok(*function);
    }
    let of_object = !matches!(found.op, DynamicOp::Binary(_) | DynamicOp::Unary(_) | DynamicOp::Convert(_));
    if of_object && types.first() == Some(&Ty::NULL) {
        return Err(refused("Cannot perform runtime binding on a null reference".to_owned()));
    }
    let key = Key::Dynamic(site, types.clone());
    let known = program.keys.get(&key).copied();
    let function = match known {
        Some(function) => function,
        None => {
            let (def, op, pos) = (found.def, found.op.clone(), found.pos);
            let body = bind::bind_dynamic(&mut program.sema, def, &op, &types, pos).map_err(refused)?;
            let function = program.function(key);
            program.dynamic_bodies.insert(function, Arc::new(body));
            function
        }
    };
    if let Some(found) = program.dynamics.get_mut(site as usize) {
        found.cache.insert(0, (types, function));
        found.cache.truncate(MAX_CACHED);
    }
    Ok(function)
}

/// Kinds of operands that a site finds at once.
const MAX_CACHED: usize = 4;

fn refused(message: String) -> Raise {
    Raise::new("RuntimeBinderException", message)
}
