//! A press that plays a part, for the tests of what `vibank` makes of a press: `VIBANK_SCRIPT` names the part.
//!
//! - `good`, and any other name: each job is answered with a file that holds the name and the first line of what was sent.
//! - `echoes`: each job is answered with all that was sent.
//! - `refuses`: each job is refused with a message.
//! - `dies`: the process ends at its second job.
//! - `dies-always`: the process ends at each job.
//! - `hangs`: no job is ever answered.
//! - `babbles`: each job is answered with what is not a reply.
//! - `exchanged`: the process ends at its second job, and the next one has another digest.
//! - `old`: it greets as another version; `foreign`: as one of another protocol; `mute`: not at all.

use std::io::{self, Write};

use vibank_press_protocol::{Greeting, Job, PROTOCOL, Reply};

fn main() -> io::Result<()> {
    #[expect(clippy::disallowed_methods, reason = "the part is named by the test")]
    let script = std::env::var("VIBANK_SCRIPT").unwrap_or_default();
    let (mut jobs, mut replies) = (io::stdin().lock(), io::stdout().lock());
    if script == "mute" {
        return Ok(());
    }
    let version = if script == "old" {
        "0.0.1"
    } else {
        env!("CARGO_PKG_VERSION")
    };
    let greeting = Greeting {
        protocol: PROTOCOL + u32::from(script == "foreign"),
        version: version.to_owned(),
        digest: if script == "exchanged" {
            format!("scripted {}", std::process::id())
        } else {
            format!("scripted {script}")
        },
    };
    greeting.send(&mut replies)?;
    let mut done = 0;
    while let Some(job) = Job::receive(&mut jobs)? {
        done += 1;
        let text = match &job {
            Job::Page { text, .. } => text,
            Job::Figure { svg } => svg,
        };
        match script.as_str() {
            "refuses" => {
                Reply::Refused("unknown variable in line 3".to_owned()).send(&mut replies)?;
            }
            "dies" | "exchanged" if done == 2 => return Ok(()),
            "dies-always" => return Ok(()),
            "hangs" => loop {
                std::thread::park();
            },
            "babbles" => {
                replies.write_all(&[b'?'; 4096])?;
                replies.flush()?;
            }
            "echoes" => Reply::File(text.clone().into_bytes()).send(&mut replies)?,
            _ => {
                let line = text.lines().next().unwrap_or_default();
                Reply::File(format!("%PDF scripted {script}: {line}").into_bytes())
                    .send(&mut replies)?;
            }
        }
    }
    Ok(())
}
