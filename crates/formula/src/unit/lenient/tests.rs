use proptest::prelude::*;

use super::*;

/// What is typed, and what files would have; the catalogue of notations that students use.
const READINGS: [(&str, &str); 116] = [
    ("", "1"),
    ("1", "1"),
    ("N·m/rad", "N m/rad"),
    ("N m/rad", "N m/rad"),
    ("N*m/rad", "N m/rad"),
    ("N⋅m/rad", "N m/rad"),
    ("N.m/rad", "N m/rad"),
    ("N-m/rad", "N m/rad"),
    ("Nm/rad", "N m/rad"),
    ("Nm per rad", "N m/rad"),
    ("newton metres per radian", "N m/rad"),
    ("Newton-meter/radian", "N m/rad"),
    ("kg m²", "kg m^2"),
    ("kg*m^2", "kg m^2"),
    ("kgm^2", "kg m^2"),
    ("kg m2", "kg m^2"),
    ("kg·m**2", "kg m^2"),
    ("kg-m^2", "kg m^2"),
    ("kg square metres", "kg m^2"),
    ("kilogram metres squared", "kg m^2"),
    ("N/(m/s)", "N s/m"),
    ("N/(m·s⁻¹)", "N s/m"),
    ("N s/m", "N s/m"),
    ("N.s/m", "N s/m"),
    ("Ns/m", "N s/m"),
    ("N·s·m⁻¹", "N s m^-1"),
    ("N s m-1", "N s m^-1"),
    ("Nms/rad", "N m s/rad"),
    ("Nms", "N m s"),
    ("Nmm", "N mm"),
    ("Nmm/rad", "N mm/rad"),
    ("kNm", "kN m"),
    ("mNm", "mN m"),
    ("mAh", "mA h"),
    ("kWh", "kW h"),
    ("Pas", "Pa s"),
    ("Vs/rad", "V s/rad"),
    ("ms", "ms"),
    ("ns", "ns"),
    ("mN", "mN"),
    ("s^-1", "s^-1"),
    ("s^(-1)", "s^-1"),
    ("s^{-1}", "s^-1"),
    ("s⁻¹", "s^-1"),
    ("s-1", "s^-1"),
    ("1/s", "1/s"),
    ("/s", "1/s"),
    ("per second", "1/s"),
    ("1/s²", "1/s^2"),
    ("rad/s", "rad/s"),
    ("rads/s", "rad/s"),
    ("rad/sec", "rad/s"),
    ("rad s-1", "rad s^-1"),
    ("rad.s^-1", "rad s^-1"),
    ("radians per second", "rad/s"),
    ("Rad/s", "rad/s"),
    ("Hz", "Hz"),
    ("hz", "Hz"),
    ("HZ", "Hz"),
    ("kHz", "kHz"),
    ("Khz", "kHz"),
    ("hertz", "Hz"),
    ("rpm", "rpm"),
    ("RPM", "rpm"),
    ("rev/min", "rev/min"),
    ("revolutions per minute", "rev/min"),
    ("cycles/s", "rev/s"),
    ("°", "deg"),
    ("º", "deg"),
    ("deg", "deg"),
    ("degrees", "deg"),
    ("^\\circ", "deg"),
    ("µm", "um"),
    ("μm", "um"),
    ("um", "um"),
    ("micrometres", "um"),
    ("ohm", "ohm"),
    ("Ω", "ohm"),
    ("\u{2126}", "ohm"),
    ("kΩ", "kohm"),
    ("\\Omega", "ohm"),
    ("ohms", "ohm"),
    ("m/s²", "m/s^2"),
    ("m s-2", "m s^-2"),
    ("m/s/s", "m/(s s)"),
    ("N m rad-1", "N m rad^-1"),
    ("1/s/s", "1/(s s)"),
    ("metres per second squared", "m/s^2"),
    ("m·s^{-2}", "m s^-2"),
    ("\\mathrm{m/s^2}", "m/s^2"),
    ("\\frac{m}{s^2}", "m/s^2"),
    ("\\mathrm{N\\,m}", "N m"),
    ("\\text{rad s}^{-1}", "rad s^-1"),
    ("\\mathrm{m/s}^2", "m/s^2"),
    ("\\frac{\\mathrm{N}}{\\mathrm{m}}", "N/m"),
    ("N/m²", "N/m^2"),
    ("KN/m", "kN/m"),
    ("J/(kg·K)", "J/(kg K)"),
    ("kg^(-1/2)", "kg^(-1/2)"),
    ("kg^-0.5", "kg^(-1/2)"),
    ("kg^-1/2", "kg^(-1/2)"),
    ("s ^ -1", "s^-1"),
    ("[N/m]", "N/m"),
    ("milli meters", "mm"),
    ("Milli-J", "mJ"),
    ("milli N s/m", "mN s/m"),
    ("micro seconds squared", "us^2"),
    ("kilo newton metres", "kN m"),
    ("mAmp", "mA"),
    ("msec", "ms"),
    ("kOhm", "kohm"),
    ("Nsec/m", "N s/m"),
    ("kNmsec", "kN m s"),
    ("mtr", "m"),
    ("mps", "m/s"),
    ("radps", "rad/s"),
];

#[test]
fn reads_what_people_type() {
    for (typed, meant) in READINGS {
        let unit =
            unit(typed).unwrap_or_else(|error| panic!("`{typed}`: {error} at {:?}", error.span));
        assert_eq!(unit.to_string(), meant, "`{typed}`");
    }
}

#[test]
fn asks_back_where_the_meaning_is_not_clear() {
    for (typed, place, message) in [
        (
            "N/m s",
            "s",
            "a product after a slash may belong above or below it",
        ),
        (
            "J/kg·K",
            "K",
            "a product after a slash may belong above or below it",
        ),
        ("kgs", "kgs", "`kgs` has more than one meaning"),
        ("mph", "mph", "`mph` is not a known unit"),
        ("radsec", "radsec", "`radsec` is not a known unit"),
        ("mhz", "mhz", "`mhz` is not a known unit"),
        ("milli", "milli", "`milli` is not a known unit"),
        (
            "milli hours",
            "milli hours",
            "`millihours` is not a known unit",
        ),
        ("furlong", "furlong", "`furlong` is not a known unit"),
        ("N/", "", "a unit is missing"),
        ("(N", "", "a parenthesis without its partner"),
        ("N)", ")", "a parenthesis without its partner"),
        ("m^x", "^", "not an exponent"),
        ("m^0", "^0", "not an exponent"),
        ("m^9999", "^9999", "not an exponent"),
        ("N + m", "+", "`+` does not belong here"),
        ("m^2/2", "2", "a number does not belong into a unit"),
        ("N/m/s", "/", "a second slash"),
        ("N m/rad/s", "/", "a second slash"),
        ("m 1", "1", "a number does not belong into a unit"),
        ("°-10°", "1", "a number does not belong into a unit"),
        ("mm-5 mm", "-5", "not an exponent"),
        ("m-2 m", "-", "`-` does not belong here"),
        (
            "rad/s (1.238 Hz)",
            "1",
            "a number does not belong into a unit",
        ),
        ("rad/s or", "or", "`or` is not a known unit"),
        ("N/m * 2", "2", "a number does not belong into a unit"),
    ] {
        let error = unit(typed).unwrap_err();
        assert_eq!(
            (&typed[error.span.clone()], error.to_string().as_str()),
            (place, message),
            "`{typed}`"
        );
    }
}

proptest! {
    #[test]
    fn any_text_is_read_or_refused_in_place(text in any::<String>()) {
        if let Err(error) = unit(&text) {
            prop_assert!(text.get(error.span).is_some());
        }
    }

    #[test]
    fn any_text_of_unit_characters_is_read_or_refused_in_place(text in "[NmskgradHzW°Ω µ·*/^()0-9².{}\\\\-]{0,30}") {
        match unit(&text) {
            Ok(unit) => prop_assert_eq!(Unit::parse(&unit.to_string()), Ok(unit)),
            Err(error) => prop_assert!(text.get(error.span).is_some()),
        }
    }
}
