"""Prints reference values of the pendulum, one JSON object a line: task, parameters, result of 50 digits.

The numbers of a line are read as the nearest binary64. The functions are those of mpmath, by theta series.

    python3 tests/references/pendulum.py > tests/fixtures/references/pendulum.jsonl
"""

import json
import math
import random

from mpmath import agm, asin, atan2, cos, cosh, ellipf, ellipfun, ellipk, exp, floor, log, mp, mpf, nstr, pi, sin, sqrt, tan

mp.dps = 120
random.seed(7)


def digits(x):
    return nstr(x, 50, min_fixed=-5, max_fixed=20)


def line(task, parameters, result):
    print(json.dumps({"task": task, "params": parameters, "result": result}, separators=(",", ":")))


def period(L, g, theta0):
    m = sin(mpf(theta0) / 2) ** 2
    small = 2 * pi * sqrt(mpf(L) / mpf(g))
    # Twice the digits, because the excess of a small swing is below the precision of the quotient.
    with mp.workdps(500):
        m = sin(mpf(theta0) / 2) ** 2
        excess = ellipk(m) * 2 / pi - 1
    line("pendulum_period", {"L": L, "g": g, "theta0": theta0},
         {"T": digits(small * (1 + excess)), "T_small": digits(small), "excess": digits(excess)})


def motion(L, g, theta0, w, times):
    start, velocity, rate = mpf(theta0), mpf(w), sqrt(mpf(g) / mpf(L))
    kappa = velocity / (2 * rate)
    turns = 2 * pi * floor(start / (2 * pi) + mpf(1) / 2)
    half = (start - turns) / 2
    energy = velocity**2 * mpf(L) / (4 * mpf(g)) + sin(half) ** 2
    result = [state(mpf(t), half, kappa, energy, rate) for t in times]
    line("pendulum_motion", {"L": L, "g": g, "theta0": theta0, "omega0": w, "t": times},
         {"theta": [digits(turns + 2 * half) for half, _ in result], "omega": [digits(2 * rate * k) for _, k in result]})


def state(t, half, kappa, energy, rate):
    """Half the angle and the reduced velocity at a time."""
    if energy == 0:
        return mpf(0), mpf(0)
    if energy == 1:
        sign = 1 if kappa > 0 else -1
        u = mp.asinh(sign * tan(half)) + rate * t
        return sign * mp.atan(mp.sinh(u)), sign / cosh(u)
    if energy < 1:
        k = sqrt(energy)
        amplitude = atan2(sin(half), kappa)
        u = incomplete(amplitude, energy) + rate * t
        u -= 4 * ellipk(energy) * floor(u / (4 * ellipk(energy)) + mpf(1) / 2)
        sn, cn, dn = (ellipfun(name, u, m=energy) for name in ("sn", "cn", "dn"))
        return atan2(k * sn, dn), k * cn
    sign, m = (1 if kappa > 0 else -1), 1 / energy
    u = sign * incomplete(half, m) + sqrt(energy) * rate * t
    periods = floor(u / (4 * ellipk(m)) + mpf(1) / 2)
    u -= 4 * ellipk(m) * periods
    sn, cn, dn = (ellipfun(name, u, m=m) for name in ("sn", "cn", "dn"))
    return sign * (atan2(sn, cn) + 2 * pi * periods), sign * sqrt(energy) * dn


def incomplete(amplitude, m):
    """F, also beyond a right angle."""
    if abs(amplitude) == pi / 2:
        return ellipk(m) * (1 if amplitude > 0 else -1)
    turns = floor(amplitude / pi + mpf(1) / 2)
    return 2 * turns * ellipk(m) + ellipf(amplitude - turns * pi, m)


def spread_times(base):
    return [0.0] + [base * random.uniform(0.5, 1.5) * 10.0**k for k in (-9, -3, -1, 0, 0.7, 2, 4)]


BODIES = [(1.0, 1.0), (1.0, 9.81), (0.25, 9.80665), (12.7, 1.62)]

for L, g in BODIES:
    for k in list(range(0, 21, 2)) + [40, 80, 120, 140, 150, 160]:
        period(L, g, 10.0**-k)
    for k in range(1, 16):
        period(L, g, math.pi - 10.0**-k)
    period(L, g, math.pi)
    period(L, g, math.nextafter(math.pi, 0))
    for theta0 in (2.0, 2.5, 3.0, 2.94, 2.9412, 2.95, -1.3, 2.2345):
        period(L, g, theta0)
for _ in range(60):
    period(random.uniform(0.1, 5), random.uniform(1, 25), random.uniform(0.01, math.pi))
period(1e-300, 1e300, 2.0)
period(1e300, 1e-300, 2.0)

# Released from rest.
for L, g in BODIES[:2]:
    for k in (0, 1, 2, 3, 5, 8, 12, 20, 40, 80, 160):
        motion(L, g, 10.0**-k, 0.0, spread_times(1.0))
    for k in range(1, 16, 2):
        motion(L, g, math.pi - 10.0**-k, 0.0, spread_times(3.0))
    motion(L, g, math.pi, 0.0, spread_times(5.0) + [38.0, 39.0, 40.0, 80.0])
    for theta0 in (2.0, -2.5, 3.0, 1.2):
        motion(L, g, theta0, 0.0, spread_times(1.0) + [1e6, 1.23e7, 6.3e7])
# Thrown from the bottom: at the separatrix, and next to it on both sides.
for L, g in [(1.0, 1.0), (4.0, 9.0), (1.0, 9.81), (0.3, 9.81)]:
    top = 2 * math.sqrt(g / L)
    speeds = [top, math.nextafter(top, 0), math.nextafter(top, 99)]
    speeds += [top * (1 + s * 10.0**-k) for k in range(1, 16, 2) for s in (-1, 1)]
    for w in speeds + [-w for w in speeds[:6]]:
        motion(L, g, 0.0, w, spread_times(2.0) + [17.3, 36.8, 39.1])
    for w in (1e-160, 1e-20, 1e-8, 0.1, 0.9 * top, 1.5 * top, 10 * top, 1e3 * top, 1e8 * top, -3 * top):
        motion(L, g, 0.0, w, spread_times(1.0) + [1e7])
# Any start.
for _ in range(60):
    L, g = random.uniform(0.1, 5), random.uniform(1, 25)
    motion(L, g, random.uniform(-20, 20), random.uniform(-3, 3) * math.sqrt(g / L), spread_times(1.0))
for theta0, w in [(3.0, 0.1), (3.0, -0.1), (-3.1, 0.2), (3.14, 1e-9), (3.2, 0.0), (math.pi / 2, math.sqrt(2.0)),
                  (1e5, 0.3), (-1.0, 2.5), (2.0, 1e-12), (1e-12, 2.0)]:
    motion(1.0, 1.0, theta0, w, spread_times(1.0) + [1e7])
