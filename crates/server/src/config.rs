use std::net::{IpAddr, Ipv4Addr};
use std::path::PathBuf;

use katydid_component::Trust;
use katydid_script::Bounds;

/// How the server runs.
#[derive(Debug, Clone)]
pub struct Config {
    /// The address that it listens on.
    pub address: IpAddr,
    /// The port; 0 for any that is free.
    pub port: u16,
    /// What whoever uses the studio must know; made by chance where none is given. Other users of this machine can reach
    /// the port too, so there always is one.
    pub token: Option<String>,
    /// The folders whose files definitions may read although they were sent, or others than this machine can join.
    pub folders: Vec<PathBuf>,
    /// The definition to open.
    pub file: Option<PathBuf>,
    /// The Rhino model that the definition refers to.
    pub model: Option<PathBuf>,
    /// Whether the page shows inputs and model alone.
    pub player: bool,
    /// The folder for recent files and journals; nothing is kept when there is none.
    pub state: Option<PathBuf>,
    /// What runs the scripts of definitions once somebody lets them; without it none run.
    pub scripts: Option<ScriptConfig>,
    /// The folder of the book whose pages stand at `/learn`; without it Katydid's own book does.
    pub book: Option<PathBuf>,
    /// The study whose page stands at `/study`.
    pub study: Option<StudyConfig>,
    /// Whether a program of this machine that knows the token may read and edit the documents that are open, as
    /// `katydid mcp --studio` does.
    pub assistant: bool,
    /// The most bytes of a file that is sent.
    pub most_upload: usize,
    /// The most documents that are open at a time.
    pub most_documents: usize,
}

/// A study that is looked at.
#[derive(Debug, Clone, Default)]
pub struct StudyConfig {
    /// Its folder.
    pub folder: PathBuf,
    /// The definition whose points are opened; without it, that which the folder names.
    pub definition: Option<PathBuf>,
}

/// What runs the scripts of definitions that are open in the studio.
#[derive(Debug, Clone, Default)]
pub struct ScriptConfig {
    /// The Python to run them with; else one is looked for beside the definition and on the path.
    pub python: Option<PathBuf>,
    /// What the scripts of a definition may use.
    pub bounds: Bounds,
    /// The list of the files whose scripts may run; answers are not kept when there is none.
    pub trusted: Option<PathBuf>,
}

/// The port of the studio.
pub(crate) const PORT: u16 = 6510;

impl Default for Config {
    /// On this machine alone, with a token made by chance.
    fn default() -> Self {
        Self {
            address: IpAddr::V4(Ipv4Addr::LOCALHOST),
            port: PORT,
            token: None,
            folders: Vec::new(),
            file: None,
            model: None,
            player: false,
            state: None,
            scripts: None,
            book: None,
            study: None,
            assistant: false,
            most_upload: 256 << 20,
            most_documents: 64,
        }
    }
}

impl Config {
    /// The folder for what is kept between runs: `$XDG_STATE_HOME/katydid`, or what stands for it on other systems.
    pub fn usual_state() -> Option<PathBuf> {
        let variable =
            |name: &str| std::env::var_os(name).map(PathBuf::from).filter(|path| path.is_absolute());
        let state = variable("XDG_STATE_HOME")
            .or_else(|| variable("LOCALAPPDATA"))
            .or_else(|| Some(variable("HOME")?.join(".local").join("state")))?;
        Some(state.join("katydid"))
    }

    /// The file in which a studio that lets assistants in tells its address, token included, to programs of the same user.
    pub fn address_file(state: &std::path::Path) -> PathBuf {
        state.join("studio-address")
    }

    /// Who works on the documents: whoever runs it alone, who knows the token, or others too.
    pub(crate) fn trust(&self) -> Trust {
        let folders = self.folders.clone();
        if self.is_local() { Trust::own(folders) } else { Trust::shared(folders) }
    }

    /// Whether nobody but this machine can reach it.
    pub fn is_local(&self) -> bool {
        self.address.is_loopback()
    }
}
