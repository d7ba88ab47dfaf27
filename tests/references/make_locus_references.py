#!/usr/bin/python3
"""The Planckian locus of the CIE 1931 standard observer, in 50 digits, for the tables of studies/planck-*.toml.

    make_locus_references.py FOLDER           writes planck-u.csv, planck-v.csv, planck-x.csv and planck-y.csv into FOLDER
    make_locus_references.py --check FOLDER   compares them with those in FOLDER

X, Y and Z are plain sums over the table cie-1931.csv beside this program, in steps of 1 nm from 360 to 830 nm, as CIE 15 recommends.
The radiance is Planck's law with c2 = 0.014388 m K, the value of CIE 15. u and v are those of CIE 1960.
"""
import os
import sys

from mpmath import exp, mp, mpf

mp.dps = 50
SECOND_CONSTANT = mpf("0.014388")

with open(os.path.join(os.path.dirname(os.path.abspath(__file__)), "cie-1931.csv"), encoding="utf-8") as file:
    OBSERVER = [[mpf(cell) for cell in line.split(",")] for line in file.read().split()[1:]]


def sums(temperature):
    """X, Y and Z of a black body, without a common factor."""
    total = [mpf(0)] * 3
    for nanometres, *weights in OBSERVER:
        metres = nanometres / 10**9
        radiance = 1 / (metres**5 * (exp(SECOND_CONSTANT / (metres * temperature)) - 1))
        total = [old + radiance * weight for old, weight in zip(total, weights)]
    return total


def uv(temperature):
    x, y, z = sums(temperature)
    return 4 * x / (x + 15 * y + 3 * z), 6 * y / (x + 15 * y + 3 * z)


def xy(temperature):
    x, y, z = sums(temperature)
    return x / (x + y + z), y / (x + y + z)


def text(value):
    return mp.nstr(value, 17)


def tables():
    """The rows of u and v have steps of 50 K; those of x and y have steps of 0.002 in t = 1000 K / T, from 25000 K to 1667 K."""
    u, v = ["T,value"], ["T,value"]
    for temperature in range(1000, 15001, 50):
        of = uv(mpf(temperature))
        u.append(f"{temperature},{text(of[0])}")
        v.append(f"{temperature},{text(of[1])}")
    x, y = ["t,value"], ["t,value"]
    for mireds in [*range(40, 600, 2), mpf(10**6) / 1667]:
        thousandth = text(mpf(mireds) / 1000)
        of = xy(10**6 / mpf(mireds))
        x.append(f"{thousandth},{text(of[0])}")
        y.append(f"{thousandth},{text(of[1])}")
    return {f"planck-{name}.csv": "\n".join(lines) + "\n" for name, lines in (("u", u), ("v", v), ("x", x), ("y", y))}


checks = sys.argv[1:2] == ["--check"]
folder = sys.argv[2 if checks else 1]
for name, content in tables().items():
    path = os.path.join(folder, name)
    if not checks:
        with open(path, "w", encoding="utf-8") as file:
            file.write(content)
        continue
    with open(path, encoding="utf-8") as file:
        if file.read() != content:
            sys.exit(f"{path} differs from what this program computes")
