"""Adds the methods of SciPy to the table of the work-precision benchmark, in the same columns.

    cargo bench --bench numerics -- FOLDER
    python3 benches/numerics/scipy_methods.py FOLDER/results.csv

The rows are appended; rows of an earlier run are replaced. Needs NumPy and SciPy.
"""

import csv
import json
import pathlib
import sys
import time

import numpy as np
import scipy
from scipy.integrate import solve_ivp
from scipy.linalg import eigh
from scipy.special import ellipj, ellipk

REFERENCES = pathlib.Path(__file__).with_name("references.jsonl")
BUILD = f"scipy {scipy.__version__}"
TOLERANCES = (1e-3, 1e-5, 1e-7, 1e-9, 1e-11)
ROWS = []


def timed(run, parts=1):
    """Nanoseconds an item: the second fastest and the median of up to 25 runs in a tenth of a second."""
    run()
    times, end = [], time.perf_counter() + 0.1
    while len(times) < 3 or len(times) < 25 and time.perf_counter() < end:
        start = time.perf_counter()
        run()
        times.append((time.perf_counter() - start) * 1e9 / parts)
    times.sort()
    return times[1], times[len(times) // 2], parts


def add(case, method, tolerance, timing, relative, scaled, digits=50):
    fast, median, items = timing
    ROWS.append([case["task"], case["case"], method, "" if tolerance is None else f"{tolerance:e}", f"{fast:.4f}", items,
                 f"{relative:e}", f"{scaled:e}", digits, BUILD, f"{median:.4f}"])


def values(case):
    return np.array([float(text) for text in case["values"]])


def largest(error):
    return 1.0 if not np.all(np.isfinite(error)) else float(np.max(error))


def samples(case, method, solve):
    exact, found = values(case), solve()
    error = np.abs(found - exact)
    relative = largest(error[exact != 0] / np.abs(exact[exact != 0]))
    add(case, method, None, timed(solve, len(exact)), relative, largest(error / np.max(np.abs(exact))))


def solution(case, method, solve):
    exact, found = values(case), np.atleast_1d(solve())
    error = largest(np.abs(found - exact) / np.abs(exact))
    add(case, method, None, timed(solve), error, error)


def integrators(case, rate, start, methods=("RK45", "DOP853", "Radau")):
    """A sample is an item; the error is that at the last time."""
    exact, times = values(case), np.array(case["at"])
    for method in methods:
        for tolerance in TOLERANCES:
            def run():
                return solve_ivp(rate, (times[0], times[-1]), start, method=method, t_eval=times, rtol=tolerance,
                                 atol=tolerance)
            end = run()
            if not end.success:
                continue
            error = abs(end.y[0, -1] - exact[-1]) / np.max(np.abs(exact))
            add(case, f"SciPy {method}", tolerance, timed(run, len(times)), error, error)


def free(case):
    c = case["data"]["c"]
    integrators(case, lambda t, y: (y[1], -c * y[1] - y[0]), (1.0, 0.0))


def forced(case):
    w = case["data"]["Omega"]
    integrators(case, lambda t, y: (y[1], np.cos(w * t) - y[0]), (0.0, 0.0))


def steady(case):
    c, w = case["data"]["c"], np.array(case["at"])
    samples(case, "NumPy hypot", lambda: 1 / np.hypot(1 - w * w, c * w))


def period(case):
    modulus = np.sin(case["data"]["theta0"] / 2)
    solution(case, "SciPy ellipk", lambda: 4 * ellipk(modulus**2))


def pendulum(case):
    w, times = case["data"]["w"], np.array(case["at"])
    if w < 2:
        samples(case, "SciPy ellipj", lambda: 2 * np.arcsin(w / 2 * ellipj(times, (w / 2) ** 2)[0]))
    else:
        samples(case, "SciPy ellipj", lambda: 2 * ellipj(w / 2 * times, (2 / w) ** 2)[3])
    integrators(case, lambda t, y: (y[1], -np.sin(y[0])), (0.0, w))


def decrement(case):
    ratio = case["data"]["x1"] / case["data"]["xn1"]
    solution(case, "NumPy log", lambda: np.log(ratio) / np.hypot(2 * np.pi, np.log(ratio)))


def modes():
    """Chains of unit masses and springs from a wall, and a wall that fades away."""
    def measure(task, case, stiffness, exact):
        def solve():
            return np.sqrt(np.maximum(eigh(stiffness, eigvals_only=True), 0))
        error = largest(np.abs(solve() - exact) / exact)
        add({"task": task, "case": case}, "SciPy eigh", None, timed(solve), error, error, 17)

    for n in (2, 3, 5, 10, 20, 50, 100, 200):
        stiffness = 2 * np.eye(n) - np.eye(n, k=1) - np.eye(n, k=-1)
        stiffness[-1, -1] = 1
        exact = 2 * np.sin((2 * np.arange(1, n + 1) - 1) * np.pi / (4 * n + 2))
        measure("modes-against-size", f"n={n}", stiffness, exact)
    for power in (0, 3, 6, 9, 12, 15):
        weak = 10.0**-power
        larger = 1 + weak / 2 + np.sqrt(1 + weak**2 / 4)
        exact = np.sqrt(np.array([weak / larger, larger]))
        measure("modes-against-stiffness-ratio", f"ratio=1e{power}", np.array([[1 + weak, -1], [-1, 1]]), exact)


TASKS = {"free-response": free, "forced-response": forced, "steady-state": steady, "pendulum-period": period,
         "pendulum-motion": pendulum, "decrement": decrement}


def main(path):
    for line in REFERENCES.read_text().splitlines():
        case = json.loads(line)
        if case["task"] in TASKS:
            TASKS[case["task"]](case)
    modes()
    with open(path, newline="") as file:
        rows = [row for row in csv.reader(file) if not row[9].startswith("scipy")]
    with open(path, "w", newline="") as file:
        csv.writer(file, lineterminator="\n").writerows(rows + ROWS)
    for row in ROWS:
        print(f"{row[0]:<30} {row[1]:<28} {row[2]:<14} {row[3]:>12} {float(row[4]):>14.1f} ns {row[7]:>14}")


main(sys.argv[1])
