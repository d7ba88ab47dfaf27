#!/usr/bin/env python3
"""The constants of studies, for tests/fit/study/study_references_test.cpp, which has their formulas as text.

    make_study_references.py                prints the file tests/references/studies.csv
    make_study_references.py --check FILE   compares FILE with what it computes: exit code 1 where a byte differs
"""

import sys

from mpmath import mp, mpf
from study_optimum import Study, largest_error, optimum


def grid(low, high, count):
    return [low + (high - low) * k / (count - 1) for k in range(count)]


def powers(low, high, count):
    return [low * (high / low) ** (k / (count - 1)) for k in range(count)]


def number(m, text):
    return mpf(text) if m is mp else float(text)


def srgb(m, x):
    if x <= number(m, "0.04045"):
        return x / number(m, "12.92")
    return ((x + number(m, "0.055")) / number(m, "1.055")) ** number(m, "2.4")


def bumps(m, x):
    return m.exp(-8 * (x - number(m, "0.2")) ** 2) + number(m, "0.9") * m.exp(-30 * (x - 1) ** 2)


def inverse_mean(m, x):
    """The integral of 1/(1 + x t^2) over t from 0 to 1."""
    return m.atan(m.sqrt(x)) / m.sqrt(x) if x > 0 else number(m, "1")


UNIT, QUARTER_TURNS = (0, 1), (-mp.pi / 2, mp.pi / 2)


def studies_of_one_variable():
    line, slope = lambda m, p, x: p[0] + p[1] * x, lambda m, p, x: 1 + p[2] * x
    return [
        Study("kink", lambda m, x: abs(x - number(m, "0.3")), lambda m, p, x: p[0] + p[1] * x + p[2] * x * x, "a b d", [UNIT],
              kinks=(mpf("0.3"),)),
        Study("ramp", lambda m, x: max(x, 0), lambda m, p, x: p[0] * m.exp(p[1] * x), "a b", [(-1, 1)], kinks=(0,),
              scan=(grid(-30, 30, 301),)),
        Study("root", lambda m, x: m.sqrt(x), line, "a b d", [UNIT], slope, scan=(grid(-0.99, 40, 300),)),
        Study("logarithm", lambda m, x: m.log(x), lambda m, p, x: p[0] + p[1] * m.sqrt(x) + p[2] * x, "a b d", [UNIT]),
        # In t, where x = cos t: the density 1/sqrt(1 - x^2) becomes 1.
        Study("chebyshev-density", lambda m, t: m.exp(-2 * m.cos(t) ** 2),
              lambda m, p, t: p[0] + p[1] * m.cos(t) ** 2 + p[2] * m.cos(t) ** 4, "a b d", [(0, mp.pi)]),
        # Optima at either bump.
        Study("two-bumps", bumps, lambda m, p, x: p[0], "a b d", [(-1, 2)], lambda m, p, x: 1 + p[1] * (x - p[2]) ** 2,
              kinks=(0, 1), scan=(powers(0.01, 300, 31), grid(-3, 4, 57))),
        # The form has complex poles at a distance of 0.14 from the range.
        Study("wave", lambda m, x: m.sin(7 * x), line, "a b d g", [UNIT], lambda m, p, x: 1 + x * (p[2] + p[3] * x),
              kinks=(mpf("0.2"), mpf("0.4"), mpf("0.6"), mpf("0.8")), scan=(grid(-8, 12, 81), grid(-8, 40, 97))),
        Study("exponentials", lambda m, x: 1 / (1 + x) ** 2,
              lambda m, p, x: p[0] * m.exp(-p[2] * x) + p[1] * m.exp(-p[3] * x), "a d b g", [(0, 4)],
              scan=(powers(0.01, 30, 30), powers(0.011, 33, 30))),
        Study("srgb", srgb, lambda m, p, x: x * (p[0] + p[1] * x + p[2] * x * x), "a b d", [UNIT], kinks=(mpf("0.04045"),)),
        Study("tone-curve", lambda m, x: 1 - m.exp(-x), lambda m, p, x: x * (p[0] + p[1] * x), "b a g d", [(0, 8)],
              lambda m, p, x: 1 + x * (p[2] + p[3] * x), scan=(grid(-0.5, 6, 66), grid(0, 6, 61))),
        Study("arc-tangent", lambda m, x: m.atan(x), lambda m, p, x: x * (p[0] + p[1] * x * x), "a b d", [(-1, 1)],
              lambda m, p, x: 1 + p[2] * x * x, scan=(grid(-0.99, 20, 400),)),
        Study("sine", lambda m, x: m.sin(x), lambda m, p, x: x * (p[0] + p[1] * x * x + p[2] * x**4), "a b d",
              [QUARTER_TURNS]),
        Study("cosine", lambda m, x: m.cos(x), lambda m, p, x: 1 + p[0] * x * x, "a b d", [QUARTER_TURNS],
              lambda m, p, x: 1 + p[1] * x * x + p[2] * x**4, scan=(grid(-0.4, 4, 45), grid(-0.2, 4, 43))),
        Study("relative", lambda m, x: m.exp(-3 * x), line, "a b d", [UNIT], slope, scan=(grid(-0.99, 40, 400),),
              factor=lambda m, x: m.exp(3 * x)),
        Study("weighted", lambda m, x: m.exp(x) - 1, lambda m, p, x: p[0] * x, "a b", [(0, 2)],
              lambda m, p, x: 1 + p[1] * x, scan=(grid(-0.499, 20, 400),), factor=lambda m, x: x * (2 - x)),
        Study("integral", inverse_mean, line, "a b d", [UNIT], slope, scan=(grid(-0.99, 40, 400),)),
    ]


def studies_of_more():
    return [
        Study("plane", lambda m, x, y: m.exp(-x * y),
              lambda m, p, x, y: p[0] + p[1] * x + p[2] * y + p[3] * x * y + p[4] * (x * y) ** 2, "a b d g h", [UNIT, (0, 2)]),
        Study("plane-rational", lambda m, x, y: m.exp(-x - y / 2) + x * y / 2,
              lambda m, p, x, y: p[0] + p[1] * x + p[2] * y + p[3] * x * y, "a b d g h k m n", [UNIT, UNIT],
              lambda m, p, x, y: 1 + p[4] * x + p[5] * y + p[6] * x * y + p[7] * x * x,
              scan=((-0.5, 0.5, 3.0), (-0.6, 0.3, 2.0), (-0.5, 0.3, 2.0), (-0.3, 0.5, 3.0))),
        Study("solid", lambda m, x, y, z: m.exp(-x * y * z) + x / 2, lambda m, p, x, y, z: p[0] + p[1] * x + p[2] * y * z,
              "a b d g", [UNIT, UNIT, (0, mpf(1) / 2)], lambda m, p, x, y, z: 1 + p[3] * x * y * z,
              scan=(grid(-0.9, 10, 40),)),
    ]


def table():
    lines = ["study,name,value"]
    for study in studies_of_one_variable() + studies_of_more():
        p, rms = optimum(study)
        named = sorted(zip(study.parameters.split(), p)) + [("rms", rms), ("largest", largest_error(study, p))]
        lines += ["%s,%s,%s" % (study.name, name, mp.nstr(value, 30)) for name, value in named]
    return "\n".join(lines) + "\n"


def main(arguments):
    computed = table()
    if not arguments:
        print(computed, end="")
        return 0
    with open(arguments[-1], encoding="utf-8") as file:
        is_same = file.read() == computed
    print("the stored references are what this program computes" if is_same else computed, end="\n" if is_same else "")
    return 0 if is_same else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
