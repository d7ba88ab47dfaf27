#!/usr/bin/python3
"""Albedos of diffuse surfaces, averages of Fresnel's reflectance and a phase function, for tests/fit/truths/truth_references_test.cpp.

    make_truth_references.py                prints the file tests/references/truths.csv
    make_truth_references.py --check FILE   compares it with FILE
    make_truth_references.py --digits       computes all values again, by other ways, and prints how many digits agree

All are integrals of the definitions below, no closed forms. l is the cosine of the light, c that of the view, t their product of sines
times the cosine of the azimuth between them, r a roughness.

    burley_albedo(c, r)         of (1 + (f - 1) (1 - c)^5) (1 + (f - 1) (1 - l)^5)/pi, f = 1/2 + 2 r (1 + c l + t)/2
    oren_nayar_albedo(c, r)     of (1 - 0.5 r^2/(r^2 + 0.33) + 0.45 r^2/(r^2 + 0.09) max(0, t)/max(c, l))/pi
    fon_albedo(c, r)            of A (1 + r (t/max(c, l) where t > 0, else t))/pi, A = 1/(1 + r (1/2 - 2/(3 pi)))
    fon_average(r)              the integral of 2 c fon_albedo(c, r) over c
    eon_albedo(c, r, rho)       of rho times the same BRDF, and rho2/pi (1 - E(c)) (1 - E(l))/(1 - M) with E = fon_albedo,
                                M = fon_average, rho2 = rho^2 M/(1 - rho (1 - M)): f_EON of portsmouth/EON-diffuse@2ba6815687
    fresnel_average(n)          the integral of 2 c F(c, n) over c
    fresnel_average_inside(n)   that of 2 c F(c, 1/n), with total reflection
    conductor_reflectance(c, n, k), conductor_average(n, k)   F(c, n + i k), and its average
    hg(c, g)                    the sum of (2 j + 1) g^j P_j(c)/(4 pi), with Legendre's polynomials

F(c, m) is the mean of |rs|^2 and |rp|^2, rs = (c - q)/(c + q), rp = (m^2 c - q)/(m^2 c + q), q = sqrt(m^2 - 1 + c^2), complex.
"""
import functools
import sys

from mpmath import asin, cos, fabs, mp, mpc, mpf, pi, quad, sin, sqrt

import make_albedo_references as albedo

mp.dps = 34
COSINES = ["0", "0.01", "0.3", "0.9", "1"]
ROUGHNESSES = ["0.01", "0.3", "1"]
INDICES = ["1.01", "1.05", "1.5", "2.5", "10"]
METALS = [("0.2", "3"), ("1.5", "7"), ("3", "3"), ("0.05", "2")]


# Diffuse surfaces.
def burley(c, l, t, r):
    less = 2 * r * (1 + c * l + t) / 2 - mpf(1) / 2
    return (1 + less * (1 - c) ** 5) * (1 + less * (1 - l) ** 5) / pi


def oren_nayar(c, l, t, r):
    a, b = 1 - mpf("0.5") * r**2 / (r**2 + mpf("0.33")), mpf("0.45") * r**2 / (r**2 + mpf("0.09"))
    return (a + b * max(t, 0) / max(c, l)) / pi


def fon(c, l, t, r):
    return (1 + r * (t / max(c, l) if t > 0 else t)) / (1 + r * (mpf(1) / 2 - 2 / (3 * pi))) / pi


DIFFUSE = [("burley_albedo", burley), ("oren_nayar_albedo", oren_nayar), ("fon_albedo", fon)]


@functools.cache
def albedo_of(brdf, c, r):
    """Gauss over the elevation and the azimuth of the light. The formulas have kinks at l = c and where t = 0."""
    top, side, total = asin(c), sqrt(1 - c * c), mpf(0)
    for low, high in ((mpf(0), top), (top, pi / 2)):
        for u, outer in albedo.gauss(24) if low < high else []:
            x = low + (high - low) * u
            l, weight = sin(x), 2 * outer * (high - low) * sin(x) * cos(x) * pi / 2
            for v, inner in albedo.gauss(12):
                t = side * cos(x) * cos(v * pi / 2)
                total += weight * inner * (brdf(c, l, t, r) + brdf(c, l, -t, r))
    return total


@functools.cache
def average_of(brdf, r):
    return sum(weight * pi / 2 * sin(u * pi) * albedo_of(brdf, sin(u * pi / 2), r) for u, weight in albedo.gauss(24))


@functools.cache
def part_of_many(c, r):
    """The integral over the light of (1 - E(c)) (1 - E(l))/(1 - M)/pi."""
    lost = sum(weight * pi / 2 * sin(u * pi) * (1 - albedo_of(fon, sin(u * pi / 2), r)) for u, weight in albedo.gauss(30))
    return (1 - albedo_of(fon, c, r)) * lost / (1 - average_of(fon, r))


def eon(c, r, rho):
    mean = average_of(fon, r)
    return rho * albedo_of(fon, c, r) + rho**2 * mean / (1 - rho * (1 - mean)) * part_of_many(c, r)


# The same by tanh-sinh over the cosine of the light, the azimuth by hand: the means over it are of t 0, of t^2 half the square of the
# sines, of max(0, t) the sines over pi.
def albedo_by_hand(brdf, c, r):
    def of_light(l):
        sines = sqrt((1 - c * c) * (1 - l * l))
        if brdf is burley:
            q, p, less = (1 - c) ** 5, (1 - l) ** 5, r * (1 + c * l) - mpf(1) / 2
            return 2 * l * ((1 + less * q) * (1 + less * p) + r**2 * sines**2 / 2 * q * p)
        if brdf is oren_nayar:
            a, b = 1 - mpf("0.5") * r**2 / (r**2 + mpf("0.33")), mpf("0.45") * r**2 / (r**2 + mpf("0.09"))
            return 2 * l * (a + b * sines / pi / max(c, l)) if l > 0 else mpf(0)
        return 2 * l * (1 + r * sines / pi * (1 / max(c, l) - 1)) / (1 + r * (mpf(1) / 2 - 2 / (3 * pi))) if l > 0 else mpf(0)

    return quad(of_light, sorted({mpf(0), c, mpf(1)}))


# Fresnel.
def reflectance(c, m):
    q = sqrt(mpc(m * m - 1 + c * c))
    return (fabs((c - q) / (c + q)) ** 2 + fabs((m * m * c - q) / (m * m * c + q)) ** 2) / 2 if c > 0 else mpf(1)


def fresnel(m):
    """Tanh-sinh over the cosine; inside a dielectric total reflection begins at the root."""
    critical = sqrt(1 - m * m) if m.imag == 0 and m.real < 1 else mpf(0)
    pieces = sorted({mpf(0), critical, mpf(1) / 16, mpf(1) / 4, mpf(1)})
    return quad(lambda c: 2 * c * reflectance(c, m), pieces)


def fresnel_by_gauss(m):
    """Over graded panels. From the angle of total reflection the distance is a square."""
    if m.imag == 0 and m.real < 1:
        critical = sqrt(1 - m * m)
        nodes = [(critical + t * t, 2 * t * weight) for t, weight in albedo.graded(sqrt(critical), sqrt(1 - critical), 60)]
        return critical**2 + sum(weight * 2 * c * reflectance(c, m) for c, weight in nodes)
    scale = min(fabs(sqrt(mpc(m * m - 1))), fabs(1 / m), mpf(1) / 10)
    return sum(weight * 2 * c * reflectance(c, m) for c, weight in albedo.graded(scale, mpf(1), 100))


# Henyey and Greenstein.
def hg_series(c, g):
    total, last, p, j = mpf(0), mpf(0), mpf(1), 0
    while fabs(g) ** j * (2 * j + 1) > mpf(10) ** -32:
        total += (2 * j + 1) * g**j * p
        last, p, j = p, ((2 * j + 1) * c * p - j * last) / (j + 1), j + 1
    return total / (4 * pi)


def hg_formula(c, g):
    return (1 - g * g) / (4 * pi * (1 + g * g - 2 * g * c) ** (mpf(3) / 2))


def rows():
    """(function, arguments as text, value, a function that computes it by another way)"""
    for name, brdf in DIFFUSE:
        for c in COSINES:
            for r in ROUGHNESSES:
                place = mpf(c), mpf(r)
                yield name, (c, r), albedo_of(brdf, *place), functools.partial(albedo_by_hand, brdf, *place)
    for r in ROUGHNESSES:
        other = lambda r=mpf(r): quad(lambda c: 2 * c * albedo_by_hand(fon, c, r), [0, 1])
        yield "fon_average", (r,), average_of(fon, mpf(r)), other
    for c in COSINES:
        for r in ROUGHNESSES:
            for rho in ("0.2", "0.8"):
                def other(c=mpf(c), r=mpf(r), rho=mpf(rho)):
                    whole, mean = albedo_by_hand(fon, c, r), average_of(fon, r)
                    return rho * whole + rho**2 * mean * (1 - whole) / (1 - rho * (1 - mean))

                yield "eon_albedo", (c, r, rho), eon(mpf(c), mpf(r), mpf(rho)), other
    for name, power in (("fresnel_average", 1), ("fresnel_average_inside", -1)):
        for n in INDICES:
            yield name, (n,), fresnel(mpf(n) ** power), functools.partial(fresnel_by_gauss, mpf(n) ** power)
    for n, k in METALS:
        m = mpc(mpf(n), mpf(k))
        for c in COSINES:
            # The other way is Born and Wolf's, with real numbers.
            def other(c=mpf(c), n=mpf(n), k=mpf(k)):
                s = 1 - c * c
                p = sqrt((n * n - k * k - s) ** 2 + 4 * n * n * k * k)
                a = sqrt((p + n * n - k * k - s) / 2)
                rs = (p + c * c - 2 * a * c) / (p + c * c + 2 * a * c)
                return rs * (1 + (c * c * p + s * s - 2 * a * c * s) / (c * c * p + s * s + 2 * a * c * s)) / 2

            yield "conductor_reflectance", (c, n, k), reflectance(mpf(c), m), other
    for n, k in METALS:
        m = mpc(mpf(n), mpf(k))
        yield "conductor_average", (n, k), fresnel(m), functools.partial(fresnel_by_gauss, m)
    for c in ("-1", "-0.5", "0.01", "1"):
        for g in ("-0.5", "0.01", "0.9"):
            yield "hg", (c, g), hg_series(mpf(c), mpf(g)), functools.partial(hg_formula, mpf(c), mpf(g))


def table():
    lines = ["function,first,second,third,value"]
    for name, arguments, value, _ in rows():
        lines.append(",".join([name, *arguments, *[""] * (3 - len(arguments)), mp.nstr(value, 20)]))
    return "\n".join(lines) + "\n"


if sys.argv[1:2] == ["--digits"]:
    for name, arguments, value, other in rows():
        albedo.agreement(f"{name}({', '.join(arguments)})", value, other())
elif sys.argv[1:2] == ["--check"]:
    with open(sys.argv[2], encoding="utf-8") as file:
        if file.read() != table():
            sys.exit(f"{sys.argv[2]} differs from what this program computes")
else:
    sys.stdout.write(table())
