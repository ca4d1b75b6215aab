//! Links of pages.

/// Where a link leads.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Target {
    /// To an address on the network.
    Elsewhere,
    /// To a part of the same page.
    Here(String),
    /// To a page, and a part of it.
    Page(String, String),
    /// Nowhere.
    Wrong(&'static str),
}

/// Reads the target of a link: an address with https, `#part`, or the folder of a page.
pub(crate) fn read(target: &str) -> Target {
    if let Some(rest) = target.strip_prefix("https://") {
        let host = rest.split('/').next().unwrap_or_default();
        let is_host = host.contains('.') && !host.contains(char::is_whitespace) && !host.contains('@');
        return if is_host { Target::Elsewhere } else { Target::Wrong("this is no address") };
    }
    if target.starts_with("http://") {
        return Target::Wrong("links go to https addresses");
    }
    if let Some(id) = target.strip_prefix('#') {
        return Target::Here(id.to_owned());
    }
    if target.contains(':') || target.starts_with('/') || target.starts_with('.') || target.is_empty() {
        return Target::Wrong("a link is an https address, #part or the folder of a page");
    }
    let (folder, id) = target.split_once('#').unwrap_or((target, ""));
    Target::Page(folder.trim_end_matches('/').to_owned(), id.to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn links_lead_to_pages_and_addresses() {
        assert_eq!(read("https://developer.rhino3d.com/guides/"), Target::Elsewhere);
        assert_eq!(read("V8#formula"), Target::Page("V8".to_owned(), "formula".to_owned()));
        assert_eq!(read("#try"), Target::Here("try".to_owned()));
        for wrong in ["http://a.b", "javascript:alert(1)", "/etc", "../V8", "", "https://nohost"] {
            assert!(matches!(read(wrong), Target::Wrong(_)), "{wrong}");
        }
    }
}
