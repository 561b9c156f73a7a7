"""Prints the reference values of the work-precision benchmark, one JSON object a line, with 50 digits.

    python3 benches/numerics/references.py > benches/numerics/references.jsonl

A line holds a task, a case, what is given (`data`), the arguments at which the values are taken (`at`) and the values.
`parameter` is the small number of a sweep, null where there is none. Needs mpmath.
"""

import json
import math

from mpmath import (agm, asin, cos, cosh, ellipfun, ellipk, exp, findroot, floor, hypot, log, mp, mpf, nstr, pi, sin,
                    sinh, sqrt)

mp.dps = 120


def digits(x):
    return nstr(x, 50, min_fixed=-5, max_fixed=20)


def line(task, case, data, at, values, parameter=None):
    print(json.dumps({"task": task, "case": case, "parameter": parameter, "data": data, "at": at,
                      "values": [digits(value) for value in values]}, separators=(",", ":")))


TIMES = [0.125 * i for i in range(201)]


def free(damping, t):
    half = mpf(damping) / 2
    square = 1 - half**2
    t = mpf(t)
    if square == 0:
        return exp(-t) * (1 + t)
    root = sqrt(abs(square))
    even, odd = (cos(root * t), sin(root * t)) if square > 0 else (cosh(root * t), sinh(root * t))
    return exp(-half * t) * (even + half / root * odd)


for case, damping, parameter in (
        ("undamped", 0.0, None), ("underdamped", 0.2, None), ("critical", 2.0, None), ("overdamped", 20.0, None),
        *((f"zeta=1-1e-{k}", 2 - 2 * 10.0**-k, 10.0**-k) for k in (3, 6, 9, 12, 15)),
        ("zeta=1+1e-9", 2 + 2e-9, None)):
    line("free-response", case, {"c": damping}, TIMES, [free(damping, t) for t in TIMES], parameter)


def forced(frequency, t):
    w, t = mpf(frequency), mpf(t)
    return t * sin(t) / 2 if w == 1 else (cos(w * t) - cos(t)) / (1 - w**2)


for case, frequency, parameter in (("off", 0.25, None), ("at resonance", 1.0, None),
                                   *((f"detuned by 1e-{k}", 1 + 10.0**-k, 10.0**-k) for k in (3, 6, 9, 12))):
    line("forced-response", case, {"Omega": frequency}, TIMES, [forced(frequency, t) for t in TIMES], parameter)

for case, damping, detuning, parameter in (("off", 0.1, 0.5, None), ("at resonance", 1e-3, 1e-3, None),
                                           *((f"detuned by 1e-{k}", 1e-14, 10.0**-k, 10.0**-k) for k in (1, 4, 8, 12))):
    at = [1 + detuning * (1 + i / 201) for i in range(201)]
    values = [1 / hypot(1 - mpf(w) ** 2, mpf(damping) * mpf(w)) for w in at]
    line("steady-state", case, {"c": damping}, at, values, parameter)

for k in range(1, 14):
    zeta = mpf(10.0**-k)
    c = 2 * zeta
    width = c * sqrt(4 - c**2)
    above, below = (sqrt((2 - c**2 + sign * width) / 2) for sign in (1, -1))
    line("bandwidth", f"zeta=1e-{k}", {"c": 2 * 10.0**-k}, [], [above - below], 10.0**-k)

# A block of 1 kg on 1 N/m with slip a: number of half-cycles, position and time of rest, path.
for n in (1, 10, 100, 10**3, 10**4, 10**6):
    for name, damping in (("", "0"), (" damped", "1e-3")):
        if damping != "0" and n > 1000:
            continue
        slip, start, c = mpf("0.01"), mpf(2 * n) * mpf("0.01") + mpf("0.0037"), mpf(damping)
        if damping != "0":
            theta = c * pi / sqrt(4 - c**2)
            b = slip * (1 + exp(-theta)) / (1 - exp(-theta))
            start = (slip * mpf("0.37") + b) * exp(theta * n) - b
            text = nstr(start, 12)
        else:
            text = f"{2 * n * 0.01 + 0.0037:.4f}"
        start = mpf(text)
        u, t, path, count = start, mpf(0), mpf(0), 0
        half = pi / sqrt(1 - c**2 / 4)
        decay = exp(-c / 2 * half)
        if c == 0:
            count = n
            u, t, path = (start - 2 * n * slip), n * half, n * (start + start - 2 * n * slip)
        else:
            while u > slip:
                following = decay * u - slip * (1 + decay)
                path, t, count, u = path + u + following, t + half, count + 1, following
        assert count == n, (count, n)
        assert abs(u) <= slip
        line("dry-friction", f"n={n}{name}", {"slip": "0.01", "x0": text, "c": damping}, [],
             [mpf(count), u * (-1) ** count, t, path], None if name else float(n))

for case, theta0, parameter in (("0.01 rad", 0.01, None), ("0.5 rad", 0.5, None), ("1 rad", 1.0, None), ("1.5 rad", 1.5, None),
                                ("2 rad", 2.0, None), ("2.8 rad", 2.8, None),
                                *((f"1e-{k} rad below the top", math.pi - 10.0**-k, 10.0**-k) for k in (1, 2, 4, 6, 8, 10, 12, 15))):
    line("pendulum-period", case, {"theta0": theta0}, [], [2 * pi / agm(1, cos(mpf(theta0) / 2))], parameter)

for case, theta0, parameter in (("0.001 rad", 0.001, 0.001), ("1e-5 rad", 1e-5, 1e-5), ("1e-7 rad", 1e-7, 1e-7), ("0.1 rad", 0.1, 0.1),
                                ("1 rad", 1.0, 1.0)):
    line("pendulum-excess", case, {"theta0": theta0}, [], [1 / agm(1, cos(mpf(theta0) / 2)) - 1], parameter)

# Thrown from the bottom with w, L = g = 1: the separatrix is w = 2.
def thrown(w, t):
    w, t = mpf(w), mpf(t)
    m = w**2 / 4
    if m < 1:
        return 2 * asin(sqrt(m) * ellipfun("sn", t, m=m))
    root, m = sqrt(m), 1 / m
    u = root * t
    turns = floor(u / (2 * ellipk(m)) + mpf(1) / 2)
    rest = u - turns * 2 * ellipk(m)
    return 2 * (asin(ellipfun("sn", rest, m=m)) + turns * pi)


SOME = [0.25 * i for i in range(81)]
for case, w, parameter in (("swing", 1.2, None), ("turn", 2.6, None),
                           *((f"1e-{k} below the separatrix", 2 - 2 * 10.0**-k, 10.0**-k) for k in (2, 5, 8, 11, 14)),
                           ("1e-8 above the separatrix", 2 + 2e-8, None)):
    line("pendulum-motion", case, {"w": w}, SOME, [thrown(w, t) for t in SOME], parameter)

for k in range(0, 16):
    first = 1 + 10.0**-k
    delta = log(mpf(first))
    line("decrement", f"ratio=1+1e-{k}", {"x1": first, "xn1": 1.0}, [], [delta / hypot(2 * pi, delta)], 10.0**-k)

# The double pendulum in absolute angles p and q (m = l = g = 1) with a spring between the rods that is prestretched by s:
# T = p'^2 + q'^2/2 + p' q' cos(p - q), V = -2 cos p - cos q + (q - p - s)^2, about the position at rest next to p = q = 0.
for case, prestretch in (("hanging", 0.0), ("prestretched", 0.3)):
    s = mpf(prestretch)
    p, q = findroot(lambda p, q: (2 * sin(p) - 2 * (q - p - s), sin(q) + 2 * (q - p - s)), (-0.1, 0.2)) if prestretch else (0, 0)
    line("linearisation", case, {"s": prestretch}, [],
         [2 * cos(p) + 2, mpf(-2), cos(q) + 2, mpf(2), cos(p - q), mpf(1)])
