//! gHowl: XML, spreadsheets, places on the earth, and messages of other programs.
//!
//! Names, ports and ids are those of its published sources (MIT), which also tell what each does; the code is our own. What asks
//! networks, or services that are gone, is listed as not supported.

mod geo;
mod kml;
mod kml_write;
mod messages;
mod sheets;
#[cfg(test)]
mod tests;
mod xml_read;
mod xml_write;

pub(crate) use xml_read::broken;

use katydid_component::parts::{Uuid, inventory};
use katydid_component::registry::Unsupported;

const NO_NETWORK: &str =
    "it reads from or writes to the network while the definition runs, which is not done";
const SERVICE_GONE: &str = "the web service that it asks is gone";

const fn row(guid: u128, name: &'static str, reason: &'static str) -> Unsupported {
    Unsupported { guid: Uuid::from_u128(guid), name, reason }
}

inventory::submit! { Unsupported::list(&LIST) }

static LIST: [Unsupported; 6] = [
    row(0xe7b66191_6548_0ce3_7d16_1ec3813ec8d1, "UDP Sender", NO_NETWORK),
    row(0x5a093912_7a24_39e7_810c_797a143f3912, "UDP Receiver", NO_NETWORK),
    row(0x1a578ada_547d_0931_c12b_04410d154353, "Network Source", NO_NETWORK),
    row(0xfd618634_b121_4237_86ef_9074040e2a59, "Get Elevation", SERVICE_GONE),
    row(0xf3054896_b62a_4fa8_b009_d43511234084, "Read Pachube", SERVICE_GONE),
    row(0x12f1943c_7f49_461c_bf1f_ececba590ba2, "Pachube Update", SERVICE_GONE),
];
