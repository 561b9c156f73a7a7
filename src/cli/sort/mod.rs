//! `vibank sort SCANS…`

mod reader;

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::io::Read as _;
use std::path::{Path, PathBuf};

use vibank::worksheet::{Student, file_stem};

use self::reader::{Reader, Reading};
use super::folder::Folder;
use super::grade::manifest;
use super::sheet::MANIFESTS;
use super::{Failure, Outcome, counted, file_kind, files};

/// Sort scanned pages by sheet and page, which it reads from the marks of `scan_marks = true`.
///
/// Each page is an image, PNG or JPEG, of 150 dpi or more, turned as it may be; it is copied, and the scans stay.
/// Each sheet has a folder with its pages, named by the code, or with a manifest by place in the list, id and name. Pages
/// without a mark go to `unsorted`, those of other runs to `foreign`, and a page that is there twice stands there twice.
///
/// Example: vibank sort scans/*.png --manifest midterm
#[derive(clap::Args)]
pub(crate) struct Arguments {
    /// The images, or folders with them.
    #[arg(required = true, value_name = "SCANS")]
    scans: Vec<PathBuf>,
    /// The folder to write to, which is made; in it nothing may be yet.
    #[arg(short, long, value_name = "FOLDER", default_value = "sorted")]
    out: PathBuf,
    /// The manifest of the run that made the sheets, or its folder: for names, other sheets and missing ones.
    #[arg(long, value_parser = file_kind::manifest())]
    manifest: Option<PathBuf>,
}

/// Where pages without a mark go.
const UNSORTED: &str = "unsorted";

/// Where the pages of sheets go that the manifest does not have.
const FOREIGN: &str = "foreign";

/// Most images of one run.
const MAX_SCANS: usize = 20_000;

pub(crate) fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let scans = scans(&arguments.scans)?;
    let names = arguments
        .manifest
        .as_deref()
        .map(SheetNames::read)
        .transpose()?;
    let out = Folder::at(&arguments.out);
    out.hold()?;
    if !out.names("").is_empty() {
        let shown = arguments.out.display();
        return Err(
            Failure::new(format!("there is something in `{shown}` already"))
                .help("name another folder with `--out`"),
        );
    }
    let readings = Reader::find()?.read(&scans)?;
    let mut sorted = Sorted::default();
    for (scan, reading) in scans.iter().zip(readings) {
        sorted.take(scan, reading, names.as_ref());
    }
    out.make()?;
    for (from, to) in &sorted.copies {
        copy(from, &out, to)?;
    }
    let findings = sorted.findings();
    let pages = sorted.sheets.values().map(|sheet| sheet.scans).sum();
    println!(
        "{} of {}, in {}",
        counted(pages, "page"),
        counted(sorted.sheets.len(), "sheet"),
        arguments.out.display()
    );
    for line in &findings {
        println!("  {line}");
    }
    if let Some(names) = &names {
        names.say_missing(&sorted);
    }
    Ok(if findings.is_empty() {
        Outcome::Done
    } else {
        Outcome::Findings
    })
}

/// The files that are meant: those of folders are the images in them, in the order of their names.
fn scans(given: &[PathBuf]) -> Result<Vec<PathBuf>, Failure> {
    let mut scans = Vec::new();
    for path in given {
        if path.is_dir() {
            let images = Folder::at(path).names("").into_iter().filter(|name| {
                let name = name.to_lowercase();
                [".png", ".jpg", ".jpeg"]
                    .iter()
                    .any(|end| name.ends_with(end))
            });
            let count = scans.len();
            scans.extend(images.map(|name| path.join(name)));
            if scans.len() == count {
                let shown = path.display();
                return Err(Failure::new(format!("there is no image in `{shown}`"))
                    .help("scans are PNG or JPEG; `pdftoppm -r 200 -png scans.pdf page` takes the pages out of a PDF"));
            }
        } else {
            // What is not there is said before anything is done.
            files::open(path)?;
            scans.push(path.clone());
        }
    }
    if scans.len() > MAX_SCANS {
        let message = format!("{} scans are more than {MAX_SCANS}", scans.len());
        return Err(Failure::new(message).help("sort them in parts"));
    }
    Ok(scans)
}

/// The sheets of a run by their codes, in the order of the run.
struct SheetNames {
    /// The name of the folder of each.
    stems: BTreeMap<String, String>,
    /// The codes of the last manifest.
    current: Vec<String>,
}

impl SheetNames {
    /// Those of a manifest, and of earlier ones of the same run: what was handed out can be sorted.
    fn read(path: &Path) -> Result<Self, Failure> {
        let mut names = Self {
            stems: BTreeMap::new(),
            current: Vec::new(),
        };
        let folder = Folder::at(path.parent().unwrap_or(Path::new("")));
        let earlier = folder.names(MANIFESTS).into_iter();
        let earlier = earlier
            .filter(|name| name.ends_with(".json"))
            .map(|name| folder.path(&format!("{MANIFESTS}/{name}")));
        let earlier: Vec<PathBuf> = earlier.collect::<Result<_, _>>()?;
        for path in [path]
            .into_iter()
            .chain(earlier.iter().map(PathBuf::as_path))
        {
            let manifest = manifest(path)?;
            let count = manifest.variants.len();
            let is_first = names.stems.is_empty();
            for (place, entry) in manifest.variants.into_iter().enumerate() {
                let student = entry.student.map(|row| Student {
                    id: row.get("id").cloned().unwrap_or_default(),
                    name: row.get("name").cloned().unwrap_or_default(),
                    ..Student::default()
                });
                let code = entry.code;
                let stem = match &student {
                    Some(student) => file_stem(place, count, Some(student), &code),
                    None => code.clone(),
                };
                if is_first {
                    names.current.push(code.clone());
                }
                names.stems.entry(code).or_insert(stem);
            }
        }
        Ok(names)
    }

    /// Says of which sheets there is no page: who was absent has handed in none.
    fn say_missing(&self, sorted: &Sorted) {
        let missing: Vec<&str> = self
            .current
            .iter()
            .filter(|code| !sorted.sheets.contains_key(*code))
            .filter_map(|code| self.stems.get(code).map(String::as_str))
            .collect();
        if !missing.is_empty() {
            println!("no page of {}:", counted(missing.len(), "sheet"));
            for stem in missing {
                println!("  {stem}");
            }
        }
    }
}

/// What becomes of the scans.
#[derive(Default)]
struct Sorted {
    /// The sheets by their codes.
    sheets: BTreeMap<String, SortedSheet>,
    /// Which file is copied where.
    copies: Vec<(PathBuf, String)>,
    /// Names that are taken.
    taken: BTreeSet<String>,
    /// What is to be looked after, in the order of the scans.
    said: Vec<String>,
}

/// What was found of a sheet.
#[derive(Default)]
struct SortedSheet {
    folder: String,
    scans: usize,
    pages: BTreeSet<u8>,
    /// The number of its pages, once the last one was met.
    last: Option<u8>,
}

impl Sorted {
    fn take(&mut self, scan: &Path, reading: Reading, names: Option<&SheetNames>) {
        let shown = scan.display();
        let mark = match reading {
            Reading::Mark(mark) => mark,
            Reading::None => {
                let to = self.unsorted(scan);
                self.said
                    .push(format!("{shown}: no mark was found; it is {to}"));
                return;
            }
            Reading::Unreadable(why) => {
                let to = self.unsorted(scan);
                self.said.push(format!("{shown}: {why}; it is {to}"));
                return;
            }
        };
        let code = mark.variant.to_string();
        let folder = match names.map(|names| names.stems.get(&code)) {
            None => code.clone(),
            Some(Some(stem)) => stem.clone(),
            Some(None) => {
                self.said
                    .push(format!("{shown}: {code} is not a sheet of this run"));
                format!("{FOREIGN}/{code}")
            }
        };
        let sheet = self.sheets.entry(code).or_default();
        let is_new = mark.page == 0 || sheet.pages.insert(mark.page);
        sheet.scans += 1;
        sheet.folder.clone_from(&folder);
        if mark.is_last {
            sheet.last = sheet.last.max(Some(mark.page));
        }
        // Pages whose number nobody knows stay in the order of the scans.
        let name = match mark.page {
            0 => format!("scan-{:03}", sheet.scans),
            page => format!("page-{page:02}"),
        };
        let to = self.free(&format!("{folder}/{name}"), &ending(scan));
        if !is_new {
            let page = mark.page;
            self.said.push(format!(
                "{shown}: page {page} of {folder} once more, as {to}"
            ));
        }
        self.copies.push((scan.to_owned(), to));
    }

    fn unsorted(&mut self, scan: &Path) -> String {
        let name = scan.file_stem().unwrap_or_default().to_string_lossy();
        let plain = |sign: char| if sign.is_alphanumeric() { sign } else { '-' };
        let name: String = name.chars().map(plain).take(60).collect();
        let place = self.copies.len() + 1;
        let to = self.free(&format!("{UNSORTED}/{place:04}-{name}"), &ending(scan));
        self.copies.push((scan.to_owned(), to.clone()));
        to
    }

    /// A name that no other file has.
    fn free(&mut self, stem: &str, ending: &str) -> String {
        let mut name = format!("{stem}.{ending}");
        let mut times = 1;
        while !self.taken.insert(name.clone()) {
            times += 1;
            name = format!("{stem}-{times}.{ending}");
        }
        name
    }

    /// What is to be looked after.
    fn findings(&self) -> Vec<String> {
        let mut findings = self.said.clone();
        for sheet in self.sheets.values() {
            let Some(highest) = sheet.pages.last() else {
                continue;
            };
            let missing: Vec<String> = (1..=sheet.last.unwrap_or(*highest))
                .filter(|page| !sheet.pages.contains(page))
                .map(|page| page.to_string())
                .collect();
            if !missing.is_empty() {
                let pages = if missing.len() == 1 { "page" } else { "pages" };
                let missing = missing.join(", ");
                findings.push(format!("{}: {pages} {missing} missing", sheet.folder));
            }
            if sheet.last.is_none() {
                findings.push(format!("{}: the last page is missing", sheet.folder));
            }
        }
        findings
    }
}

/// The ending that a copy has: that of the scan, if it is one.
fn ending(scan: &Path) -> String {
    let ending = scan.extension().unwrap_or_default().to_string_lossy();
    let is_plain =
        (1..=5).contains(&ending.len()) && ending.chars().all(|sign| sign.is_ascii_alphanumeric());
    if is_plain {
        ending.to_lowercase()
    } else {
        "bin".to_owned()
    }
}

/// Copies a scan piece by piece.
fn copy(from: &Path, out: &Folder, to: &str) -> Result<(), Failure> {
    let mut file: fs::File = files::open(from)?;
    let mut draft = out.begin(to)?;
    let mut piece = vec![0; 1 << 16];
    loop {
        let length = file.read(&mut piece).map_err(files::unreadable(from))?;
        if length == 0 {
            break;
        }
        draft.write(&piece[..length])?;
    }
    draft.finish()?;
    Ok(())
}

#[cfg(test)]
mod tests {
    use vibank::seed::Variant;
    use vibank::worksheet::ScanMark;

    use super::*;

    fn page(number: u64, page: u8, is_last: bool) -> Reading {
        let variant = Variant::new(number).expect("it is below 2⁴⁰");
        Reading::Mark(ScanMark {
            variant,
            page,
            is_last,
        })
    }

    fn sorted(readings: Vec<Reading>, names: Option<&SheetNames>) -> Sorted {
        let mut sorted = Sorted::default();
        for (number, reading) in readings.into_iter().enumerate() {
            let scan = PathBuf::from(format!("in/s{number}.PNG"));
            sorted.take(&scan, reading, names);
        }
        sorted
    }

    #[test]
    fn no_scan_is_lost_and_none_takes_the_place_of_another() {
        let readings = vec![
            page(1, 2, true),
            page(1, 1, false),
            page(1, 2, true),
            Reading::None,
            page(2, 0, false),
            page(2, 0, false),
            Reading::Unreadable("it is too large".to_owned()),
        ];
        let sorted = sorted(readings, None);
        assert_eq!(sorted.copies.len(), 7);
        assert_eq!(sorted.taken.len(), 7);
        let [one, two] = [1, 2].map(|number| Variant::new(number).expect("small").to_string());
        let to: Vec<&str> = sorted.copies.iter().map(|(_, to)| to.as_str()).collect();
        let expected = [
            format!("{one}/page-02.png"),
            format!("{one}/page-01.png"),
            format!("{one}/page-02-2.png"),
            "unsorted/0004-s3.png".to_owned(),
            format!("{two}/scan-001.png"),
            format!("{two}/scan-002.png"),
            "unsorted/0007-s6.png".to_owned(),
        ];
        assert_eq!(to, expected);
        assert_eq!(sorted.findings().len(), 3);
    }

    #[test]
    fn missing_pages_and_sheets_of_other_runs_are_said() {
        let code = Variant::new(1).expect("small").to_string();
        let names = SheetNames {
            stems: BTreeMap::from([(code.clone(), "001-s1".to_owned())]),
            current: vec![code],
        };
        let readings = vec![page(1, 3, false), page(1, 1, false), page(7, 1, true)];
        let sorted = sorted(readings, Some(&names));
        let findings = sorted.findings();
        assert!(
            findings[0].ends_with("is not a sheet of this run"),
            "{findings:?}"
        );
        assert!(
            findings.contains(&"001-s1: page 2 missing".to_owned()),
            "{findings:?}"
        );
        assert!(findings.contains(&"001-s1: the last page is missing".to_owned()));
        assert!(sorted.copies[2].1.starts_with("foreign/"));
        assert_eq!(findings.len(), 3);
    }
}
