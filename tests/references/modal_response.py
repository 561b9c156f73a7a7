"""Prints free motions of spring networks with dampers, and steady states, one JSON object a line.

Displacements and velocities come from the exponential of the state matrix, in enough digits for its norm, so that nothing
is shared with a modal solution; 30 digits are printed. Data are the binary64 numbers printed.

    python3 tests/references/modal_response.py > tests/fixtures/references/modal-response.jsonl
    python3 tests/references/modal_response.py forced > tests/fixtures/references/forced-modal-response.jsonl
"""

import json
import sys

from mpmath import cos, expm, lu_solve, matrix, mp, mpc, mpf, nstr


def assembled(count, links):
    k = matrix(count)
    for i, j, value in links:
        for p in (i, j):
            if p:
                k[p - 1, p - 1] += mpf(value)
        if i and j:
            k[i - 1, j - 1] -= mpf(value)
            k[j - 1, i - 1] -= mpf(value)
    return k


def parts(masses, springs, dampers, rayleigh):
    n = len(masses)
    m = matrix(n)
    for i, mass in enumerate(masses):
        m[i, i] = mpf(mass)
    k = assembled(n, springs)
    c = assembled(n, dampers) + mpf(rayleigh[0]) * m + mpf(rayleigh[1]) * k
    return m, c, k


def generator(masses, springs, dampers, rayleigh):
    n = len(masses)
    m, c, k = parts(masses, springs, dampers, rayleigh)
    a = matrix(2 * n)
    for i in range(n):
        a[i, n + i] = mpf(1)
        for j in range(n):
            a[n + i, j] = -k[i, j] / m[i, i]
            a[n + i, n + j] = -c[i, j] / m[i, i]
    return a


def norm(a):
    return max(sum(abs(a[i, j]) for i in range(a.rows)) for j in range(a.cols))


def moved(a, state, time):
    """exp(A t) z by scaling to norm 1/4, a Taylor series, and squaring."""
    size = norm(a) * time
    squarings = max(0, int(mp.log(size, 2)) + 3) if size else 0
    mp.dps = 45 + int(0.7 * squarings)
    small = a * (mpf(time) / mpf(2) ** squarings)
    term = total = mp.eye(a.rows)
    order = 1
    while order < 400:
        term = term * small / order
        total = total + term
        if norm(term) < mpf(10) ** (-mp.dps):
            break
        order += 1
    for _ in range(squarings):
        total = total * total
    return total * state


def response(name, masses, springs, x0, v0, times, dampers=(), rayleigh=(0.0, 0.0)):
    n = len(masses)
    mp.dps = 80
    a = generator(masses, springs, dampers, rayleigh)
    xs, vs = [], []
    for time in times:
        mp.dps = 80
        z = moved(a, matrix([mpf(x) for x in x0 + v0]), time)
        xs.append([nstr(z[i], 30) for i in range(n)])
        vs.append([nstr(z[n + i], 30) for i in range(n)])
    entry = {"name": name, "masses": masses, "springs": springs, "dampers": list(dampers), "rayleigh": list(rayleigh),
             "x0": x0, "v0": v0, "t": times, "x": xs, "v": vs}
    print(json.dumps(entry, separators=(",", ":")), flush=True)


def steady(name, masses, springs, forces, frequencies, dampers=(), rayleigh=(0.0, 0.0)):
    n = len(masses)
    mp.dps = 80
    m, c, k = parts(masses, springs, dampers, rayleigh)
    amplitudes = []
    for frequency in frequencies:
        omega = mpf(frequency)
        z = matrix(n)
        for i in range(n):
            for j in range(n):
                z[i, j] = mpc(k[i, j] - omega**2 * m[i, j], omega * c[i, j])
        solution = lu_solve(z, matrix([mpc(f) for f in forces]))
        amplitudes.append([[nstr(x.real, 30), nstr(x.imag, 30)] for x in solution])
    entry = {"name": name, "masses": masses, "springs": springs, "dampers": list(dampers), "rayleigh": list(rayleigh),
             "forces": forces, "frequencies": frequencies, "amplitudes": amplitudes}
    print(json.dumps(entry, separators=(",", ":")), flush=True)


def forced(name, masses, springs, x0, v0, cosine, sine, frequency, times, dampers=(), rayleigh=(0.0, 0.0)):
    """The force is two more components of the state, which turn with its angular frequency."""
    n = len(masses)
    mp.dps = 80
    free = generator(masses, springs, dampers, rayleigh)
    a = matrix(2 * n + 2)
    for i in range(2 * n):
        for j in range(2 * n):
            a[i, j] = free[i, j]
    for i in range(n):
        a[n + i, 2 * n] = mpf(cosine[i]) / mpf(masses[i])
        a[n + i, 2 * n + 1] = mpf(sine[i]) / mpf(masses[i])
    a[2 * n, 2 * n + 1] = -mpf(frequency)
    a[2 * n + 1, 2 * n] = mpf(frequency)
    xs, vs = [], []
    for time in times:
        mp.dps = 80
        z = moved(a, matrix([mpf(x) for x in x0 + v0 + [1.0, 0.0]]), time)
        xs.append([nstr(z[i], 30) for i in range(n)])
        vs.append([nstr(z[n + i], 30) for i in range(n)])
    entry = {"name": name, "masses": masses, "springs": springs, "dampers": list(dampers), "rayleigh": list(rayleigh),
             "x0": x0, "v0": v0, "cosine": cosine, "sine": sine, "frequency": frequency, "t": times, "x": xs, "v": vs}
    print(json.dumps(entry, separators=(",", ":")), flush=True)


def chain(springs):
    return [[i, i + 1, k] for i, k in enumerate(springs) if k]


SHORT = [0.5, 3.0, 20.0]
LONG = [1e3, 1e6, 1e9]

TWO = [1.0, 2.0], [[0, 1, 3.0], [1, 2, 2.0], [2, 0, 1.0]]
FIVE = [1.0, 2.0, 1.0, 0.5, 1.5], chain([1.0, 2.0, 1.5, 0.75, 1.25])
FIVE_STATE = [0.1, -0.2, 0.3, 0.0, 1.0], [0.0, 1.0, -0.5, 0.25, 0.0]

if sys.argv[1:] == ["forced"]:
    REST = [0.0, 0.0], [0.0, 0.0]
    for frequency in (0.3, 1.0, 1.0000001, 1.7, 2.1):
        # The lower natural frequency of this pair is 1.
        forced(f"two at {frequency}", *TWO, *REST, [1.0, -0.5], [0.0, 0.0], frequency, SHORT + LONG)
        forced(f"two at {frequency}, by a sine", *TWO, [0.5, 0.0], [0.0, -1.0], [0.0, 0.3], [1.0, -0.5], frequency,
               SHORT + [1e3, 1e6])
        forced(f"two at {frequency}, lightly damped", *TWO, [0.5, 0.0], [0.0, -1.0], [1.0, -0.5], [0.2, 0.0], frequency,
               SHORT + LONG, rayleigh=(1e-6, 0.0))
        forced(f"two at {frequency}, damped", *TWO, [0.5, 0.0], [0.0, -1.0], [1.0, -0.5], [0.2, 0.0], frequency,
               SHORT + [1e4], rayleigh=(0.02, 0.01))
        forced(f"two at {frequency}, coupled", *TWO, [0.5, 0.0], [0.0, -1.0], [1.0, -0.5], [0.2, 0.0], frequency,
               SHORT + [100.0], [[1, 2, 0.3]])
    forced("five", *FIVE, *FIVE_STATE, [0.0, 1.0, 0.0, 0.0, -2.0], [0.0] * 5, 0.7, SHORT + LONG)
    forced("overdamped", *TWO, [0.5, 0.0], [0.0, -1.0], [1.0, -0.5], [0.2, 0.0], 0.8, SHORT + [1e3], rayleigh=(0.0, 6.0))
    forced("constant", *TWO, *REST, [1.0, 2.0], [0.0, 0.0], 0.0, SHORT + LONG)
    forced("free three", [1.0, 2.0, 3.0], chain([0.0, 2.0, 1.0]), [0.0] * 3, [0.0] * 3, [1.0, 0.0, -1.0], [0.0] * 3, 0.6,
           SHORT + [300.0])
    sys.exit()

# No damping, to long times.
response("two undamped", *TWO, [1.0, 0.0], [0.0, 0.5], SHORT + LONG)
response("five undamped", *FIVE, *FIVE_STATE, SHORT + LONG)
response("ten undamped", [1.0] * 10, chain([1.0] * 10), [0.0] * 9 + [1.0], [0.0] * 10, SHORT + [1e9])
for power in (3, 6, 9, 12, 15):
    response(f"stiff 1e{power}", [1.0, 2.0, 1.0], chain([1.0, 10.0**power, 2.0]), [1.0, 1.0, -0.5], [0.0, 0.0, 0.3],
             SHORT + [1e4])
    response(f"weak coupling 1e-{power}", [1.0, 1.0], [[0, 1, 1.0], [1, 2, 10.0**-power], [2, 0, 1.0]], [1.0, 0.0],
             [0.0, 0.0], SHORT + [1e3, 1e6])
response("weak wall", [1.0, 2.0, 1.0], chain([1e-12, 1.0, 2.0]), [1.0, 0.5, 0.0], [0.0, 0.0, 0.1], SHORT + [1e6, 1e7])
response("light mass", [1.0, 1e-9, 2.0], chain([1.0, 2.0, 3.0]), [1.0, 0.8, 0.0], [0.0, 0.0, 0.0], SHORT)

# Rigid motions.
response("free three", [1.0, 2.0, 3.0], chain([0.0, 2.0, 1.0]), [1.0, 0.0, 0.0], [0.0, 0.5, -0.25], SHORT + [1e6])
response("two free bodies", [1.0, 2.0, 3.0, 0.5], [[1, 2, 1.0], [3, 4, 2.0]], [1.0, 0.0, 0.0, 0.5], [0.0, 0.5, -0.25, 1.0],
         SHORT)
response("isolated and dragged", [1.0, 2.0], [[0, 1, 1.0]], [1.0, 0.0], [0.0, 2.0], SHORT, [[0, 2, 0.5]])
response("ring of three", [1.0] * 3, [[1, 2, 1.0], [2, 3, 1.0], [3, 1, 1.0]], [1.0, 0.0, 0.0], [0.0, 0.0, 0.5], SHORT + [1e6])

# Classical damping.
response("rayleigh", *FIVE, *FIVE_STATE, SHORT + [100.0], rayleigh=(0.02, 0.05))
response("rayleigh overdamped", *FIVE, *FIVE_STATE, SHORT + [100.0], rayleigh=(0.0, 4.0))
response("dampers beside springs", *TWO, [1.0, 0.0], [0.0, 0.5], SHORT, [[0, 1, 0.3], [1, 2, 0.2], [2, 0, 0.1]])
response("stiff rayleigh", [1.0, 2.0, 1.0], chain([1.0, 1e9, 2.0]), [1.0, 1.0, -0.5], [0.0, 0.0, 0.3], SHORT,
         rayleigh=(0.1, 1e-5))

# General viscous damping.
response("one damper", *FIVE, *FIVE_STATE, SHORT + [45.0, 500.0], [[0, 3, 0.4]])
response("damper between", *TWO, [1.0, 0.0], [0.0, 0.5], SHORT + [1e4], [[1, 2, 0.05]])
response("strong damper", *FIVE, *FIVE_STATE, SHORT + [500.0], [[2, 4, 50.0]])
response("huge damper", *TWO, [1.0, 0.0], [0.0, 0.5], SHORT + [1e5], [[1, 2, 1e7]])
response("critical pair", [1.0, 1.0], [[0, 1, 1.0], [0, 2, 4.0]], [1.0, 1.0], [0.0, 0.0], SHORT, [[0, 1, 2.0], [0, 2, 1.0]])
response("defective", [1.0, 1.0], [[0, 1, 1.0], [1, 2, 1.0], [0, 2, 1.0]], [1.0, 0.0], [0.0, 0.0], SHORT,
         [[0, 1, 2.0], [0, 2, 2.0], [1, 2, 0.7]])
response("free with a damper", [1.0, 2.0, 3.0], chain([0.0, 2.0, 1.0]), [1.0, 0.0, 0.0], [0.0, 0.5, -0.25], SHORT + [300.0],
         [[1, 3, 0.6]])
for power in (4, 8, 12, 15):
    response(f"stiff with a damper 1e{power}", [1.0, 2.0, 1.0], chain([1.0, 10.0**power, 2.0]), [1.0, 1.0, -0.5],
             [0.0, 0.0, 0.3], SHORT + [300.0], [[0, 3, 0.2]])
response("ten with three dampers", [1.0 + i % 3 for i in range(10)], chain([1.0 + i % 2 for i in range(10)]),
         [0.1 * i for i in range(10)], [0.0] * 10, [1.0, 20.0], [[0, 3, 0.5], [4, 7, 0.25], [0, 10, 1.5]])

# Steady states.
SWEEP = [0.0, 0.1, 0.5, 1.1, 1.7, 2.5, 100.0]
steady("two undamped", *TWO, [1.0, 0.5], SWEEP)
steady("absorber", [10.0, 1.0], [[0, 1, 90.0], [1, 2, 9.0]], [18.0, 0.0], [2.9, 2.999, 2.999999999, 3.000000001, 3.1, 2.5627], [])
steady("five damped", *FIVE, [1.0, 0.0, -0.5, 0.0, 2.0], SWEEP, [[0, 3, 0.4], [1, 5, 0.1]], (0.01, 0.0))
steady("lightly damped at resonance", [1.0, 1.0], [[0, 1, 1.0], [1, 2, 1e-6], [2, 0, 1.0]], [1.0, 0.0],
       [0.999999, 1.0, 1.0000005, 1.000001], [[1, 2, 1e-9], [0, 1, 1e-10]])
steady("stiff", [1.0, 2.0, 1.0], chain([1.0, 1e12, 2.0]), [1.0, 0.0, 0.0], [0.3, 0.45, 1.0, 2.0], [[0, 3, 0.2]])
