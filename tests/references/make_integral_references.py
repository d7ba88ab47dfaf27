#!/usr/bin/python3
"""One-parameter fits that have no power series of their own, for tests/references.hpp, in 25 digits: the Phong lobe by a Blinn lobe,
and fits on a part of the domain.

    make_integral_references.py                prints the file tests/references/integrals.csv
    make_integral_references.py --check FILE   compares it with FILE

shadefit samples robust rearrangements at Gauss-Legendre nodes; here the plain difference of form and target is integrated by
tanh-sinh, panel by panel.
"""
import sys

from mpmath import acos, cos, exp, findroot, ln, mp, mpf, quad

mp.dps = 40
EXPONENTS = "0.1 0.5 1 2 2.5 4 7.3 8 16 23.9 64 333.3 2048 1000000"
OTHER_POWERS = "32 128 256 512 1024"  # of two, which bench/peers/run sweeps


def sg_offset(c, k, x):
    """Form - target at c, and the form's derivative by x."""
    form = exp((k + x) * (c - 1))
    return form - c**k, form * (c - 1)


def phong_blinn(c, k, x):
    half = ln((1 + c) / 2) / 2
    form = exp(x * k * half)
    return form - c**k, form * k * half


def fresnel_one_term(c, _, a):
    form = exp(-a * ln(2) * c)
    return form - (1 - c) ** 5, -form * ln(2) * c


def gradient(family, k, measure, domain, x):
    """The integral of measure * error * slope: the gradient of the objective, up to a factor 2.

    Panels end at 1 - c = 1, 10, 100 over k, beyond which a lobe of exponent k has fallen to e^-100. In the angle measure the variable
    is the angle.
    """
    bottom, top = (1 - end for end in domain)
    ends = [top] + [y for y in (top + t / k for t in (1, 10, 100)) if y < bottom]
    if top + 100 / k >= bottom:
        ends.append(bottom)

    def integrand(variable):
        c = cos(variable) if measure == "angle" else 1 - variable
        if c <= 0:
            return mpf(0)
        error, slope = family(c, k, x)
        return error * slope * (c if measure == "cosine-weighted" else 1)

    return quad(integrand, [acos(1 - y) for y in ends] if measure == "angle" else ends)


def row(name, parameter, family, exponent, measure, domain, start):
    k, ends, start = mpf(exponent or 1), [mpf(end) for end in domain.split(":")], mpf(start)
    best = findroot(lambda x: gradient(family, k, measure, ends, x), (start, start * mpf("1.01")), tol=mpf(10) ** -30, verify=False)
    return f"{name},{parameter},{exponent},{measure},{domain},{mp.nstr(best, 25)}"


def table():
    lines = ["constant,parameter,exponent,measure,domain,value"]
    for measure in ("cosine", "angle", "cosine-weighted"):
        exponents = EXPONENTS.split() + (OTHER_POWERS.split() if measure == "cosine" else [])
        lines += [row("phong-blinn", "x", phong_blinn, exponent, measure, "0:1", "4.5") for exponent in exponents]
        lines += [row("sg-offset", "x", sg_offset, k, measure, "0.25:1", "0.7") for k in ("0.5", "5", "100")]
        lines.append(row("sg-offset", "x", sg_offset, "5", measure, "0.5:0.875", "0.7"))
        lines.append(row("fresnel-one-term", "A", fresnel_one_term, "", measure, "0.25:1", "8"))
    return "\n".join(lines) + "\n"


if sys.argv[1:2] == ["--check"]:
    with open(sys.argv[2], encoding="utf-8") as file:
        if file.read() != table():
            sys.exit(f"{sys.argv[2]} differs from what this program computes")
else:
    sys.stdout.write(table())
