//! Messages of other programs (Open Sound Control), which come as lists: the address first.

use std::sync::Arc as Shared;

use katydid_component::{Context, List, component};

/// What a message brings, when it is for an address.
fn data_for(address: &str, message: &[Shared<str>]) -> Option<Shared<str>> {
    let (first, data) = message.split_first()?;
    if **first != *address || data.is_empty() {
        return None;
    }
    Some(data.join(",").into())
}

/// The data of a message that is for the object's own short name, apart by commas; null for others. Stands for gHowl's OSC Channel;
/// what came in earlier solves is not kept.
#[component("4654efcd-8975-4fe8-90c2-d767ccdd80c4", name = "OSC Channel", nick = "OSC_C", at = "gHowl/UDP")]
#[output("OSC Data", "O", "The data.")]
fn channel(
    context: &Context<'_>,
    /// The message: its address, then its data.
    #[port("OSC Message", "M")]
    message: List<Shared<str>>,
) -> Option<Shared<str>> {
    let message: Vec<Shared<str>> = message.present().collect();
    data_for(context.settings().str("NickName").unwrap_or_default(), &message)
}

/// Puts the data of a message at the place of its address in a list. Stands for gHowl's OSC Dispatch; what came in earlier solves is
/// not kept: the other places are null.
#[component("6b8c8c86-b384-452a-b3e2-4fa9ad693476", name = "OSC Dispatch", nick = "OSC_D", at = "gHowl/UDP")]
#[output("OSC Device", "D", "The address, where it is in the list.")]
#[output("OSC Data", "O", "The data, at the place of the address.")]
fn dispatch(
    context: &Context<'_>,
    /// The addresses that are listened to.
    #[port("OSC Devices", "D")]
    devices: List<Shared<str>>,
    /// The message: its address, then its data.
    #[port("OSC Message", "M")]
    message: List<Shared<str>>,
) -> (Option<Shared<str>>, Vec<Option<Shared<str>>>) {
    let message: Vec<Shared<str>> = message.present().collect();
    let mut device = None;
    let mut data = vec![None; devices.len()];
    for (own, slot) in devices.iter().zip(&mut data) {
        if let Some(own) = own.filter(|own| device.is_none() && message.first() == Some(own)) {
            *slot = data_for(&own, &message);
            device = Some(own);
        }
    }
    if device.is_none() {
        context.warn("The address of the message is not in the list");
    }
    (device, data)
}
