"""Processor time of vibank and of its peers, each pair in one run on one core.

Each line: what is done, vibank, the peer, and how often the peer takes as long. Peers that are not here are skipped.
"""

import json
import os
import random
import resource
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
# One thread everywhere: what is compared is work.
ONE_THREAD = {
    **os.environ,
    "RAYON_NUM_THREADS": "1",
    "OMP_NUM_THREADS": "1",
    "OPENBLAS_NUM_THREADS": "1",
}


def of_children():
    """Processor time of the processes that were waited for, in seconds."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def ran(command, **more):
    """Runs a program; the processor time that it took, and what it wrote."""
    before = of_children()
    done = subprocess.run(
        command, env=ONE_THREAD, capture_output=True, text=True, check=True, **more
    )
    return of_children() - before, done.stdout


def each(task, count):
    """The processor time of a task, run so often."""
    task()
    start = time.process_time()
    for _ in range(count):
        task()
    return (time.process_time() - start) / count


def told(what, own, peer, name):
    print(f"{what}: vibank {own:9.1f} µs, {name} {peer:9.1f} µs, {peer / own:8.1f} times")


def marked(vibank, item, part, response, count=4000):
    """Processor time of a response in a stream of requests, in µs: that of many less that of one."""
    request = json.dumps({"id": item, "part": part, "response": response}) + "\n"
    one, said = ran([vibank, "mark", "--jsonl"], input=request)
    assert '"right"' in said, said
    many, _ = ran([vibank, "mark", "--jsonl"], input=request * (count + 1))
    return (many - one) / count * 1e6


def numbers(vibank):
    """A number with a tolerance: edX evaluates the text and compares."""
    try:
        from calc import evaluator
    except ImportError:
        return print("skipped: edX's grader (openedx-calc) is not installed")
    own = marked(vibank, "ch1/e7-rolling-disk-ke", "frac_rot", "0.333")

    def grade():
        value = evaluator({}, {}, "0.333")
        assert abs(value - 1 / 3) <= 0.01 / 3

    told("a number", own, each(grade, 2000) * 1e6, "edX")


def formulas(vibank):
    """The same formula in another form."""
    item, part = "ch2/p1-pinned-bar-block", "omega_d"
    key, typed = "sqrt(3*k/(2*m) - (3*c/(20*m))^2)", "sqrt(600*m*k - 9*c^2)/(20*m)"
    own = marked(vibank, item, part, typed)
    try:
        from calc import evaluator

        draws = random.Random(1)

        def sampled():
            # As its problems of this kind do: both formulas at ten random points.
            for _ in range(10):
                values = {name: draws.uniform(1, 3) for name in "kmc"}
                expected, found = (evaluator(values, {}, text) for text in (key, typed))
                assert abs(expected - found) <= 1e-9 * abs(expected)

        told("a formula", own, each(sampled, 40) * 1e6, "edX, ten points")
    except ImportError:
        print("skipped: edX's grader (openedx-calc) is not installed")
    try:
        import sympy

        names = dict(zip("kmc", sympy.symbols("k m c", positive=True)))

        def proved():
            # PrairieLearn's symbolic input asks SymPy whether two expressions are equal.
            sides = (sympy.sympify(text.replace("^", "**"), locals=names) for text in (key, typed))
            expected, found = sides
            assert expected.equals(found)

        told("a formula", own, each(proved, 20) * 1e6, "SymPy, `equals`")
    except ImportError:
        print("skipped: SymPy, which PrairieLearn's symbolic input asks, is not installed")


def sheets(vibank, folder):
    """Sheets of five questions, and pages of the same content by pdfTeX."""
    blueprint = (ROOT / "examples/midterm.toml").read_text()
    count = 40
    text = blueprint.replace("variants = 4", f"variants = {count}\nsolutions = false")
    for name in ("html", "tex"):
        path = folder / f"{name}.toml"
        path.write_text(text.replace("seed ", f'formats = ["{name}"]\nseed ', 1))
    plan = folder / "html.toml"
    own, _ = ran([vibank, "sheet", plan, "--out", folder / "html"])
    print(f"a sheet of five questions as HTML with its key: vibank {own / count * 1e3:.2f} ms")
    if shutil.which("Rscript") and "TRUE" in ran(["Rscript", "-e", "require(exams)"])[1]:
        code = (
            'library(exams); set.seed(1); e <- c("tstat", "boxplots", "fruit", "deriv", "scatterplot");'
            f'invisible(exams2html(as.list(e), n={count}, dir="{folder}", quiet=TRUE))'
        )
        peer, _ = ran(["Rscript", "-e", code])
        told("a sheet as HTML", own / count * 1e6, peer / count * 1e6, "R/exams, its own exercises")
    else:
        print("skipped: R/exams is not here; no registry that is used here publishes it")
    print("skipped: PrairieLearn, WeBWorK and the runtime of Numbas are not published as packages")
    if shutil.which("pdflatex") is None:
        return print("skipped: pdflatex is not here (in Debian: texlive-latex-recommended, lmodern)")
    if subprocess.run([vibank, "sheet", folder / "tex.toml", "--out", folder / "tex"]).returncode:
        return print("skipped: figures of LaTeX pages need `vibank-press`")
    peer, said = ran(["pdflatex", "-interaction=batchmode", "sheets.tex"], cwd=folder / "tex")
    print(f"a sheet by one pass of pdflatex: {peer / count * 1e3:.1f} ms {said[-80:]}")


def main():
    vibank = Path(sys.argv[1]).resolve()
    if not vibank.is_file():
        return print(f"skipped: there is no {vibank}; build it by `cargo build --release`")
    numbers(vibank)
    formulas(vibank)
    with tempfile.TemporaryDirectory() as folder:
        sheets(vibank, Path(folder))


main()
