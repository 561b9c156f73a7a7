//! Marks are read from simulated scans: pages full of writing, turned, drawn out of shape, blurred, faded, speckled and
//! pressed, some with pen strokes over a mark.

mod scan;

use rand::{RngExt as _, SeedableRng as _};
use rand_chacha::ChaCha8Rng;
use vibank::seed::Variant;
use vibank::worksheet::ScanMark;
use vibank_scan::{Grey, mark};

use scan::{Sheet, scanned};

/// How many of these scans are read, with the numbers of those that are not. A wrong reading ends the test.
fn read(scans: std::ops::Range<u64>) -> (u64, Vec<u64>) {
    let mut read = 0;
    let mut unread = Vec::new();
    for number in scans {
        let mut random = ChaCha8Rng::seed_from_u64(20_260_000 + number);
        let printed = ScanMark {
            variant: Variant::new(random.random_range(0..Variant::COUNT)).expect("it is in range"),
            page: random.random_range(1..30),
            is_last: random.random_bool(0.3),
        };
        let mut sheet = Sheet::written(&mut random);
        sheet.stamp(&printed.modules(), &mut random);
        let file = scanned(&sheet, &mut random);
        let page = Grey::read(&file).expect("it is an image");
        match mark(&page) {
            Some(bytes) => {
                assert_eq!(ScanMark::read(&bytes), Some(printed), "scan {number}");
                read += 1;
            }
            None => unread.push(number),
        }
    }
    (read, unread)
}

#[test]
fn marks_of_some_scans_are_read() {
    let (count, unread) = read(0..12);
    assert_eq!(count, 12, "unread: {unread:?}");
}

/// The measure by which this is worth having: 99.5 % of 500 pages.
#[test]
#[ignore = "takes minutes"]
fn marks_of_nearly_all_scans_are_read() {
    let (count, unread) = read(0..500);
    assert!(
        count * 1000 >= 500 * 995,
        "{count} of 500 are read, not {unread:?}"
    );
}

#[test]
fn the_modules_are_those_of_a_code_that_others_read() {
    for number in [0, 1, 0x12_3456_789a, Variant::COUNT - 1] {
        for page in [0, 1, 77, ScanMark::MAX_PAGE] {
            let printed = ScanMark {
                variant: Variant::new(number).expect("it is in range"),
                page,
                is_last: page == 77,
            };
            let modules = printed.modules();
            // A reader of its own, that knows nothing of ours, finds it in a clean picture.
            let at = |x: usize, y: usize| {
                let (x, y) = ((x / 5).wrapping_sub(4), (y / 5).wrapping_sub(4));
                modules
                    .get(y)
                    .is_some_and(|row| x < 21 && row >> x & 1 == 1)
            };
            let mut picture = rqrr::PreparedImage::prepare_from_bitmap(145, 145, at);
            let codes = picture.detect_grids();
            let mut bytes = Vec::new();
            codes[0].decode_to(&mut bytes).expect("it is a code");
            assert_eq!(bytes, printed.bytes());
        }
    }
}

#[test]
fn files_that_are_no_pages_are_refused_and_nothing_panics() {
    let mut random = ChaCha8Rng::seed_from_u64(1);
    let mut sheet = Sheet::written(&mut random);
    sheet.stamp(&[0; ScanMark::WIDTH], &mut random);
    for file in [
        &b""[..],
        b"%PDF-1.7",
        b"\x89PNG\r\n\x1a\n",
        b"\xff\xd8\xff",
        &[0; 99],
    ] {
        assert!(Grey::read(file).is_err());
    }
    let file = scanned(&sheet, &mut random);
    for _ in 0..30 {
        let mut broken = file[..random.random_range(0..file.len())].to_vec();
        for _ in 0..8 {
            let at = random.random_range(0..broken.len().max(1));
            if let Some(byte) = broken.get_mut(at) {
                *byte = random.random_range(0..=255);
            }
        }
        // It may be read in part, or not at all.
        let _ = Grey::read(&broken);
    }
    // A header alone that promises more pixels than any page has.
    let mut large =
        b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR\x7f\xff\xff\xff\x7f\xff\xff\xff\x08\0\0\0\0".to_vec();
    large.extend([0; 64]);
    assert!(Grey::read(&large).is_err());
    for (width, height) in [(1, 1), (64, 64), (4000, 70), (20, 9000)] {
        let chessboard = (0..width * height).map(|at| if at % 3 == 0 { 0 } else { 255 });
        let page = Grey::new(width, height, chessboard.collect()).expect("it is a page");
        assert_eq!(mark(&page), None);
    }
}
