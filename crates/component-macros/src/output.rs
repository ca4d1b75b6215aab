//! The results of a component's function, and the ports they go to.

use proc_macro2::TokenStream;
use quote::{format_ident, quote};
use syn::parse::{Parse, ParseStream};
use syn::{Attribute, Error, Ident, LitStr, Result, ReturnType, Token, Type, spanned::Spanned};

use crate::input::{inner, last_name};

/// How a result gives its data.
enum Shape {
    /// `T`.
    Item(Type),
    /// `Option<T>`.
    Maybe(Type),
    /// `Vec<T>`.
    List(Type),
    /// `Vec<Option<T>>`.
    MaybeList(Type),
    /// `ItemOrList<T>`.
    ItemOrList(Type),
    /// `Column`: a list of values of any type, where speed matters.
    Column,
    /// `Tree`.
    Tree,
    /// `Each<Option<T>>`.
    EachItems(Type),
    /// `Each<Vec<Option<T>>>`.
    EachLists(Type),
    /// `Each<Column>`.
    EachColumns,
    /// `Each<Tree>`.
    EachTrees,
}

/// What stands in `#[output(…)]`.
struct OutputAttribute {
    name: String,
    nick: String,
    help: String,
    kind: Option<Ident>,
}

impl Parse for OutputAttribute {
    fn parse(input: ParseStream<'_>) -> Result<Self> {
        let name: LitStr = input.parse()?;
        input.parse::<Token![,]>()?;
        let nick: LitStr = input.parse()?;
        input.parse::<Token![,]>()?;
        let help: LitStr = input.parse()?;
        let mut output = Self { name: name.value(), nick: nick.value(), help: help.value(), kind: None };
        if input.parse::<Token![,]>().is_ok() && !input.is_empty() {
            let key: Ident = input.parse()?;
            if key != "kind" {
                return Err(Error::new(key.span(), "expected kind = …"));
            }
            input.parse::<Token![=]>()?;
            output.kind = Some(input.parse()?);
        }
        Ok(output)
    }
}

pub(crate) struct Outputs {
    /// The function gives a `Result`.
    fallible: bool,
    /// Its value is a tuple, not a single result.
    tuple: bool,
    results: Vec<(Shape, OutputAttribute)>,
}

impl Outputs {
    pub(crate) fn new(returned: &ReturnType, attributes: &[Attribute]) -> Result<Self> {
        let attributes: Vec<OutputAttribute> =
            attributes.iter().map(Attribute::parse_args).collect::<Result<_>>()?;
        let span = returned.span();
        let (fallible, value) = match returned {
            ReturnType::Default => (false, None),
            ReturnType::Type(_, t) => match t.as_ref() {
                Type::Path(path) if last_name(path) == "Result" => (true, Some(inner(path)?)),
                other => (false, Some(other.clone())),
            },
        };
        let (tuple, types) = match value {
            None => (true, Vec::new()),
            Some(Type::Tuple(tuple)) => (true, tuple.elems.into_iter().collect()),
            Some(one) => (false, vec![one]),
        };
        if types.len() != attributes.len() {
            let (n, m) = (types.len(), attributes.len());
            return Err(Error::new(
                span,
                format!("{n} results, but {m} #[output(\"Name\", \"N\", \"help\")]"),
            ));
        }
        let shapes: Vec<Shape> = types.iter().map(shape).collect::<Result<_>>()?;
        Ok(Self { fallible, tuple, results: shapes.into_iter().zip(attributes).collect() })
    }

    /// The static descriptions of the ports.
    pub(crate) fn ports(&self) -> Vec<TokenStream> {
        let parts = quote!(::katydid_component::parts);
        let port = |(shape, attribute): &(Shape, OutputAttribute)| {
            let OutputAttribute { name, nick, help, kind } = attribute;
            let (access, many) = match shape {
                Shape::Item(_) | Shape::Maybe(_) | Shape::ItemOrList(_) => (quote!(Item), false),
                Shape::List(_) | Shape::MaybeList(_) | Shape::Column => (quote!(List), false),
                Shape::Tree => (quote!(Tree), false),
                Shape::EachItems(_) => (quote!(Item), true),
                Shape::EachLists(_) | Shape::EachColumns => (quote!(List), true),
                Shape::EachTrees => (quote!(Tree), true),
            };
            let kind = match (kind, shape) {
                (Some(kind), _) => quote!(#parts::Kind::#kind),
                (None, Shape::Tree | Shape::EachTrees | Shape::Column | Shape::EachColumns) => {
                    quote!(#parts::Kind::Generic)
                }
                (
                    None,
                    Shape::Item(t)
                    | Shape::Maybe(t)
                    | Shape::List(t)
                    | Shape::MaybeList(t)
                    | Shape::ItemOrList(t)
                    | Shape::EachItems(t)
                    | Shape::EachLists(t),
                ) => quote!(<#t as #parts::Item>::KIND),
            };
            quote! {
                ::katydid_component::Port {
                    name: #name,
                    nick: #nick,
                    help: #help,
                    kind: #kind,
                    access: ::katydid_component::Access::#access,
                    optional: false,
                    many: #many,
                    default: None,
                }
            }
        };
        self.results.iter().map(port).collect()
    }

    /// The type of the tuple that collects the results.
    pub(crate) fn sinks(&self) -> TokenStream {
        let parts = quote!(::katydid_component::parts);
        let sinks = self.results.iter().map(|(shape, _)| match shape {
            Shape::Item(t) | Shape::Maybe(t) => quote!(#parts::Items<#t>),
            Shape::List(t) | Shape::MaybeList(t) => quote!(#parts::Lists<#t>),
            Shape::ItemOrList(t) => quote!(#parts::ItemsOrLists<#t>),
            Shape::Column => quote!(#parts::Lists<#parts::Value>),
            Shape::Tree => quote!(#parts::Trees),
            Shape::EachItems(t) => quote!(#parts::EachItems<#t>),
            Shape::EachLists(t) => quote!(#parts::EachLists<#t>),
            Shape::EachColumns => quote!(#parts::EachLists<#parts::Value>),
            Shape::EachTrees => quote!(#parts::EachTrees),
        });
        quote!((#(#sinks,)*))
    }

    /// Calls the function and gives its results as what the sinks take.
    pub(crate) fn results(&self, call: &TokenStream) -> TokenStream {
        let names: Vec<Ident> = (0..self.results.len()).map(|k| format_ident!("output_{k}")).collect();
        let call = if self.fallible { quote!(#call?) } else { quote!(#call) };
        let pattern = match (self.tuple, names.as_slice()) {
            (true, []) => quote!(()),
            (true, names) => quote!((#(#names,)*)),
            (false, names) => quote!(#(#names)*),
        };
        let results = self.results.iter().zip(&names).map(|((shape, _), name)| match shape {
            Shape::Item(_) => quote!(Some(#name)),
            Shape::Maybe(_) | Shape::ItemOrList(_) | Shape::Tree => quote!(#name),
            Shape::List(_) => quote!(::katydid_component::parts::ListOf::Full(#name)),
            Shape::MaybeList(_) => quote!(::katydid_component::parts::ListOf::Gaps(#name)),
            Shape::Column => quote!(::katydid_component::parts::ListOf::Column(#name)),
            Shape::EachItems(_) | Shape::EachTrees => quote!(#name.0),
            Shape::EachColumns => {
                quote!(#name.0.into_iter().map(::katydid_component::parts::ListOf::Column).collect())
            }
            Shape::EachLists(_) => {
                quote!(#name.0.into_iter().map(::katydid_component::parts::ListOf::Gaps).collect())
            }
        });
        quote! {
            let #pattern = #call;
            Ok(Some((#(#results,)*)))
        }
    }
}

fn shape(t: &Type) -> Result<Shape> {
    let Type::Path(path) = t else { return Ok(Shape::Item(t.clone())) };
    let optional = |t: &Type| match t {
        Type::Path(path) if last_name(path) == "Option" => inner(path).ok(),
        _ => None,
    };
    Ok(match last_name(path).as_str() {
        "Tree" => Shape::Tree,
        "Column" => Shape::Column,
        "Option" => Shape::Maybe(inner(path)?),
        "ItemOrList" => Shape::ItemOrList(inner(path)?),
        "Vec" => {
            let t = inner(path)?;
            match optional(&t) {
                Some(t) => Shape::MaybeList(t),
                None => Shape::List(t),
            }
        }
        "Each" => match inner(path)? {
            Type::Path(path) if last_name(&path) == "Tree" => Shape::EachTrees,
            Type::Path(path) if last_name(&path) == "Column" => Shape::EachColumns,
            Type::Path(path) if last_name(&path) == "Option" => Shape::EachItems(inner(&path)?),
            Type::Path(path) if last_name(&path) == "Vec" => match optional(&inner(&path)?) {
                Some(t) => Shape::EachLists(t),
                None => return Err(Error::new(path.span(), "expected Each<Vec<Option<T>>>")),
            },
            other => {
                return Err(Error::new(
                    other.span(),
                    "expected Each<Option<T>>, Each<Vec<Option<T>>>, Each<Column> or Each<Tree>",
                ));
            }
        },
        _ => Shape::Item(t.clone()),
    })
}
