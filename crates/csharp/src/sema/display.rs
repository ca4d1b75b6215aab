//! Names of types in messages and at run time.

use super::{Kind, MethodId, Prim, Sema, Ty};
use crate::syntax::ast::Passing;

impl Sema {
    /// The name as csc writes it in messages.
    pub fn show(&self, ty: Ty) -> String {
        match self.types.kind(ty) {
            Kind::Special(s) => match u32::from(*s) {
                1 => "void",
                2 => "<null>",
                3 => "dynamic",
                _ => "?",
            }
            .to_owned(),
            Kind::Param(param) => self.param(*param).name.to_string(),
            Kind::Array(element, rank) => {
                format!("{}[{}]", self.show(*element), ",".repeat(usize::from(*rank) - 1))
            }
            Kind::Tuple(inner, names) => {
                let parts: Vec<_> = self
                    .args_of(*inner)
                    .iter()
                    .zip(names.iter())
                    .map(|(ty, name)| match name {
                        Some(name) => format!("{} {name}", self.show(*ty)),
                        None => self.show(*ty),
                    })
                    .collect();
                format!("({})", parts.join(", "))
            }
            Kind::Named(def, args) => {
                let info = self.def(*def);
                if let Some(keyword) = keyword(info.prim, &info.namespace, &info.name) {
                    return keyword.to_owned();
                }
                if *def == self.known.nullable && args.len() == 1 {
                    return format!("{}?", self.show(args[0]));
                }
                let mut name = String::new();
                if let Some(outer) = info.outer {
                    name.push_str(&self.def(outer).name);
                    name.push('.');
                } else if !info.namespace.is_empty() {
                    name.push_str(&info.namespace);
                    name.push('.');
                }
                name.push_str(&info.name);
                if !args.is_empty() {
                    let args: Vec<_> = args.iter().map(|arg| self.show(*arg)).collect();
                    name.push_str(&format!("<{}>", args.join(", ")));
                }
                name
            }
        }
    }

    /// The name that `GetType().ToString()` gives.
    pub fn full_name(&self, ty: Ty) -> String {
        match self.types.kind(ty) {
            Kind::Array(element, rank) => {
                format!("{}[{}]", self.full_name(*element), ",".repeat(usize::from(*rank) - 1))
            }
            Kind::Named(def, args) => {
                let info = self.def(*def);
                let mut name = String::new();
                let mut outer = info.outer;
                let mut around = Vec::new();
                while let Some(def) = outer {
                    around.push(self.def(def).name.to_string());
                    outer = self.def(def).outer;
                }
                if !info.namespace.is_empty() {
                    name = format!("{}.", info.namespace);
                }
                for part in around.iter().rev() {
                    name.push_str(part);
                    name.push('+');
                }
                name.push_str(&info.name);
                if !args.is_empty() {
                    let list: Vec<_> = args.iter().map(|arg| self.full_name(*arg)).collect();
                    name.push_str(&format!("`{}[{}]", args.len(), list.join(",")));
                }
                name
            }
            Kind::Tuple(inner, _) => self.full_name(*inner),
            _ => self.show(ty),
        }
    }

    /// A method with the types of its parameters, as csc writes it.
    pub fn show_method(&self, id: MethodId) -> String {
        let method = self.method(id);
        let owner = &self.def(method.owner).name;
        let name = if &*method.name == ".ctor" { owner.to_string() } else { method.name.to_string() };
        let params: Vec<_> = method
            .params
            .iter()
            .map(|p| {
                let word = match p.passing {
                    Passing::Value => "",
                    Passing::Ref => "ref ",
                    Passing::Out => "out ",
                    Passing::In => "in ",
                };
                format!("{word}{}", self.show(p.ty))
            })
            .collect();
        format!("{owner}.{name}({})", params.join(", "))
    }
}

fn keyword(prim: Option<Prim>, namespace: &str, name: &str) -> Option<&'static str> {
    if namespace != "System" {
        return None;
    }
    Some(match (prim, name) {
        (Some(Prim::Bool), _) => "bool",
        (Some(Prim::Char), _) => "char",
        (Some(Prim::I8), _) => "sbyte",
        (Some(Prim::U8), _) => "byte",
        (Some(Prim::I16), _) => "short",
        (Some(Prim::U16), _) => "ushort",
        (Some(Prim::I32), _) => "int",
        (Some(Prim::U32), _) => "uint",
        (Some(Prim::I64), _) => "long",
        (Some(Prim::U64), _) => "ulong",
        (Some(Prim::F32), _) => "float",
        (Some(Prim::F64), _) => "double",
        (Some(Prim::Decimal), _) => "decimal",
        (None, "Object") => "object",
        (None, "String") => "string",
        _ => return None,
    })
}
