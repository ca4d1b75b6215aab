//! Definitions as tools for assistants: a server of the Model Context Protocol.
//!
//! An [`Assistant`] has definitions open, and tools by which they are made, described, edited with undo, solved, looked at,
//! explained, compared, saved and exported. Edits and answers never wait for a solve, which goes on as a job. Files are read
//! and written below the folders that [`Config`] names, and nowhere else. Where [`Config`] names a studio that a person has
//! open, the definitions are copies of the documents there: each call brings them up to date, and each edit is a step there,
//! which the person sees and can take back. [`serve`] speaks over the standard input and
//! output; tests speak with an [`Assistant`] in memory.
//!
//! The protocol itself is that of the library `rmcp`; what an edit means is told by `katydid-session`.

mod attached;
mod document;
mod fault;
mod folders;
mod job;
mod reference;
mod resources;
mod server;
mod store;
mod studio;
mod text;
mod thresholds;
mod tools;
mod work;

use rmcp::ServiceExt;
use rmcp::transport::async_rw::AsyncRwTransport;
use rmcp::transport::stdio_pipes;

pub use server::Assistant;
pub use store::{Config, ScriptsOf, StudioAddress};

/// Serves one client over the standard input and output, until it closes the input.
///
/// Runs on a runtime of Tokio with its drivers; what computes runs on threads of its own.
///
/// # Errors
/// A folder is not there, or the client does not speak the protocol.
pub async fn serve(config: Config) -> Result<(), String> {
    let assistant = Assistant::new(config)?;
    let (read, write) = stdio_pipes();
    let transport =
        AsyncRwTransport::new_server(read, write).with_max_line_length(thresholds::LONGEST_MESSAGE);
    let running = match assistant.serve(transport).await {
        Ok(running) => running,
        // A client that went away before it said anything wanted nothing.
        Err(rmcp::service::ServerInitializeError::ConnectionClosed(_)) => return Ok(()),
        Err(error) => return Err(format!("the client does not speak the protocol: {error}")),
    };
    running.waiting().await.map(drop).map_err(|error| error.to_string())
}
