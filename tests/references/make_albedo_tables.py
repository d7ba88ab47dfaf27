#!/usr/bin/python3
"""Directional albedos of GGX and of sheen, in doubles, for the tables of studies/karis-*.toml and others.

    make_albedo_tables.py                  prints how far it is from albedo.csv beside this program
    make_albedo_tables.py --write FOLDER   writes the tables into FOLDER
    make_albedo_tables.py --check FOLDER   compares them with those in FOLDER

x is the cosine of the view. r is a roughness with alpha = r^2, y is alpha itself; alpha is the width of the lobe. Each table has the row
of every x and every r or y of its grid, and 12 digits or 13 decimals, whichever is less. The program first compares its albedos with
albedo.csv, where that has them.
"""
import math
import os
import sys
from math import asin, asinh, atan, atan2, cos, cosh, exp, expm1, fsum, pi, sin, sinh, sqrt, tan


def gauss(count):
    """Gauss-Legendre on [0, 1]: pairs of node and weight."""
    rule = []
    for k in range(count):
        x = cos(pi * (k + 0.75) / (count + 0.5))
        for _ in range(5):
            last, p = 1.0, x
            for n in range(2, count + 1):
                last, p = p, ((2 * n - 1) * x * p - (n - 1) * last) / n
            slope = count * (x * p - last) / (x * x - 1)
            x -= p / slope
        rule.append(((1 - x) / 2, 1 / ((1 - x * x) * slope**2)))
    return rule


RULES = {count: gauss(count) for count in (40, 44, 48, 56)}


def graded(scale, end, count):
    """Gauss-Legendre for [0, end], denser and denser towards 0, down to the scale."""
    k = asinh(end / scale)
    return [(scale * sinh(k * t), weight * k * scale * cosh(k * t)) for t, weight in RULES[count]]


# GGX. x is the elevation of the light, m and d are half the sum and half the difference of the angles of light and view. For a turn
# q of the light from the mirrored view, |v + l|^2 = 4 (cos^2 m + s sin^2(q/2)), where s is the product of the sines.
def height_correlated(mu, l, alpha):
    """The masking of light and view, divided by mu."""
    root_v, root_l = (sqrt(alpha**2 + (1 - alpha**2) * c**2) for c in (mu, l))
    return 2 * l / (mu * root_l + l * root_v)


def separable(mu, l, alpha):
    root_v, root_l = (sqrt(alpha**2 + (1 - alpha**2) * c**2) for c in (mu, l))
    return 4 * l / ((mu + root_v) * (l + root_l))


def schlick(mu, l, alpha):
    k = alpha / 2
    return l / ((mu * (1 - k) + k) * (l * (1 - k) + k))


def ggx(masking, mu, alpha, split=True):
    """(scale, bias) of the albedo f0 scale + bias with Schlick's Fresnel; not split: the albedo with F = 1."""
    sine = sqrt((1 - mu) * (1 + mu))
    view, top = atan2(sine, mu), atan2(mu, sine)
    scale = min(alpha, top)
    nodes = []  # from the mirrored view to the normal, half the way to the horizon, and from the horizon
    for sign, end in ((-1, view / 2), (1, top / 4)):
        if end > 0:
            for t, weight in graded(scale, tan(end), 56):
                d = atan(t)
                nodes.append((top - 2 * sign * d, -sign * d, 2 * weight / (1 + t * t)))
    for x, weight in graded(scale, top / 2, 56):
        nodes.append((x, (x - top) / 2, weight))
    a2 = alpha**2
    whole, bias = [], []
    for x, d, weight in nodes:
        m = pi / 2 - x + d
        c2d, c2m = cos(d) ** 2, cos(m) ** 2
        near = 4 * c2m * (sin(d) ** 2 + a2 * c2d)  # |v + l|^2 (1 - (1 - a2) h_z^2) for q = 0, and for q = pi
        far = 4 * c2d * (sin(m) ** 2 + a2 * c2m)
        part = 4 * (1 - a2) * c2d * c2m
        root = sqrt(near * far)
        closed = 2 * pi * (1 + 2 * part / root + part**2 * (near + far) / (2 * root**3))
        weight *= a2 * cos(x) / (4 * pi) * masking(mu, sin(x), alpha)
        whole.append(weight * closed)
        if not split:
            continue
        sines = cos(x) * sine
        if sines == 0:
            bias.append(weight * closed * (1 - cos(m)) ** 5)
            continue
        ring = []
        for half, w in graded(sqrt(near / (4 * sines)), pi / 2, 40):
            turn = 4 * sines * sin(half) ** 2
            square = 4 * c2m + turn
            ring.append(w * (square / (near + turn)) ** 2 * (1 - sqrt(square) / 2) ** 5)
        bias.append(4 * weight * fsum(ring))
    whole, bias = fsum(whole), fsum(bias)
    return (whole - bias, bias) if split else whole


# Sheen. The lobe is D = (2 + 1/alpha) sin(h)^(1/alpha)/(2 pi), the visibility that of Neubelt and Pettineo 2013.
def up(t):
    """From 0 to 1, flat at both ends."""
    return t**4 * (35 + t * (-84 + t * (70 - 20 * t)))


def sheen(mu, alpha, most=math.inf):
    """The albedo. The visibility is at most `most`."""
    sine = sqrt((1 - mu) * (1 + mu))
    top = atan2(mu, sine)
    reach = 1 / (4 * most)  # the visibility is cut off where l + mu - l mu is less
    cuts = sorted({0.0, top, pi / 2} | ({asin((reach - mu) / (1 - mu))} if mu < reach else set()))
    nodes = []
    for t, w in RULES[48]:
        depth = 38 * t**3
        x = cuts[1] * exp(-depth)
        d = cuts[1] * expm1(-depth) if cuts[1] == top else x - top
        nodes.append((x, d / 2, w * 114 * t * t * x))
    for a, b in zip(cuts[1:], cuts[2:]):
        for t, w in RULES[48]:
            x = a + (b - a) * up(t)
            d = -(b - a) * up(1 - t) if b == top else (b - a) * up(t) if a == top else x - top
            nodes.append((x, d / 2, w * (b - a) * 140 * (t * (1 - t)) ** 3))
    power = 1 / (2 * alpha)
    total = []
    for x, d, weight in nodes:
        m = pi / 2 - x + d
        sines, c2m, s2d = cos(x) * sine, cos(m) ** 2, sin(d) ** 2
        l = sin(x)
        weight *= cos(x) * l * min(most, 1 / (4 * (l + mu - l * mu)))
        if sines == 0:
            total.append(weight * 2 * pi * s2d**power)
            continue
        ring = []
        scale = s2d if alpha >= 0.25 else 1 + s2d  # a narrow lobe is nothing where sin^2 h is small
        for half, w in graded(max(sqrt(c2m * scale / sines), 1e-100), pi / 2, 44):
            turn = sines * sin(half) ** 2
            ring.append(w * ((c2m * s2d + turn) / (c2m + turn)) ** power)
        total.append(4 * weight * fsum(ring))
    return (2 + 1 / alpha) / (2 * pi) * fsum(total)


def compare():
    """The largest difference from albedo.csv, where the tables reach."""
    with open(os.path.join(os.path.dirname(os.path.abspath(__file__)), "albedo.csv"), encoding="utf-8") as file:
        rows = [line.split(",") for line in file.read().split()[1:]]
    most = 0.0
    for name, mu, alpha, value in rows:
        mu, alpha = float(mu), float(alpha)
        if mu < 0.01 or alpha < 0.001:
            continue  # beyond the tables
        parts = name.split("-")
        if name == "ggx-separable":
            own = ggx(separable, mu, alpha, False)
        elif name == "sheen-neubelt":
            own = sheen(mu, alpha)
        elif parts[0] == "ggx" and parts[-1] in ("scale", "bias"):
            masking = {"schlick": schlick, "separable": separable}.get(parts[1], height_correlated)
            own = ggx(masking, mu, alpha)[parts[-1] == "bias"]
        else:
            continue
        most = max(most, abs(own - float(value)))
    return most


# The tables. Nodes are rounded to 12 digits, and are what the rows print.
def even(first, last, count):
    return [float(f"{first + (last - first) * k / (count - 1):.12g}") for k in range(count)]


def table(second, xs, seconds, albedo):
    """One table for each number that the albedo gives."""
    lines = None
    for x in xs:
        for s in seconds:
            values = albedo(x, s)
            lines = lines or [[f"x,{second},value"] for _ in values]
            for rows, value in zip(lines, values):
                rows.append(f"{x:.12g},{s:.12g},{round(value, 13):.12g}")
    return ["\n".join(rows) + "\n" for rows in lines]


def tables():
    result = {}
    views, grades = even(0.02, 1, 25), even(0.05, 1, 25)
    for name, content in zip(("scale", "bias"), table("r", views, grades, lambda x, r: ggx(schlick, x, r * r))):
        result[f"karis-{name}.csv"] = content
    texels = even(1 / 64, 63 / 64, 32)
    for name, content in zip(("scale", "bias"), table("y", texels, texels, lambda x, y: ggx(height_correlated, x, y))):
        result[f"materialx-ggx-{name}.csv"] = content
    entries = even(0, 1, 32)
    result["conductor-albedo.csv"] = table("r", entries, entries, lambda x, r: [ggx(separable, max(x, 0.02), max(r, 0.035) ** 2, False)])[0]
    result["three-sheen.csv"] = table("r", views, grades, lambda x, r: [min(1, sheen(x, r * r, 1))])[0]
    return result


def agree(own, other):
    """The same nodes, and values that agree in 11 digits or to 2e-13: another mathematical library may round differently."""
    own, other = ([line.split(",") for line in text.splitlines()] for text in (own, other))
    if own[0] != other[0] or len(own) != len(other):
        return False
    return all(a[:-1] == b[:-1] and abs(float(a[-1]) - float(b[-1])) <= 1e-11 * abs(float(a[-1])) + 2e-13 for a, b in zip(own[1:], other[1:]))


if __name__ == "__main__":
    difference = compare()
    if difference > 1e-12:
        sys.exit(f"differs from albedo.csv by {difference:.2g}")
    if len(sys.argv) == 1:
        print(f"differs from albedo.csv by at most {difference:.2g}")
    elif len(sys.argv) == 3 and sys.argv[1] in ("--write", "--check"):
        for name, content in tables().items():
            path = os.path.join(sys.argv[2], name)
            if sys.argv[1] == "--write":
                with open(path, "w", encoding="utf-8") as file:
                    file.write(content)
                continue
            with open(path, encoding="utf-8") as file:
                if not agree(content, file.read()):
                    sys.exit(f"{path} differs from what this program computes")
    else:
        sys.exit(__doc__)
