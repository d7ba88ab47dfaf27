#!/usr/bin/python3
"""Checks the committed tables of truth: their digests, and some rows of each by another way.

    check_tables.py                  checks tables.sha256 beside this program, then recomputes rows of each table of studies
    check_tables.py --write-digests  writes tables.sha256 anew, after a program has made a table anew

The rows are drawn: one in a hundred, at least five of each table. Which ones follows from the length of the table alone. They are
computed by other integrals or in another arithmetic than the table:

    karis-*, materialx-ggx-*, conductor-albedo   over the visible normals, not over the directions of the light
    three-sheen                                  over the cosine of the light, and cut off
    airy-*, planck-*                             sums of doubles, not of 30 or 50 digits
    cie-y                                        the table in steps of 1 nm, rounded

The rows of zeltner-* come from random walks of others, and are not computed here.
"""
import functools
import hashlib
import math
import os
import random
import sys

from mpmath import fp, mp, mpf

import make_albedo_references as albedo

FOLDER = os.path.dirname(os.path.abspath(__file__))
SOURCE = os.path.dirname(os.path.dirname(FOLDER))
DIGESTS = os.path.join(FOLDER, "tables.sha256")
mp.dps = 18


def tables():
    """The tables of studies and the references, as paths from the source folder."""
    found = [f"{folder}/{name}" for folder in ("studies", "tests/references") for name in os.listdir(os.path.join(SOURCE, folder))]
    return sorted(path for path in found if path.endswith(".csv"))


def read(path):
    with open(os.path.join(SOURCE, path), encoding="utf-8") as file:
        return [line.split(",") for line in file.read().split()]


def digests():
    lines = []
    for path in tables():
        with open(os.path.join(SOURCE, path), "rb") as file:
            lines.append(f"{hashlib.sha256(file.read()).hexdigest()}  {path}\n")
    return lines


def check_digests():
    with open(DIGESTS, encoding="utf-8") as file:
        stored = file.readlines()
    for line in sorted(set(stored) ^ set(digests())):
        path = line.split()[1]
        sys.exit(f"{path} is not the table that tables.sha256 has, or one of them has no such table")


# GGX and sheen. A table has 12 digits or 13 decimals. The directions of the light give these, so do 40 nodes of each of the others.
NODES = 40


@functools.cache  # scale and bias have the same rows
def by_normals(mu, alpha):
    return albedo.ggx_by_normals(mu, alpha, NODES)


def ggx(masking, part):
    """part 0: the albedo with F = 1; 1: scale; 2: bias."""
    k = albedo.MASKINGS.index(masking)

    def value(mu, alpha):
        whole, bias = by_normals(mu, alpha)
        return (whole[k], whole[k] - bias[k], bias[k])[part]

    return value


def cut_sheen(mu, alpha):
    """In doubles. The visibility is at most 1, and so is the albedo."""
    mu, alpha = float(mu), float(alpha)
    sine = math.sqrt(1 - mu * mu)

    def around(l):
        side = sine * math.sqrt(1 - l * l)

        def lobe(q):
            half = (mu + l) ** 2 / (2 + 2 * (mu * l + side * math.cos(q)))  # cos^2 h
            return max(0.0, 1 - half) ** (1 / (2 * alpha))

        return 2 * fp.quad(lobe, [0, math.pi / 64, math.pi / 8, math.pi]) * l * min(1, 1 / (4 * (l + mu - l * mu)))

    cut = [(0.25 - mu) / (1 - mu)] if mu < 0.25 else []
    return min(1, (2 + 1 / alpha) / (2 * math.pi) * fp.quad(around, sorted({0.0, mu, 1.0, *cut})))


# The observer.
OBSERVER = [[float(cell) for cell in row] for row in read("tests/references/cie-1931.csv")[1:]]


def airy(column):
    whole = math.fsum(row[2] for row in OBSERVER)
    return lambda path: math.fsum(row[column] * math.cos(2 * math.pi * path / row[0]) for row in OBSERVER) / whole


def locus(temperature):
    """X, Y and Z of a black body. c2 is in nm K."""
    radiances = [(row, row[0] ** -5 / math.expm1(0.014388e9 / (row[0] * temperature))) for row in OBSERVER]
    return [math.fsum(row[column] * radiance for row, radiance in radiances) for column in (1, 2, 3)]


def chromaticity(numerator, weights, temperature_of):
    def value(place):
        sums = locus(temperature_of(place))
        return numerator(sums) / math.fsum(weight * part for weight, part in zip(weights, sums))

    return value


def luminosity(wavelength):
    """The table in steps of 5 nm has 6 decimals."""
    return next(round(row[2], 6) for row in OBSERVER if row[0] == wavelength)


UV, XY = (1, 15, 3), (1, 1, 1)
RECIPES = {
    # The table's variables as (mu, alpha), then the truth of these.
    "karis-scale": (lambda x, r: (x, r * r), ggx("schlick", 1)),
    "karis-bias": (lambda x, r: (x, r * r), ggx("schlick", 2)),
    "materialx-ggx-scale": (lambda x, y: (x, y), ggx("height-correlated", 1)),
    "materialx-ggx-bias": (lambda x, y: (x, y), ggx("height-correlated", 2)),
    "conductor-albedo": (lambda x, r: (max(x, mpf("0.02")), max(r, mpf("0.035")) ** 2), ggx("separable", 0)),
    "three-sheen": (lambda x, r: (x, r * r), cut_sheen),
    "airy-x": (float, airy(1)),
    "airy-y": (float, airy(2)),
    "airy-z": (float, airy(3)),
    "planck-u": (float, chromaticity(lambda sums: 4 * sums[0], UV, float)),
    "planck-v": (float, chromaticity(lambda sums: 6 * sums[1], UV, float)),
    "planck-x": (float, chromaticity(lambda sums: sums[0], XY, lambda t: 1000 / t)),
    "planck-y": (float, chromaticity(lambda sums: sums[1], XY, lambda t: 1000 / t)),
    "cie-y": (float, luminosity),
}


def check_rows(path):
    """The largest difference of the drawn rows, and how many they are. A table rounds to 12 digits or 13 decimals."""
    name = os.path.basename(path)[:-len(".csv")]
    variables, truth = RECIPES[name]
    rows = read(path)[1:]
    drawn = random.Random(len(rows)).sample(rows, max(5, (len(rows) + 99) // 100))
    most = 0.0
    for *place, printed in drawn:
        place = variables(*(mpf(cell) for cell in place))
        value = truth(*place) if isinstance(place, tuple) else truth(place)
        most = max(most, abs(float(value - mpf(printed))) / (1 + abs(float(value))))
        if most > 1e-12:
            sys.exit(f"{path} has {printed} at {place}, computed {mp.nstr(mpf(value), 14)}")
    return most, len(drawn)


def main(arguments):
    if arguments == ["--write-digests"]:
        with open(DIGESTS, "w", encoding="utf-8") as file:
            file.writelines(digests())
        return
    if arguments:
        sys.exit(__doc__)
    check_digests()
    for path in tables():
        if path.startswith("studies/") and not path.startswith("studies/zeltner-"):
            most, count = check_rows(path)
            print(f"{path}: {count} rows, largest difference {most:.1g}")


if __name__ == "__main__":
    main(sys.argv[1:])
