"""numba's side of `compare`: `numba_side.py CASE SIZE FOLDER` computes the problem that dapple wrote into FOLDER.

Compiles the candidates, holds each against dapple's plain solver, keeps the fastest, and says
`ready NAME LAYER SECONDS_A_STEP`. Then it does as many steps as each line of standard input says and answers with the
seconds. The number of threads comes from NUMBA_NUM_THREADS.
"""

import statistics
import sys
import time
from pathlib import Path

import numba
import numpy as np

import stencils

#: Steps after which dapple wrote its concentrations once more.
CHECKED = 20
#: Largest difference after them ÷ largest concentration.
TOLERANCE = 1e-3


class Problem:
    def __init__(self, folder, size):
        def plane(name):
            return np.fromfile(folder / name, dtype="<f4").reshape(-1, size, size)

        self.start = [plane(f"start-{i}")[0] for i in (0, 1)]
        self.after = [plane(f"after-{i}")[0] for i in (0, 1)]
        self.mobility = [plane(f"mobility-{i}")[0].copy() for i in (0, 1)]
        self.rate = plane("rate")[0].copy()
        self.weights = plane("weights")

    def padded(self):
        """Concentrations and arrays to step them into."""
        u = [np.pad(u, stencils.PAD, mode="wrap") for u in self.start]
        return [*u, *(u.copy() for u in u)]


def candidates(case, problem):
    """(name, function, arguments between the arrays and the number of steps)."""
    # On one core the serial form may be the faster one.
    forms = (True, False) if numba.config.NUMBA_NUM_THREADS == 1 else (True,)
    coefficients = (*problem.mobility, problem.rate)
    for parallel in forms:
        form = "" if parallel else ", serial"
        if case == "isotropic":
            constants = [plane[0, 0] for plane in coefficients]
            yield "rows" + form, stencils.isotropic(parallel), constants
            continue
        kinetics = {
            "tensor": (stencils.turing, stencils.turing_bound),
            "ratio": (stencils.meinhardt, stencils.no_bound),
        }[case]
        stride = problem.rate.shape[1] + 2 * stencils.PAD
        in_runs = stencils.in_runs(problem.weights, stride)
        yield "runs" + form, stencils.runs(parallel, *kinetics), [*in_runs, *coefficients]
        yield "planes" + form, stencils.planes(parallel, *kinetics), [problem.weights, *coefficients]


def agrees(problem, arrays):
    """Whether the concentrations are dapple's."""
    inside = slice(stencils.PAD, -stencils.PAD)
    for found, wanted in zip(arrays, problem.after):
        apart = np.abs(found[inside, inside] - wanted).max() / np.abs(wanted).max()
        if not apart < TOLERANCE:
            raise SystemExit(f"numba and dapple are {apart:.1e} apart after {CHECKED} steps")


def timed(steps, arrays, arguments, count):
    started = time.perf_counter()
    steps(*arrays, *arguments, count)
    return time.perf_counter() - started


def main():
    case, size, folder = sys.argv[1], int(sys.argv[2]), Path(sys.argv[3])
    problem = Problem(folder, size)
    best = None
    for name, steps, arguments in candidates(case, problem):
        arrays = problem.padded()
        steps(*arrays, *arguments, CHECKED)
        agrees(problem, arrays)
        # Even numbers of steps from here on: the arrays have changed places as often as not.
        taken = statistics.median(timed(steps, arrays, arguments, 10) for _ in range(5)) / 10
        if best is None or taken < best[0]:
            best = (taken, name, steps, arrays, arguments)
    taken, name, steps, arrays, arguments = best
    layer = numba.threading_layer()
    print(f"ready {name}|{layer}|{taken}", flush=True)
    for line in sys.stdin:
        count = int(line)
        print(timed(steps, arrays, arguments, count + count % 2) * count / (count + count % 2), flush=True)


if __name__ == "__main__":
    main()
