"""Prints reference values of dry friction, one JSON object a line: task, parameters, result of 50 digits.

The numbers of a line are decimals and taken as such. Motions of few half-cycles are followed slide by slide, with the
linear motion of each solved by its characteristic roots; long ones by the recurrence of their turning points, solved.

    python3 tests/references/friction.py > tests/fixtures/references/friction.jsonl
"""

import json
import math
import random
from fractions import Fraction

from mpmath import acos, exp, expm1, floor, log, log1p, mp, mpc, mpf, nstr, pi, sqrt

mp.dps = 110
random.seed(11)

FOLLOWED = 300


def number(fraction):
    return mpf(fraction.numerator) / mpf(fraction.denominator)


def digits(x):
    return nstr(mpf(x), 50, min_fixed=-5, max_fixed=20)


class Line:
    """m y'' + c y' + k y = 0 from (y, v), by its roots."""

    def __init__(self, m, c, k):
        self.m, self.c, self.k = m, c, k
        root = mp.sqrt(mpc(c * c - 4 * m * k))
        self.a, self.b = (-c + root) / (2 * m), (-c - root) / (2 * m)

    def at(self, y, v, t):
        a, b = self.a, self.b
        if a == b:
            slope = v - a * y
            return ((y + slope * t) * exp(a * t)).real, ((v + a * slope * t) * exp(a * t)).real
        p, q = (v - b * y) / (a - b), (a * y - v) / (a - b)
        return (p * exp(a * t) + q * exp(b * t)).real, (p * a * exp(a * t) + q * b * exp(b * t)).real

    def turn(self, y, v):
        """The first time > 0 at which the velocity vanishes, or None."""
        a, b = self.a, self.b
        if a == b:
            slope = v - a * y
            t = -v / (a * slope) if slope != 0 else mpf(-1)
            return t.real if t.real > 0 else None
        p, q = (v - b * y) / (a - b), (a * y - v) / (a - b)
        ratio = -q * b / (p * a)  # e^((a - b) t)
        if a.imag == 0:
            if ratio.real <= 1:
                return None
            return (log(ratio.real) / (a - b)).real
        omega = a.imag
        angle = mp.arg(ratio) / (2 * omega)
        half = pi / omega
        tiny = half * mpf(10) ** -60
        while angle <= tiny:
            angle += half
        while angle > half + tiny:
            angle -= half
        return angle


def solve(p):
    """The result for a dictionary of decimals."""
    f = {name: Fraction(text) for name, text in p.items() if name != "t"}
    m, k, c = f["m"], f["k"], f.get("c", Fraction(0))
    weight = f["m"] * f["g"]
    kinetic, fixed = f["mu"] * weight, f.get("mu_s", f["mu"]) * weight
    force, v0 = f.get("F", Fraction(0)), f.get("v0", Fraction(0))
    offset = f["x0"] - force / k
    slip, hold = kinetic / k, fixed / k
    times = [number(Fraction(t)) for t in p.get("t", [])]
    if v0 == 0 and abs(offset) <= hold:
        slides = []
        result = dict(n=0, t=mpf(0), u=offset, path=mpf(0))
    elif v0 == 0 and c == 0:
        n = -((hold - abs(offset)) // (2 * slip))  # a ceiling
        last = abs(offset) - 2 * n * slip
        side = (1 if offset > 0 else -1) * (-1) ** (n % 2)
        result = dict(n=n, t=n * pi * sqrt(number(m / k)), u=side * last, path=number(n * (abs(offset) + last)))
    elif v0 == 0 and estimate(m, c, k, offset, slip, hold) > FOLLOWED:
        result = long_damped(*map(number, (m, c, k, offset, slip, hold)))
    else:
        result = follow(*map(number, (m, c, k, offset, v0, slip, hold)))
    equilibrium = number(force / k)
    states = [state(number(m), number(c), number(k), number(offset), number(v0), number(slip), result, t) for t in times]
    u = result["u"]
    return {
        "n_half": int(result["n"]),
        "t_stop": digits(result["t"]) if result["t"] != mp.inf else None,
        "x_stop": digits(equilibrium + (number(u) if isinstance(u, Fraction) else u)),
        "path": digits(result["path"]),
        "x_stick": digits(number(hold)),
    } | ({"x_t": [digits(equilibrium + x) for x, _ in states], "v_t": [digits(v) for _, v in states]} if times else {})


def estimate(m, c, k, offset, slip, hold):
    if c * c >= 4 * m * k:
        return 1
    theta = float(number(c)) * math.pi / float(sqrt(number(4 * m * k - c * c)))
    b = float(slip) / math.tanh(theta / 2)
    return math.log1p((abs(float(offset)) - float(hold)) / (float(hold) + b)) / theta


def follow(m, c, k, u, v, slip, hold):
    """Slide by slide."""
    line, n, t, path = Line(m, c, k), 0, mpf(0), mpf(0)
    arcs = []
    while v != 0 or abs(u) > hold:
        direction = (1 if v > 0 else -1) if v != 0 else (-1 if u > 0 else 1)
        centre = -direction * slip
        y, n = u - centre, n + 1
        tau = line.turn(y, v) if v != 0 else (pi / line.a.imag if line.a.imag != 0 else None)
        arcs.append((t, centre, y, v))
        if tau is None:
            return dict(n=n, t=mp.inf, u=centre, path=path + abs(y), arcs=arcs)
        end = centre + line.at(y, v, tau)[0]
        path, t, u, v = path + abs(end - u), t + tau, end, mpf(0)
    return dict(n=n, t=t, u=u, path=path, arcs=arcs)


def long_damped(m, c, k, offset, slip, hold):
    """The recurrence U -> q U - a (1 + q), solved."""
    root = sqrt(4 * m * k - c * c)
    theta = c * pi / root
    q = exp(-theta)
    b = slip * (1 + q) / (1 - q)
    reach = abs(offset)
    n = int(mp.ceil(log((reach + b) / (hold + b)) / theta))
    last = (reach + b) * q**n - b
    assert last <= hold < (reach + b) * q ** (n - 1) - b
    total = (reach + b) * (1 - q**n) / (1 - q) - n * b
    side = (1 if offset > 0 else -1) * (-1) ** (n % 2)
    return dict(n=n, t=n * pi * 2 * m / root, u=side * last, path=2 * total - reach + last)


def state(m, c, k, offset, v0, slip, result, t):
    """Position from the equilibrium, and velocity."""
    if t >= result["t"]:
        return (number(result["u"]) if isinstance(result["u"], Fraction) else result["u"]), mpf(0)
    line = Line(m, c, k)
    if "arcs" in result:
        start, centre, y, v = [arc for arc in result["arcs"] if arc[0] <= t][-1]
        y, v = line.at(y, v, t - start)
        return centre + y, v
    half = pi / line.a.imag if c > 0 else pi * sqrt(m / k)
    j = floor(t / half)
    reach, side = abs(offset), (1 if offset > 0 else -1) * (-1) ** int(j)
    q = exp(line.a.real * half)
    now = reach - 2 * j * slip if c == 0 else (reach + slip * (1 + q) / (1 - q)) * q**j - slip * (1 + q) / (1 - q)
    y, v = line.at(side * (now - slip), mpf(0), t - j * half)
    return side * slip + y, v


def line(**p):
    p = {name: [repr(x) if isinstance(x, float) else str(x) for x in v] if isinstance(v, list) else str(v)
         for name, v in p.items()}
    # A decay of 1e-300 in a half-cycle has to be told from none.
    with mp.workdps(1000 if 0 < Fraction(p["c"]) < Fraction(1, 10**20) else 110):
        result = solve(p)
    print(json.dumps({"task": "coulomb_stop", "params": p, "result": result}, separators=(",", ":")))


def some_times(omega, n):
    return [f"{x:.6g}" for x in (0.01 / omega, 1 / omega, 2.5 / omega, (0.3 * n + 0.4) * math.pi / omega,
                                 (0.7 * n + 0.1) * math.pi / omega, (n + 0.5) * math.pi / omega)]


# Ties on the decimals, and their neighbours: mu m g/k = 0.1 m.
for j in (0, 1, 2, 3, 10, 12345, 10**6):
    tie = Fraction(2 * j + 1, 10)
    text = f"{tie.numerator * (10 // tie.denominator) // 10}.{tie.numerator * (10 // tie.denominator) % 10}"
    for x0 in (text, repr(math.nextafter(float(text), 0)), repr(math.nextafter(float(text), 1e9)), "-" + text,
               text + "0000000000000001", f"{j // 5}.{2 * j % 10}"):
        line(m="1", k="1", mu="0.1", g="1", x0=x0, c="0")
        line(m="2", k="0.2", mu="0.001", g="10", x0=x0, c="0")
line(m="2", k="73.5", mu="0.35", g="9.8", x0="0.28", c="0")
line(m="0.3", k="0.3", mu="0.1", g="3", x0="0.9", c="0")
# Long motions.
for n in (10, 10**3, 10**5, 10**7, 10**9, 10**12):
    for part in ("3", "9999999", "000001", "5"):
        line(m="1.3", k="47", mu="0.2", g="9.81", x0=f"{2 * n * 0.0542680851063829787 + 0.054:.6f}{part}", c="0")
        line(m="1", k="1", mu="0.5", g="1", x0=f"{n}.{part}", c="0")
# The centre, stuck at the start, one-sided rest, other coefficients, a constant force, a throw.
for x0 in ("0.2", "0.4", "-0.6", "0.05", "-0.1", "0", "0.11", "0.19", "-0.15", "0.31"):
    for extra in ({}, {"mu_s": "0.15"}, {"F": "0.05"}, {"F": "-0.3", "mu_s": "0.3"}, {"v0": "0.5"}, {"v0": "-0.3"},
                  {"v0": "1e-9"}, {"v0": "2.5", "mu_s": "0.2", "F": "0.12"}):
        for c in ("0", "0.1", "1.9", "2", "2.1", "40"):
            line(m="1", k="1", mu="0.1", g="1", x0=x0, c=c, t=["0", "0.3", "1", "2.2", "4", "7.7", "30"], **extra)
# Throws that tie: (k x0 + F_k)^2 + k m v0^2 is a square.
for u, v in ((3, 4), (5, 12), (8, 15), (20, 21), (119, 120)):
    for v0 in (f"{v / 10}", repr(math.nextafter(v / 10, 99)), repr(math.nextafter(v / 10, 0))):
        line(m="1", k="1", mu="0.1", g="1", x0=f"{(u - 1) / 10}", v0=v0, c="0")
        line(m="1", k="1", mu="0.1", g="1", x0=f"{(1 - u) / 10}", v0="-" + v0, c="0")
# Viscous damping from hardly any to nearly critical: theta = c pi/sqrt(4 m k - c^2).
for c in ("1e-300", "1e-60", "1e-25", "1e-15", "6.4e-12", "1e-9", "1e-6", "1e-3", "0.05", "0.5", "1.5", "1.99", "1.999999",
          "1.999999999999", "1.9999999999999998"):
    for x0 in ("0.3", "1.234", "77.7", "-500.03", "1e4", "123456.789", "1e6"):
        line(m="1", k="1", mu="0.1", g="1", x0=x0, c=c)
        line(m="1", k="1", mu="0.0123", g="9.81", mu_s="0.05", x0=x0, c=c, t=["0.5", "3", "3.2", "100.25", "1e4"])
# Anything.
for _ in range(150):
    m, k = f"{random.uniform(0.2, 9):.3g}", f"{random.uniform(5, 900):.3g}"
    mu, ratio = f"{random.uniform(0.01, 0.8):.2g}", random.choice((1, 1, 1.2, 2))
    delta = float(mu) * float(m) * 9.81 / float(k)
    n = random.choice((0.4, 1.6, 3.2, 10, 50))
    omega = math.sqrt(float(k) / float(m))
    c = random.choice(("0", "0", f"{random.uniform(0, 0.3) * math.sqrt(float(m) * float(k)):.3g}",
                       f"{random.uniform(0, 5) * math.sqrt(float(m) * float(k)):.3g}"))
    line(m=m, k=k, mu=mu, g="9.81", mu_s=f"{float(mu) * ratio:.4g}", x0=f"{random.choice((-1, 1)) * n * 2 * delta:.4g}",
         c=c, v0=random.choice(("0", "0", f"{random.uniform(-3, 3) * n * delta * omega:.3g}")),
         F=random.choice(("0", f"{random.uniform(-9, 9):.3g}")), t=some_times(omega, n))
