"""Prints reference values of linearised double pendulums, one JSON object a line, with 50 digits.

    python3 tests/references/linearisation.py > tests/fixtures/references/linearisation.jsonl

T = (m1 + m2) a^2 p'^2/2 + m2 b^2 q'^2/2 + m2 a b p' q' cos(p - q),
V = -(m1 + m2) g a cos p - m2 g b cos q + k (q - p - s)^2/2, in absolute angles, about the position at rest next to zero.
A line holds the data, the entries K11, K12, K22, M11, M12, M22, and the sums of the magnitudes of their terms.
"""

import json
import random

from mpmath import cos, fabs, findroot, mp, mpf, nstr, sin

mp.dps = 80
random.seed(11)


def digits(x):
    return nstr(x, 50, min_fixed=-5, max_fixed=20)


def line(m1, m2, a, b, g, k, s):
    data = {"m1": m1, "m2": m2, "a": a, "b": b, "g": g, "k": k, "s": s}
    m1, m2, a, b, g, k, s = map(mpf, data.values())
    first, second = (m1 + m2) * g * a, m2 * g * b
    p, q = mpf(0), mpf(0)
    if s:
        p, q = findroot(lambda p, q: (first * sin(p) - k * (q - p - s), second * sin(q) + k * (q - p - s)),
                        (-float(k * s / (first + k)), float(k * s / (second + k))))
    entries = (first * cos(p) + k, -k, second * cos(q) + k, (m1 + m2) * a**2, m2 * a * b * cos(p - q), m2 * b**2)
    scales = (fabs(first * cos(p)) + k, k, fabs(second * cos(q)) + k, entries[3], fabs(entries[4]), entries[5])
    print(json.dumps({"data": data, "entries": [digits(x) for x in entries], "scales": [nstr(x, 6) for x in scales]},
                     separators=(",", ":")))


def number(low, high):
    return float(f"{random.uniform(low, high):.4g}")


line(1.0, 1.0, 1.0, 1.0, 9.81, 0.0, 0.0)
line(1.0, 1e-6, 1.0, 1.0, 9.81, 2.0, 0.0)
line(1e-3, 1e3, 0.1, 10.0, 9.81, 1e-6, 0.0)
for _ in range(20):
    line(number(0.2, 5), number(0.2, 5), number(0.1, 3), number(0.1, 3), 9.81, number(0.1, 60), 0.0)
for _ in range(40):
    line(number(0.2, 5), number(0.2, 5), number(0.1, 3), number(0.1, 3), 9.81, number(0.1, 20), number(-1, 1))
