"""The optimum of a study by means that share nothing with the toolkit: for make_study_references.py.

mpmath computes in 80 digits. One variable is integrated by the tanh-sinh rule between kinks, two and three by products of
Gauss-Legendre rules. A scan of the parameters that do not enter linearly, in double, sees the basins; from each,
Levenberg-Marquardt in double and Newton in 80 digits find the optimum, and the lowest is the answer. A finer rule must confirm
31 digits. Derivatives are central differences with a step of 1e-25: right to more than 45 digits.
"""

import itertools
import math
from dataclasses import dataclass
from typing import Callable, Optional

from mpmath import mp, mpf

mp.dps = 80
STEP = mpf(10) ** -25


@dataclass
class Study:
    """A form to a target. Its functions take m, which is mpmath, or math for the scan."""

    name: str
    target: Callable  # of m, *x
    numerator: Callable  # of the form: of m, p, *x
    parameters: str  # those that enter linearly first
    over: list  # the ends of each variable
    denominator: Optional[Callable] = None  # positive where the form has no pole
    scan: tuple = ()  # a grid for each parameter that does not enter linearly
    kinks: tuple = ()  # where one variable is split
    factor: Callable = lambda m, *x: 1  # of the error: a weight, or 1/target

    def form(self, m, p, *x):
        top = self.numerator(m, p, *x)
        return top / self.denominator(m, p, *x) if self.denominator else top


# ---- quadrature ------------------------------------------------------------------------------------------------------------


def tanh_sinh(a, b, step):
    """Nodes and weights between a and b. Nearer to an end than 1e-75 nothing counts."""
    nodes = []
    count = int(5 / step)
    for k in range(-count, count + 1):
        t = k * step
        outer = mp.pi * mp.sinh(t)
        u = 1 / (1 + mp.exp(-outer))
        weight = mp.pi * mp.cosh(t) * u / (1 + mp.exp(outer)) * step * (b - a)
        if min(u, 1 - u) > mpf(10) ** -75:
            nodes.append((a + (b - a) * u, weight))
    return nodes


def gauss_legendre(a, b, count):
    nodes = []
    for k in range(1, count + 1):
        x = mp.cos(mp.pi * (k - mpf(1) / 4) / (count + mpf(1) / 2))
        for _ in range(9):
            last, value = mpf(1), x
            for n in range(2, count + 1):
                last, value = value, ((2 * n - 1) * x * value - (n - 1) * last) / n
            slope = count * (x * value - last) / (x * x - 1)
            x -= value / slope
        nodes.append((a + (b - a) * (1 + x) / 2, (b - a) / ((1 - x * x) * slope * slope)))
    return nodes


GAUSS_SIZES = {2: (34, 40), 3: (16, 20)}


def nodes_of(study, is_fine):
    """Places and their weights, which sum to 1."""
    if len(study.over) == 1:
        ends = [study.over[0][0], *study.kinks, study.over[0][1]]
        step = mpf(1) / (48 if is_fine else 32)
        axes = [[node for a, b in zip(ends, ends[1:]) for node in tanh_sinh(mpf(a), mpf(b), step)]]
    else:
        count = GAUSS_SIZES[len(study.over)][is_fine]
        axes = [gauss_legendre(mpf(a), mpf(b), count) for a, b in study.over]
    nodes = []
    for node in itertools.product(*axes):
        x = tuple(place for place, _ in node)
        nodes.append((x, mp.fprod(w for _, w in node)))
    total = mp.fsum(w for _, w in nodes)
    return [(x, w / total) for x, w in nodes]


# ---- the optimum -----------------------------------------------------------------------------------------------------------


class Sampled:
    """A study at nodes, in the arithmetic of m. What does not depend on parameters is computed once."""

    def __init__(self, study, nodes, m):
        number = mpf if m is mp else float
        self.study, self.m, self.step = study, m, STEP if m is mp else 1e-6
        self.nodes = []
        for x, w in nodes:
            x = tuple(number(c) for c in x)
            factor = study.factor(m, *x)
            self.nodes.append((x, number(w) * factor * factor, study.target(m, *x)))

    def square(self, p):
        form, m = self.study.form, self.m
        return sum(w * (form(m, p, *x) - target) ** 2 for x, w, target in self.nodes)

    def rows(self, p):
        """Weight, error and slopes at each node."""
        form, m = self.study.form, self.m
        shifted = []
        for i in range(len(p)):
            shifted.append([[c + s * self.step if k == i else c for k, c in enumerate(p)] for s in (1, -1)])
        for x, w, target in self.nodes:
            slopes = [(form(m, up, *x) - form(m, down, *x)) / (2 * self.step) for up, down in shifted]
            yield w, form(m, p, *x) - target, slopes

    def gradient(self, p):
        sums = [self.nodes[0][1] * 0] * len(p)
        for w, error, slopes in self.rows(p):
            sums = [s + w * error * slope for s, slope in zip(sums, slopes)]
        return sums

    def has_pole(self, p):
        denominator = self.study.denominator
        return denominator is not None and min(denominator(self.m, p, *x) for x, _, _ in self.nodes) <= 0


def solved(matrix, right):
    """Gauss elimination with pivots, in floats."""
    n = len(right)
    rows = [list(row) + [r] for row, r in zip(matrix, right)]
    for i in range(n):
        pivot = max(range(i, n), key=lambda k: abs(rows[k][i]))
        rows[i], rows[pivot] = rows[pivot], rows[i]
        for k in range(i + 1, n):
            ratio = rows[k][i] / rows[i][i]
            rows[k] = [a - ratio * b for a, b in zip(rows[k], rows[i])]
    result = [0.0] * n
    for i in reversed(range(n)):
        result[i] = (rows[i][n] - sum(rows[i][k] * result[k] for k in range(i + 1, n))) / rows[i][i]
    return result


def with_best_linear(sampled, p, linear):
    """p with its first parameters, which are linear, the best for the others."""
    p = [0.0] * linear + list(p[linear:])
    form, m = sampled.study.form, sampled.m
    units = [[1.0 if k == i else (0.0 if k < linear else c) for k, c in enumerate(p)] for i in range(linear)]
    matrix, right = [[0.0] * linear for _ in range(linear)], [0.0] * linear
    for x, w, target in sampled.nodes:
        base = form(m, p, *x)
        columns = [form(m, unit, *x) - base for unit in units]
        for i in range(linear):
            right[i] += w * columns[i] * (target - base)
            for k in range(linear):
                matrix[i][k] += w * columns[i] * columns[k]
    return solved(matrix, right) + p[linear:]


def descended(sampled, p):
    """Levenberg-Marquardt in floats."""
    square, damping = sampled.square(p), 1e-3
    for _ in range(300):
        n = len(p)
        matrix, right = [[0.0] * n for _ in range(n)], [0.0] * n
        for w, error, slopes in sampled.rows(p):
            for i in range(n):
                right[i] -= w * error * slopes[i]
                for k in range(n):
                    matrix[i][k] += w * slopes[i] * slopes[k]
        for i in range(n):
            matrix[i][i] *= 1 + damping
        step = solved(matrix, right)
        trial = [a + b for a, b in zip(p, step)]
        trial_square = sampled.square(trial)
        if trial_square < square and not sampled.has_pole(trial):
            size = max(abs(s) / max(abs(c), 1e-3) for s, c in zip(step, trial))
            p, square, damping = trial, trial_square, damping / 5
            if size < 1e-9:
                break
        else:
            damping *= 4
            if damping > 1e12:
                break
    return square, p


def lowest_basin(study):
    """The lowest end of descents from every local minimum of the scan."""
    nodes = nodes_of(study, False)
    least = max(w for _, w in nodes) * mpf(10) ** -12
    some = [node for node in nodes if node[1] > least]
    stride = 4 if len(study.over) == 1 else 1
    if len(study.over) > 1:  # every fifth place of the product is enough to see basins
        some = some[::5]
    sampled = Sampled(study, some[::stride], math)
    linear = len(study.parameters.split()) - len(study.scan)
    squares = {}
    for index in itertools.product(*(range(len(grid)) for grid in study.scan)):
        p = [0.0] * linear + [grid[i] for grid, i in zip(study.scan, index)]
        try:
            p = with_best_linear(sampled, p, linear)
            if not sampled.has_pole(p):
                squares[index] = sampled.square(p), p
        except (OverflowError, ZeroDivisionError, ValueError):
            continue
    ends = []
    for index, (square, p) in squares.items():
        around = itertools.product(*((i - 1, i, i + 1) for i in index))
        if any(near in squares and squares[near][0] < square for near in around):
            continue
        try:
            ends.append(descended(sampled, p))
        except (OverflowError, ZeroDivisionError, ValueError):
            continue
    # The lowest; of the same curve with exchanged parameters the one that comes first.
    lowest = min(square for square, _ in ends)
    return min(p for square, p in ends if square <= lowest * (1 + 1e-7))


def polished(sampled, p):
    """Newton with the Hessian of the start: each step gains the digits that the start has."""
    p = [mpf(c) for c in p]
    n = len(p)
    gradient = sampled.gradient(p)
    shift = mpf(10) ** -20
    hessian = mp.matrix(n, n)
    for i in range(n):
        moved = sampled.gradient([c + shift if k == i else c for k, c in enumerate(p)])
        for k in range(n):
            hessian[k, i] = (moved[k] - gradient[k]) / shift
    for _ in range(40):
        step = mp.lu_solve(hessian, mp.matrix(gradient))
        p = [c - s for c, s in zip(p, step)]
        if max(abs(s / c) for s, c in zip(step, p)) < mpf(10) ** -38:
            return p, hessian
        gradient = sampled.gradient(p)
    raise ArithmeticError(sampled.study.name + ": Newton does not converge")


def optimum(study):
    sampled = Sampled(study, nodes_of(study, False), mp)
    p, hessian = polished(sampled, lowest_basin(study))
    fine = Sampled(study, nodes_of(study, True), mp)
    step = mp.lu_solve(hessian, mp.matrix(fine.gradient(p)))
    difference = max(abs(s / c) for s, c in zip(step, p))
    if difference > mpf(10) ** -31:
        raise ArithmeticError(study.name + ": the rules differ by " + mp.nstr(difference))
    p = [c - s for c, s in zip(p, step)]
    return p, mp.sqrt(fine.square(p))


# ---- the largest error -----------------------------------------------------------------------------------------------------


def largest_error(study, p):
    """From the best place of a grid, in steps along the axes that are halved where they gain nothing."""
    counts = {1: 2000, 2: 60, 3: 16}
    places = []
    for a, b in study.over:
        count = counts[len(study.over)]
        places.append([a + (b - a) * mpf(k) / count for k in range(count + 1)] + [mpf(k) for k in study.kinks])
    floats = [float(c) for c in p]

    def in_floats(x):
        x = [float(c) for c in x]
        try:
            return abs(study.form(math, floats, *x) - study.target(math, *x))
        except (ValueError, ZeroDivisionError):
            return 0

    at = list(max(itertools.product(*places), key=in_floats))

    def magnitude(x):
        return abs(study.form(mp, p, *x) - study.target(mp, *x))

    best, step = magnitude(at), mpf(1) / 64
    while step > mpf(10) ** -36:
        is_better = False
        for axis, side in itertools.product(range(len(at)), (1, -1)):
            a, b = study.over[axis]
            trial = list(at)
            trial[axis] = min(max(trial[axis] + side * step * (b - a), mpf(a)), mpf(b))
            value = magnitude(trial)
            if value > best:
                at, best, is_better = trial, value, True
        if not is_better:
            step /= 2
    return best
