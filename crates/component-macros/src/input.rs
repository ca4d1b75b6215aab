//! One argument of a component's function, and the port it stands for.

use proc_macro2::TokenStream;
use quote::quote;
use syn::parse::{Parse, ParseStream};
use syn::{
    Error, Expr, FnArg, GenericArgument, Ident, LitStr, PathArguments, Result, Token, Type, TypePath,
    spanned::Spanned,
};

use crate::parse::{help, take_attributes};

/// How an argument takes its data.
enum Shape {
    /// `&Context`: no port.
    Context,
    /// `T`.
    Item(Type),
    /// `&T`: an item that is shared, lent for the call.
    Lent(Type),
    /// `Option<T>`.
    Maybe(Type),
    /// `List<T>`.
    List(Type),
    /// `&Tree`.
    Tree,
    /// `ManyItems<T>`.
    ManyItems(Type),
    /// `ManyLists<T>`.
    ManyLists(Type),
    /// `ManyTrees`.
    ManyTrees,
}

/// What stands in `#[port(…)]`.
#[derive(Default)]
struct PortAttribute {
    name: String,
    nick: String,
    default: Option<Expr>,
    optional: bool,
    kind: Option<Ident>,
}

impl Parse for PortAttribute {
    fn parse(input: ParseStream<'_>) -> Result<Self> {
        let name: LitStr = input.parse()?;
        input.parse::<Token![,]>()?;
        let nick: LitStr = input.parse()?;
        let mut port = Self { name: name.value(), nick: nick.value(), ..Self::default() };
        while !input.is_empty() {
            input.parse::<Token![,]>()?;
            if input.is_empty() {
                break;
            }
            let key: Ident = input.parse()?;
            match key.to_string().as_str() {
                "optional" => port.optional = true,
                "default" => {
                    input.parse::<Token![=]>()?;
                    port.default = Some(input.parse()?);
                }
                "kind" => {
                    input.parse::<Token![=]>()?;
                    port.kind = Some(input.parse()?);
                }
                _ => return Err(Error::new(key.span(), "expected default, optional or kind")),
            }
        }
        Ok(port)
    }
}

pub(crate) struct Input {
    shape: Shape,
    help: String,
    port: PortAttribute,
}

impl Input {
    pub(crate) fn new(argument: &mut FnArg) -> Result<Self> {
        let FnArg::Typed(argument) = argument else {
            return Err(Error::new(argument.span(), "a component is a free function"));
        };
        let shape = shape(&argument.ty)?;
        let help = help(&argument.attrs);
        let attributes = take_attributes(&mut argument.attrs, "port");
        take_attributes(&mut argument.attrs, "doc");
        let port = match (attributes.first(), &shape) {
            (Some(attribute), _) => attribute.parse_args()?,
            (None, Shape::Context) => PortAttribute::default(),
            (None, _) => return Err(Error::new(argument.span(), "expected #[port(\"Name\", \"N\")]")),
        };
        if help.is_empty() && !matches!(shape, Shape::Context) {
            return Err(Error::new(argument.span(), "a port needs a doc comment: it is its help"));
        }
        Ok(Self { shape, help, port })
    }

    pub(crate) fn is_context(&self) -> bool {
        matches!(self.shape, Shape::Context)
    }

    /// The access constant.
    pub(crate) fn access(&self) -> TokenStream {
        let name = match self.shape {
            Shape::List(_) | Shape::ManyLists(_) => quote!(List),
            Shape::Tree | Shape::ManyTrees => quote!(Tree),
            _ => quote!(Item),
        };
        quote!(::katydid_component::Access::#name)
    }

    fn kind(&self) -> TokenStream {
        let parts = quote!(::katydid_component::parts);
        if let Some(kind) = &self.port.kind {
            return quote!(#parts::Kind::#kind);
        }
        match &self.shape {
            Shape::Lent(t) => quote!(<::std::sync::Arc<#t> as #parts::Item>::KIND),
            Shape::Item(t) | Shape::Maybe(t) | Shape::List(t) | Shape::ManyItems(t) | Shape::ManyLists(t) => {
                quote!(<#t as #parts::Item>::KIND)
            }
            Shape::Tree | Shape::ManyTrees | Shape::Context => quote!(#parts::Kind::Generic),
        }
    }

    /// The static description of the port.
    pub(crate) fn port(&self) -> TokenStream {
        let PortAttribute { name, nick, default, optional, .. } = &self.port;
        let help = &self.help;
        let kind = self.kind();
        let access = self.access();
        let many = matches!(self.shape, Shape::ManyItems(_) | Shape::ManyLists(_) | Shape::ManyTrees);
        let optional = *optional || matches!(self.shape, Shape::Maybe(_));
        let default = match default {
            None => quote!(None),
            Some(Expr::Array(list)) => {
                let items = list.elems.iter();
                quote!(Some(|| ::katydid_component::parts::default_tree(
                    [#(::katydid_component::parts::Value::from(#items)),*]
                )))
            }
            Some(value) => quote!(Some(|| ::katydid_component::parts::default_tree(
                [::katydid_component::parts::Value::from(#value)]
            ))),
        };
        quote! {
            ::katydid_component::Port {
                name: #name,
                nick: #nick,
                help: #help,
                kind: #kind,
                access: #access,
                optional: #optional,
                many: #many,
                default: #default,
            }
        }
    }

    /// Fetches the argument's data in an iteration; a null where an item must be ends the iteration.
    pub(crate) fn binding(&self, variable: &Ident, k: usize) -> TokenStream {
        match &self.shape {
            Shape::Context => quote!(),
            // An optional port with a plain item type has a default, so that only a null is missing there.
            Shape::Item(t) => {
                quote!(let Some(#variable) = row.item::<#t>(#k) else { return Ok(None) };)
            }
            Shape::Lent(t) => {
                quote!(let Some(#variable) = row.item::<::std::sync::Arc<#t>>(#k) else { return Ok(None) };)
            }
            Shape::Maybe(t) => quote!(let #variable = row.item::<#t>(#k);),
            Shape::List(t) => quote!(let #variable = row.list::<#t>(#k);),
            Shape::Tree => quote!(let #variable = row.tree(#k);),
            Shape::ManyItems(t) => quote!(let #variable = row.many_items::<#t>(#k);),
            Shape::ManyLists(t) => quote!(let #variable = row.many_lists::<#t>(#k);),
            Shape::ManyTrees => quote!(let #variable = row.many_trees(#k);),
        }
    }

    /// The argument as it is handed on.
    pub(crate) fn argument(&self, variable: &Ident) -> TokenStream {
        match self.shape {
            Shape::Lent(_) => quote!(&*#variable),
            _ => quote!(#variable),
        }
    }
}

/// The type inside the angle brackets.
pub(crate) fn inner(path: &TypePath) -> Result<Type> {
    let last = path.path.segments.last();
    if let Some(PathArguments::AngleBracketed(arguments)) = last.map(|s| &s.arguments) {
        for argument in &arguments.args {
            if let GenericArgument::Type(t) = argument {
                return Ok(t.clone());
            }
        }
    }
    Err(Error::new(path.span(), "expected a type in angle brackets"))
}

fn shape(t: &Type) -> Result<Shape> {
    if let Type::Reference(reference) = t {
        let Type::Path(path) = reference.elem.as_ref() else {
            return Err(Error::new(t.span(), "expected &Context, &Tree or a shared item"));
        };
        return Ok(match last_name(path).as_str() {
            "Context" => Shape::Context,
            "Tree" => Shape::Tree,
            _ => Shape::Lent(reference.elem.as_ref().clone()),
        });
    }
    let Type::Path(path) = t else { return Ok(Shape::Item(t.clone())) };
    Ok(match last_name(path).as_str() {
        "Option" => Shape::Maybe(inner(path)?),
        "List" => Shape::List(inner(path)?),
        "ManyItems" => Shape::ManyItems(inner(path)?),
        "ManyLists" => Shape::ManyLists(inner(path)?),
        "ManyTrees" => Shape::ManyTrees,
        _ => Shape::Item(t.clone()),
    })
}

/// The last name of a type path: `List` of `katydid_component::List<f64>`.
pub(crate) fn last_name(path: &TypePath) -> String {
    path.path.segments.last().map(|s| s.ident.to_string()).unwrap_or_default()
}
