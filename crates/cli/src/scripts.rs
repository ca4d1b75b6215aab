//! Whether and how a definition's scripts run.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use clap::Args;
use katydid_script::{Bounds, CSharpMaker, Permission, PythonMaker, Trusted, find};
use katydid_server::ScriptConfig;
use katydid_solver::{Refused, ScriptMaker, Scripts};

use crate::args::TrustArgs;
use crate::output::say;
use crate::source;

/// Whether a definition's scripts run, and with what.
#[derive(Debug, Clone, Args)]
pub(crate) struct ScriptArgs {
    /// Run the definition's Python scripts: they are programs, and not ours; `katydid trust FILE` allows those of one file
    #[arg(long)]
    pub(crate) allow_scripts: bool,

    /// Let the scripts that run use the network
    #[arg(long)]
    pub(crate) allow_network: bool,

    /// Let the scripts that run read the files in a folder and in the folders below it, but change none; may be given
    /// several times
    #[arg(long, value_name = "FOLDER", value_parser = readable_folder)]
    pub(crate) script_read: Vec<PathBuf>,

    /// The Python to run scripts with; else that of KATYDID_PYTHON, a .venv or venv beside the definition, or python3
    #[arg(long, value_name = "PATH")]
    pub(crate) python: Option<PathBuf>,

    /// The most megabytes of memory that the scripts of a definition may take
    #[arg(long, value_name = "MEGABYTES", default_value_t = 4096)]
    pub(crate) script_memory: u64,
}

/// With what the scripts of definitions run that are open in the studio, which asks whether they may.
#[derive(Debug, Args)]
pub(crate) struct StudioScriptArgs {
    /// Let the scripts that run use the network
    #[arg(long)]
    allow_network: bool,

    /// The Python to run scripts with, once the page was told that they may run; else that of KATYDID_PYTHON, a .venv or
    /// venv beside the definition, or python3
    #[arg(long, value_name = "PATH")]
    python: Option<PathBuf>,

    /// The most megabytes of memory that the scripts of a definition may take
    #[arg(long, value_name = "MEGABYTES", default_value_t = 4096)]
    script_memory: u64,
}

impl StudioScriptArgs {
    /// What runs scripts, and where the answers are kept.
    pub(crate) fn for_studio(&self) -> ScriptConfig {
        ScriptConfig {
            python: self.python.clone(),
            bounds: bounds(self.script_memory, self.allow_network),
            trusted: Trusted::usual_place(),
        }
    }
}

/// What a process of scripts may use.
fn bounds(megabytes: u64, network: bool) -> Bounds {
    Bounds { memory: megabytes.saturating_mul(1 << 20), network, ..Bounds::default() }
}

/// A folder that scripts may read, by its real path: links in it that lead elsewhere are not followed.
fn readable_folder(text: &str) -> Result<PathBuf, String> {
    let folder = if cfg!(windows) { std::path::absolute(text) } else { std::fs::canonicalize(text) };
    let folder = folder.map_err(|error| error.to_string())?;
    if !folder.is_dir() {
        return Err("is no folder".to_owned());
    }
    // The process that runs scripts is told its folders as a search path.
    if std::env::join_paths([&folder]).is_err() {
        return Err("its path has a character that parts the folders of a search path".to_owned());
    }
    Ok(folder)
}

impl ScriptArgs {
    /// What runs the scripts of a file, or says of each why it does not.
    pub(crate) fn scripts(&self, file: &Path) -> Arc<dyn Scripts> {
        match self.permission(file) {
            Permission::Given => csharp_and(Some(Arc::new(self.python(Some(file)))), String::new()).make(),
            // Without the file's path: the same definition gives the same words wherever it lies.
            Permission::Refused => csharp_and(
                None,
                "look at it, then run it with --allow-scripts, or allow it for good with `katydid trust FILE`",
            )
            .make(),
        }
    }

    /// What runs the scripts of a definition that is in no file.
    pub(crate) fn of_no_file(&self) -> Arc<dyn Scripts> {
        let python = self.allow_scripts.then(|| Arc::new(self.python(None)) as _);
        csharp_and(python, "Katydid was started without --allow-scripts").make()
    }

    /// What runs the scripts of a server's definitions.
    pub(crate) fn of_server(&self) -> CSharpMaker {
        let python = self.allow_scripts.then(|| Arc::new(self.python(None)) as _);
        csharp_and(python, "this server was started without --allow-scripts")
    }

    /// What runs Python scripts once they are allowed; an environment beside the file is looked for.
    fn python(&self, file: Option<&Path>) -> PythonMaker {
        let bounds =
            Bounds { readable: self.script_read.clone(), ..bounds(self.script_memory, self.allow_network) };
        let definition = file.map(|file| std::path::absolute(file).unwrap_or_else(|_| file.to_owned()));
        PythonMaker { interpreter: find(self.python.as_deref(), file), bounds, definition }
    }

    fn permission(&self, file: &Path) -> Permission {
        let is_trusted = || {
            let bytes = source::bytes(file).ok()?;
            Some(Trusted::of_user().ok()?.trusts(&bytes))
        };
        if self.allow_scripts || is_trusted() == Some(true) { Permission::Given } else { Permission::Refused }
    }
}

/// C# can only compute, and needs no permission; Python does.
fn csharp_and(python: Option<Arc<dyn ScriptMaker>>, advice: impl Into<String>) -> CSharpMaker {
    CSharpMaker { others: python, refused: Refused::new(advice) }
}

/// Trusts files: their scripts may run from now on, until they change.
pub(crate) fn trust(args: &TrustArgs) -> Result<u8, String> {
    let failed = |error: &std::io::Error| format!("the list of trusted files: {error}");
    let mut trusted = Trusted::of_user().map_err(|error| failed(&error))?;
    for file in &args.files {
        let bytes = source::bytes(file)?;
        let name = std::path::absolute(file).unwrap_or_else(|_| file.clone());
        trusted.add(&bytes, &name.display().to_string()).map_err(|error| failed(&error))?;
        say(&format!("{} may run its scripts, as it is now", file.display()));
    }
    Ok(0)
}
