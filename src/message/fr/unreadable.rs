//! Pourquoi une réponse n’a pas pu être lue : why a response could not be read.

use super::{capital, listed};
use crate::answer::{At, Example, Trouble, Unreadable, Why};
use crate::quantity::Absent;
use crate::unit::{DecimalMark, ErrorKind};

/// What is said where a response could not be read.
pub(crate) fn unreadable(unreadable: &Unreadable) -> String {
    let why = why(&unreadable.why);
    let mut sentence = match &unreadable.at {
        _ if why.is_empty() => String::new(),
        Some(At::Here(place)) => format!("À « {place} » : {why}"),
        Some(At::Behind(place)) => format!("Après « {place} » : {why}"),
        None => capital(&why),
    };
    if let Some(symbol) = unreadable.undefined() {
        sentence.push_str(&format!(" Ou ajoutez ce que c’est : `…, {symbol} = …`."));
    }
    if let Some(example) = unreadable.example {
        if !sentence.is_empty() {
            sentence.push(' ');
        }
        sentence.push_str(self::example(example));
    }
    sentence
}

fn example(example: Example) -> &'static str {
    match example {
        Example::Number => {
            "Écrivez un nombre et son unité, par exemple `15,8 rad/s` ou `1,6e-2 m`."
        }
        Example::UnitLast => {
            "Écrivez un nombre et son unité, l’unité à la fin : `15,8 rad/s`, `1,6e-2 m`, `sqrt(2)/2 m`."
        }
        Example::Complex => {
            "Écrivez un nombre complexe et son unité, par exemple `3 - 4i ohm` ou `5∠-53° ohm`."
        }
        Example::Interval => "Écrivez par exemple `0,1 <= x < 0,5`, `x > 2` ou `[0,1 ; 0,5[`.",
        Example::OneValue => "Écrivez-la seule, ou après son nom comme dans `x = 7,78`.",
    }
}

/// Why a response could not be read: a sentence that goes on after a place.
#[expect(clippy::too_many_lines, reason = "a table")]
fn why(why: &Why) -> String {
    match why {
        Why::Form => String::new(),
        Why::TooLong => "c’est trop long pour être lu.".to_owned(),
        Why::LongerThan(bytes) => format!("la réponse dépasse {bytes} octets."),
        Why::NoKey(absent) => no_key(absent),
        Why::Dollar => "le signe dollar n’est pas une unité, et celui-ci n’encadre aucune formule : supprimez-le.".to_owned(),
        Why::Formula(trouble) => formula(trouble),
        Why::Quantity(error) => quantity(&error.kind),
        Why::Dimension(_) => "les dimensions ne s’accordent pas.".to_owned(),

        Why::Letters => "un nombre est demandé, sans lettres.".to_owned(),
        Why::UnitNotLast => "l’unité se place à la fin, après le nombre complet.".to_owned(),
        Why::Counted(word) => format!("écrivez le nombre seul, sans « {word} »."),
        Why::CountedUnit => "écrivez le nombre seul, sans ce qu’il compte.".to_owned(),
        Why::NumberAlone => "un nombre seul est demandé : supprimez ce qu’il compte.".to_owned(),
        Why::TwoSigns(text) => format!("`{text}` commence par deux signes : donnez un seul nombre."),
        Why::NoValue(text) => format!("`{text}` n’a pas de valeur."),
        Why::ExponentMissing(text) => format!(
            "dans `{text}`, l’exposant manque après `e` : écrivez `2e-3`, ou `exp(1)` pour le nombre e."
        ),
        Why::RangeOrDifference(text) => format!(
            "`{text}` peut être un intervalle ou une différence : donnez un seul nombre, ou mettez des espaces autour du signe moins."
        ),
        Why::MixedDegrees => {
            "l’un de ces angles porte le signe des degrés, un autre non.".to_owned()
        }
        Why::TwoUnits => "il y a deux unités.".to_owned(),
        Why::CommaOfThree {
            typed,
            decimal,
            thousands,
        } => format!(
            "la virgule de `{typed}` peut séparer des décimales ou des milliers : écrivez `{decimal}` ou `{thousands}`."
        ),
        Why::PointOrProduct(number) => format!(
            "le point peut être décimal ou tenir lieu de produit. Écrivez une puissance de dix comme dans `{number}e3` ou `{number}*10^3`."
        ),
        Why::BracketAfterNumber => "on ne sait pas s’il s’agit d’un facteur ou d’une autre valeur. Écrivez un seul nombre ; un produit demande son signe, `*`.".to_owned(),
        Why::Inequality => "une seule valeur est demandée.".to_owned(),
        Why::UnitOfZero => "l’autre membre de l’équation a une autre unité. Supprimez celle du zéro et vérifiez les termes.".to_owned(),
        Why::UnequalSides(one, other) => {
            format!("`{one}` et `{other}` ne sont pas égaux : donnez une seule valeur.")
        }
        Why::OutsideOfSpan => "la fonction est demandée pour d’autres instants. Supprimez ceux-ci si elle vaut aussi ailleurs.".to_owned(),
        Why::Withdrawn => "ceci dit que la réponse n’est pas retenue. Écrivez seulement celle que vous retenez.".to_owned(),
        Why::UnclearSide => "on ne sait pas de quoi c’est la valeur. Écrivez-la seule, ou après le nom de ce qui est demandé, comme dans `x = 7,78`.".to_owned(),
        Why::TooManyTurns { times, turn } => format!(
            "c’est plus de {times} fois {} : donnez la valeur à un tour près.",
            turn.text(DecimalMark::Comma)
        ),
        Why::Gram => "`g` est le gramme : écrivez `g0` pour l’accélération de la pesanteur.".to_owned(),
        Why::AngleInUnit(asked) => {
            format!("un angle n’entre pas ainsi dans l’unité ; la réponse est demandée en {}.", asked.text())
        }
        Why::OtherQuantity => {
            "ceci nomme une autre grandeur que celle qui est demandée. Donnez la réponse seule.".to_owned()
        }
        Why::LabelsInOtherOrder => {
            "la plus petite de ces valeurs porte le premier symbole : donnez les valeurs sans symboles, ou échangez-les.".to_owned()
        }
        Why::LabelTwice => {
            "deux valeurs portent ce symbole : donnez les valeurs sans symboles, ou à chacune le sien."
                .to_owned()
        }
        Why::EmptyPlace => "il manque une valeur ici.".to_owned(),
        Why::MostNumbers(most) => format!("une liste contient au plus {most} nombres."),
        Why::TightComma => "une virgule entre des chiffres peut être décimale : séparez les nombres par des points-virgules, comme dans `5 ; 8,7`.".to_owned(),
        Why::AngleWithoutUnit(angle) => {
            format!("l’angle `{angle}` n’a pas d’unité : est-il en degrés ? Écrivez `{angle}°`.")
        }
        Why::AngleUnit => "un angle est en degrés ou en radians.".to_owned(),
        Why::SeveralComplex => "un seul nombre complexe est demandé.".to_owned(),

        Why::NoOption(last) => format!("ce n’est aucun des choix : écrivez une lettre de a à {last}."),
        Why::OneOption => "un seul choix est demandé : écrivez une lettre.".to_owned(),
        Why::Ranking(count) => format!("donnez les {count} lettres, chacune une fois, dans l’ordre."),

        Why::JoinInequalities => "reliez les inégalités par `ou`, ou par `et`.".to_owned(),
        Why::NoneSatisfies(text) => format!("aucune valeur ne vérifie `{text}`. Reliez les intervalles par `ou`."),
        Why::LongChain => "cette suite d’inégalités est trop longue.".to_owned(),
        Why::SameWay => "les deux signes vont dans le même sens.".to_owned(),
        Why::NoInterval => "ni signe d’inégalité ni intervalle.".to_owned(),
        Why::BeforeInterval(symbol) => format!(
            "seul `{symbol} in` peut précéder l’intervalle des valeurs demandées ; plusieurs intervalles se relient par `ou`."
        ),
        Why::IntervalBracket => "il manque un crochet.".to_owned(),
        Why::NoUnit => "ce n’est pas une unité connue.".to_owned(),
        Why::TwoEnds => {
            "un intervalle a deux bornes ; avec des virgules décimales, séparez-les par un point-virgule.".to_owned()
        }
        Why::SolveForDistance(symbol) => format!("isolez d’abord `{symbol}` ou `|{symbol}|`."),
        Why::SolveFor(symbol) => format!("isolez d’abord `{symbol}`."),
        Why::NotInInequality(symbol) => format!("`{symbol}` ne figure pas dans cette inégalité."),
        Why::BoundsOrder => "la borne inférieure dépasse la borne supérieure.".to_owned(),
        Why::BoundsAsFormulas => "donnez les bornes par des formules littérales.".to_owned(),
        Why::BoundsAsNumbers => "donnez les bornes par des nombres.".to_owned(),
        Why::BoundValue => "ceci n’a pas de valeur.".to_owned(),

        Why::FormulaNotNumber => {
            "une formule littérale est demandée, pas un nombre : donnez-la sans sa valeur.".to_owned()
        }
        Why::Incomparable => {
            "cette formule ne peut pas être comparée ; écrivez-la plus simplement.".to_owned()
        }
        Why::DigitsLost => "tous les chiffres se perdent dans ce calcul, qui ne peut donc pas être comparé ; écrivez-le plus simplement.".to_owned(),
        Why::TwoReadings(one, other) => format!(
            "ceci peut se lire `{one}` ou `{other}` : écrivez ce que vous voulez dire."
        ),
        Why::UnitBehindLetters => {
            "les lettres portent leurs unités, et celle-ci ne s’y accorde pas : supprimez-la.".to_owned()
        }
        Why::UnitComesOut(unit) => {
            let own = unit.map_or("un nombre sans dimension".to_owned(), |unit| format!("une grandeur en {}", unit.text()));
            format!("les lettres portent leurs unités, et ceci est déjà {own} : supprimez l’unité.")
        }

        Why::NoEquation => "une équation est demandée : il manque un signe égal.".to_owned(),
        Why::NotInequality => "une équation est demandée, pas une inégalité.".to_owned(),
        Why::EquationNumber => {
            "est-ce le numéro de l’équation ? Supprimez-le ; un facteur s’écrit `2*`.".to_owned()
        }
        Why::InitialState => {
            "donnez l’équation seule ; les conditions initiales n’en font pas partie.".to_owned()
        }
        Why::IncomparableEquation => {
            "cette équation ne peut pas être comparée ; écrivez-la plus simplement.".to_owned()
        }
        Why::Figures { asked, number, has } => {
            format!("{asked} chiffres significatifs sont demandés, `{number}` en a {has}.")
        }
        Why::RoundedNumbers => {
            "ses nombres sont arrondis ; donnez-les exactement, par des fractions, des racines ou des multiples de π."
                .to_owned()
        }
        Why::ValuesForLetters => {
            "écrivez cela avec les lettres de l’énoncé, pas avec leurs valeurs.".to_owned()
        }

        Why::EntriesAsNumbers => "donnez les éléments par des nombres.".to_owned(),
        Why::IncomparableEntries => {
            "ces éléments ne peuvent pas être comparés ; écrivez-les plus simplement.".to_owned()
        }
        Why::UnitBehindMatrix => {
            "ceci est de trop après la matrice. Les lettres portent leurs unités : supprimez-le.".to_owned()
        }
        Why::Shape { found, asked } => format!(
            "ceci a {} de {} ; une matrice {} × {} est demandée, par exemple `[[a, b], [c, d]]`, avec une virgule entre les éléments.",
            counted(found.0, "ligne"),
            found.1,
            asked.0,
            asked.1
        ),
        Why::NumbersNotFormulas => "des nombres sont demandés ici, pas des formules.".to_owned(),
        Why::FormulasNotNumbers => "des formules littérales sont demandées ici, pas des nombres.".to_owned(),
        Why::EntryValue => "un élément n’a pas de valeur.".to_owned(),
        Why::UnitOfEntries(unit) => format!("l’unité `{}` ne convient pas à tous les éléments.", unit.text()),

        Why::UnitOfComponents => {
            "les composantes ont des unités différentes : supprimez celle-ci et donnez-les en unités SI.".to_owned()
        }
        Why::UnitOfShape(unit) => format!(
            "cette unité ne convient pas ; une forme de masse modale 1 est en {}.",
            unit.text()
        ),
        Why::ComponentValue => "une composante n’a pas de valeur.".to_owned(),
        Why::Components { found, asked } => format!(
            "ceci a {} ; {asked} sont demandées, comme `(1 ; -0,5)` pour deux.",
            counted(*found, "composante")
        ),
        Why::ShapesOf {
            found,
            rows,
            shapes,
            width,
        } => format!(
            "ceci a {} en {} ; {shapes} formes de {} sont demandées, comme `(1 ; -0,5), (1 ; 2)`.",
            counted(*found, "composante"),
            counted(*rows, "ligne"),
            counted(*width, "composante")
        ),

        Why::UnequalFunctions(last) => format!(
            "les deux membres de l’égalité avant `{last}` ne sont pas la même fonction : donnez-en une seule."
        ),
        Why::UnitOrQuantity => "une lettre peut être ici une unité ou une grandeur : donnez les nombres en unités SI, sans unité.".to_owned(),
        Why::AngleAdded => {
            "un angle est ajouté à la fonction : mettez des parenthèses, comme dans `cos(5 t + 30°)`.".to_owned()
        }
        Why::UnitOfArgument => {
            "l'argument d'un sinus, d'une exponentielle ou d'une autre fonction est un nombre ou un angle ; ici, il reste une unité."
                .to_owned()
        }
        Why::UnitOfTerms => "donnez son unité à chaque terme, ou écrivez-en une seule après le tout.".to_owned(),
        Why::UnitOfFunction(unit) => {
            format!("l’unité ne convient pas ; la réponse est demandée en {}.", unit.text())
        }
        Why::OneFunction(asked) => format!("une seule fonction est demandée ici : {asked} = …."),
        Why::OtherFunction(asked) => format!(
            "{asked} est demandée. Donnez-la seule, ou avec son nom avant le signe égal."
        ),
        Why::UnclearFunction(asked) => format!(
            "on ne sait pas ce que ceci représente ; écrivez {asked} = … ou la fonction seule."
        ),
        Why::Functions(symbols) => {
            let forms: Vec<String> = symbols.iter().map(|symbol| format!("{symbol} = …")).collect();
            format!("donnez une fonction du temps pour chacune, séparées par des points-virgules : {}.", forms.join(" ; "))
        }
        Why::TwoFunctions(symbol) => format!("il y a deux fonctions pour {symbol}."),
        Why::FunctionMissing => "il manque une fonction.".to_owned(),
        Why::TooManyConstants { most, needed } => {
            format!("employez au plus {most} constantes ; {needed} suffisent.")
        }
        Why::Undifferentiable => {
            "ces fonctions ne peuvent pas être dérivées ; écrivez-les plus simplement.".to_owned()
        }
    }
}

/// Why there is no key to mark with. What has no value is named by the item, in the language of the item.
fn no_key(absent: &Absent) -> String {
    match absent {
        Absent::ByHand => {
            "cette question n’est pas notée par le programme : une personne la corrige.".to_owned()
        }
        _ => "cette question ne peut pas être notée pour ces données.".to_owned(),
    }
}

/// What is wrong with a quantity.
fn quantity(kind: &ErrorKind) -> String {
    match kind {
        ErrorKind::Empty => "rien n’est écrit.".to_owned(),
        ErrorKind::TooLong { limit } => format!("c’est plus long que {limit} octets."),
        ErrorKind::NumberMissing => "il manque un nombre.".to_owned(),
        ErrorKind::NotANumber { found } => format!("`{found}` n’est pas un nombre."),
        ErrorKind::TooManyDigits { limit } => {
            format!("il y a plus de {limit} chiffres significatifs.")
        }
        ErrorKind::OutOfRange => "la valeur est hors limites.".to_owned(),
        ErrorKind::AmbiguousComma { found } => {
            format!("la virgule de `{found}` peut séparer des décimales ou des milliers.")
        }
        ErrorKind::UnknownUnit { found } => format!("`{found}` n’est pas une unité connue."),
        ErrorKind::AmbiguousUnit { found, one, other } => {
            format!("`{found}` a plus d’un sens : écrivez `{one}` ou `{other}`.")
        }
        ErrorKind::SecondSlash => {
            "il y a une seconde barre de fraction : mettez des parenthèses.".to_owned()
        }
        ErrorKind::ProductAfterSlash => {
            "un produit après une barre peut être au numérateur ou au dénominateur : mettez des parenthèses.".to_owned()
        }
        ErrorKind::NumberWithinUnit => "un nombre n’a pas sa place dans une unité.".to_owned(),
        ErrorKind::UnitMissing => "il manque une unité.".to_owned(),
        ErrorKind::NotAnExponent => "ce n’est pas un exposant.".to_owned(),
        ErrorKind::TooManyFactors { limit } => format!("il y a plus de {limit} facteurs."),
        ErrorKind::Parenthesis => "une parenthèse n’a pas de partenaire.".to_owned(),
        ErrorKind::Unexpected { found } => format!("« {found} » n’a pas sa place ici."),
        ErrorKind::NotARange => "ce n’est pas un intervalle.".to_owned(),
        ErrorKind::EmptyRange => "l’intervalle se termine avant de commencer.".to_owned(),
        // What the reader of quantities may learn to refuse, until it has words here.
        _ => "ceci n’est pas une grandeur.".to_owned(),
    }
}

/// Why a formula could not be read.
fn formula(trouble: &Trouble) -> String {
    let letters = |words: &str, letters: &[String]| match letters {
        [] => ".".to_owned(),
        all => format!(" ; {words} {}.", listed(all)),
    };
    match trouble {
        Trouble::Unknown {
            near: Some(near), ..
        } => return format!("on ne sait pas ce que cela signifie ; vouliez-vous dire `{near}` ?"),
        Trouble::Unknown {
            near: None,
            letters: known,
        } => {
            return format!(
                "on ne sait pas ce que cela signifie{}",
                letters("les lettres sont", known)
            );
        }
        Trouble::NotAllowed(allowed) => {
            return format!(
                "la réponse ne doit pas contenir ceci{}",
                letters("donnez-la en fonction de", allowed)
            );
        }
        Trouble::Arguments {
            name,
            least: 1,
            most: 1,
        } => return format!("`{name}` prend un argument."),
        Trouble::Arguments { name, least, .. } => {
            return format!(
                "`{name}` prend {least} arguments entre parenthèses ; écrivez les décimales avec un point."
            );
        }
        Trouble::Value(_) => "ce n’est pas un nombre.",
        Trouble::Missing => "il manque une formule ici.",
        Trouble::TooLong => "c’est trop long pour être lu.",
        Trouble::TooDeep => "il y a trop de parenthèses imbriquées.",
        Trouble::Unit => {
            "les unités n’ont pas leur place dans une formule : les lettres portent les leurs, et les nombres sont en unités SI."
        }
        Trouble::Sign => "ce signe n’est pas compris ici.",
        Trouble::Number => "ce nombre a trop de chiffres.",
        Trouble::Bracket => "cette parenthèse n’a pas de partenaire.",
        Trouble::NumberAfter => {
            "il manque un signe avant ce nombre ; écrivez `*` pour un produit ou `^` pour une puissance."
        }
        Trouble::List => {
            "une seule formule est attendue ici, pas une liste ; écrivez les décimales avec un point."
        }
        Trouble::Exponent => {
            "ceci fait-il partie de l’exposant ? Mettez des parenthèses : `e^(-2 t)` ou `e^(-2)*t`."
        }
        Trouble::Logarithm => "écrivez `ln` ou `log10`.",
        Trouble::TwoValues => "donnez une seule valeur, sans `±`.",
        Trouble::Unsolved => {
            "seul le symbole demandé peut précéder un signe égal ; isolez-le et donnez la formule seule."
        }
        Trouble::LeftOver => "ceci est de trop ; manque-t-il un signe avant ?",
        Trouble::NoRelation => "il manque un signe d’égalité ou d’inégalité.",
        Trouble::UnitOfEntry => "donnez une seule unité pour tous, après la liste entre crochets.",
        Trouble::UnitOrLetter => {
            "ceci se termine par une lettre ou par une unité ; mettez la liste entre crochets, et le reste après."
        }
        Trouble::Order => "donnez-les dans l’ordre de la question, en liste et sans noms.",
        Trouble::NamedMatrices => {
            "les noms des matrices ne disent pas ce qu’elles contiennent : écrivez leurs termes, comme dans `det([[a, b], [c, d]])`, ou le déterminant développé."
        }
        Trouble::Determinant => {
            "des barres forment un déterminant ou une norme : mettez une matrice entre crochets."
        }
        Trouble::Ragged => "les lignes sont de longueurs différentes.",
    }
    .to_owned()
}

/// A count with its noun, of which the plural has an s.
fn counted(count: usize, noun: &str) -> String {
    let plural = if count < 2 { "" } else { "s" };
    format!("{count} {noun}{plural}")
}
