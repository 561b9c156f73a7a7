"""Prints reference values of the oscillator, one JSON object a line: task, parameters, result of 50 digits.

The numbers of a line are read as the nearest binary64. Beside each result stands its local scale: the magnitude of the
terms that sum up to it, in the form that keeps them smallest. The stress lists are those of the closed forms: near and at
critical damping, far beyond it, near and at resonance, tiny and huge times, decay to the edge of underflow, constants
whose products leave the exponent range.

    cd tests/references
    python3 oscillator.py free > ../fixtures/references/free.jsonl
    python3 oscillator.py forced > ../fixtures/references/forced.jsonl
    python3 oscillator.py steady > ../fixtures/references/steady.jsonl
    python3 oscillator.py decrement > ../fixtures/references/decrement.jsonl
"""

import json
import math
import random
import sys

from mpmath import atan2, conj, cos, exp, fabs, hypot, im, log, mp, mpc, mpf, nstr, pi, re, sin, sqrt

mp.dps = 400
random.seed(3)


def digits(x):
    return nstr(x, 50, min_fixed=-5, max_fixed=20) if x is not None else None


def short(x):
    return nstr(x, 6, min_fixed=-5, max_fixed=20)


def line(task, parameters, result):
    print(json.dumps({"task": task, "params": parameters, "result": result}, separators=(",", ":")))


def uniform(low, high):
    """A number of four figures, log-uniform."""
    return float(f"{10 ** random.uniform(low, high):.4g}")


def signed(low, high):
    return uniform(low, high) * random.choice([-1, 1])


def beside(x, steps):
    """The binary64 so many places above x."""
    for _ in range(abs(steps)):
        x = math.nextafter(x, math.inf if steps > 0 else -math.inf)
    return x


# Free response


class Free:
    """Motion with its local scales, at one time."""

    def __init__(self, m, c, k, x0, v0):
        self.m, self.c, self.k, self.x0, self.v0 = map(mpf, (m, c, k, x0, v0))
        self.discriminant = self.c**2 - 4 * self.m * self.k
        self.root = sqrt(fabs(self.discriminant))
        self.decay = self.c / (2 * self.m)

    def regime(self):
        if self.c == 0:
            return "undamped"
        return "underdamped" if self.discriminant < 0 else "critical" if self.discriminant == 0 else "overdamped"

    def roots(self):
        return -2 * self.k / (self.c + self.root), -(self.c + self.root) / (2 * self.m)

    def at(self, t):
        """x, v and the scales of both."""
        t = mpf(t)
        x0, v0, decay = self.x0, self.v0, self.decay
        slope, bend = v0 + decay * x0, self.k / self.m * x0 + decay * v0
        if self.discriminant < 0:
            frequency = self.root / (2 * self.m)
            envelope, sine, cosine = exp(-decay * t), sin(frequency * t), cos(frequency * t)
            reach = min(fabs(t), 1 / frequency)
            return (envelope * (x0 * cosine + slope * sine / frequency),
                    envelope * (v0 * cosine - bend * sine / frequency),
                    envelope * (fabs(x0) + fabs(slope) * reach),
                    envelope * (fabs(v0) + fabs(bend) * reach))
        if self.discriminant == 0:
            envelope = exp(-decay * t)
            return (envelope * (x0 + slope * t), envelope * (v0 - decay * slope * t),
                    envelope * (fabs(x0) + fabs(slope * t)), envelope * (fabs(v0) + fabs(decay * slope * t)))
        slow, fast = self.roots()
        gap = self.root / self.m
        p, q = (v0 - fast * x0) / gap, -(v0 - slow * x0) / gap
        a, b = p * exp(slow * t), q * exp(fast * t)
        ramp = 1 - exp(-gap * t)
        near_x = exp(slow * t) * (fabs(x0) + fabs(q) * ramp)
        near_v = fabs(v0) * exp(fast * t) + fabs(slow * p) * ramp * exp(slow * t)
        return (a + b, slow * a + fast * b,
                min(near_x, fabs(a) + fabs(b)), min(near_v, fabs(slow * a) + fabs(fast * b)))


def free(m, c, k, x0, v0, times):
    motion = Free(m, c, k, x0, v0)
    samples = [motion.at(t) for t in times]
    regime = motion.regime()
    slow, fast = motion.roots() if regime == "overdamped" else (None, None)
    line("free_response", {"m": m, "c": c, "k": k, "x0": x0, "v0": v0, "t": times}, {
        "x": [digits(s[0]) for s in samples], "v": [digits(s[1]) for s in samples],
        "x_scale": [short(s[2]) for s in samples], "v_scale": [short(s[3]) for s in samples],
        "omega0": digits(sqrt(motion.k / motion.m)), "zeta": digits(motion.c / (2 * sqrt(motion.m * motion.k))),
        "regime": regime,
        "omega_d": digits(motion.root / (2 * motion.m)) if regime in ("undamped", "underdamped") else None,
        "r_slow": digits(slow), "r_fast": digits(fast)})


def free_cases():
    ordinary = [0.0, 1e-8, 0.3, 2.0, 17.0]
    for k in range(1, 16):
        for sign in (-1, 1):
            free(1.0, 2 * (1 + sign * 10.0**-k), 1.0, 1.0, -0.3, ordinary + [700.0])
    for m, k in ((1.0, 1.0), (0.7, 3.1), (2.3e-5, 8.1e7)):
        critical = 2 * math.sqrt(m * k)
        rate = math.sqrt(k / m)
        for steps in (-2, -1, 0, 1, 2):
            free(m, beside(critical, steps), k, 0.4, 1.1 * rate, [t / rate for t in (0.01, 1.0, 30.0, 600.0)])
    for m, c, k in ((0.1, 0.2, 0.1), (0.3, 0.6, 0.3), (0.7, 1.4, 0.7), (1e-7, 2e-7, 1e-7), (3.0, 6.0, 3.0)):
        free(m, c, k, -1.0, 2.0, ordinary)
    for power in range(1, 13):
        zeta = 10.0**power
        free(1.0, 2 * zeta, 1.0, 1.0, -1.0, [1e-20, 0.1 / zeta, 1.0, zeta, 50 * zeta, 1400 * zeta])
        free(0.3, 2 * zeta, 0.7, -1e-3, 1e3, [1e-3 / zeta, 1 / zeta, 0.5, zeta])
    for c in (2.5, 3.0, 20.0, 2.0000001):
        slow, fast = Free(1.0, c, 1.0, 0, 0).roots()
        for root in (slow, fast):
            free(1.0, c, 1.0, 1.0, float(root), [0.01, 0.3, 1.0, 3.0, 20.0, 100.0])
            free(1.0, c, 1.0, 0.3, float(root * mpf(0.3)), [0.01, 1.0, 10.0, 40.0])
    decades = [10.0**k for k in range(-12, 14)]
    free(1.3, 0.0, 2.7, 0.8, -0.6, decades)
    free(1.3, 1e-13, 2.7, 0.8, -0.6, decades)
    free(1.0, 2e-12, 1.0, 1.0, 0.0, [1e3, 1e6, 1e9, 1e12, 1e13, 3e14])
    for c in (0.02, 0.5, 1.9, 2.0, 2.1, 5.0):
        rate = -float(Free(1.0, c, 1.0, 0, 0).roots()[0]) if c > 2 else c / 2
        free(1.0, c, 1.0, 1.0, 0.5, [x / rate for x in (100.0, 400.0, 600.5, 700.0, 709.0, 740.0)])
        free(1.0, c, 1.0, 1e300, -1e300, [x / rate for x in (1.0, 599.0, 650.0, 800.0, 1200.0, 1390.0)])
    free(1.0, 0.5, 1.0, 0.0, 0.0, [0.0, 1.0])
    free(1.0, 5.0, 1.0, 0.0, 0.0, [0.0, 1.0])
    extremes = ((1e-300, 1e-10, 1e300), (1e300, 1e10, 1e-300), (1e-300, 3e-300, 1e-300), (1e300, 5e300, 1e300),
                (5e-324, 1e-323, 5e-324), (1e-310, 3e-320, 2e-309), (1e-200, 1e-150, 1e-100), (1e200, 1e-50, 1e-190),
                (4e-300, 1e-5, 1e300), (2.0, 1e-300, 1e-300), (1e-5, 1e-310, 1e250))
    for m, c, k in extremes:
        rate = float(sqrt(mpf(k) / mpf(m)))
        unit = 1 / rate
        times = [t for t in (0.7 * unit, 5 * unit, 100 * unit) if 0 < t < 1e305]
        v0 = -0.4 * rate if 1e-300 < rate < 1e300 else 0.0
        free(m, c, k, 0.6, v0, times)
    free(1.0, 0.1, 1.0, 1e-310, 0.0, [0.5, 3.0])
    free(1.0, 0.1, 1.0, 0.0, 5e-324, [0.5, 3.0])
    free(1.0, 0.1, 1.0, 1e308, -1e308, [0.0, 0.5, 3.0])
    for _ in range(150):
        m, k = uniform(-3, 3), uniform(-3, 4)
        rate = math.sqrt(k / m)
        c = float(f"{2 * math.sqrt(m * k) * 10 ** random.uniform(-4, 2):.4g}")
        free(m, c, k, signed(-3, 0), signed(-3, 0) * rate, [uniform(-3, 2) / rate for _ in range(4)])


# Forced response


def forced(m, c, k, force, frequency, x0, v0, times, part=re):
    """Under the real part of a complex force, the cosine, or under the imaginary one, the sine."""
    motion = Free(m, c, k, x0, v0)
    start = Free(m, c, k, x0, v0)
    w = mpf(frequency)
    # Equal nodes are taken apart by less than any digit printed.
    root = sqrt(mpc(motion.discriminant)) if motion.discriminant != 0 else mpf(10) ** -130 * motion.c
    first, second = (-motion.c + root) / (2 * motion.m), (-motion.c - root) / (2 * motion.m)
    third = mpc(0, w)
    if min(fabs(third - first), fabs(third - second)) < mpf(10) ** -100 * (fabs(first) + fabs(third)):
        third += mpf(10) ** -130 * fabs(first)

    def difference(t):
        """The second divided difference of exp(z t), and its derivative in time."""
        a = [(z, exp(z * t) / p) for z, p in (
            (first, (first - second) * (first - third)),
            (second, (second - first) * (second - third)),
            (third, (third - first) * (third - second)))]
        return sum(y for _, y in a), sum(z * y for z, y in a)

    gain = mpf(force) / motion.m
    rows = []
    for t in map(mpf, times):
        x, v = difference(t)
        near = [difference(t * mpf(f)) for f in ("1", "0.93", "0.8")]
        free_x, free_v, scale_x, scale_v = start.at(t)
        rows.append((free_x + gain * part(x), free_v + gain * part(v),
                     scale_x + fabs(gain) * max(fabs(y) for y, _ in near),
                     scale_v + fabs(gain) * max(fabs(y) for _, y in near)))
    line("forced_response" if part is re else "forced_by_sine",
         {"m": m, "c": c, "k": k, "F0": force, "Omega": frequency, "x0": x0, "v0": v0, "t": times},
         {"x": [digits(r[0]) for r in rows], "v": [digits(r[1]) for r in rows],
          "x_scale": [short(r[2]) for r in rows], "v_scale": [short(r[3]) for r in rows]})


def forced_cases():
    times = [1e-9, 0.01, 0.9, 3.0, 40.0, 1e4]
    for k in range(1, 16, 2):
        for sign in (-1, 1):
            for c in (0.0, 1e-6, 0.05):
                forced(1.0, c, 1.0, 1.0, 1 + sign * 10.0**-k, 0.0, 0.0, times)
    for c in (0.0, 1e-15, 1e-9, 1e-3, 0.3, 1.0, 2.0, 2.0000000001, 3.0, 1e3, 1e6):
        for frequency in (0.0, 1e-9, 0.3, beside(1.0, -1), 1.0, beside(1.0, 1), 2.7, 1e3, 1e8):
            forced(1.0, c, 1.0, -2.5, frequency, 0.0, 0.0, [1e-12, 0.3, 1.4, 1.6, 25.0, 1e5])
    for frequency in (0.7, 1.0, 5.0):
        for c in (0.0, 1e-12, 1e-4):
            forced(1.3, c, 2.1, 1.0, frequency, 0.0, 0.0, [1e6, 1e8, 1e9])
    for c in (2.0, 1.9999999, 2.0000001):
        forced(1.0, c, 1.0, 1.0, 1.0, 0.5, -0.5, [0.1, 1.0, 10.0, 100.0])
    forced(1e-200, 1e-205, 1e-190, 1e-100, 1e5, 0.0, 0.0, [1e-7, 1e-5, 1e-3])
    forced(1e200, 1e195, 1e210, 1e200, 1.01e5, 1e-10, 0.0, [1e-7, 1e-5, 1e-3])
    forced(1.0, 0.1, 1.0, 1.0, 1e100, 0.0, 0.0, [1e-101, 1e-100, 1e-99])
    forced(1.0, 0.1, 1.0, 1.0, 1e-100, 0.3, 0.0, [0.5, 50.0, 1e3])
    for c in (0.0, 1e-9, 0.3, 2.0, 50.0):
        for frequency in (1e-9, 0.4, beside(1.0, 1), 1.0, 1.001, 3.0, 1e7):
            forced(1.0, c, 1.0, 1.5, frequency, 0.0, 0.0, [1e-6, 0.5, 2.0, 30.0, 1e5], im)
    for _ in range(100):
        m, k = uniform(-2, 2), uniform(-2, 3)
        rate = math.sqrt(k / m)
        c = float(f"{2 * math.sqrt(m * k) * 10 ** random.uniform(-5, 1.5):.4g}")
        frequency = float(f"{rate * 10 ** random.uniform(-1.5, 1.5):.4g}")
        forced(m, c, k, signed(-1, 2), frequency, signed(-3, 0), signed(-3, 0) * rate,
               [uniform(-3, 3) / rate for _ in range(4)])


# Steady state and resonance


def steady(m, c, k, force, frequency):
    M, C, K, F, w = map(mpf, (m, c, k, force, frequency))
    residual, loss = K - M * w**2, C * w
    modulus = hypot(residual, loss)
    line("steady_amplitude_phase", {"m": m, "c": c, "k": k, "F0": force, "Omega": frequency},
         dict(zip(("X", "phi", "power", "transmissibility"), (None,) * 4)) if modulus == 0 else {
             "X": digits(F / modulus), "phi": digits(atan2(loss, residual)),
             "power": digits(C * (w * F / modulus) ** 2 / 2),
             "transmissibility": digits(hypot(K, loss) / modulus)})


def transfer(m, c, k, frequency):
    """Base motion of 0.25 m, unbalance of 0.5 kg m, and the complex quotients."""
    M, C, K, w = map(mpf, (m, c, k, frequency))
    dynamic = mpc(K - M * w**2, C * w)
    passed_on = mpc(K, C * w) / dynamic
    line("transfer", {"m": m, "c": c, "k": k, "Omega": frequency}, {
        "relative": digits(M * w**2 / fabs(dynamic) / 4), "unbalance": digits(w**2 / fabs(dynamic) / 2),
        "magnification": digits(K / fabs(dynamic)), "transmission_lag": digits(atan2(-im(passed_on), re(passed_on))),
        "resistance": digits(C), "reactance": digits(M * w - K / w),
        "receptance_re": digits(re(1 / dynamic)), "receptance_im": digits(im(1 / dynamic)),
        "mobility_re": digits(re(mpc(0, w) / dynamic)), "mobility_im": digits(im(mpc(0, w) / dynamic)),
        "accelerance_re": digits(-w**2 * re(1 / dynamic)), "accelerance_im": digits(-w**2 * im(1 / dynamic))})


def resonance(m, c, k):
    M, C, K = map(mpf, (m, c, k))
    n2 = 2 * M * K - C**2
    zeta = C / (2 * sqrt(M * K))
    peaked = zeta < 1 / sqrt(mpf(2))
    two_sided = zeta < sin(pi / 8)
    width = C * sqrt(4 * M * K - C**2) if peaked else None
    below = sqrt(n2 - width) / (sqrt(mpf(2)) * M) if two_sided else None
    above = sqrt(n2 + width) / (sqrt(mpf(2)) * M) if peaked else None
    h = sqrt(4 * M * K + C**2)
    line("resonance_bandwidth", {"m": m, "c": c, "k": k}, {
        "omega_r": digits(sqrt(n2) / (sqrt(mpf(2)) * M) if peaked else None),
        "gain_peak": digits(2 * M * K / width if peaked and C > 0 else None),
        "omega1": digits(below), "omega2": digits(above),
        "bandwidth": digits(above - below if two_sided else None),
        "Q": digits(sqrt(M * K) / C if C > 0 else None),
        "vel_omega1": digits(2 * K / (h + C)), "vel_omega2": digits((h + C) / (2 * M)), "vel_bandwidth": digits(C / M)})


def steady_cases():
    for k in range(1, 17):
        for sign in (-1, 1):
            for c in (0.0, 1e-3, 10.0**-k):
                steady(1.0, c, 1.0, 2.0, 1 + sign * 10.0**-k)
    for steps in (-2, -1, 0, 1, 2):
        for c in (0.0, 1e-18, 1e-3, 5.0):
            steady(1.0, c, 1.0, 1.0, beside(1.0, steps))
            steady(0.7, c, 3.3, 1.0, beside(math.sqrt(3.3 / 0.7), steps))
    for k in range(1, 300, 20):
        steady(1.0, 10.0**-k, 4.0, 3.0, 2.0)
    for frequency in (1e-300, 1e-200, 1e-20, 1e-3, 1e3, 1e20, 1e100, 1e150):
        for c in (0.0, 1e-5, 3.0, 1e8):
            steady(2.0, c, 5.0, 0.5, frequency)
    for m, c, k in ((1e-300, 1e-300, 1e-300), (1e300, 1e290, 1e300), (1e-200, 1e-100, 1e-10), (5e-324, 1e-320, 1e-310)):
        rate = float(sqrt(mpf(k) / mpf(m)))
        for ratio in (0.5, 1.0, 3.0):
            steady(m, c, k, 1e-150, rate * ratio)
    for _ in range(300):
        m, k = uniform(-3, 3), uniform(-3, 3)
        steady(m, float(f"{2 * math.sqrt(m * k) * 10 ** random.uniform(-4, 2):.4g}"), k, uniform(-2, 3),
               float(f"{math.sqrt(k / m) * 10 ** random.uniform(-2, 2):.4g}"))
    for k in range(1, 16, 2):
        for sign in (-1, 1):
            transfer(1.0, 10.0**-k, 1.0, 1 + sign * 10.0**-k)
    for _ in range(60):
        m, k = uniform(-3, 3), uniform(-3, 3)
        transfer(m, float(f"{2 * math.sqrt(m * k) * 10 ** random.uniform(-4, 2):.4g}"), k,
                 float(f"{math.sqrt(k / m) * 10 ** random.uniform(-2, 2):.4g}"))
    for k in range(1, 17):
        resonance(1.0, 2 * 10.0**-k, 1.0)
        resonance(0.37, 2 * 10.0**-k, 5.1)
    for threshold in (math.sin(math.pi / 8), math.sqrt(0.5)):
        for k in (2, 6, 10, 13):
            for sign in (-1, 1):
                resonance(1.0, 2 * (threshold + sign * 10.0**-k), 1.0)
    for c in (0.0, 1e-300, 1.0, 3.0, 1e6, 1e200):
        resonance(2.0, c, 3.0)
    resonance(1e-300, 1e-302, 1e-300)
    resonance(1e300, 1e298, 1e300)
    for _ in range(100):
        m, k = uniform(-3, 3), uniform(-3, 3)
        resonance(m, float(f"{2 * math.sqrt(m * k) * 10 ** random.uniform(-5, 0.5):.4g}"), k)


# Logarithmic decrement


def decrement(first, last, n, period, mass):
    a, b, T, M = map(mpf, (first, last, period, mass))
    delta = log(a / b) / n
    natural = hypot(2 * pi, delta) / T
    line("log_decrement", {"x1": first, "xn1": last, "n": n, "Td": period, "m": mass}, {
        "delta": digits(delta), "zeta": digits(delta / hypot(2 * pi, delta)), "lambda": digits(delta / T),
        "omega0": digits(natural), "c": digits(2 * M * delta / T), "k": digits(M * natural**2)})


def decrement_cases():
    for k in range(1, 16):
        decrement(1 + 10.0**-k, 1.0, 1, 0.5, 2.0)
        decrement(0.1 * (1 + 10.0**-k), 0.1, 7, 1.3, 0.4)
    decrement(beside(1.0, 1), 1.0, 1, 1.0, 1.0)
    decrement(beside(0.3, 1), 0.3, 3, 1e-3, 1.0)
    for ratio in (1.9999, 2.0, 2.0001, 10.0, 1e10, 1e100, 1e300):
        decrement(ratio, 1.0, 2, 0.7, 3.0)
    decrement(1e308, 1e-308, 3, 1.0, 1.0)
    decrement(1e-300, 1e-310, 5, 1.0, 1.0)
    decrement(-0.8, -0.2, 4, 0.25, 1.5)
    for _ in range(60):
        last = uniform(-3, 2)
        decrement(float(f"{last * (1 + 10 ** random.uniform(-3, 2)):.4g}"), last, random.randint(1, 30), uniform(-2, 1), uniform(-1, 2))


{"free": free_cases, "forced": forced_cases, "steady": steady_cases, "decrement": decrement_cases}[sys.argv[1]]()
