"""Equations of motion, right and wrong, for tests/corpora/equations.tsv.

The systems are those of the bank, their equations derived by hand (or with SymPy's Lagrangian mechanics in `CHECKED`)
and written as lists of terms. Right responses are the equation in another form; wrong ones have one slip, with what has
to be said about it. Each response is checked here by SymPy: right ones are multiples of the equation, wrong ones are not.

    python3 tests/references/equations_of_motion.py > tests/corpora/equations.tsv
"""

import re
import sys

import sympy as sp

# item, part, unknowns, terms: coefficient and what it multiplies ("" stands for the right side).
SYSTEMS = [
    ("ch2/e1-vertical-elastic-pendulum", "eom", ["x"], [("m", "x''"), ("k", "x"), ("m*g - k*x_st", "")]),
    ("ch2/e2-horizontal-elastic-pendulum", "eom", ["x"], [("m", "x''"), ("k", "x")]),
    ("ch2/e5-compound-pendulum", "eom", ["theta"], [("I", "theta''"), ("m*g*d", "theta")]),
    ("ch2/e6-torsion-pendulum", "eom", ["theta"], [("I", "theta''"), ("kappa", "theta")]),
    ("ch2/e7-lc-circuit", "eom", ["q"], [("L", "q''"), ("1/C", "q")]),
    ("ch2/p1-pinned-bar-block", "eom", ["theta"], [("5/6*m*l^2", "theta''"), ("1/4*c*l^2", "theta'"), ("5/4*k*l^2", "theta")]),
    ("ch2/p2-centre-pinned-bar-cable", "eom", ["theta"], [("(m_b/12 + m/4)*l^2", "theta''"), ("c*l^2/4", "theta'"), ("k*l^2/2", "theta")]),
    ("ch2/p3-parallel-springs-damper", "eom", ["x"], [("m", "x''"), ("b", "x'"), ("(k1 + k2)", "x")]),
    ("ch2/p4-disk-on-incline", "eom", ["x"], [("3/2*m", "x''"), ("c", "x'"), ("4*k", "x"), ("m*g*sin(phi)", "")]),
    ("ch2/p5-stepped-disk-two-springs", "eom", ["theta"], [("(I + m*r1^2)", "theta''"), ("(k1*r1^2 + k2*r2^2)", "theta"), ("m*g*r1", "")]),
    ("ch2/p6-series-springs-damper", "eom", ["x"], [("m", "x''"), ("b", "x'"), ("k1*k2/(k1 + k2)", "x")]),
    ("ch2/p7-disk-two-springs-damper", "eom", ["theta"], [("3/2*m*r^2", "theta''"), ("c*r^2", "theta'"), ("13*k*r^2", "theta")]),
    ("ch3/e1-damped-elastic-pendulum", "eom", ["x"], [("m", "x''"), ("alpha", "x'"), ("k", "x")]),
    ("ch3/e8-rlc-circuit", "eom", ["q"], [("L", "q''"), ("R", "q'"), ("1/C", "q")]),
    ("ch4/e1-forced-steady-state", "eom", ["x"], [("m", "x''"), ("alpha", "x'"), ("k", "x"), ("F0*cos(Omega*t)", "")]),
    ("ch4/p1-rolling-disk-hub-moment", "eom", ["x"], [("3/2*m", "x''"), ("b", "x'"), ("11/2*k", "x"), ("-M0/r*sin(Omega*t)", "")]),
    ("ch4/p2-pinned-bar-transmitted-force", "eom", ["theta"], [("m*L^2/12", "theta''"), ("c*L^2/4", "theta'"), ("k*L^2/4", "theta"), ("F0*L/2*sin(Omega*t)", "")]),
    ("ch4/p5-unbalanced-rotor", "eom", ["x"], [("m", "x''"), ("b", "x'"), ("k", "x"), ("m*ecc*Omega^2*sin(Omega*t)", "")]),
    ("ch4/t1-rotating-unbalance", "eom", ["x"], [("m", "x''"), ("c", "x'"), ("k", "x"), ("mu*ecc*Omega^2*sin(Omega*t)", "")]),
    ("ch5/e1-elastic-coupling", "eom1", ["x1", "x2"], [("m1", "x1''"), ("alpha1", "x1'"), ("(k1 + kc)", "x1"), ("-kc", "x2")]),
    ("ch5/e3-viscous-coupling", "eom1", ["x1", "x2"], [("m1", "x1''"), ("(alpha1 + beta)", "x1'"), ("-beta", "x2'"), ("k1", "x1")]),
    ("ch5/e4-coupled-pendulums-general", "eom2", ["theta1", "theta2"], [("m2*l2^2", "theta2''"), ("-K*s^2", "theta1"), ("(m2*g*l2 + K*s^2)", "theta2")]),
    ("ch5/p1-stepped-disk-two-blocks", "eom2", ["x1", "theta"], [("(m2*r2^2 + J)", "theta''"), ("b2*r2^2", "theta'"), ("k1*r1", "x1"), ("(k1*r1^2 + k2*r2^2)", "theta")]),
    ("ch5/p2-cart-disk-hanging-mass", "eom2", ["x1", "x2"], [("(m + J/r^2)", "x2''"), ("-k", "x1"), ("k", "x2"), ("m*g", "")]),
    ("ch5/p3-three-mass-chain-double-spring", "eom2", ["x1", "x2", "x3"], [("m2", "x2''"), ("-k2", "x1"), ("(k2 + 2*k3)", "x2"), ("-2*k3", "x3")]),
    ("ch5/p6-forced-two-dof-modal", "eom1", ["x1", "x2"], [("2*m", "x1''"), ("2*k", "x1"), ("-k", "x2"), ("f0*sin(Omega*t)", "")]),
    ("ch5/t5-double-pendulum", "eom1", ["theta1", "theta2"], [("(m1 + m2)*l1^2", "theta1''"), ("m2*l1*l2", "theta2''"), ("(m1 + m2)*g*l1", "theta1")]),
    ("ch5/t6-rayleigh-damping", "eom2", ["x1", "x2"], [("m2", "x2''"), ("-k2*a1", "x1'"), ("(m2*a0 + k2*a1)", "x2'"), ("-k2", "x1"), ("k2", "x2")]),
]

# What a coefficient misses or has too much, and what is said: item, terms with the slip, words.
MISSED = [
    ("ch2/p1-pinned-bar-block", "5/6 m l² θ'' + c l²/4 θ' + k l² θ = 0", "number in front of the stiffness term (in θ)"),
    ("ch2/p1-pinned-bar-block", "5/6 m l² θ'' + c l²/2 θ' + 5/4 k l² θ = 0", "number in front of the damping term (in θ′)"),
    ("ch2/p1-pinned-bar-block", "m l² θ'' + c l²/4 θ' + 5/4 k l² θ = 0", "number in front of the inertia term (in θ″)"),
    ("ch2/p2-centre-pinned-bar-cable", "m/4 l^2 theta'' + c l^2/4 theta' + k l^2/2 theta = 0", "inertia term (in θ″) misses"),
    ("ch2/p2-centre-pinned-bar-cable", "m_b/12 l^2 theta'' + c l^2/4 theta' + k l^2/2 theta = 0", "inertia term (in θ″) misses m"),
    ("ch2/p3-parallel-springs-damper", "m x'' + b x' + k1 x = 0", "stiffness term (in x) misses k2"),
    ("ch2/p3-parallel-springs-damper", "m x'' + b x' + k_2 x = 0", "stiffness term (in x) misses k1"),
    ("ch2/p4-disk-on-incline", "m x'' + c x' + 4 k x = m g sin(phi)", "number in front of the inertia term (in x″)"),
    ("ch2/p5-stepped-disk-two-springs", "I θ'' + (k1 r1² + k2 r2²) θ = m g r1", "inertia term (in θ″) misses"),
    ("ch2/p5-stepped-disk-two-springs", "(I + m r1²) θ'' + k1 r1² θ = m g r1", "k2 (stiffness of spring 2)"),
    ("ch4/p1-rolling-disk-hub-moment", "m x'' + b x' + 11/2 k x = -M0/r sin(Ωt)", "number in front of the inertia term (in x″)"),
    ("ch5/p1-stepped-disk-two-blocks", "m2 r2² θ'' + b2 r2² θ' + k1 r1 x1 + (k1 r1² + k2 r2²) θ = 0", "inertia term (in θ″) misses I (moment of inertia of the disk)"),
    ("ch5/p2-cart-disk-hanging-mass", "m x2'' - k x1 + k x2 = m g", "inertia term (in x2″) misses"),
    ("ch5/e1-elastic-coupling", "m1 x1'' + α1 x1' + k1 x1 - kc x2 = 0", "stiffness term (in x1) misses"),
    ("ch5/p3-three-mass-chain-double-spring", "m2 x2'' - k2 x1 + k2 x2 - 2 k3 x3 = 0", "stiffness term (in x2) misses k3"),
    ("ch5/t5-double-pendulum", "m1 l1^2 theta1'' + m2 l1 l2 theta2'' + (m1+m2) g l1 theta1 = 0", "inertia term (in θ1″) misses m2"),
    ("ch2/e5-compound-pendulum", "I θ'' + m g d sin θ = 0", "still has to be linearized"),
]
PARTS = {item: part for item, part, _, _ in SYSTEMS}


def expression(text):
    text = re.sub(r"([A-Za-z]\w*)''", r"\1_dd", text)
    text = re.sub(r"([A-Za-z]\w*)'", r"\1_d", text)
    names = {name: sp.Symbol(name) for name in re.findall(r"[A-Za-z_]\w*", text) if name not in ("sin", "cos")}
    return sp.sympify(text.replace("^", "**"), locals=names)


def joined(left, right):
    """An equation of terms, with its signs."""

    def side(terms):
        text = ""
        for coefficient, unknown in terms:
            sign = "-" if coefficient.startswith("-") else "+"
            body = coefficient.removeprefix("-")
            if " - " in body or (" + " in body and not body.startswith("(")):
                body = f"({body})"
            term = f"{body}*{unknown}" if unknown else body
            text += f" {sign} {term}" if text else (f"-{term}" if sign == "-" else term)
        return text or "0"

    return f"{side(left)} = {side(right)}"


def negated(coefficient):
    return coefficient[1:] if coefficient.startswith("-") else (f"-({coefficient})" if " - " in coefficient else f"-{coefficient}")


def paper(text):
    """The same on paper: Greek letters, dots as primes, raised squares, no signs for products."""
    for word, letter in [("theta", "θ"), ("alpha", "α"), ("beta", "β"), ("Omega", "Ω"), ("kappa", "κ"), ("phi", "φ"), ("mu*", "μ*")]:
        text = text.replace(word, letter)
    return text.replace("^2", "²").replace("*", " ")


def dots(text):
    """The same with dots."""
    text = re.sub(r"([A-Za-z]+?)(\d*)''", r"\1ddot\2", text)
    return re.sub(r"([A-Za-z]+?)(\d*)'", r"\1dot\2", text)


def latex(text):
    text = re.sub(r"\b(theta|alpha|beta|Omega|kappa|phi|mu)(\d?)", lambda found: "\\" + found[1] + (f"_{found[2]}" if found[2] else ""), text)
    text = re.sub(r"(\\?[A-Za-z]+(?:_\d|\d)?)''", r"\\ddot{\1}", text)
    text = re.sub(r"(\\?[A-Za-z]+(?:_\d|\d)?)'", r"\\dot{\1}", text)
    return text.replace("*", " ").replace("sin(", "\\sin(").replace("cos(", "\\cos(")


def difference(text):
    left, right = text.split("=")
    return expression(left) - expression(right)


def kind(unknown):
    return {2: "inertia", 1: "damping", 0: "stiffness"}[unknown.count("'")]


def shown(unknown):
    name = unknown.replace("theta", "θ")
    return name.replace("''", "″").replace("'", "′")


def main():
    lines, right, wrong = [], 0, 0
    for item, part, unknowns, terms in SYSTEMS:
        left = [term for term in terms if term[1]]
        rest = [term for term in terms if not term[1]]
        key = joined(left, rest)
        lead = left[0]
        forms = [paper(key), joined(list(reversed(left)), rest)]
        forms.append(dots(joined(left[1:], rest + [(negated(lead[0]), lead[1])])))
        divided = [(f"{coefficient}/({lead[0]})", unknown) for coefficient, unknown in left[1:]]
        right_side = [(f"({coefficient})/({lead[0]})", "") for coefficient, _ in rest]
        forms.append(joined([("1", lead[1])] + divided, right_side))
        forms.append(latex(key))
        for form in forms:
            lines.append((item, part, form, "right", ""))
            right += 1
        plain = joined([("1", lead[1])] + divided, right_side)
        assert sp.simplify(difference(plain) * expression(lead[0]) - difference(key)) == 0, item
        for place, (coefficient, unknown) in enumerate(left[1:], 1):
            slipped = left[:place] + [(negated(coefficient), unknown)] + left[place + 1 :]
            text = joined(slipped, rest)
            ratio = sp.simplify(difference(text) / difference(key))
            assert ratio.free_symbols, text
            words = f"sign of the {kind(unknown)} term (in {shown(unknown)})"
            lines.append((item, part, paper(text), "wrong", words))
            wrong += 1
            if len(left) > 2:
                text = joined(left[:place] + left[place + 1 :], rest)
                lines.append((item, part, paper(text), "wrong", f"{kind(unknown)} term (in {shown(unknown)}) is missing"))
                wrong += 1
        # The weight and the spring's extension at rest cancel: without them it is right as well.
        if rest and item != "ch2/e1-vertical-elastic-pendulum":
            lines.append((item, part, paper(joined(left, [])), "wrong", "without"))
            wrong += 1
    for item, text, words in MISSED:
        lines.append((item, PARTS[item], text, "wrong", words))
        wrong += 1
    print("# Made by tests/references/equations_of_motion.py: item, part, response, verdict, what is said.")
    for line in lines:
        print("\t".join(line))
    print(right, wrong, file=sys.stderr)


main()
