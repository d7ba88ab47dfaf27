#!/usr/bin/python3
"""The fits within bounds of tests/fit/bounded_study_test.cpp, by SciPy.

    make_bounded_references.py > bounded.csv

shadefit visits the faces of the box. SciPy's solvers know bounds: `lsq_linear` and `least_squares` from many starts on 80 Gauss points, and
`linprog` on a dense grid, whose level is below the true one by about the square of its step. Of forms that are not linear the level is that
of `linprog` on errors that are linearised again, from many starts. The problems are random, from a fixed seed. Each has the best root mean
square or level of all parameters in the box.
"""
import numpy as np
from scipy.optimize import least_squares, linprog, lsq_linear

rng = np.random.default_rng(20261129)
NODES, WEIGHTS = np.polynomial.legendre.leggauss(80)
NODES, WEIGHTS = (NODES + 1) / 2, WEIGHTS / 2
GRID = (1 - np.cos(np.linspace(0, np.pi, 4001))) / 2
ROWS = np.arange(9) / 8
TARGETS = {
    "exp(x)": np.exp,
    "sqrt(1 + x)": lambda x: np.sqrt(1 + x),
    "sin(3 x)": lambda x: np.sin(3 * x),
    "1/(1 + 2 x)": lambda x: 1 / (1 + 2 * x),
    "x^5": lambda x: x**5,
}
LINEAR = {
    "a + b x": lambda x: np.stack([x**0, x], 1),
    "a + b x + d x^2": lambda x: np.stack([x**0, x, x**2], 1),
    "a + b x + d x^2 + g x^3": lambda x: np.stack([x**0, x, x**2, x**3], 1),
    "a x + b exp(-x) + d": lambda x: np.stack([x, np.exp(-x), x**0], 1),
}
CURVED = {
    "a exp(-b x) + d": (lambda p, x: p[0] * np.exp(-p[1] * x) + p[2], [(-2, 2), (0.1, 3), (-2, 2)]),
    "(a + b x)/(1 + d x)": (lambda p, x: (p[0] + p[1] * x) / (1 + p[2] * x), [(-2, 2), (-2, 2), (-0.5, 3)]),
    "a x^2 + exp(b x - d)": (lambda p, x: p[0] * x**2 + np.exp(p[1] * x - p[2]), [(-2, 2), (-2, 2), (-2, 2)]),
}


def near(optimum):
    """A random box whose ends are on either side of the free optimum, or beyond it; some ends are open."""
    box = []
    for value in optimum:
        size = max(abs(value), 0.5)
        ends = np.sort(np.round(value + size * rng.uniform(-0.6, 0.6, 2), 3))
        lower, upper = ends if ends[0] < ends[1] else (ends[0], ends[0] + 0.25)
        kind = rng.integers(5)
        box.append((lower, np.inf) if kind == 0 else (-np.inf, upper) if kind == 1 else
                   (-np.inf, np.inf) if kind == 2 else (lower, upper))
    return np.array(box)


def least_square(columns, values, weights, box):
    roots = np.sqrt(weights)
    found = lsq_linear(columns * roots[:, None], values * roots, bounds=box.T, tol=1e-15, max_iter=1000)
    return np.sqrt(2 * found.cost), found.x


def level(columns, values, box):
    count = len(values)
    one = np.ones((count, 1))
    found = linprog([0] * columns.shape[1] + [1], np.block([[columns, -one], [-columns, -one]]),
                    np.concatenate([values, -values]), bounds=[*box, (0, None)], method="highs")
    return found.x[-1], found.x[:-1]


def starts(box, usual):
    lower = [b[0] if np.isfinite(b[0]) else min(u[0], b[1] - 1) for b, u in zip(box, usual)]
    upper = [b[1] if np.isfinite(b[1]) else max(u[1], b[0] + 1) for b, u in zip(box, usual)]
    return [rng.uniform(lower, upper) for _ in range(60)]


def curved_square(form, usual, values, x, weights, box):
    roots = np.sqrt(weights)
    ends = []
    for start in starts(box, usual):
        with np.errstate(all="ignore"):
            if not np.all(np.isfinite(form(start, x))):
                continue
            found = least_squares(lambda p: roots * (form(p, x) - values), start, bounds=box.T, xtol=1e-15, ftol=1e-15, gtol=1e-15,
                                  max_nfev=2000)
        ends.append((np.sqrt(2 * found.cost), found.x))
    return min(ends, key=lambda end: end[0])


def curved_level(form, usual, target, box):
    """The errors are linearised at the best parameters so far, in a region that shrinks where that fails."""
    x = GRID[::10]
    values = target(x)
    error = lambda p: np.max(np.abs(form(p, x) - values))
    ends = []
    for start in starts(box, usual)[:20]:
        p, radius = start, 1.0
        for _ in range(200):
            steps = 1e-6 * np.maximum(np.abs(p), 1e-2)
            slopes = np.stack([(form(p + s, x) - form(p - s, x)) / (2 * s[i])
                               for i, s in enumerate(np.diag(steps))], 1)
            near_p = np.array([(max(b[0] - v, -radius), min(b[1] - v, radius)) for b, v in zip(box, p)])
            _, step = level(slopes, values - form(p, x), near_p)
            moved = np.clip(p + step, box[:, 0], box[:, 1])
            if error(moved) < error(p):
                p = moved
            else:
                radius /= 4
            if radius < 1e-13:
                break
        ends.append((np.max(np.abs(form(p, GRID) - target(GRID))), p))
    return min(ends, key=lambda end: end[0])


def text(names, box):
    shown = lambda end: "" if np.isinf(end) else f"{end:.3f}"
    return " ".join(f"{n}={shown(b[0])}:{shown(b[1])}" for n, b in zip(names, box) if np.isfinite(b).any())


def rounded(box):
    return np.where(np.isfinite(box), np.round(box, 3), box)


def problems():
    open_box = lambda n: np.array([(-np.inf, np.inf)] * n)
    for form, columns_of in LINEAR.items():
        names = [c for c in "abdg" if c in form.replace("exp", "")]
        for target, f in TARGETS.items():
            columns, dense = columns_of(NODES), columns_of(GRID)
            _, free = least_square(columns, f(NODES), WEIGHTS, open_box(len(names)))
            box = rounded(near(free))
            yield "square", target, form, names, box, least_square(columns, f(NODES), WEIGHTS, box)
            yield "level", target, form, names, box, level(dense, f(GRID), box)
            noisy = np.round(f(ROWS) + 0.05 * rng.normal(size=len(ROWS)), 4)
            rows, box = " ".join(map(str, noisy)), rounded(near(free))
            yield "square", rows, form, names, box, least_square(columns_of(ROWS), noisy, np.ones(9) / 9, box)
            yield "level", rows, form, names, box, level(columns_of(ROWS), noisy, box)
    for form, (f_of, usual) in CURVED.items():
        for target, f in TARGETS.items():
            _, free = curved_square(f_of, usual, f(NODES), NODES, WEIGHTS, np.array(usual, float))
            box = rounded(near(free))
            if form.startswith("("):
                box[2] = np.clip(box[2], -0.5, None)
                box[2][1] = max(box[2][1], 0)
            names = ["a", "b", "d"]
            yield "square", target, form, names, box, curved_square(f_of, usual, f(NODES), NODES, WEIGHTS, box)
            yield "level", target, form, names, box, curved_level(f_of, usual, f, box)


def lines():
    yield "norm,target,form,bounds,best," + ",".join(f"p{i}" for i in range(1, 5))
    for norm, target, form, names, box, (best, p) in problems():
        if not text(names, box):
            continue
        cells = [f"{v:.9g}" for v in p] + [""] * (4 - len(p))
        yield f"{norm},{target},{form},{text(names, box)},{best:.12g}," + ",".join(cells)


if __name__ == "__main__":
    print(*lines(), sep="\n")
