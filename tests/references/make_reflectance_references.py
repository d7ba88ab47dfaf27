#!/usr/bin/python3
"""Directional reflectance, for tests/fit/claims/reflectance_test.cpp, in 18 digits: the integrals over the hemisphere n.l >= 0 of
(r.v)^a and (n.h)^a, as they stand and times n.l.

    make_reflectance_references.py                prints the file tests/references/reflectance.csv
    make_reflectance_references.py --check FILE   compares it with FILE

shadefit integrates in polar coordinates around the lobe's axis (half vectors for Blinn-Phong) and around a pole square to normal and
view; here the integrand is written as it is defined, over the light l in polar coordinates around the normal, and integrated twice by
tanh-sinh.
"""
import sys

from mpmath import acos, cos, cosh, exp, mp, mpf, pi, sin, sinh, sqrt

mp.dps = 30


def tanh_sinh():
    """Nodes and weights on [-1, 1]: x = tanh(pi/2 sinh t), to |t| = 3.8."""
    for i in range(-76, 77):
        t = mpf(i) / 20
        near = exp(-pi * sinh(t))
        yield (1 - near) / (1 + near), 2 * pi * cosh(t) * near / (1 + near) ** 2 / 20


NODES = list(tanh_sinh())


def nodes_between(start, end, cuts):
    """Panel by panel: `cuts` in any order, those outside left out."""
    ends = [start, *sorted(cut for cut in cuts if start < cut < end), end]
    for low, high in zip(ends, ends[1:]):
        middle, radius = (low + high) / 2, (high - low) / 2
        for x, weight in NODES:
            yield middle + radius * x, radius * weight


def integrals(is_phong, view, alpha):
    """Of the lobe as it stands, and times n.l. theta is cut at the peak, where the clamp of Phong begins, and on either side of a
    sharp peak; phi, counted from the peak, beyond a sharp one, whose width shrinks with n.l + n.v at grazing views."""
    view_cosine, view_sine = sin(pi / 2 - view), cos(pi / 2 - view)
    width = 6 / sqrt(mpf(alpha))
    plain = with_cosine = mpf(0)
    for theta, outer in nodes_between(mpf(0), pi / 2, (pi / 2 - view, view, view - width, view + width)):
        c, s = cos(theta), sin(theta)
        along, across = view_cosine * c, view_sine * s
        last = +pi
        if is_phong and along < across:
            last = acos(-along / across)
        inner = mpf(0)
        for phi, weight in nodes_between(mpf(0), last, (width, width * (c + view_cosine))):
            if is_phong:
                inner += weight * max(along + across * cos(phi), 0) ** alpha
            else:  # n.h = n.(l+v) / |l+v|, |l+v|^2 = 2 + 2 l.v; v stands opposite to r
                inner += weight * ((c + view_cosine) ** 2 / (2 + 2 * (along - across * cos(phi)))) ** (mpf(alpha) / 2)
        plain += 2 * s * outer * inner
        with_cosine += 2 * s * c * outer * inner
    return plain, with_cosine


def text_of(value):
    """18 digits, as C++ prints them."""
    return mp.nstr(value, 18, min_fixed=-5).replace("e-", "e-0")


def table():
    lines = ["lobe,exponent,view_angle,with_cosine,value"]
    for tenths in (300, 750, 899):
        for alpha in (1, 8, 2048):
            for lobe in ("phong", "blinn-phong"):
                values = integrals(lobe == "phong", pi * tenths / 1800, alpha)
                lines += [f"{lobe},{alpha},{tenths / 10},{word},{text_of(value)}" for word, value in zip(("no", "yes"), values)]
    return "\n".join(lines) + "\n"


if sys.argv[1:2] == ["--check"]:
    with open(sys.argv[2], encoding="utf-8") as file:
        if file.read() != table():
            sys.exit(f"{sys.argv[2]} differs from what this program computes")
else:
    sys.stdout.write(table())
