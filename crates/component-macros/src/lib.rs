//! The `#[component]` attribute: see `katydid_component`.

mod input;
mod output;
mod parse;

use proc_macro::TokenStream;
use quote::{format_ident, quote};
use syn::{ItemFn, Result, parse_macro_input};

use crate::input::Input;
use crate::output::Outputs;
use crate::parse::{Header, help, take_attributes};

/// Turns a function into a component: reads ports and help off its signature, writes the loop over the data,
/// and enters it in the registry.
///
/// `#[component("guid", name = "…", nick = "…", at = "Tab/Panel", also("old guid", …), columns = function, floating, columns, old)]`, then an
/// `#[output("Name", "N", "help")]` for each result, and on each argument a doc comment and
/// `#[port("Name", "N", default = …, optional)]`. Argument types give the access: `T` takes an item,
/// `Option<T>` one that may be missing, `List<T>` a branch, `&Tree` everything; `ManyItems<T>`,
/// `ManyLists<T>` and `ManyTrees` stand for any number of ports. `&Context` is no port. Results are `T`,
/// `Option<T>`, `Vec<T>`, `Vec<Option<T>>`, `Tree` or `Each<…>`, alone or in a tuple, plain or in a `Result`.
#[proc_macro_attribute]
pub fn component(attribute: TokenStream, item: TokenStream) -> TokenStream {
    let header = parse_macro_input!(attribute as Header);
    let function = parse_macro_input!(item as ItemFn);
    expand(&header, function).unwrap_or_else(|error| error.to_compile_error()).into()
}

fn expand(header: &Header, mut function: ItemFn) -> Result<proc_macro2::TokenStream> {
    let help = help(&function.attrs);
    if help.is_empty() {
        return Err(syn::Error::new(
            function.sig.ident.span(),
            "a component needs a doc comment: it is its help",
        ));
    }
    let output_attributes = take_attributes(&mut function.attrs, "output");
    let outputs = Outputs::new(&function.sig.output, &output_attributes)?;
    let inputs = function.sig.inputs.iter_mut().map(Input::new).collect::<Result<Vec<Input>>>()?;

    let name = &function.sig.ident;
    let parts = quote!(::katydid_component::parts);
    let mut port_index = 0usize;
    let mut input_ports = Vec::new();
    let mut access = Vec::new();
    let mut bindings = Vec::new();
    let mut arguments = Vec::new();
    for (k, input) in inputs.iter().enumerate() {
        let variable = format_ident!("input_{k}");
        if input.is_context() {
            arguments.push(quote!(context));
            continue;
        }
        bindings.push(input.binding(&variable, port_index));
        arguments.push(input.argument(&variable));
        input_ports.push(input.port());
        access.push(input.access());
        port_index += 1;
    }
    let output_ports = outputs.ports();
    let sinks = outputs.sinks();
    let results = outputs.results(&quote!(#name(#(#arguments),*)));
    let Header { guid, name: title, nick, tab, panel, also, floating, old, columns } = header;
    let columns = columns.iter();
    Ok(quote! {
        #function

        const _: () = {
            fn run(call: &::katydid_component::Call<'_>) -> ::katydid_component::Outcome {
                #(if let Some(outcome) = #columns(call) {
                    return outcome;
                })*
                #parts::run::<#sinks>(call, &[#(#access),*], |row, context| {
                    #(#bindings)*
                    let _ = (&row, &context);
                    #results
                })
            }

            #parts::inventory::submit! {
                ::katydid_component::Component {
                    guid: #parts::Uuid::from_u128(#guid),
                    also: &[#(#parts::Uuid::from_u128(#also)),*],
                    name: #title,
                    nick: #nick,
                    tab: #tab,
                    panel: #panel,
                    help: #help,
                    floating: #floating,
                    old: #old,
                    inputs: &[#(#input_ports),*],
                    outputs: &[#(#output_ports),*],
                    run,
                }
            }
        };
    })
}
