//! The table of all measurements.

use std::fmt::Write;

use crate::measure::Timing;

/// One measurement: a method on a case of a task.
#[derive(Clone, Debug)]
pub(crate) struct Record {
    pub(crate) task: &'static str,
    pub(crate) case: String,
    pub(crate) method: &'static str,
    /// Tolerance of an integrator.
    pub(crate) tolerance: Option<f64>,
    pub(crate) timing: Timing,
    /// Largest relative error.
    pub(crate) relative_error: f64,
    /// Largest error over the scale of the case.
    pub(crate) scaled_error: f64,
}

/// Digits of the references.
const REFERENCE_DIGITS: u32 = 30;

/// The measurements as comma-separated values with a header.
pub(crate) fn table(records: &[Record]) -> String {
    let build = if cfg!(target_feature = "fma") {
        "fma"
    } else {
        "portable"
    };
    let mut text = String::from(
        "task,case,method,tolerance,ns_per_item,items,max_rel_err,max_scaled_err,ref_digits,build,median_ns\n",
    );
    for record in records {
        let tolerance = record
            .tolerance
            .map_or(String::new(), |tolerance| format!("{tolerance:e}"));
        writeln!(
            text,
            "{},{},{},{tolerance},{:.4},{},{:e},{:e},{REFERENCE_DIGITS},{build},{:.4}",
            record.task,
            record.case,
            record.method,
            record.timing.fast,
            record.timing.items,
            record.relative_error,
            record.scaled_error,
            record.timing.median,
        )
        .expect("a string takes any text");
    }
    text
}
