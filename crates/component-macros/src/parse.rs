//! The arguments of `#[component]`, and help out of doc comments.

use syn::parse::{Parse, ParseStream};
use syn::punctuated::Punctuated;
use syn::{Attribute, Error, Expr, ExprLit, Ident, Lit, LitStr, Meta, Result, Token, parenthesized};

/// What stands in `#[component(…)]`.
pub(crate) struct Header {
    pub(crate) guid: u128,
    pub(crate) also: Vec<u128>,
    pub(crate) name: String,
    pub(crate) nick: String,
    pub(crate) tab: String,
    pub(crate) panel: String,
    pub(crate) floating: bool,
    /// What is asked before the loop runs.
    pub(crate) columns: Option<syn::Path>,
    pub(crate) old: bool,
}

fn guid(text: &LitStr) -> Result<u128> {
    uuid::Uuid::parse_str(&text.value())
        .map(|guid| guid.as_u128())
        .map_err(|error| Error::new(text.span(), format!("not a GUID: {error}")))
}

impl Parse for Header {
    fn parse(input: ParseStream<'_>) -> Result<Self> {
        let id: LitStr = input.parse()?;
        let mut header = Self {
            guid: guid(&id)?,
            also: Vec::new(),
            name: String::new(),
            nick: String::new(),
            tab: String::new(),
            panel: String::new(),
            floating: false,
            columns: None,
            old: false,
        };
        while !input.is_empty() {
            input.parse::<Token![,]>()?;
            if input.is_empty() {
                break;
            }
            let key: Ident = input.parse()?;
            match key.to_string().as_str() {
                "floating" => header.floating = true,
                "columns" => {
                    input.parse::<Token![=]>()?;
                    header.columns = Some(input.parse()?);
                }
                "old" => header.old = true,
                "also" => {
                    let inner;
                    parenthesized!(inner in input);
                    let ids = Punctuated::<LitStr, Token![,]>::parse_terminated(&inner)?;
                    header.also = ids.iter().map(guid).collect::<Result<_>>()?;
                }
                known @ ("name" | "nick" | "at") => {
                    input.parse::<Token![=]>()?;
                    let text: LitStr = input.parse()?;
                    match known {
                        "name" => header.name = text.value(),
                        "nick" => header.nick = text.value(),
                        _ => {
                            let value = text.value();
                            let (tab, panel) = value
                                .split_once('/')
                                .ok_or_else(|| Error::new(text.span(), "expected \"Tab/Panel\""))?;
                            header.tab = tab.to_owned();
                            header.panel = panel.to_owned();
                        }
                    }
                }
                _ => return Err(Error::new(key.span(), "expected name, nick, at, also, floating or old")),
            }
        }
        if header.name.is_empty() || header.tab.is_empty() {
            return Err(Error::new(id.span(), "a component needs name = \"…\" and at = \"Tab/Panel\""));
        }
        Ok(header)
    }
}

/// The text of doc comments: lines joined, paragraphs kept.
pub(crate) fn help(attributes: &[Attribute]) -> String {
    let mut text = String::new();
    for attribute in attributes.iter().filter(|a| a.path().is_ident("doc")) {
        let Meta::NameValue(pair) = &attribute.meta else { continue };
        let Expr::Lit(ExprLit { lit: Lit::Str(line), .. }) = &pair.value else { continue };
        let line = line.value();
        let line = line.trim();
        if line.is_empty() {
            text.push('\n');
        } else {
            if !text.is_empty() && !text.ends_with('\n') {
                text.push(' ');
            }
            text.push_str(line);
        }
    }
    text.trim().to_owned()
}

/// Takes the attributes of that name out of the list.
pub(crate) fn take_attributes(attributes: &mut Vec<Attribute>, name: &str) -> Vec<Attribute> {
    let (taken, kept) = attributes.drain(..).partition(|a| a.path().is_ident(name));
    *attributes = kept;
    taken
}
