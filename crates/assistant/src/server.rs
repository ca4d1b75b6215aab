//! The protocol's side: what the server says of itself, and how calls come to the tools.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;
use std::time::Instant;

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use rmcp::handler::server::ServerHandler;
use rmcp::model::{
    CallToolRequestParams, CallToolResponse, CallToolResult, ContentBlock, ErrorData, Implementation,
    ListResourceTemplatesResult, ListResourcesResult, ListToolsResult, PaginatedRequestParams,
    ProgressNotificationParam, ReadResourceRequestParams, ReadResourceResponse, ReadResourceResult,
    ResourceContents, ServerCapabilities, ServerConfig,
};
use rmcp::service::{RequestContext, RoleServer};

use crate::document::Opened;
use crate::fault::Fault;
use crate::job::Job;
use crate::resources;
use crate::store::{Config, Store};
use crate::thresholds::{LOOK_EVERY, TELL_EVERY};
use crate::tools::{self, Answer, Reply};

/// What an assistant is told before all else.
const INSTRUCTIONS: &str = "\
Katydid opens, makes, solves and saves Grasshopper definitions: graphs of components whose outputs are wired to inputs. \
Begin with new_definition or open_definition; describe_definition and list_objects tell what is there; find_components finds \
components by words, and component_help explains one. Build with edit_text: statements such as `r = Number Slider(5, 0..10)`, \
`c = Circle(_, r)`, `e = Extrude(c, Unit Z(3))` (resource katydid://kd has the language), or with edit_definition. Then call \
solve, look at the problems it tells, ask why for objects that failed, read_values and measure to check numbers, and picture to \
look at the result. save_definition and export_geometry write files, below the folders that are open only. Every editing call is \
one step for undo; a call that is refused changes nothing.";

/// What it is told besides where the definitions are those of a studio.
const IN_STUDIO: &str = " You work on the definitions that a person has open in the studio: list_definitions tells them. The \
person sees each edit as it is made, and edits too; every call has the newest state. undo takes back only your own steps, as \
long as the person has done nothing since. Do not call new_definition, open_definition or close_definition: the person does that.";

/// A server of the protocol. Clones are the same server.
#[derive(Clone)]
pub struct Assistant {
    store: Arc<Store>,
}

impl std::fmt::Debug for Assistant {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Assistant").field("config", &self.store.config).finish_non_exhaustive()
    }
}

impl Assistant {
    /// A server without open definitions.
    ///
    /// # Errors
    /// A folder is not there.
    pub fn new(config: Config) -> Result<Self, String> {
        Ok(Self { store: Arc::new(Store::new(config)?) })
    }

    fn instructions(&self) -> String {
        match self.store.config.studio {
            Some(_) => format!("{INSTRUCTIONS}{IN_STUDIO}"),
            None => INSTRUCTIONS.to_owned(),
        }
    }

    async fn call(
        &self,
        request: CallToolRequestParams,
        context: &RequestContext<RoleServer>,
    ) -> Result<CallToolResult, ErrorData> {
        let Some(entry) = tools::find(&request.name) else {
            let names: Vec<&str> = tools::all().iter().map(|entry| entry.tool.name.as_ref()).collect();
            let name = crate::document::cut(&request.name);
            let why = format!("there is no tool \"{name}\": there are {}", names.join(", "));
            return Err(ErrorData::invalid_params(why, None));
        };
        let store = Arc::clone(&self.store);
        let arguments = request.arguments.unwrap_or_default();
        // Nothing of a tool runs on the threads that carry messages.
        let done = tokio::task::spawn_blocking(move || {
            let reply = catch_unwind(AssertUnwindSafe(|| (entry.run)(&store, arguments)));
            store.all().iter().for_each(Opened::write_ahead);
            reply
        });
        let failed = || {
            Fault::new(
                format!("{} failed", entry.tool.name),
                "",
                "this is a fault of Katydid: please report it",
            )
        };
        let reply = match done.await {
            Ok(Ok(reply)) => reply,
            Ok(Err(_)) | Err(_) => Err(failed()),
        };
        Ok(match reply {
            Ok(Reply::Done(answer)) => told(answer),
            Ok(Reply::Waits { document, job, wait, owns }) => {
                self.wait(&job, wait, owns, context).await;
                told(of_job(&document, &job))
            }
            Err(fault) => fault.answer(),
        })
    }

    /// Waits for the end of a job, and tells the client how far it is where it asked for that.
    async fn wait(
        &self,
        job: &Job,
        wait: std::time::Duration,
        owns: bool,
        context: &RequestContext<RoleServer>,
    ) {
        let began = Instant::now();
        let token = context.meta.get_progress_token();
        let (mut told, mut last) = (began, None);
        while job.is_running() && began.elapsed() < wait {
            tokio::select! {
                () = context.ct.cancelled() => {
                    if owns {
                        job.cancel.cancel();
                    }
                    return;
                }
                () = tokio::time::sleep(LOOK_EVERY) => {}
            }
            let (done, total, name) = job.so_far();
            if let Some(token) = token.as_ref().filter(|_| told.elapsed() >= TELL_EVERY && last != Some(done))
            {
                (told, last) = (Instant::now(), Some(done));
                #[allow(clippy::cast_precision_loss, reason = "numbers of objects")]
                let mut progress = ProgressNotificationParam::new(token.clone(), done as f64);
                #[allow(clippy::cast_precision_loss, reason = "numbers of objects")]
                let whole = total as f64;
                progress.total = Some(whole);
                progress.message = Some(name);
                // A client that is gone need not be told.
                let _ = context.peer.notify_progress(progress).await;
            }
        }
    }
}

/// How a job stands, and how the objects came out where it has ended.
fn of_job(document: &Opened, job: &Job) -> Answer {
    let mut value = job.told();
    if job.is_running() {
        value["note"] =
            "it goes on: job_status tells how it stands, cancel_job ends it, and all other tools answer"
                .into();
    } else {
        value["outcome"] = document.outcome();
        value["results"] = document.standing();
    }
    Answer { value, ..Answer::default() }
}

/// An answer as the protocol has it: the object as text for those that read text, and as itself.
fn told(answer: Answer) -> CallToolResult {
    let mut content = vec![ContentBlock::text(answer.value.to_string())];
    content.extend(answer.pictures.iter().map(|png| ContentBlock::image(STANDARD.encode(png), "image/png")));
    if let Some((name, kind, bytes)) = &answer.file {
        let file = ResourceContents::blob(STANDARD.encode(bytes), format!("katydid://made/{name}"));
        content.push(ContentBlock::resource(file.with_mime_type(*kind)));
    }
    let mut result = CallToolResult::success(content);
    result.structured_content = Some(answer.value);
    result
}

impl ServerHandler for Assistant {
    fn get_info(&self) -> ServerConfig {
        let capabilities = ServerCapabilities::builder().enable_tools().enable_resources().build();
        let mut info = ServerConfig::new(capabilities).with_instructions(self.instructions());
        info.server_info = Implementation::new("katydid", env!("CARGO_PKG_VERSION"));
        info
    }

    async fn list_tools(
        &self,
        _: Option<PaginatedRequestParams>,
        _: RequestContext<RoleServer>,
    ) -> Result<ListToolsResult, ErrorData> {
        Ok(ListToolsResult::with_all_items(tools::all().iter().map(|entry| entry.tool.clone()).collect()))
    }

    async fn call_tool(
        &self,
        request: CallToolRequestParams,
        context: RequestContext<RoleServer>,
    ) -> Result<CallToolResponse, ErrorData> {
        Ok(self.call(request, &context).await?.into())
    }

    async fn list_resources(
        &self,
        _: Option<PaginatedRequestParams>,
        _: RequestContext<RoleServer>,
    ) -> Result<ListResourcesResult, ErrorData> {
        Ok(ListResourcesResult::with_all_items(resources::list(self.store.config.book.as_deref())))
    }

    async fn list_resource_templates(
        &self,
        _: Option<PaginatedRequestParams>,
        _: RequestContext<RoleServer>,
    ) -> Result<ListResourceTemplatesResult, ErrorData> {
        Ok(ListResourceTemplatesResult::with_all_items(resources::templates()))
    }

    async fn read_resource(
        &self,
        request: ReadResourceRequestParams,
        _: RequestContext<RoleServer>,
    ) -> Result<ReadResourceResponse, ErrorData> {
        let book = self.store.config.book.clone();
        let uri = request.uri.clone();
        let read = tokio::task::spawn_blocking(move || resources::read(book.as_deref(), &uri));
        let found = read.await.unwrap_or_else(|_| Err("the resource could not be read".to_owned()));
        let contents = found.map_err(|why| ErrorData::resource_not_found(why, None))?;
        Ok(ReadResourceResult::new(vec![contents]).into())
    }
}
