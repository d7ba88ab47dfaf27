#!/usr/bin/python3
"""The ACES film curve of a grey, for the target of studies/aces-narkowicz.toml, in 40 digits.

    make_tone_references.py                prints the file tests/references/tone.csv
    make_tone_references.py --check FILE   compares it with FILE

Follows the CTL of ampas/aces-dev: RRT, then ODT.Academy.Rec709_100nits_dim up to the gamma of the display. A grey passes their
matrices unchanged. The splines are evaluated by de Boor's recurrence, as convex combinations, and not by their polynomials.
"""
import sys

from mpmath import floor, log10, mp, mpf

mp.dps = 40
GREY = mpf("0.18")

RRT_LOW = "-4 -4 -3.1573765773 -0.4852499958 1.8477324706 1.8477324706"
RRT_HIGH = "-0.7185482425 2.0810307172 3.6681241237 4 4 4"
ODT_LOW = "-1.6989700043 -1.6989700043 -1.4779 -1.2291 -0.8648 -0.448 0.00518 0.4511080334 0.9113744414 0.9113744414"
ODT_HIGH = "0.5154386965 0.8470437783 1.1358 1.3802 1.5197 1.5985 1.6467 1.6746091357 1.687873339 1.687873339"


def spline(coefficients, share):
    """A uniform quadratic B-spline; share from 0 to 1 runs over all of its pieces."""
    c = [mpf(text) for text in coefficients.split()]
    knots = share * (len(c) - 3)
    piece = int(floor(knots))
    t = knots - piece
    a, b, d = c[piece : piece + 3]
    left = a + (b - a) * (1 + t) / 2
    right = b + (d - b) * t / 2
    return left + (right - left) * t


def segmented(x, low, high, ends):
    """Two splines that meet in the middle, over log10."""
    first, middle, last = ends
    if x < middle:
        return spline(low, (x - first) / (middle - first))
    return spline(high, (x - middle) / (last - middle))


def rrt(x):
    return segmented(x, RRT_LOW, RRT_HIGH, [log10(GREY) + n * log10(mpf(2)) for n in (-15, 0, 18)])


ODT_ENDS = [rrt(log10(GREY) + mpf(n) * log10(mpf(2))) for n in ("-6.5", "0", "6.5")]


def aces(x):
    """The linear value of a grey x on a display in a dim room."""
    y = rrt(log10(x))
    if y <= ODT_ENDS[0]:
        return mpf(0)
    luminance = 10 ** segmented(y, ODT_LOW, ODT_HIGH, ODT_ENDS)
    return ((luminance - mpf("0.02")) / (48 - mpf("0.02"))) ** mpf("0.9811")


def table():
    lines = ["x,aces"]
    for thousandths in [1, 2, 3, 5, 8, 12, 20, 32, 50, 80, 128, 200, 320, 500, 800, 1280, 2000, 3200, 5000, 8000]:
        x = mpf(thousandths) / 1000
        lines.append(f"{mp.nstr(x, 6)},{mp.nstr(aces(2 * x), 30)}")
    return "\n".join(lines) + "\n"


if sys.argv[1:2] == ["--check"]:
    with open(sys.argv[2], encoding="utf-8") as file:
        if file.read() != table():
            sys.exit(f"{sys.argv[2]} differs from what this program computes")
else:
    sys.stdout.write(table())
