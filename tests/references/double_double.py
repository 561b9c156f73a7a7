"""Prints reference values of the double-double functions, one JSON list a line: function, arguments, value.

Arguments are pairs of binary64 as integers (bit patterns), values pairs likewise: the double-double nearest to the value.

    python3 tests/references/double_double.py > tests/fixtures/references/double-double.jsonl
"""

import json
import random
import struct

from mpmath import (acos, acosh, asin, asinh, atan, atan2, atanh, cos, cosh, exp, expm1, hypot, isfinite, log, log1p, mp,
                    mpf, power, sin, sinh, sqrt, tan, tanh)

mp.prec = 1600
random.seed(20)


def bits(x):
    return struct.unpack("<q", struct.pack("<d", x))[0]


def pair(x):
    hi = float(x)
    return [bits(hi), bits(float(mpf(x) - mpf(hi)))]


def number(magnitude):
    """A random double-double of about this magnitude."""
    hi = float(mpf(magnitude) * random.uniform(0.5, 2) * random.choice([-1, 1]))
    return mpf(hi) + mpf(hi * random.uniform(-1, 1) * 2.0**-54)


def spread(low, high, count):
    return [number(mpf(10) ** random.uniform(low, high)) for _ in range(count)]


def near(centre, count):
    return [centre + number(mpf(10) ** -random.uniform(0.5, 15)) for _ in range(count)]


def rounded(x):
    hi = float(x)
    return mpf(hi) + mpf(float(x - mpf(hi)))


every = spread(-30, 2.8, 40) + spread(-3, 1, 40)
positive = [abs(x) for x in spread(-300, 300, 40) + spread(-2, 2, 40) + near(mpf(1), 40)]
unit = [x for x in spread(-20, -0.02, 40) + near(mpf(1), 40) + near(mpf(-1), 40) if abs(x) <= 1]
turns = spread(-20, 3, 60) + spread(3, 25, 40) + spread(25, 300, 20)
turns += [mp.pi * k / 2 + d for k in (1, 2, 3, 7, 10**6, 10**13) for d in near(mpf(0), 8)]

cases = [
    ("sqrt", sqrt, positive),
    ("exp", exp, every),
    ("expm1", expm1, every),
    ("ln", log, positive),
    ("ln_1p", log1p, [x for x in every if x > -1] + near(mpf(-1), 30)),
    ("sin", sin, turns),
    ("cos", cos, turns),
    ("tan", tan, turns),
    ("asin", asin, unit),
    ("acos", acos, unit),
    ("atan", atan, spread(-30, 30, 80)),
    ("sinh", sinh, every),
    ("cosh", cosh, every),
    ("tanh", tanh, every),
    ("asinh", asinh, spread(-30, 300, 80)),
    ("acosh", acosh, [x for x in spread(0, 300, 80) + near(mpf(1), 60) if x >= 1]),
    ("atanh", atanh, [x for x in unit if abs(x) < 1]),
]
for name, function, arguments in cases:
    for x in map(rounded, arguments):
        if name in ("ln_1p",) and x <= -1 or name in ("acosh",) and x < 1 or abs(x) > 1 and name in ("asin", "acos"):
            continue
        value = function(x)
        if isfinite(value) and mpf("1e-290") < abs(value) < mpf("1e300"):
            print(json.dumps([name, [pair(x)], pair(value)], separators=(",", ":")))
for y, x in zip(spread(-10, 10, 80), spread(-10, 10, 80)):
    y, x = rounded(y), rounded(x)
    print(json.dumps(["atan2", [pair(y), pair(x)], pair(atan2(y, x))], separators=(",", ":")))
    print(json.dumps(["hypot", [pair(y), pair(x)], pair(hypot(y, x))], separators=(",", ":")))
for x, y in zip(spread(-2, 2, 80), spread(-1, 0.5, 80)):
    x, y = abs(rounded(x)), rounded(y)
    print(json.dumps(["pow", [pair(x), pair(y)], pair(power(x, y))], separators=(",", ":")))
for n in (-40, -3, 2, 3, 10, 77):
    for x in spread(-1, 1, 8):
        x = rounded(x)
        print(json.dumps(["powi", [pair(x), [n, 0]], pair(x**n)], separators=(",", ":")))
