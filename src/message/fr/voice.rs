//! Formulas and units as they are heard in French.

use crate::math::Voice;

/// The words of French.
pub(crate) static VOICE: Voice = Voice {
    minus: "moins",
    capital: ["", "majuscule"],
    bold: ["", "gras"],
    script: ["", "cursif"],
    double: ["", "ajouré"],
    root: ["racine carrée de", "fin de racine"],
    degree: ["racine de degré", "de"],
    fraction: ["fraction", "fin de fraction"],
    over: "sur",
    above: "au-dessus de",
    sub: ["indice", "fin d’indice"],
    power: ["puissance", "fin de puissance"],
    squared: "au carré",
    cubed: "au cube",
    prime: "prime",
    degrees: "degrés",
    star: "étoile",
    accents: [
        "point",
        "double point",
        "triple point",
        "chapeau",
        "tilde",
        "barre",
        "vecteur",
    ],
    blank: "vide",
    of: "de",
    bounds: ["de", "à"],
    operator: "l’opérateur",
    with: ["avec", "au-dessous"],
    under: "sous",
    brace: "entre accolades horizontales",
    determinant: "déterminant de",
    absolute: ["valeur absolue de", "fin de valeur absolue"],
    matrix: ["matrice", "ligne", "fin de matrice"],
    cases: ["cas", "cas", "fin des cas"],
    line: "ligne",
    per: "par",
    half: "un demi",
    sign,
    letter,
    function,
    // A unit is named in the singular, as in `mètre par seconde`.
    unit: |name| name.french,
};

/// English and French names of signs; those that both have are not among them.
const SIGNS: &[(&str, &str)] = &[
    ("equals", "égale"),
    ("minus", "moins"),
    ("times", "fois"),
    ("open paren", "parenthèse ouvrante"),
    ("close paren", "parenthèse fermante"),
    ("comma", "virgule"),
    ("over", "sur"),
    ("open bracket", "crochet ouvrant"),
    ("close bracket", "crochet fermant"),
    ("open brace", "accolade ouvrante"),
    ("close brace", "accolade fermante"),
    ("is less than", "est inférieur à"),
    ("is greater than", "est supérieur à"),
    ("is at most", "est inférieur ou égal à"),
    ("is at least", "est supérieur ou égal à"),
    ("is not equal to", "est différent de"),
    ("is approximately", "est à peu près égal à"),
    ("bar", "barre"),
    ("semicolon", "point-virgule"),
    ("colon", "deux-points"),
    ("factorial", "factorielle"),
    ("question mark", "point d’interrogation"),
    ("star", "étoile"),
    ("plus or minus", "plus ou moins"),
    ("minus or plus", "moins ou plus"),
    ("divided by", "divisé par"),
    ("composed with", "rond"),
    ("degrees", "degrés"),
    ("infinity", "infini"),
    ("partial", "d rond"),
    ("ell", "l cursif"),
    ("h bar", "h barre"),
    ("real part", "partie réelle"),
    ("imaginary part", "partie imaginaire"),
    ("is identical to", "est identique à"),
    ("is similar to", "est semblable à"),
    ("is asymptotically equal to", "est asymptotiquement égal à"),
    ("is congruent to", "est congru à"),
    ("is proportional to", "est proportionnel à"),
    ("is much less than", "est très inférieur à"),
    ("is much greater than", "est très supérieur à"),
    ("is defined as", "est défini comme"),
    ("equals approximately", "est environ égal à"),
    ("is less than about", "est inférieur à environ"),
    ("is greater than about", "est supérieur à environ"),
    ("to", "tend vers"),
    ("left arrow", "flèche vers la gauche"),
    ("left right arrow", "flèche double"),
    ("implies", "implique"),
    ("is implied by", "est impliqué par"),
    ("if and only if", "si et seulement si"),
    ("maps to", "donne"),
    ("up arrow", "flèche vers le haut"),
    ("down arrow", "flèche vers le bas"),
    ("in equilibrium with", "en équilibre avec"),
    ("in", "appartient à"),
    ("not in", "n’appartient pas à"),
    ("contains", "contient"),
    ("is a subset of", "est inclus dans"),
    ("is a subset of or equals", "est inclus dans ou égal à"),
    ("without", "privé de"),
    ("and", "et"),
    ("or", "ou"),
    ("not", "non"),
    ("for all", "pour tout"),
    ("there is", "il existe"),
    ("the empty set", "l’ensemble vide"),
    ("therefore", "donc"),
    ("because", "car"),
    ("perpendicular", "perpendiculaire"),
    ("is perpendicular to", "est perpendiculaire à"),
    ("is parallel to", "est parallèle à"),
    ("such that", "tel que"),
    ("circled plus", "plus encerclé"),
    ("tensor product", "produit tensoriel"),
    ("dagger", "croix"),
    ("and so on", "et ainsi de suite"),
    ("blank", "vide"),
    ("bullet", "puce"),
    ("open angle bracket", "chevron ouvrant"),
    ("close angle bracket", "chevron fermant"),
    ("open floor", "plancher ouvrant"),
    ("close floor", "plancher fermant"),
    ("open ceiling", "plafond ouvrant"),
    ("close ceiling", "plafond fermant"),
    ("double bar", "double barre"),
    ("the sum", "somme"),
    ("the product", "produit"),
    ("the integral", "intégrale"),
    ("the double integral", "intégrale double"),
    ("the triple integral", "intégrale triple"),
    ("the contour integral", "intégrale de contour"),
    ("the union", "union"),
    ("the intersection", "intersection"),
    ("percent", "pour cent"),
    ("number", "dièse"),
    ("underscore", "tiret bas"),
];

fn sign(english: &'static str) -> &'static str {
    let row = SIGNS.iter().find(|(known, _)| *known == english);
    row.map_or(english, |(_, french)| french)
}

fn letter(name: &'static str) -> &'static str {
    match name {
        "beta" => "bêta",
        "zeta" => "zêta",
        "eta" => "êta",
        "theta" | "Theta" => "thêta",
        "rho" => "rhô",
        "chi" => "khi",
        "omega" | "Omega" => "oméga",
        "ell" => "l cursif",
        same => same,
    }
}

fn function(name: &str) -> Option<&'static str> {
    Some(match name {
        "sin" => "sinus",
        "cos" => "cosinus",
        "tan" => "tangente",
        "exp" => "exponentielle de",
        "ln" => "logarithme népérien de",
        "log" => "logarithme de",
        "arctan" => "arc tangente de",
        "arcsin" => "arc sinus de",
        "arccos" => "arc cosinus de",
        "sinh" => "sinus hyperbolique de",
        "cosh" => "cosinus hyperbolique de",
        "tanh" => "tangente hyperbolique de",
        "lim" => "limite",
        "max" => "maximum",
        "min" => "minimum",
        "det" => "déterminant de",
        "arg" => "argument de",
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::{self, Math, symbol};
    use crate::unit::Unit;

    #[test]
    fn formulas_are_heard_in_french() {
        let x = || symbol("x1");
        let plus = |math: Math| Math::row([math, Math::binary("+"), Math::number("2,5")]);
        for (math, words) in [
            (symbol("Omega"), "oméga majuscule"),
            (x().derivative(2), "x double point indice 1"),
            (Math::letter('r').with_sup(Math::number("2")), "r au carré"),
            (
                Math::root(Math::fraction(plus(symbol("k")), symbol("m"))),
                "racine carrée de fraction k plus 2,5 sur m fin de fraction fin de racine",
            ),
            (
                Math::row([Math::prefix("−"), x(), Math::relation("≤"), symbol("beta")]),
                "moins x indice 1 est inférieur ou égal à bêta",
            ),
        ] {
            assert_eq!(math.spoken(&VOICE), words);
        }
    }

    #[test]
    fn units_are_named_in_french() {
        let named = |unit: &str| Unit::parse(unit).map(|unit| unit.spoken(true, &VOICE));
        assert_eq!(named("N m/rad").as_deref(), Ok("newton mètre par radian"));
        assert_eq!(
            named("mm/s^2").as_deref(),
            Ok("millimètre par seconde au carré")
        );
        assert_eq!(named("rpm").as_deref(), Ok("tour par minute"));
    }

    /// Signs and letters whose words are those of both languages.
    const SAME: &[&str] = &[
        "plus",
        "prime",
        "point",
        "nabla",
        "i",
        "j",
        "angle",
        "triangle",
        "dollar",
        "union",
        "intersection",
    ];

    #[test]
    fn every_sign_has_french_words() {
        for words in math::SIGNS.iter().map(|own| own.words) {
            assert!(SAME.contains(&words) || sign(words) != words, "{words}");
        }
    }
}
