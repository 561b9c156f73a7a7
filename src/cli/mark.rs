//! `vibank mark`

use serde_json::{Value as Json, json};
use vibank::grade::request;

use super::bank::BankArgument;
use super::{Failure, Outcome, lines, solve};

/// Mark one response, or those of a script.
///
/// Example: vibank mark ch2/e8-springs-parallel-series k_par "500 N/m" --set "k1=200 N/m" --set "k2=300 N/m"
#[derive(clap::Args)]
pub(crate) struct Arguments {
    /// The item.
    #[arg(required_unless_present = "jsonl")]
    item: Option<String>,
    /// The part.
    #[arg(required_unless_present = "jsonl")]
    part: Option<String>,
    /// What was answered.
    #[arg(required_unless_present = "jsonl", allow_hyphen_values = true)]
    response: Option<String>,
    /// A value for a parameter, such as m=2kg.
    #[arg(long = "set", value_name = "NAME=VALUE")]
    set: Vec<String>,
    /// Draw what is not set from this seed.
    #[arg(long)]
    seed: Option<u64>,
    /// Print JSON.
    #[arg(long)]
    json: bool,
    /// Read requests from standard input, one JSON object a line.
    #[arg(long, conflicts_with_all = ["item", "part", "response", "set", "seed"])]
    jsonl: bool,
    #[command(flatten)]
    bank: BankArgument,
}

pub(crate) fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let catalogue = arguments.bank.catalogue()?;
    if arguments.jsonl {
        return lines::answer(|line| request::answer(&catalogue, line));
    }
    let line = json!({
        "id": arguments.item,
        "part": arguments.part,
        "response": arguments.response,
        "set": solve::settings(&arguments.set)?,
        "seed": arguments.seed,
    });
    let reply = request::answer(&catalogue, &line.to_string());
    let value: Json = serde_json::from_str(&reply).expect("the reply is JSON");
    if let Some(error) = value.get("error") {
        return Err(Failure::new(error["message"].as_str().unwrap_or_default()));
    }
    if arguments.json {
        println!("{reply}");
    } else {
        println!(
            "{}, credit {}",
            value["verdict"].as_str().unwrap_or_default(),
            value["credit"]
        );
        if let Some(text) = value["text"].as_str() {
            println!("read as {text}");
        }
        for feedback in value["feedback"].as_array().into_iter().flatten() {
            println!("{}", feedback.as_str().unwrap_or_default());
        }
    }
    Ok(if value["verdict"] == "right" {
        Outcome::Done
    } else {
        Outcome::Findings
    })
}
