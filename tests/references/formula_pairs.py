"""Pairs of formulas for tests/corpora/formulas.tsv: equal ones and near misses.

Each key is a formula of the bank's domain. Equal formulas are made from it by algebra (SymPy), near misses by one slip
of the kind that students make; both are written in one of several notations. Which of the two a pair is, is decided by
evaluating both formulas with 60 digits at points around the data (mpmath), not by how the pair was made.

    python3 tests/references/formula_pairs.py > tests/corpora/formulas.tsv
"""

import random
import re
import sys

sys.setrecursionlimit(20000)
import tomllib
from pathlib import Path

import mpmath
import sympy as sp

HERE = Path(__file__).resolve().parent
DATA = tomllib.loads((HERE / "../corpora/symbols.toml").read_text())["parameters"]
NAMES = list(DATA)
SYMBOLS = {name: sp.Symbol(name, positive=True) for name in NAMES}
VALUE = {
    name: float((entry["value"] if isinstance(entry, dict) else entry).split()[0]) for name, entry in DATA.items()
}
ALIKE = [["m", "M", "m1", "m2"], ["k", "k1", "k2", "k3"], ["c", "c1"], ["l", "a", "b", "R", "x0", "Y"], ["zeta", "rho", "delta", "mu"]]

KEYS = """
sqrt(k/m)
1/(2*pi)*sqrt(k/m)
2*pi*sqrt(m/k)
sqrt(k/m - (c/(2*m))^2)
sqrt(4*k*m - c^2)/(2*m)
c/(2*sqrt(k*m))
2*sqrt(k*m)
2*pi*sqrt(l/g)
2*pi*sqrt(2*l/(3*g))
sqrt(m*g*l/J)
sqrt((k*l^2 + m*g*l)/(m*l^2))
sqrt(g/l + k*a^2/(m*l^2))
k1*k2/(k1 + k2)
k1 + k2*k3/(k2 + k3)
1/(1/k1 + 1/k2 + 1/k3)
m + M/2
3/2*m + J/R^2
1/2*m*v0^2 + 1/2*k*x0^2
m*l^2/12 + m*a^2
m*l^2/3 + M*(l + R)^2 + 2/5*M*R^2
m*g*l*(1 - cos(theta0))
1/2*k*(x0 + Y)^2 - m*g*x0
sqrt(x0^2 + (v0*m/c)^2)
sqrt(x0^2 + m*v0^2/k)
x0*exp(-c*tau/(2*m))*cos(sqrt(k/m)*tau)
x0*exp(-zeta*Omega*tau)*cos(Omega*tau*sqrt(1 - zeta^2))
(x0 + (v0 + Omega*x0)*tau)*exp(-Omega*tau)
x0*cos(Omega*tau) + v0/Omega*sin(Omega*tau)
2*pi*zeta/sqrt(1 - zeta^2)
delta/sqrt(4*pi^2 + delta^2)
ln(x0/Y)/n
F0/sqrt((k - m*Omega^2)^2 + (c*Omega)^2)
F0/(m*sqrt((k/m - Omega^2)^2 + (c*Omega/m)^2))
F0/k/sqrt((1 - rho^2)^2 + (2*zeta*rho)^2)
sqrt((1 + (2*zeta*rho)^2)/((1 - rho^2)^2 + (2*zeta*rho)^2))
me*ex*Omega^2/sqrt((k - M*Omega^2)^2 + (c*Omega)^2)
rho^2/sqrt((1 - rho^2)^2 + (2*zeta*rho)^2)
1/(2*zeta*sqrt(1 - zeta^2))
sqrt(k/m)*sqrt(1 - 2*zeta^2)
sqrt(k/m - c^2/(2*m^2))
atan(c*Omega/(k - m*Omega^2))
1/2*c*Omega^2*Y^2
pi*c*Omega*Y^2
sqrt(k*m)/c
k*x0/(m*g)
x0 - 4*mu*m*g/k
mu*m*g/k
pi*sqrt(m/k)
1/sqrt(L*C)
sqrt(1/(L*C) - (Rel/(2*L))^2)
Rel/2*sqrt(C/L)
1/Rel*sqrt(L/C)
sqrt(Rel^2 + (Omega*L - 1/(Omega*C))^2)
sqrt((k1 + k2)/(m1 + m2))
sqrt((k*(m1 + m2))/(m1*m2))
((k1 + k2)/m1 + k2/m2)/2
sqrt(((k1 + k2)/m1 + k2/m2)/2 - sqrt((((k1 + k2)/m1 + k2/m2)/2)^2 - k1*k2/(m1*m2)))
sqrt(3*E*I/(m*l^3))
sqrt(48*E*I/(l^3*(M + 17*m/35)))
(k - m*Omega^2)*(k2 - m2*Omega^2) - k2^2
k^2 - 2*k*m*Omega^2 + m^2*Omega^4 + c^2*Omega^2
M0/(kt - J*Omega^2)
sqrt(kt/J - (ct/(2*J))^2)
2*pi*sqrt(l/g)*(1 + theta0^2/16)
sin(2*Omega*tau)
2*Y*cos(Omega*tau/2)*sin(Omega*tau/2)
m*g*sin(theta0) - k*x0*cos(theta0)
sqrt(2*g*l*(1 - cos(theta0)))
(m1 - m2)*g/(m1 + m2 + J/R^2)
exp(-pi*zeta/sqrt(1 - zeta^2))
-ln(rho)/(2*pi*n)
""".split("\n")
KEYS = [key for key in KEYS if key.strip()]


def read(text):
    """SymPy's reading of a formula, unevaluated where it matters little."""
    return sp.sympify(text.replace("^", "**").replace("ln(", "log("), locals=dict(SYMBOLS, pi=sp.pi))


def function(expr):
    """The formula as a function of a point with 60 digits; None where there is no real value."""
    names = sorted(map(str, expr.free_symbols))
    compiled = sp.lambdify(names, expr, "mpmath")

    def at(point):
        with mpmath.workdps(60):
            try:
                number = compiled(*(mpmath.mpf(point[name]) for name in names))
            except (ZeroDivisionError, ValueError):
                return None
            number = mpmath.mpmathify(number)
            return number if isinstance(number, mpmath.mpf) and mpmath.isfinite(number) else None

    return at


def points(draw, count, spread):
    for _ in range(count):
        yield {name: VALUE[name] * 10 ** draw.uniform(-spread, spread) for name in NAMES}


def largest_difference(key, other, draw):
    """The largest difference as a part of the key over points where both are real; None if there are too few."""
    found = []
    key, other = function(key), function(other)
    for spread in (0.1, 0.3, 0.5):
        for point in points(draw, 3, spread):
            a, b = key(point), other(point)
            if a is not None and b is not None and a != 0:
                with mpmath.workdps(60):
                    found.append(abs((a - b) / a))
    return max(found) if len(found) >= 3 else None


# Notations ------------------------------------------------------------------------------------------------------------

GREEK = {"Omega": "Ω", "zeta": "ζ", "mu": "μ", "theta0": "θ₀", "rho": "ρ", "delta": "δ", "tau": "τ", "ex": "ex"}
LATEX = {"Omega": "\\Omega", "zeta": "\\zeta", "mu": "\\mu", "theta0": "\\theta_0", "rho": "\\rho", "delta": "\\delta", "tau": "\\tau"}


class Writer:
    """Writes a SymPy expression as somebody might type it."""

    def __init__(self, draw):
        self.draw = draw
        self.style = draw.choice(["plain", "plain", "stars", "paper", "paper", "latex"])

    def name(self, name):
        if self.style == "paper":
            return GREEK.get(name, re.sub(r"(?<=[A-Za-z])(\d)", lambda found: "₀₁₂₃₄₅₆₇₈₉"[int(found[1])], name))
        if self.style == "latex":
            return LATEX.get(name, re.sub(r"(?<=[A-Za-z])(\d)", r"_\1", name))
        return name

    def write(self, expr):
        return self.sum(expr)

    def sum(self, expr):
        if not expr.is_Add:
            return self.product(expr)
        terms = list(expr.args)
        self.draw.shuffle(terms)
        terms.sort(key=lambda term: term.could_extract_minus_sign())
        text = self.product(terms[0])
        for term in terms[1:]:
            if term.could_extract_minus_sign():
                text += (" − " if self.style == "paper" else " - ") + self.product(-term)
            else:
                text += " + " + self.product(term)
        return text

    def product(self, expr):
        if expr.could_extract_minus_sign() and not expr.is_Add:
            return "-" + self.product(-expr)
        if not (expr.is_Mul or expr.is_Pow or expr.is_Rational):
            return self.factor(expr)
        above, below = [], []
        for factor in sp.Mul.make_args(expr):
            base, power = factor.as_base_exp()
            if factor.is_Rational and not factor.is_Integer:
                if factor.p != 1:
                    above.append(sp.Integer(factor.p))
                below.append(sp.Integer(factor.q))
            elif power.is_Rational and power < 0:
                below.append(base ** (-power))
            else:
                above.append(factor)
        number = [factor for factor in above if factor.is_number]
        letters = [factor for factor in above if not factor.is_number]
        self.draw.shuffle(letters)
        top = self.times(number + letters)
        if not below:
            return top
        bottom = self.times(below)
        if self.style == "latex":
            return f"\\frac{{{top}}}{{{bottom}}}"
        if len(below) > 1 or below[0].is_Add:
            bottom = f"({bottom})" if not (len(below) == 1 and below[0].is_Add) else bottom
        return f"{top}/{bottom}"

    def times(self, factors):
        if not factors:
            return "1"
        if len(factors) == 1:
            return self.factor(factors[0])
        sign = {"plain": "*", "stars": "*", "paper": self.draw.choice([" ", "·", " "]), "latex": " "}[self.style]
        texts = [self.factor(factor) for factor in factors]
        text = texts[0]
        for before, after in zip(texts, texts[1:]):
            # Two numbers side by side need a sign.
            joint = "*" if after[0].isdigit() and sign == " " else sign
            if joint == "*" and self.style == "latex":
                joint = " \\cdot "
            text += joint + after
        return text

    def factor(self, expr):
        if expr.is_Symbol:
            return self.name(str(expr))
        if expr == sp.pi:
            return {"paper": "π", "latex": "\\pi"}.get(self.style, "pi")
        if expr.is_Integer and expr >= 0:
            return str(expr)
        if expr.is_Float:
            return format(float(expr), ".10g")
        if expr.is_Pow:
            base, power = expr.as_base_exp()
            if power == sp.Rational(1, 2):
                inner = self.sum(base)
                if self.style == "latex":
                    return f"\\sqrt{{{inner}}}"
                if self.style == "paper":
                    return f"√({inner})"
                return f"sqrt({inner})" if self.draw.random() < 0.8 else f"({inner})^0.5"
            if power.is_Rational and power > 0:
                body = self.factor(base) if not (base.is_Add or base.is_Mul or base.is_Pow or base.is_Function) else f"({self.sum(base)})"
                if self.style == "paper" and power in (2, 3, 4):
                    return body + {2: "²", 3: "³", 4: "⁴"}[int(power)]
                sign = "**" if self.style == "stars" else "^"
                if self.style == "latex":
                    return f"{body}^{{{power}}}"
                return f"{body}{sign}{power}" if power.is_Integer else f"{body}{sign}({power})"
        if isinstance(expr, sp.exp):
            inner = self.sum(expr.args[0])
            return {"latex": f"e^{{{inner}}}", "paper": f"e^({inner})"}.get(self.style, f"exp({inner})")
        if expr.is_Function:
            name = {"log": "ln"}.get(expr.func.__name__, expr.func.__name__)
            if self.style == "latex":
                name = {"atan": "\\arctan"}.get(name, "\\" + name)
                return f"{name}\\left({self.sum(expr.args[0])}\\right)"
            if name == "Abs":
                return f"|{self.sum(expr.args[0])}|"
            return f"{name}({self.sum(expr.args[0])})"
        return f"({self.sum(expr)})"


# Equal formulas -------------------------------------------------------------------------------------------------------

def hold(*factors):
    return sp.Mul(*factors, evaluate=False)


def equals(key, draw):
    """Formulas that should equal the key."""
    names = sorted(key.free_symbols, key=str)
    one = draw.choice(names)
    roots = [node for node in sp.preorder_traversal(key) if node.is_Pow and node.exp == sp.Rational(1, 2)]
    yield key
    yield sp.expand(key)
    yield sp.factor(key)
    yield sp.together(key)
    if key.count_ops() < 15:
        yield sp.simplify(key)
    yield sp.expand_power_base(sp.powdenest(key, force=True), force=True)
    yield sp.expand(sp.together(key))
    yield sp.cancel(sp.together(key))
    yield sp.collect(sp.expand(key), one)
    yield hold(sp.expand(key * one), 1 / one)
    yield hold(sp.expand(key / one), one)
    yield hold(sp.Rational(1, 2), sp.expand(2 * key))
    yield 1 / sp.expand(1 / key)
    yield sp.sqrt(sp.expand(key**2)) if not key.could_extract_minus_sign() else -sp.sqrt(sp.expand(key**2))
    for root in roots:
        inner = root.base
        yield key.subs(root, sp.sqrt(sp.expand(4 * inner), evaluate=False) / 2)
        yield key.subs(root, hold(one, sp.sqrt(sp.expand(inner / one**2))))
        yield key.subs(root, sp.sqrt(sp.together(inner)))
        yield key.subs(root, sp.expand(inner) / sp.sqrt(sp.factor(inner)))
    if key.has(sp.sin, sp.cos):
        yield sp.expand_trig(key)
        yield sp.trigsimp(key)
        for node in key.atoms(sp.cos):
            yield key.subs(node, 1 - 2 * sp.sin(node.args[0] / 2) ** 2)
            yield key.subs(node, sp.sin(node.args[0] + sp.pi / 2, evaluate=False))
        for node in key.atoms(sp.sin):
            yield key.subs(node, 2 * sp.sin(node.args[0] / 2) * sp.cos(node.args[0] / 2))
    if key.has(sp.log):
        yield sp.expand_log(key)
        yield -sp.expand_log(-key)
    for node in key.atoms(sp.exp):
        yield key.subs(node, 1 / sp.exp(-node.args[0]))
    for node in key.atoms(sp.atan):
        yield key.subs(node, sp.pi / 2 - sp.atan(1 / node.args[0]))
    if key.is_Add:
        first, *rest = key.args
        yield hold(first, sp.expand(1 + sum(rest) / first))


# Near misses ----------------------------------------------------------------------------------------------------------

def replaced(expr, path, by):
    """The tree with another node at a path."""
    if not path:
        return by
    args = list(expr.args)
    args[path[0]] = replaced(args[path[0]], path[1:], by)
    return expr.func(*args)


def paths(expr, at=()):
    yield at, expr
    for place, argument in enumerate(expr.args):
        yield from paths(argument, at + (place,))


def misses(key, draw):
    """One slip each."""
    nodes = [(path, node) for path, node in paths(key)]
    inner = [(path, node) for path, node in nodes if not node.is_number]
    path, node = draw.choice(inner)
    yield replaced(key, path, sp.Float("1.000001", 7) * node)
    path, node = draw.choice(inner)
    yield replaced(key, path, sp.Float("0.999999", 6) * node)
    yield sp.Float("1.000001", 7) * key
    path, node = draw.choice(inner)
    yield replaced(key, path, 2 * node)
    path, node = draw.choice(inner)
    yield replaced(key, path, node / 2)
    yield 2 * sp.pi * key
    yield key / (2 * sp.pi)
    yield -key
    yield key * sp.pi / 180
    sums = [(path, node) for path, node in nodes if node.is_Add]
    for path, node in sums:
        chosen = draw.randrange(len(node.args))
        args = list(node.args)
        yield replaced(key, path, sp.Add(*(args[:chosen] + [-args[chosen]] + args[chosen + 1 :])))
        yield replaced(key, path, sp.Add(*(args[:chosen] + args[chosen + 1 :])))
    for path, node in nodes:
        if node.is_Symbol:
            for group in ALIKE:
                if str(node) in group:
                    yield replaced(key, path, SYMBOLS[draw.choice([name for name in group if name != str(node)])])
        if node.is_Pow and node.exp in (2, sp.Rational(1, 2)):
            yield replaced(key, path, node.base)
        if isinstance(node, sp.sin):
            yield replaced(key, path, node.args[0])
            yield replaced(key, path, sp.cos(node.args[0]))
        if isinstance(node, sp.cos):
            yield replaced(key, path, 1 - node.args[0] ** 2 / 2)
            yield replaced(key, path, sp.sin(node.args[0]))
        if isinstance(node, sp.exp):
            yield replaced(key, path, 1 + node.args[0])
            yield replaced(key, path, sp.exp(-node.args[0]))


def main():
    draw = random.Random(2026)
    lines, counts = [], {"=": 0, "!": 0}
    for text in KEYS:
        key = read(text)
        for relation, source, most in (("=", equals, 9), ("!", misses, 9)):
            seen = {re.sub(r"\s", "", text)}
            tries = list(source(key, draw))
            if relation == "!":
                draw.shuffle(tries)
            else:
                tries = tries + tries
            made = 0
            for other in tries:
                if made == most:
                    break
                difference = largest_difference(key, other, draw)
                if difference is None or other.has(sp.I) or not other.free_symbols:
                    continue
                if relation == "=" and difference > mpmath.mpf("1e-50"):
                    continue
                if relation == "!" and difference < mpmath.mpf("1e-10"):
                    continue
                response = Writer(draw).write(other)
                if len(response) > 300 or re.sub(r"\s", "", response) in seen:
                    continue
                seen.add(re.sub(r"\s", "", response))
                lines.append(f"{relation}\t{text}\t{response}")
                counts[relation] += 1
                made += 1
    print("# Made by tests/references/formula_pairs.py: relation (= equal, ! not), key, response.")
    print("\n".join(lines))
    print(counts, file=sys.stderr)


main()
