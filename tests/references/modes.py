"""Prints natural frequencies and mode shapes of spring networks and matrices, one JSON object a line.

Rates are natural angular frequencies with 50 digits, or minus the growth rate of an unstable mode, in ascending order;
shapes are mass-normalized, with 20 digits, given up to ten degrees of freedom, or where asked for. Data are the binary64 numbers printed.

    python3 tests/references/modes.py > tests/fixtures/references/modes.jsonl
"""

import json
import random

from mpmath import diag, eigsy, matrix, mp, mpf, nstr, sqrt

random.seed(4)


def chain(masses, springs, last_wall=0.0):
    """Springs to the left of each mass, and one behind the last."""
    links = [[i, i + 1, k] for i, k in enumerate(springs) if k]
    return masses, links + ([[len(masses), 0, last_wall]] if last_wall else [])


def assembled(count, springs):
    k = matrix(count)
    for i, j, value in springs:
        for p in (i, j):
            if p:
                k[p - 1, p - 1] += mpf(value)
        if i and j:
            k[i - 1, j - 1] -= mpf(value)
            k[j - 1, i - 1] -= mpf(value)
    return k


def digits(values):
    """Digits that resolve the smallest eigenvalue beside the largest."""
    sizes = [abs(mpf(v)) for v in values if v]
    return 60 + 2 * int(mp.log10(max(sizes) / min(sizes)) + 1)


def solved(m, k, with_shapes):
    """Signed rates and shapes of the pencil, by Cholesky of M."""
    n = m.rows
    lower = mp.cholesky(m)
    inverse = mp.inverse(lower)
    weighted = inverse * k * inverse.T
    weighted = (weighted + weighted.T) / 2
    if not with_shapes:
        return eigsy(weighted, eigvals_only=True), None
    values, vectors = eigsy(weighted)
    shapes = inverse.T * vectors
    return values, [[shapes[i, r] for i in range(n)] for r in range(n)]


def emit(name, data, m, k, magnitudes, with_shapes=True):
    mp.dps = digits(magnitudes)
    m, k = m(), k()
    values, shapes = solved(m, k, with_shapes if with_shapes == "all" else with_shapes and m.rows <= 10)
    largest = max(abs(v) for v in values)
    noise = largest * mpf(10) ** (-mp.dps + 8)
    rates = [mpf(0) if abs(v) < noise else (sqrt(v) if v > 0 else -sqrt(-v)) for v in values]
    entry = {"name": name, **data, "rates": [nstr(r, 50) for r in rates]}
    if shapes:
        entry["shapes"] = [[nstr(x, 20) for x in shape] for shape in shapes]
    print(json.dumps(entry, separators=(",", ":")))


def network(name, masses, springs, with_shapes=True):
    emit(name, {"masses": masses, "springs": springs}, lambda: diag([mpf(x) for x in masses]),
         lambda: assembled(len(masses), springs), [k for _, _, k in springs] + [1 / x for x in masses], with_shapes)


def matrices(name, m, k, with_shapes=True):
    emit(name, {"M": m, "K": k}, lambda: matrix(m), lambda: matrix(k), [1.0, 1e16], with_shapes)


# A stiffness ratio of 10^k in every place of a chain of five, free or held at the far end.
for place in range(6):
    for power in (3, 6, 9, 12, 15, -3, -6, -9, -12, -15):
        springs = [1.0, 2.0, 1.5, 0.75, 1.25, 0.5]
        springs[place] *= 10.0**power
        network(f"chain stiffness {place} 1e{power}", *chain([1.0, 2.0, 1.0, 0.5, 1.5], springs[:5], springs[5]),
                with_shapes=abs(power) in (3, 12))

# Two and three masses, the closed form and its neighbour.
for power in (0, -1, -4, -8, -12, -15, 3, 7, 15):
    for place in range(3):
        springs = [1.0, 3.0, 2.0]
        springs[place] *= 10.0**power
        network(f"pair {place} 1e{power}", *chain([1.0, 2.5], springs[:2], springs[2]))

# The wall fades away.
for power in (2, 5, 8, 11, 15, 30, 100, 200, 300):
    network(f"weak wall 1e-{power}", *chain([1.0, 2.0, 1.0, 3.0], [10.0**-power, 1.0, 2.0, 1.0]), with_shapes=False)

# Mass ratios.
for place in range(4):
    for power in (-9, 9):
        masses = [1.0, 2.0, 1.0, 3.0]
        masses[place] *= 10.0**power
        network(f"mass {place} 1e{power}", *chain(masses, [1.0, 3.0, 2.0, 1.0], 0.5))

# Rigid motions.
network("free pair", *chain([1.0, 3.0], [0.0, 2.0]))
network("free six", *chain([1.0, 2.0, 3.0, 1.0, 2.0, 3.0], [0.0, 1.0, 2.0, 3.0, 4.0, 5.0]))
network("free six stiff", *chain([1.0, 2.0, 3.0, 1.0, 2.0, 3.0], [0.0, 1.0, 2e8, 3.0, 4e-7, 5.0]))
network("two free bodies", [1.0, 2.0, 3.0, 0.5, 0.7], [[1, 2, 1.0], [2, 3, 2.0], [4, 5, 1.5]])
network("isolated mass", [1.0, 2.0, 3.0], [[0, 1, 1.0], [1, 3, 2.0]])
network("one mass", [2.0], [[0, 1, 3.0]])
network("nothing but mass", [2.0, 3.0], [])

# Repeated frequencies.
network("ring of three", [1.0] * 3, [[1, 2, 1.0], [2, 3, 1.0], [3, 1, 1.0]])
network("ring of six", [2.0] * 6, [[i + 1, (i + 1) % 6 + 1, 3.0] for i in range(6)])
network("ring of eight on ground", [2.0] * 8,
        [[i + 1, (i + 1) % 8 + 1, 3.0] for i in range(8)] + [[i + 1, 0, 1e-6] for i in range(8)])
network("star", [5.0] + [1.0] * 5, [[1, i, 2.0] for i in range(2, 7)])
network("complete", [1.0] * 6, [[i, j, 1.0] for i in range(1, 7) for j in range(1, i)] + [[1, 0, 1.0]])

# Two equal oscillators, weakly coupled.
for power in (2, 4, 6, 8, 10, 12, 14):
    network(f"weak coupling 1e-{power}", [1.0, 2.0, 2.0, 1.0],
            [[0, 1, 1.0], [1, 2, 1.0], [2, 3, 10.0**-power], [3, 4, 1.0], [4, 0, 1.0]])

# SI magnitudes.
network("carbon dioxide", [2.6567e-26, 1.9945e-26, 2.6567e-26], [[1, 2, 1600.0], [2, 3, 1600.0]])
network("ship", [2.1e7, 6.4e6, 9.3e6, 1.2e5], [[0, 1, 3.3e8], [1, 2, 7.1e9], [2, 3, 2.2e9], [3, 4, 4.1e5], [4, 0, 60.0]])

# Trees and dense graphs with spread data.
for trial in range(8):
    n = 10
    spread = trial % 4 * 3
    masses = [float(f"{10 ** random.uniform(-spread / 3, spread / 3):.4g}") for _ in range(n)]
    springs = [[0, 1 + random.randrange(n), 1.0]]
    springs += [[random.randrange(1, i), i, float(f"{10 ** random.uniform(-spread, spread):.4g}")] for i in range(2, n + 1)]
    if trial >= 4:
        springs += [[i, j, float(f"{10 ** random.uniform(-spread, spread):.4g}")]
                    for i in range(1, n + 1) for j in range(1, i) if random.random() < 0.4]
    network(f"{'graph' if trial >= 4 else 'tree'} spread {spread}", masses, springs)

# Long chains.
network("chain of fifty", *chain([1.0 + i % 3 for i in range(50)], [1.0 + i % 5 for i in range(50)]))
network("chain of fifty stiff", *chain([1.0 + i % 3 for i in range(50)], [10.0 ** (i % 5 * 2 - 4) for i in range(50)]))
network("chain of two hundred", *chain([1.0] * 200, [1.0] * 200))
network("chain of two hundred mixed", *chain([1.0 + i % 7 for i in range(200)], [1.0 + i % 11 for i in range(200)], 2.0))

# Repelling springs.
network("repelling wall", *chain([1.0, 2.0, 1.0], [-0.5, 1.0, 1.0]))
network("repelling but stable", *chain([1.0, 2.0, 1.0], [3.0, -0.25, 2.0], 1.0))
network("inverted", [1.0, 1.0], [[0, 1, -2.0], [1, 2, 1.0], [0, 2, -2.0]])

# Matrices: double pendulum, inertial coupling, semi-definite, indefinite.
matrices("double pendulum", [[2.0, 1.0], [1.0, 1.0]], [[19.62, 0.0], [0.0, 9.81]])
matrices("triple pendulum", [[3.0, 2.0, 1.0], [2.0, 2.0, 1.0], [1.0, 1.0, 1.0]],
         [[29.43, 0.0, 0.0], [0.0, 19.62, 0.0], [0.0, 0.0, 9.81]])
matrices("cart and pendulum", [[3.0, 0.5], [0.5, 0.25]], [[0.0, 0.0], [0.0, 4.905]])
matrices("inverted double pendulum", [[2.0, 1.0], [1.0, 1.0]], [[-19.62, 0.0], [0.0, -9.81]])
matrices("saddle", [[2.0, 0.5, 0.0], [0.5, 1.0, 0.25], [0.0, 0.25, 3.0]], [[4.0, -1.0, 0.0], [-1.0, -2.0, 0.5], [0.0, 0.5, 1.0]])
matrices("stiff", [[2.0, 0.5, 0.0], [0.5, 1.0, 0.25], [0.0, 0.25, 3.0]],
         [[1000001.0, -1000000.0, 0.0], [-1000000.0, 1000002.0, -1.0], [0.0, -1.0, 1.5]])
matrices("diagonal", [[2.0, 0.0], [0.0, 8.0]], [[1.0, 0.0], [0.0, 1e-12]])

# Larger systems, solved by reduction to tridiagonal form where that can be proven, and neighbours for which it cannot.
def drawn(low, high):
    return float(f"{random.uniform(low, high):.4g}")


def spread(decades):
    return float(f"{10 ** random.uniform(-decades, decades):.4g}")


def dense(n, stiffness):
    return [drawn(1, 3) for _ in range(n)], [[i, j, stiffness()] for i in range(1, n + 1) for j in range(i)]


def symmetric(n, diagonal):
    factor = [[drawn(-1, 1) for _ in range(n)] for _ in range(n)]
    entry = lambda i, j: sum(factor[i][k] * factor[j][k] for k in range(n)) + (diagonal if i == j else 0.0)
    return [[entry(max(i, j), min(i, j)) for j in range(n)] for i in range(n)]


network("chain of twenty", *chain([drawn(1, 3) for _ in range(20)], [drawn(1, 9) for _ in range(20)], 2.5), "all")
network("chain of twenty, six decades", *chain([spread(1) for _ in range(20)], [spread(3) for _ in range(20)], 0.5), "all")
network("free chain of eighteen", *chain([drawn(1, 3) for _ in range(18)], [0.0] + [drawn(1, 9) for _ in range(17)]), "all")
network("chain of eighteen, weak in the middle", *chain([1.0] * 18, [1.0] * 9 + [1e-4] + [1.0] * 8, 1.5), "all")
network("dense of twenty", *dense(20, lambda: drawn(1, 10)), "all")
network("dense of eighteen, six decades", *dense(18, lambda: spread(3)), "all")
network("dense of forty", *dense(40, lambda: drawn(1, 10)))
network("dense of seventy", *dense(70, lambda: drawn(1, 10)))
network("tree of twenty", [drawn(1, 3) for _ in range(20)], [[random.randrange(i), i, drawn(1, 9)] for i in range(1, 21)], "all")
network("ring of eighteen", [2.0] * 18, [[i + 1, (i + 1) % 18 + 1, 3.0] for i in range(18)] + [[1, 0, 1.0]])
network("complete of eighteen", [1.0] * 18, [[i, j, 1.0] for i in range(1, 19) for j in range(i)])
matrices("matrices of twenty", symmetric(20, 3.0), symmetric(20, 1.0), "all")
matrices("matrices of twenty, point masses", [[1.0 + i if i == j else 0.0 for j in range(20)] for i in range(20)], symmetric(20, 1.0), "all")
matrices("matrices of eighteen, unstable", symmetric(18, 3.0), symmetric(18, -4.0))
matrices("matrices of seventy", symmetric(70, 9.0), symmetric(70, 1.0))
