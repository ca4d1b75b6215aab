//! Telepathy: data sent to receivers of the same name, over wires that are not drawn. Files keep these wires, so that both ends hand
//! on what comes.

use katydid_component::component;
use katydid_data::Tree;

/// Sends data to the receivers that have its name. Stands for Telepathy's Remote Sender; the receivers are wired in the file.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1e01",
    name = "Remote Sender",
    nick = "Sender",
    at = "Telepathy/Params",
    floating
)]
#[output("Remote Sender", "Sender", "The data.")]
fn remote_sender(
    /// The data.
    #[port("Remote Sender", "Sender", optional)]
    data: &Tree,
) -> Tree {
    data.clone()
}

/// Gives the data of the senders that have its name. Stands for Telepathy's Remote Receiver; the senders are wired in the file.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1e02",
    name = "Remote Receiver",
    nick = "Receiver",
    at = "Telepathy/Params",
    floating
)]
#[output("Remote Receiver", "Receiver", "The data.")]
fn remote_receiver(
    /// The data.
    #[port("Remote Receiver", "Receiver", optional)]
    data: &Tree,
) -> Tree {
    data.clone()
}
