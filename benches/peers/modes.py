"""Times SciPy's `eigh` on systems read from standard input, one request of the task `modes` a line.

Prints the mean processor time in seconds, a line for each system; a word where SciPy is missing.

    OPENBLAS_NUM_THREADS=1 python3 benches/peers/modes.py < requests.jsonl
"""

import json
import sys
import time

try:
    import numpy
    import scipy.linalg
except ImportError as error:
    print(f"{error.name} is not installed")
    sys.exit()

RUNS = 60


def matrices(params):
    """M and K; M is none where all masses are 1 kg."""
    if "M" in params:
        mass, stiffness = numpy.array(params["M"], float), numpy.array(params["K"], float)
    else:
        size = len(params["masses"])
        mass, stiffness = numpy.diag(numpy.array(params["masses"], float)), numpy.zeros((size, size))
        for i, j, k in params["springs"]:
            for node in (i, j):
                if node:
                    stiffness[node - 1, node - 1] += k
            if i and j:
                stiffness[i - 1, j - 1] -= k
                stiffness[j - 1, i - 1] -= k
    if numpy.array_equal(mass, numpy.diag(numpy.diag(mass))):
        # The quickest way for point masses: an ordinary eigenproblem.
        roots = numpy.sqrt(numpy.diag(mass))
        return stiffness / numpy.outer(roots, roots), None
    return stiffness, mass


for line in sys.stdin:
    stiffness, mass = matrices(json.loads(line)["params"])
    scipy.linalg.eigh(stiffness, mass)
    start = time.process_time()
    for _ in range(RUNS):
        scipy.linalg.eigh(stiffness, mass)
    print((time.process_time() - start) / RUNS)
