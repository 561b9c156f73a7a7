//! Numbers with units: the slips that are diagnosed, and what is asked back.

use vibank::bank::Catalogue;

use super::check;

/// An item with one number.
fn number(key: &str, unit: &str, more: &str) -> String {
    format!(
        "[parameters]\np = \"1 {unit}\"\n[quantities]\nq = {{ formula = \"{key}*p\", unit = \"{unit}\" }}\n[[part]]\nkey = \"q\"\nask = \"Find it.\"\n{more}"
    )
}

#[test]
fn angles_count_by_turns() {
    check(
        &number("-120", "deg", "modulo = \"360 deg\"\ntolerance = \"1 %\"\n"),
        &[
            ("-120°", "right"),
            ("240°", "right"),
            ("-480 deg", "right"),
            ("-2*pi/3 rad", "right"),
            ("-2*pi/3", "right"),
            ("4π/3", "right"),
            ("120°", "wrong sign: other sign"),
            ("-2.0944", "wrong angle-unit"),
            ("60°", "wrong other"),
            ("123°", "wrong other"),
            ("1e30", "unreadable: 100 times 360.0°"),
            ("36240°", "unreadable"),
        ],
    );
    let within = "modulo = \"360 deg\"\nwithin = \"(-180 deg, 180 deg]\"\ntolerance = \"1 %\"\n";
    check(
        &number("-120", "deg", within),
        &[
            ("-120°", "right"),
            ("-2*pi/3", "right"),
            ("240°", "partial other: from −180"),
            ("120°", "wrong sign: other sign"),
        ],
    );
    check(
        &number("180", "deg", within),
        &[
            ("180°", "right"),
            ("-180°", "right"),
            ("540°", "partial other"),
        ],
    );
    check(
        &number("20", "N m/rad", "tolerance = \"1 %\"\n"),
        &[
            ("0.34907 N m/deg", "right"),
            ("20 N m/deg", "wrong angle-unit"),
            ("20 J", "right matches: N·m/rad"),
            ("20 N/m", "wrong dimension: torsional stiffness"),
        ],
    );
}

#[test]
fn slips_are_named() {
    check(
        &number("0.326", "1", ""),
        &[("32.6", "wrong power-of-ten: percent"), ("32.6 %", "right")],
    );
    check(
        &number("0.75", "1/s", ""),
        &[
            ("0.119 Hz", "wrong two-pi: counts cycles"),
            ("0.75 Hz", "right"),
            ("4.712", "wrong two-pi"),
        ],
    );
    check(
        &number("5", "m/s^2", ""),
        &[
            ("5 g", "unreadable: g0"),
            ("5 ms^-2", "right"),
            ("5 km h", "wrong dimension"),
        ],
    );
    check(
        &number("5", "m", ""),
        &[
            ("5 inches", "unreadable: Write `mm`"),
            (
                "5 MM",
                "unreadable: `MM` is not a known unit. Type a number",
            ),
            ("sqrt(k/m)", "unreadable: At `k`: a number is asked"),
            ("2 kg * 9.81 m/s^2", "wrong dimension"),
            ("5 m (16 ft)", "unreadable: At `(`"),
        ],
    );
}

/// A mistake of another dimension is diagnosed by its number, with its unit, with that of the answer or without.
#[test]
fn mistakes_in_another_unit_are_told() {
    let mistakes = "tolerance = \"1 %\"\nmistakes = [{ answer = \"q^2\", unit = \"1/s^2\", feedback = \"Its square.\" }]\n";
    check(
        &number("38.2", "rad/s", mistakes),
        &[
            ("1459 1/s^2", "wrong mistake-1"),
            ("1459", "wrong mistake-1"),
            ("1459 rad/s", "wrong mistake-1"),
            ("57000/39", "wrong mistake-1"),
            ("38.2", "right"),
        ],
    );
}

fn list(more: &str) -> String {
    format!(
        "[parameters]\np = \"5 rad/s\"\n[quantities]\nq = {{ formula = \"[p, 2*p, 3*p]\", unit = \"rad/s\" }}\n[[part]]\nkey = \"q\"\nask = \"Find them.\"\n{more}"
    )
}

#[test]
fn lists_are_read_and_told() {
    check(
        &list(""),
        &[
            ("15; 5; 10 rad/s", "right"),
            ("5, 10, and 15", "right matches: Taken in rad/s"),
            ("5 & 10 & 15", "right"),
            ("5 10 15", "right"),
            ("\\{5,10,15\\}", "right"),
            ("[5 10 15]", "right"),
            ("5,10,15", "right"),
            ("ω1, ω2, ω3 = 5, 10, 15 rad/s", "right"),
            ("ω = 5, 10, 15", "right"),
            ("5,10 , 15", "unreadable: semicolons"),
            ("5,10", "unreadable: semicolons"),
            ("5,0; 10,0; 15,0", "right"),
            ("5 Hz; 10 Hz; 15 Hz", "wrong two-pi"),
            ("-5; -10; -15", "wrong sign"),
            ("5; 10; 16", "partial other: 2 of 3 values are right"),
            ("5; 11; 16", "partial other: 1 of 3 values is right"),
            ("±5, ±10, ±15", "wrong other: but 6 are given"),
            ("2ω = 5; 10; 15", "unreadable"),
            ("5; 10; ω > 15", "unreadable"),
        ],
    );
    check(
        &list("ordered = true\n"),
        &[
            ("5; 10; 15", "right"),
            ("ω3 = 15, ω1 = 5, ω2 = 10", "right"),
            ("ω₃ = 15; ω₁ = 5; ω₂ = 10 rad/s", "right"),
            ("15; 10; 5", "partial other: their order is not"),
            ("10; 5; 16", "wrong other: but in another order"),
            ("15; 5; 10", "wrong other: their order is not"),
        ],
    );
}

#[test]
fn counts_are_bare() {
    check(
        "[parameters]\np = \"3\"\n[[part]]\nid = \"n\"\nkind = \"integer\"\nkey = \"p\"\nask = \"Count.\"\n",
        &[
            ("3", "right"),
            ("n = 3", "right"),
            ("n >= 3", "unreadable"),
            ("3 cycles", "unreadable: Type the number alone"),
            ("3 DOF", "right"),
            ("3 half-cycles", "unreadable"),
            ("3 kg", "wrong dimension"),
            ("2.5", "wrong"),
        ],
    );
}

#[test]
fn an_interval_for_angles_has_two_ends_and_a_period() {
    for (modulo, within, is_sound) in [
        ("modulo = '360 deg'", "(-180 deg, 180 deg]", true),
        ("", "(-180 deg, 180 deg]", false),
        ("modulo = '360 deg'", "(180 deg, -180 deg]", false),
        ("modulo = '360 deg'", "-180 deg, 180 deg", false),
        ("modulo = '360 deg'", "(-180 deg]", false),
        ("modulo = '360 deg'", "(-1 m, 1 m]", false),
    ] {
        let part = number("1", "deg", &format!("{modulo}\nwithin = '{within}'\n"));
        let item =
            format!("[item]\ntitle = 'T'\nsource = 'test'\n[statement]\ntext = 'T.'\n{part}");
        let (_, findings) = Catalogue::load([
            ("bank.toml", "format = 1\ntitle = 'T'\n"),
            ("ch1/_chapter.toml", "title = 'T'\n"),
            ("ch1/test.toml", item.as_str()),
        ]);
        let reported = format!("{findings:?}");
        assert_eq!(
            !reported.contains("not an interval"),
            is_sound,
            "{within}: {reported}"
        );
    }
}
