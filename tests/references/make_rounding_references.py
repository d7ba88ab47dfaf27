#!/usr/bin/env python3
"""The best constants of narrow formats, for tests/fit/rounding/round_study_test.cpp.

    make_rounding_references.py                prints the file tests/references/rounding.csv
    make_rounding_references.py --check FILE   compares it with FILE

shadefit rules out constants by intervals. Here all neighbours within some steps of the format are tried, at every number of the format
in the range, until the best is the centre of its neighbours. Half is that of numpy; bfloat16 rounds the mantissa of a double.
"""
import itertools
import sys

import numpy as np

FORMATS = {"half": (11, -14), "bfloat16": (8, -126)}


def rounded(x, fmt):
    x = np.asarray(x, dtype=np.float64)
    if fmt == "half":
        return x.astype(np.float16).astype(np.float64)
    digits, least = FORMATS[fmt]
    exponent = np.maximum(np.frexp(x)[1], least + 1)
    return np.ldexp(np.rint(np.ldexp(x, digits - exponent)), exponent - digits)


def numbers(low, high, fmt):
    """Every number of the format in a range of numbers that are not negative."""
    digits, least = FORMATS[fmt]
    count = 1 << (digits - 1)
    all_of = [np.arange(count) * 2.0 ** (least - digits + 1)]
    for e in range(least, int(np.ceil(np.log2(high))) + 1):
        all_of.append((count + np.arange(count)) * 2.0 ** (e - digits + 1))
    x = np.concatenate(all_of)
    return x[(low <= x) & (x <= high)]


def step(value, steps, fmt):
    """The number that is so many steps above in magnitude, for values that stay away from zero."""
    digits = FORMATS[fmt][0]
    bits = int(np.float16(value).view(np.uint16)) if fmt == "half" else int(np.float32(value).view(np.uint32)) >> 16
    bits += steps
    if fmt == "half":
        return float(np.uint16(bits).view(np.float16))
    return float(np.uint32(bits << 16).view(np.float32))


# Each operation is rounded. The target and the factor of the error are in double.
STUDIES = {
    "pair": ((0, 1), lambda c: (1 - c) ** 5, lambda c: np.ones_like(c), (-5.5, -7),
             lambda r, x, p: r(np.exp2(r(r(r(p[0] * x) + p[1]) * x)))),
    "sine": ((0, 1.5), np.sin, lambda x: np.ones_like(x), (0.98, -0.14),
             lambda r, x, p: r(x * r(p[0] + r(r(p[1] * x) * x)))),
    "relative": ((0, 2), lambda x: np.exp(-x), lambda x: np.exp(x), (0.9, 0.8),
                 lambda r, x, p: r(p[0] / r(p[1] + x))),
    "parabola": ((0, 1), lambda x: np.exp(x), lambda x: np.ones_like(x), {"half": (1.01, 0.85, 0.84), "bfloat16": (1.015, 0.82, 0.88)},
                 lambda r, x, p: r(p[0] + r(r(p[1] + r(p[2] * x)) * x))),
}
FARTHEST = {2: 8, 3: 4}


def best_of(study, fmt):
    (low, high), target, factor, start, form = STUDIES[study]
    x = numbers(low, high, fmt)
    t, f = target(x), factor(x)
    r = lambda v: rounded(v, fmt)
    error = lambda p: np.max(np.abs((form(r, x, p) - t) * f))
    centre = tuple(float(r(v)) for v in (start[fmt] if isinstance(start, dict) else start))
    n = FARTHEST[len(centre)]
    while True:
        moves = itertools.product(range(-n, n + 1), repeat=len(centre))
        points = [tuple(step(v, k, fmt) for v, k in zip(centre, move)) for move in moves]
        errors = [error(p) for p in points]
        best = points[int(np.argmin(errors))]
        if min(errors) >= error(centre):
            return centre, min(errors)
        centre = best


def text():
    lines = ["study,format,constants,error"]
    for study in STUDIES:
        for fmt in FORMATS:
            constants, error = best_of(study, fmt)
            lines.append(f"{study},{fmt},{' '.join(repr(c) for c in constants)},{error:.9g}")
    return "\n".join(lines) + "\n"


def main():
    made = text()
    if sys.argv[1:2] != ["--check"]:
        sys.stdout.write(made)
        return 0
    with open(sys.argv[2], encoding="utf-8") as file:
        return 0 if file.read() == made else 1


if __name__ == "__main__":
    sys.exit(main())
