//! `vibank solve`

use serde::Serialize;
use serde_json::{Map, Value as Json, json};
use vibank::solution::request::{self, SolveRequest, Solved};
use vibank::solution::{Entry, Nested, Session};

use super::bank::BankArgument;
use super::{Failure, Outcome, file_kind, lines};

/// Solve an item for given data, or requests of a script.
///
/// Example: vibank solve ch4/p1-rolling-disk-hub-moment --set m=2kg --set "r=12.5 cm" --json
#[derive(clap::Args)]
pub(crate) struct Arguments {
    /// The id of the item, such as ch2/e8-springs-parallel-series.
    #[arg(required_unless_present = "jsonl")]
    item: Option<String>,
    /// A value for a parameter, such as m=2kg; a bare number is in SI units.
    #[arg(long = "set", value_name = "NAME=VALUE")]
    set: Vec<String>,
    /// Draw what is not set from this seed.
    #[arg(short, long)]
    seed: Option<u64>,
    /// A time in seconds, for functions of time.
    #[arg(long = "at", value_name = "SECONDS")]
    at: Vec<String>,
    /// An answer that is wanted; all without any.
    #[arg(long = "want", value_name = "ANSWER")]
    want: Vec<String>,
    /// Print JSON.
    #[arg(long)]
    json: bool,
    /// Read requests from standard input, one JSON object a line.
    #[arg(long, conflicts_with_all = ["item", "set", "seed", "at", "want"])]
    jsonl: bool,
    /// Print what was computed and what was not.
    #[arg(long)]
    trace: bool,
    #[command(flatten)]
    bank: BankArgument,
}

pub(crate) fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let catalogue = arguments.bank.catalogue()?;
    if arguments.jsonl {
        let mut session = Session::new(&catalogue);
        return lines::answer(|line| request::answer(&mut session, line));
    }
    let request = SolveRequest {
        id: arguments.item.clone().unwrap_or_default(),
        set: settings(&arguments.set)?,
        seed: arguments.seed,
        at: arguments
            .at
            .iter()
            .map(|time| Json::String(time.clone()))
            .collect(),
        want: (!arguments.want.is_empty()).then(|| arguments.want.clone()),
        tag: None,
    };
    let (reply, trace) = request::reply(&mut Session::new(&catalogue), request);
    if arguments.json {
        let text = serde_json::to_string(&reply).expect("a reply is plain data");
        println!("{text}");
    }
    match &reply.outcome {
        request::SolveOutcome::Refused { error } if !arguments.json => {
            let is_unknown = error.code == "unknown-item";
            let other = Some(&reply.id).filter(|_| is_unknown);
            let other = other.and_then(|id| file_kind::not_an_item(id));
            return Err(other.unwrap_or_else(|| Failure::new(error.message.as_str())));
        }
        request::SolveOutcome::Refused { .. } => return Ok(Outcome::Findings),
        request::SolveOutcome::Solved(solved) if !arguments.json => print(&reply.id, solved),
        request::SolveOutcome::Solved(_) => {}
    }
    if let Some(trace) = trace.filter(|_| arguments.trace) {
        eprintln!("computed: {}", trace.computed.join(", "));
        eprintln!("skipped:  {}", trace.skipped.join(", "));
    }
    Ok(Outcome::Done)
}

/// `name=value` pairs.
pub(crate) fn settings(pairs: &[String]) -> Result<Map<String, Json>, Failure> {
    pairs
        .iter()
        .map(|pair| match pair.split_once('=') {
            Some((name, value)) => Ok((name.trim().to_owned(), json!(value.trim()))),
            None => Err(Failure::new(format!("`{pair}` sets nothing"))
                .help("write for example `--set m=2kg`")),
        })
        .collect()
}

fn print(id: &str, solved: &Solved) {
    println!("{id}\n\ngiven");
    for (name, given) in &solved.parameters {
        let unit = Nested::One(given.unit.clone());
        println!(
            "  {name:<12} {} {}",
            Json::from(given.value),
            shown_unit(&unit)
        );
    }
    println!("\nanswers");
    for (id, entry) in &solved.answers {
        println!("  {id:<12} {}", shown(entry));
    }
}

/// An answer on one line.
fn shown(entry: &Entry) -> String {
    if let Some(reason) = &entry.reason {
        return format!("– {reason}");
    }
    match (&entry.si, &entry.value, &entry.text) {
        (Some(si), ..) => {
            let unit = entry.unit.as_ref().map_or_else(String::new, shown_unit);
            format!("{} {unit}", nested(si))
        }
        (None, Some(Nested::One(option)), _) => option.clone(),
        (None, Some(options), _) => nested(options),
        (None, None, text) => text.clone().unwrap_or_default(),
    }
}

fn shown_unit(unit: &Nested<String>) -> String {
    match unit {
        Nested::One(unit) if unit == "1" => String::new(),
        Nested::One(unit) => unit.clone(),
        units => nested(units),
    }
}

/// Values as a program would get them.
fn nested<T: Serialize>(values: &Nested<T>) -> String {
    serde_json::to_string(values).expect("values are plain data")
}
