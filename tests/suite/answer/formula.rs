//! Equal and nearly equal formulas over the domain of the bank.

use super::check;

const DATA: &str = r#"
[parameters]
m = { value = "2 kg", range = "1 .. 5 kg", step = "0.5 kg" }
M = "3 kg"
k = { value = "800 N/m", range = "200 .. 900 N/m", step = "50 N/m" }
k1 = "100 N/m"
k2 = "150 N/m"
c = "4 N s/m"
l = "0.5 m"
g = "9.81 m/s^2"
F = "10 N"
w = "3 rad/s"
mu = "0.2"
v0 = { value = "0.1 m/s", range = "-1 .. 1 m/s", step = "0.1 m/s" }
zeta = "0.1"
R = "5 ohm"
Lh = { value = "0.1 H", symbol = "L" }
Cap = { value = "1e-6 F", symbol = "C" }
[symbols]
x = "m"
theta = "rad"
omega = "rad/s"
[quantities]
omega_n = { formula = "sqrt(k/m)", unit = "rad/s" }
"#;

/// A key, formulas that equal it, and formulas that nearly do.
const CORPUS: &[(&str, &[&str], &[&str])] = &[
    (
        "sqrt(k/m)",
        &[
            "√(k/m)",
            "(k/m)^0.5",
            "(k/m)^(1/2)",
            "sqrt(k)/sqrt(m)",
            "\\sqrt{\\frac{k}{m}}",
            "k/sqrt(k m)",
            "sqrt(4k/4m)",
            "1/sqrt(m/k)",
            "|sqrt(k/m)|",
            "omega_1 = sqrt(k/m)",
            "√(k/m)·1",
        ],
        &[
            "sqrt(m/k)",
            "sqrt(k/m)/(2pi)",
            "sqrt(2k/m)",
            "-sqrt(k/m)",
            "1.000001 sqrt(k/m)",
            "k/m",
            "sqrt(k/(m+M))",
            "sqrt(k1/m)",
            "2π sqrt(k/m)",
            "sqrt(k/m + 1e-6 k/m)",
        ],
    ),
    (
        "sqrt(4*k*m - c^2)/(2*m)",
        &[
            "sqrt(k/m - (c/(2m))^2)",
            "√(k/m − c²/(4m²))",
            "sqrt(k/m) sqrt(1 - c^2/(4 k m))",
            "sqrt(4km-c²)/2m",
            "1/2 sqrt(4k/m - (c/m)^2)",
            "\\frac{\\sqrt{4km-c^2}}{2m}",
            "sqrt(k/m)*sqrt((1 - c/(2 sqrt(km)))(1 + c/(2 sqrt(km))))",
        ],
        &[
            "sqrt(k/m - (c/m)^2)",
            "sqrt(k/m + (c/(2m))^2)",
            "sqrt(k/m)",
            "sqrt(4km - c^2)/m",
            "sqrt(k/m - 2 (c/(2m))^2)",
            "sqrt(k/m - (c/(2m))^2)*1.000001",
        ],
    ),
    (
        "F/(m*sqrt((k/m-w^2)^2+(c*w/m)^2))",
        &[
            "F/sqrt((k - m w^2)^2 + (c w)^2)",
            "(F/k)/sqrt((1 - m w²/k)² + (c w/k)²)",
            "F/|k - m w^2|/sqrt(1 + (c w/(k - m w^2))^2)",
            "F ((k-mw²)²+c²w²)^(-1/2)",
            "F/m/sqrt(k²/m² - 2k/m w² + w^4 + c²w²/m²)",
        ],
        &[
            "F/sqrt((k - m w^2)^2 + c w^2)",
            "F/((k - m w^2) + c w)",
            "F/sqrt((k - m w^2)^2 - (c w)^2)",
            "F/sqrt((k + m w^2)^2 + (c w)^2)",
            "F/|k - m w^2|",
            "F/m/sqrt((k/m-w^2)^2+(2 c w/m)^2)",
        ],
    ),
    (
        "2*pi*sqrt(l/g)",
        &[
            "2π√(l/g)",
            "2pi/sqrt(g/l)",
            "π sqrt(4 l/g)",
            "6.283185307179586 sqrt(l/g)",
        ],
        &[
            "2 sqrt(l/g)",
            "2π sqrt(g/l)",
            "6.3 sqrt(l/g)",
            "6.29 sqrt(l/g)",
            "6.283186 sqrt(l/g)",
            "2*pi*sqrt(2*l/g)",
        ],
    ),
    (
        "m*g*l*(1 - cos(theta))",
        &[
            "mgl(1-cosθ)",
            "mgl - mgl cos θ",
            "2mgl sin²(θ/2)",
            "2 m g l sin(theta/2)^2",
            "m g l (1 - cos(-theta))",
        ],
        &[
            "m g l θ²/2",
            "-mgl cos θ",
            "mgl(1+cosθ)",
            "mgl sin²θ",
            "mgl(1 - sin θ)",
            "m g (1 - cos theta)",
        ],
    ),
    (
        "k1*k2/(k1 + k2)",
        &[
            "1/(1/k1 + 1/k2)",
            "(1/k1+1/k2)^-1",
            "k_1 k_2/(k_1+k_2)",
            "k1 - k1²/(k1+k2)",
            "\\frac{k_1k_2}{k_1+k_2}",
        ],
        &[
            "k1 + k2",
            "k1 k2/(k1 - k2)",
            "2 k1 k2/(k1+k2)",
            // Modulo a prime these are no more than the key.
            "2^61 k1 k2/(k1+k2)",
            "2305843009213693952 k1 k2/(k1+k2)",
            "2^122 k1 k2/(k1+k2)",
            "k1 k2/(k1+k2) + (2^61-1) k1",
            "k1 k2/(k1+k2) + (2^61-31) k1",
            "k1 k2/(k1+k2) + (2^61-1)(2^61-31) k1",
            "(k1+k2)/4",
            "1/k1 + 1/k2",
        ],
    ),
    (
        "m*l^2 + M*(l/2)^2 + M*l^2/12",
        &[
            "ml² + Ml²/3",
            "(m + M/3) l²",
            "(3m+M)l^2/3",
            "1/3 (3m + M) l l",
        ],
        &[
            "ml² + Ml²/12",
            "ml + Ml²/3",
            "(m + M) l²/3",
            "ml^2 + M l^2/3.000001",
        ],
    ),
    (
        "abs(v0)/sqrt(k/m)",
        &["|v0| sqrt(m/k)", "sqrt(v0^2 m/k)", "|v_0|/sqrt(k/m)"],
        &["v0 sqrt(m/k)", "-v0 sqrt(m/k)", "v0^2 m/k"],
    ),
    (
        "(x - l)^7",
        &[
            "x^7 - 7x^6 l + 21x^5 l^2 - 35x^4 l^3 + 35x^3 l^4 - 21x^2 l^5 + 7x l^6 - l^7",
            "-(l - x)^7",
        ],
        &[
            "(l - x)^7",
            "x^7 - 7x^6 l + 21x^5 l^2 - 35x^4 l^3 + 35.00001x^3 l^4 - 21x^2 l^5 + 7x l^6 - l^7",
        ],
    ),
    (
        "R + i*w*Lh + 1/(i*w*Cap)",
        &[
            "R + iwL - i/(wC)",
            "R + j w L + 1/(j w C)",
            "R + i(wL - 1/(wC))",
            "R + (1 - w² L C)/(i w C)",
        ],
        &[
            "R + iwL + i/(wC)",
            "R + w L - 1/(w C)",
            "R - i(wL - 1/(wC))",
            "R",
        ],
    ),
    (
        "atan2(c*w, k - m*w^2)",
        &["atan2(c w, k - m w²)"],
        &[
            "atan2(k - m w^2, c w)",
            "atan(c w/(k - m w^2))",
            "atan2(c w, k + m w²)",
        ],
    ),
    (
        "zeta/sqrt(1 - zeta^2)",
        &["ζ/√(1-ζ²)", "1/sqrt(1/ζ² - 1)", "tan(asin(ζ))"],
        &["ζ", "ζ sqrt(1-ζ²)", "ζ/(1-ζ²)", "ζ(1 + ζ²/2)"],
    ),
];

#[test]
fn equal_formulas_are_right_and_near_ones_wrong() {
    for (key, equal, near) in CORPUS {
        let responses: Vec<(&str, &str)> = equal
            .iter()
            .map(|response| (*response, "right"))
            .chain(near.iter().map(|response| (*response, "wrong")))
            .collect();
        let item = format!(
            "{DATA}[[part]]\nid = \"p\"\nkind = \"formula\"\nask = \"Find it.\"\nkey = \"{key}\"\n"
        );
        check(&item, &responses);
    }
}

#[test]
fn what_is_wrong_is_said() {
    let item = format!(
        "{DATA}[[part]]\nkind = \"formula\"\nask = \"Find it.\"\nkey = \"omega_n\"\nin = [\"m\", \"k\", \"c\"]\n\
         mistakes = [{{ answer = \"sqrt(m/k)\", unit = \"s\", feedback = \"Upside down.\" }}, {{ with = {{ k = \"2*k\" }}, feedback = \"One spring.\" }}]\n"
    );
    check(
        &item,
        &[
            ("sqrt(k/m)", "right matches"),
            ("sqrt(m/k)", "wrong mistake-1"),
            ("sqrt(2k/m)", "wrong mistake-2"),
            ("k/m", "wrong dimension"),
            ("k + m", "wrong dimension"),
            ("sqrt(k/m)/(2π)", "wrong two-pi"),
            // Wrong by either reading, so that nothing is asked.
            ("1/2π sqrt(k/m)", "wrong other"),
            ("-sqrt(k/m)", "wrong sign"),
            ("1.00001sqrt(k/m)", "wrong near"),
            ("3 sqrt(k/m)", "wrong other"),
            ("20 rad/s", "unreadable"),
            ("20", "unreadable"),
            ("omega_n", "unreadable"),
            // A datum of the statement, though not one that the key is printed in.
            ("sqrt(k1/m)", "wrong other"),
            ("sqrt(k9/m)", "unreadable"),
            ("sqrt(k/m", "unreadable"),
            ("", "missing"),
        ],
    );
}

#[test]
fn slips_are_named_by_what_they_are() {
    let part = |key: &str, more: &str| {
        format!(
            "{DATA}[[part]]\nid = \"p\"\nkind = \"formula\"\nask = \"Find it.\"\nkey = \"{key}\"\n{more}\n"
        )
    };
    check(
        &part("2*pi*m*g", ""),
        &[
            ("m g", "wrong two-pi: It is off by a factor of 2π."),
            ("0", "wrong other: This is zero"),
            ("2 m g", "wrong other: off by a constant factor"),
            ("6.3 m g", "wrong near"),
            ("6.28 m g", "unreadable: Its numbers are rounded"),
            ("6.2832 m g", "right matches: its numbers are rounded"),
            ("6.285 m g", "wrong near"),
            ("2π m q g", "unreadable: At `q`"),
            ("2π mgQ", "unreadable: At `Q`"),
            ("2π gamma m", "unreadable: At `gamma`"),
            ("2π G m", "right"),
            ("2π m g/H", "unreadable: At `H`"),
            ("2π m2 g", "unreadable: did you mean `m^2`?"),
            ("2π m g;", "right"),
            ("2.*π.*m.*g", "right"),
            ("2*np.pi*m*g", "right"),
            ("2*PI*m.g", "right"),
        ],
    );
    check(
        &part(
            "1*R",
            "mistakes = [{ answer = \"i*R\", unit = \"ohm\", feedback = \"It is in phase.\" }]",
        ),
        &[
            ("i R", "wrong mistake-1"),
            ("R + 0j", "right"),
            ("2i R", "wrong"),
        ],
    );
    check(
        &part("sqrt(R^2 + (w*Lh)^2)", ""),
        &[
            ("|R + i w L|", "right"),
            ("R + i w L", "unreadable: At `i`"),
            ("sqrt(R² + 2 w²L²)", "wrong"),
        ],
    );
    check(
        &part("l*sin(2*theta)", ""),
        &[
            ("l sin2θ", "right"),
            ("l sin 2θ", "right"),
            ("l cos2θ", "wrong"),
            ("l sin(2θ°)", "unreadable: At `°`"),
        ],
    );
}
