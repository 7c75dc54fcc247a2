//! A browser for tests.

use std::path::PathBuf;

/// Browsers by the names they go by; Debian's package manager knows the first.
pub const BROWSERS: [&str; 5] =
    ["chromium-headless-shell", "chromium", "chromium-browser", "google-chrome", "chrome"];

/// The browser that `LINEAMENT_BROWSER` names, or one that is on the path.
pub fn browser() -> Option<PathBuf> {
    if let Some(named) = std::env::var_os("LINEAMENT_BROWSER") {
        return Some(named.into());
    }
    let paths = std::env::var_os("PATH")?;
    std::env::split_paths(&paths).flat_map(|p| BROWSERS.map(|name| p.join(name))).find(|path| path.is_file())
}
