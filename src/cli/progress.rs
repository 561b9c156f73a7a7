//! Progress of long work, on standard error of a terminal.

use indicatif::{ProgressBar, ProgressStyle};

/// A bar for `count` things; invisible where standard error is no terminal.
pub(crate) fn bar(count: u64, things: &'static str) -> ProgressBar {
    let style = ProgressStyle::with_template("{bar:32} {pos}/{len} {msg}  {eta}")
        .expect("the template is right");
    ProgressBar::new(count)
        .with_style(style)
        .with_message(things)
}
