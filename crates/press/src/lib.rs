//! Prints the pages of vibank: Typst markup becomes a tagged PDF, a figure a PDF of its own size.
//!
//! The same job gives the same bytes on every machine: fonts are embedded, nothing is read but the fonts that a job
//! names, and there is no clock. What the typesetter keeps from text to text never shrinks, so that a long run replaces
//! its press now and then; `vibank` does.
//!
//! ```
//! use vibank_press::{Job, print};
//!
//! let text = "#set document(title: [T])\n#set text(lang: \"en\")\nHello".to_owned();
//! let pdf = print(Job::Page { text, fonts: Vec::new() }).expect("it is sound markup");
//! assert!(pdf.starts_with(b"%PDF-"));
//! ```

mod world;

pub use vibank_press_protocol::{Greeting, Job, PROTOCOL, Reply};

/// What this press says of itself.
pub fn greeting() -> Greeting {
    Greeting {
        protocol: PROTOCOL,
        version: env!("CARGO_PKG_VERSION").to_owned(),
        digest: env!("VIBANK_PRESS_DIGEST").to_owned(),
    }
}

/// The file of a job.
///
/// # Errors
///
/// What the typesetter says is wrong with it, with lines of its text.
pub fn print(job: Job) -> Result<Vec<u8>, String> {
    match job {
        Job::Page { text, fonts } => world::accessible(text, &fonts),
        Job::Figure { svg } => world::picture(framed(&svg)),
    }
}

/// A page as large as its only picture.
fn framed(svg: &str) -> String {
    let mut text =
        String::from("#set page(width: auto, height: auto, margin: 0pt)\n#image(bytes(\"");
    for char in svg.chars() {
        match char {
            '\\' | '"' => text.extend(['\\', char]),
            '\n' => text.push_str("\\n"),
            char if char.is_control() => {}
            char => text.push(char),
        }
    }
    text.push_str("\"), format: \"svg\")");
    text
}
