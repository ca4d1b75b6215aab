//! The addresses, in one table: what is routed, described and listed comes from here.

use axum::http::Method;

/// What is asked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Route {
    Home,
    Robots,
    Icon,
    Health,
    Version,
    Time,
    Children,
    Idle,
    Validate,
    Sdk,
    SdkSource,
    RhinoPlugins,
    GrasshopperPlugins,
    Grasshopper,
    Io,
    Geometry,
    Script,
    Jobs,
    Job,
    JobEvents,
    JobResult,
    Metrics,
    OpenApi,
    Docs,
}

impl Route {
    /// Whether it is about work that nobody waits for.
    pub(crate) fn is_of_jobs(self) -> bool {
        matches!(self, Self::Jobs | Self::Job | Self::JobEvents | Self::JobResult)
    }
}

/// How an address is used.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Address {
    pub(crate) route: Route,
    /// In lower case; `{id}` stands for one part, `**` for all that follows.
    pub(crate) path: &'static str,
    /// `GET` stands for `HEAD` too.
    pub(crate) methods: &'static [&'static str],
    /// Whether it is answered without the key: there is nothing behind it.
    pub(crate) is_open: bool,
    pub(crate) what: &'static str,
}

const fn at(
    route: Route,
    path: &'static str,
    methods: &'static [&'static str],
    what: &'static str,
) -> Address {
    Address { route, path, methods, is_open: false, what }
}

const fn open(route: Route, path: &'static str, what: &'static str) -> Address {
    Address { route, path, methods: GET, is_open: true, what }
}

const GET: &[&str] = &["GET"];
const POST: &[&str] = &["POST"];
const BOTH: &[&str] = &["GET", "POST"];

/// All addresses.
pub(crate) const ADDRESSES: &[Address] = &[
    at(Route::Grasshopper, "/grasshopper", POST, "Solves a definition with the values of its inputs"),
    at(Route::Io, "/io", BOTH, "What a definition asks for and gives"),
    at(Route::Jobs, "/jobs", POST, "Solves a definition without keeping the caller waiting"),
    at(
        Route::Job,
        "/jobs/{id}",
        &["GET", "DELETE"],
        "How far a job is; DELETE stops it, or forgets it when it is over",
    ),
    at(Route::JobEvents, "/jobs/{id}/events", GET, "A job's progress as server-sent events"),
    at(Route::JobResult, "/jobs/{id}/result", GET, "What came of a job"),
    at(Route::Geometry, "/rhino/**", BOTH, "A function of RhinoCommon, called with a list of arguments"),
    at(Route::Health, "/healthcheck", GET, "Whether a small definition can be solved now"),
    at(Route::Version, "/version", GET, "The versions of the server and of what it stands for"),
    at(Route::Time, "/servertime", GET, "The server's clock, in UTC"),
    at(Route::Children, "/activechildren", GET, "How many solves can run at a time"),
    at(Route::Idle, "/idlespan", GET, "The seconds since the last solve; -1 when there was none"),
    at(Route::Validate, "/validate", GET, "Whether the key is right"),
    at(Route::RhinoPlugins, "/plugins/rhino/installed", GET, "Plug-ins of Rhino, with their versions"),
    at(
        Route::GrasshopperPlugins,
        "/plugins/gh/installed",
        GET,
        "Plug-ins of Grasshopper, with their versions",
    ),
    at(Route::Sdk, "/sdk", GET, "All functions of geometry, as a page"),
    at(Route::SdkSource, "/sdk/**", GET, "Sources of clients: not supported"),
    at(Route::Script, "/script/**", BOTH, "Scripts: disabled"),
    at(Route::Metrics, "/metrics", GET, "Figures for Prometheus"),
    at(Route::Home, "/", GET, "The name of the server"),
    open(Route::OpenApi, "/openapi.json", "This description"),
    open(Route::Docs, "/docs", "A page that explains the addresses and tries them"),
    open(Route::Robots, "/robots.txt", "Tells search engines to stay away"),
    open(Route::Icon, "/favicon.ico", "An empty icon"),
];

impl Address {
    fn matches(&self, parts: &[&str]) -> bool {
        let mut given = parts.iter();
        for own in self.path.split('/').filter(|own| !own.is_empty()) {
            match (own, given.next()) {
                ("**", Some(_)) => return true,
                ("{id}", Some(_)) => {}
                (own, Some(part)) if own == *part => {}
                _ => return false,
            }
        }
        given.next().is_none()
    }

    pub(crate) fn allows(&self, method: &Method) -> bool {
        let method = if *method == Method::HEAD { "GET" } else { method.as_str() };
        self.methods.contains(&method)
    }

    /// What may be sent, for the header `Allow`.
    pub(crate) fn allowed(&self) -> String {
        let heads: &[&str] = if self.methods.contains(&"GET") { &["HEAD", "OPTIONS"] } else { &["OPTIONS"] };
        [self.methods, heads].concat().join(", ")
    }
}

/// The parts of a path in lower case, without empty ones: `//Grasshopper/` is `grasshopper`.
pub(crate) fn parts(path: &str) -> Vec<String> {
    path.split('/').filter(|part| !part.is_empty()).map(str::to_ascii_lowercase).collect()
}

/// The address that a path means.
pub(crate) fn find(parts: &[String]) -> Option<&'static Address> {
    let parts: Vec<&str> = parts.iter().map(String::as_str).collect();
    ADDRESSES.iter().find(|address| address.matches(&parts))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_in_any_case_and_with_too_many_strokes() {
        let found = |path: &str| find(&parts(path)).map(|address| address.route);
        for path in ["/grasshopper", "//Grasshopper", "/GRASSHOPPER/", "///grasshopper//"] {
            assert_eq!(found(path), Some(Route::Grasshopper), "{path}");
        }
        assert_eq!(found("/"), Some(Route::Home));
        assert_eq!(found(""), Some(Route::Home));
        assert_eq!(found("/jobs"), Some(Route::Jobs));
        assert_eq!(found("/jobs/1"), Some(Route::Job));
        assert_eq!(found("/jobs/1/Events"), Some(Route::JobEvents));
        assert_eq!(found("/Rhino/Geometry/curve/getlength-curve"), Some(Route::Geometry));
        assert_eq!(found("/sdk/csharp"), Some(Route::SdkSource));
        for path in ["/grasshopper/x", "/jobs/1/2", "/rhino", "/..%2fetc/passwd", "/.."] {
            assert_eq!(found(path), None, "{path}");
        }
    }
}
