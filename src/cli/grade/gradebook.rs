//! The marks as a platform imports them into its gradebook: one row a student.
//!
//! Moodle: <https://docs.moodle.org/en/Grade_import>; who has no mark yet is not in the file, since an empty cell of a new
//! column is taken for a grade there (`grade/import/csv/classes/load_data.php`). A student whom it does not know stops the
//! import. Canvas: the columns of its own export in their order, with the points that are possible in the second row; an
//! empty cell changes nothing (`lib/gradebook_importer.rb`).

use std::collections::BTreeSet;

use vibank::grade;
use vibank::numerics::Rational;
use vibank::source::nearest;
use vibank::worksheet::Csv;

use super::outcome::SheetOutcome;
use crate::cli::Failure;
use crate::cli::folder::Folder;
use crate::cli::platform::CANVAS_ID;
use crate::cli::table::Dialect;

/// A platform with a gradebook.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub(crate) enum GradebookPlatform {
    Moodle,
    Canvas,
}

/// The rows of a gradebook while sheets are marked.
pub(crate) struct Gradebook {
    platform: GradebookPlatform,
    /// The column of the class list by which the platform knows students.
    column: String,
    rows: Vec<Row>,
    most: Rational,
    /// Codes of sheets whose student the platform cannot find.
    unknown: Vec<String>,
}

struct Row {
    id: String,
    /// The number of Canvas itself, where its own report said it.
    canvas: String,
    name: String,
    /// None while something is undecided.
    points: Option<String>,
}

/// The file that is written.
pub(crate) const FILE: &str = "gradebook.csv";

impl Gradebook {
    /// One of students who are known by a column of their list, which has to be one of `columns`.
    pub(crate) fn new(
        platform: GradebookPlatform,
        column: &str,
        columns: &BTreeSet<String>,
    ) -> Result<Self, Failure> {
        let column = column.to_lowercase();
        if columns.is_empty() {
            let failure = Failure::new("the sheets have no names, so that no gradebook takes them");
            return Err(failure.help(
                "remove `--gradebook`; where a blueprint names a class list with `students`, each sheet has its student",
            ));
        }
        if !columns.contains(&column) {
            let near = nearest(&column, columns.iter().map(String::as_str));
            let near = near.map_or_else(String::new, |near| format!("did you mean `{near}`? "));
            let all = columns.iter().map(String::as_str).collect::<Vec<_>>();
            let failure = Failure::new(format!("the class list has no column `{column}`"));
            let help = format!("{near}`--gradebook-id` can be {}", all.join(", "));
            return Err(failure.help(help));
        }
        Ok(Self {
            platform,
            column,
            rows: Vec::new(),
            most: Rational::ZERO,
            unknown: Vec::new(),
        })
    }

    pub(crate) fn add(&mut self, sheet: &SheetOutcome, is_absent: bool) {
        let id = sheet.column(&self.column);
        if id.is_empty() {
            self.unknown.push(sheet.code.clone());
            return;
        }
        self.most = self.most.max(sheet.max());
        let is_decided = sheet.undecided().0 == 0 && !is_absent;
        let points = grade::rounded(sheet.points());
        self.rows.push(Row {
            id: id.to_owned(),
            canvas: sheet.column(CANVAS_ID).to_owned(),
            name: sheet.column("name").to_owned(),
            points: is_decided.then_some(points),
        });
    }

    /// The heading under which the platform looks for students.
    fn heading(&self) -> &str {
        match (self.platform, self.column.as_str()) {
            (GradebookPlatform::Moodle, "id") => "ID number",
            (GradebookPlatform::Moodle, "email") => "Email address",
            (GradebookPlatform::Moodle, "username") => "Username",
            (GradebookPlatform::Canvas, "id") => "SIS User ID",
            (GradebookPlatform::Canvas, "email" | "username" | "login") => "SIS Login ID",
            (GradebookPlatform::Canvas, _) => "ID",
            (GradebookPlatform::Moodle, other) => other,
        }
    }

    /// Writes the file, with a column for a title; what the platform cannot find is returned.
    pub(crate) fn finish(self, out: &Folder, title: &str) -> Result<Vec<String>, Failure> {
        let dialect = Dialect::new(Csv::Plain, '.');
        let heading = self.heading();
        let mut table = match self.platform {
            GradebookPlatform::Moodle => dialect.head(&[heading, title])?,
            GradebookPlatform::Canvas => {
                let columns = [
                    "Student",
                    "ID",
                    "SIS User ID",
                    "SIS Login ID",
                    "Section",
                    title,
                ];
                let mut table = dialect.head(&columns)?;
                let most = grade::rounded(self.most);
                table.extend(dialect.line(&["Points Possible", "", "", "", "", &most])?);
                table
            }
        };
        for row in &self.rows {
            table.extend(match self.platform {
                GradebookPlatform::Moodle => match &row.points {
                    Some(points) => dialect.line(&[&row.id, points])?,
                    None => continue,
                },
                GradebookPlatform::Canvas => {
                    let [id, user, login] = ["ID", "SIS User ID", "SIS Login ID"].map(|own| {
                        if own == heading && row.id != row.canvas {
                            row.id.as_str()
                        } else {
                            ""
                        }
                    });
                    let id = if row.canvas.is_empty() {
                        id
                    } else {
                        &row.canvas
                    };
                    dialect.line(&[
                        &row.name,
                        id,
                        user,
                        login,
                        "",
                        row.points.as_deref().unwrap_or_default(),
                    ])?
                }
            });
        }
        out.write(FILE, &table)?;
        Ok(self.unknown)
    }
}
