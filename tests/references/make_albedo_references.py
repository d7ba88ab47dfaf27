#!/usr/bin/python3
"""Directional albedos of GGX and of sheen: the share of the light from one direction that a surface reflects.

    make_albedo_references.py                prints the file tests/references/albedo.csv
    make_albedo_references.py --check FILE   compares it with FILE
    make_albedo_references.py --digits       computes all values again, by other integrals, and prints how many digits agree

mu is the cosine of the view, alpha the width of the lobe. A program whose roughness is perceptual has alpha = roughness^2.
No value is clamped: those of sheen may be greater than 1.

    ggx-height-correlated   F = 1, G2 = 2 l mu/(mu sqrt(alpha^2 + (1 - alpha^2) l^2) + l sqrt(alpha^2 + (1 - alpha^2) mu^2))
    ggx-separable           F = 1, G2 = G1(mu) G1(l), G1(c) = 2 c/(c + sqrt(alpha^2 + (1 - alpha^2) c^2))
    ggx-schlick             F = 1, G2 = G1(mu) G1(l), G1(c) = c/(c (1 - k) + k), k = alpha/2
    ggx-..-scale, -bias     with Schlick's F = f0 + (1 - f0) (1 - v.h)^5: the albedo is f0 scale + bias
    sheen-neubelt           Charlie's D = (2 + 1/alpha) sin(h)^(1/alpha)/(2 pi), V = 1/(4 (l + mu - l mu)) by Neubelt and Pettineo 2013.
                            Filament and three.js take it with alpha = roughness^2, MaterialX (Imageworks sheen) with alpha = roughness.
    sheen-charlie           the same with V at most 1, as three.js has it
    sheen-estevez-kulla     the same D, V = 1/(4 l mu (1 + lambda(mu) + lambda(l))) of Estevez and Kulla 2017, no softened terminator
"""
import sys

from mpmath import (asin, asinh, atan, atan2, beta, cos, cosh, elliprf, elliprj, exp, expm1, floor, log, log10, mp, mpf,
                    pi, quad, sin, sinh, sqrt, tan)

mp.dps = 50
POINTS = [("0.01", "0.01"), ("0.01", "0.1"), ("0.01", "1"), ("0.1", "0.01"), ("0.1", "0.1"), ("0.1", "0.5"), ("0.5", "0.1"),
          ("0.5", "0.5"), ("0.9", "0.01"), ("0.9", "0.5"), ("1", "0.1"), ("1", "1"), ("0.2", "0.25"), ("0.0001", "0.1"),
          ("0.01", "0.0001"), ("0.5", "0.0001")]
MASKINGS = ["height-correlated", "separable", "schlick"]
RULES = {}


def gauss(count):
    """Gauss-Legendre on [0, 1]: pairs of node and weight."""
    if count not in RULES:
        RULES[count] = []
        for k in range(count):
            x = cos(pi * (k + mpf(3) / 4) / (count + mpf(1) / 2))
            for _ in range(7):
                last, p = mpf(1), x
                for n in range(2, count + 1):
                    last, p = p, ((2 * n - 1) * x * p - (n - 1) * last) / n
                slope = count * (x * p - last) / (x * x - 1)
                x -= p / slope
            RULES[count].append(((1 - x) / 2, 1 / ((1 - x * x) * slope**2)))
    return RULES[count]


def graded(scale, end, count):
    """Gauss-Legendre for [0, end], denser and denser towards 0, down to the scale: x = scale sinh(k t)."""
    k = asinh(end / scale)
    return [(scale * sinh(k * t), weight * k * scale * cosh(k * t)) for t, weight in gauss(count)]


def masking(mu, l, alpha):
    """G2/mu, for each of MASKINGS."""
    root_v, root_l = (sqrt(alpha**2 + (1 - alpha**2) * c**2) for c in (mu, l))
    k = alpha / 2
    return [2 * l / (mu * root_l + l * root_v), 4 * l / ((mu + root_v) * (l + root_l)), l / ((mu * (1 - k) + k) * (l * (1 - k) + k))]


# GGX over the directions of the light. With d and m, half the difference and half the sum of the angles of light and view, and q
# the azimuth from the mirrored view: |v + l|^2 = 4 (cos^2 m + s sin^2(q/2)), s the product of the sines. The integrals over q of
# D alone are elementary.
def light_angles(mu, alpha, count):
    """(elevation x of the light, d, weight): panels from the mirrored view to the normal and to the horizon, and from the horizon."""
    view = pi / 2 - asin(mu)
    top = asin(mu)
    scale = min(alpha, mu)
    nodes = []
    for sign, end in ((-1, view / 2), (1, top / 4)):
        if end > 0:
            for t, weight in graded(scale, tan(end), count):
                d = atan(t)
                nodes.append((top - 2 * sign * d, -sign * d, 2 * weight / (1 + t * t)))
    for x, weight in graded(scale, top / 2, count):
        nodes.append((x, (x - top) / 2, weight))
    return nodes


def ggx_by_light(mu, alpha, count, azimuths):
    """Albedos for MASKINGS with F = 1, by the closed form, and with F = (1 - v.h)^5."""
    whole, bias = [mpf(0)] * 3, [mpf(0)] * 3
    a2 = alpha**2
    for x, d, weight in light_angles(mu, alpha, count):
        l = sin(x)
        m = pi / 2 - x + d
        sines = cos(x) * sqrt(1 - mu * mu)
        c2d, c2m = cos(d) ** 2, cos(m) ** 2
        near, far = 4 * c2m * (1 - c2d + a2 * c2d), 4 * c2d * (1 - c2m + a2 * c2m)  # |v + l|^2 (1 - (1 - a2) h_z^2), q = 0 and pi
        part = 4 * (1 - a2) * c2d * c2m
        root = sqrt(near * far)
        closed = 2 * pi * (1 + 2 * part / root + part**2 * (near + far) / 2 / root**3)
        weight *= a2 * cos(x) / (4 * pi)
        if sines > 0:
            fresnel = mpf(0)
            for half, w in graded(sqrt(near / (4 * sines)), pi / 2, azimuths):
                turn = 4 * sines * sin(half) ** 2
                square = 4 * c2m + turn
                fresnel += 4 * w * (square / (near + turn)) ** 2 * (1 - sqrt(square) / 2) ** 5
        else:
            fresnel = closed * (1 - cos(m)) ** 5
        for k, g in enumerate(masking(mu, l, alpha)):
            whole[k] += weight * closed * g
            bias[k] += weight * fresnel * g
    return whole, bias


def ggx_by_normals(mu, alpha, count):
    """The same over the slopes of the visible normals, in polar coordinates: slope alpha sinh(u), up to where the light sets."""
    whole, bias = [mpf(0)] * 3, [mpf(0)] * 3
    s = sqrt(1 - mu * mu)
    for sign in (1, -1):
        for chi, outer in graded(mu, pi / 2, count):
            c = sign * sin(chi)
            root = sqrt((s * c) ** 2 + mu**2)
            end = (root + s * c) / mu if c > 0 else mu / (root - s * c)
            end = asinh(end / alpha)
            nodes = [(t * end / 2, w * end / 2) for t, w in gauss(count)]
            nodes += [(end - t, w) for t, w in graded(alpha, end / 2, count)]
            for u, inner in nodes:
                slope = alpha * sinh(u)
                toward = mu + s * slope * c
                l = 2 * toward / (1 + slope**2) - mu
                weight = 2 / pi * outer * inner * toward * sinh(u) / cosh(u) ** 3
                fresnel = (1 - toward / sqrt(1 + slope**2)) ** 5
                for k, g in enumerate(masking(mu, l, alpha)):
                    whole[k] += weight * g
                    bias[k] += weight * g * fresnel
    return whole, bias


# Sheen.
def neubelt(mu, l, alpha):
    """l V"""
    return l / (4 * (l + mu - l * mu))


def charlie(mu, l, alpha):
    """l V. V is cut off where l is below `cut_of`."""
    return min(l, neubelt(mu, l, alpha))


def cut_of(view, mu):
    return (mpf(1) / 4 - mu) / (1 - mu) if view is charlie and mu < mpf(1) / 4 else mpf(0)


def estevez_kulla(mu, l, alpha):
    """l V, with the fit of lambda that the paper prints for alpha = 0 and for alpha = 1."""
    smooth = (1 - alpha) ** 2
    a, b, c, d, e = (smooth * mpf(x) + (1 - smooth) * mpf(y) for x, y in zip(
        "25.3245 3.32435 0.16801 -1.27393 -4.85967".split(), "21.5473 3.82987 0.19823 -1.97760 -4.32054".split()))
    curve = lambda x: a / (1 + b * x**c) + d * x + e
    slope = lambda x: exp(curve(x)) if x < mpf(1) / 2 else exp(2 * curve(mpf(1) / 2) - curve(1 - x))
    return 1 / (4 * mu * (1 + slope(mu) + slope(l)))


def around(mu, l, alpha):
    """The integral of sin(h)^(1/alpha) over the azimuth: a polynomial where 1/(2 alpha) is whole, elliptic for alpha = 1."""
    if alpha == 1:
        s = sqrt((1 - mu * mu) * (1 - l * l))
        m2 = (1 + mu * l - s) / 2  # cos^2 m; sin^2 d is (1 - mu l - s)/2
        if s == 0:
            return 2 * pi * sqrt(1 - m2)
        outer, inner = m2 / s, m2 * ((mu - l) ** 2 / (2 * (1 - mu * l + s))) / s
        p, q = inner / (1 + inner), outer / (1 + outer)
        return 4 / sqrt((1 + inner) * (1 + outer)) * ((1 + inner) * elliprf(0, p, q) - elliprj(0, p, q, 1) / 3)
    power = int(floor(1 / (2 * alpha) + mpf(1) / 2))
    with mp.workdps(80):
        half, x = (mu + l) / 2, (1 + mu * l) / (mu + l)
        total, last, p, factor = mpf(1), mpf(0), mpf(1), mpf(1)
        for j in range(1, power + 1):
            factor *= -half * (power - j + 1) / j
            total += factor * p
            last, p = p, ((2 * j - 1) * x * p - (j - 1) * last) / j
    return 2 * pi * total


def sheen_by_light(view, mu, alpha):
    """Tanh-sinh over the cosine of the light. lambda changes its formula at 1/2, the lobe of alpha = 1 has a logarithm at mu."""
    cuts = sorted({mpf(0), mu / 16, mu, mpf(1) / 2, mpf(1), cut_of(view, mu)})
    return (2 + 1 / alpha) / (2 * pi) * quad(lambda l: view(mu, l, alpha) * around(mu, l, alpha), cuts)


def sheen_by_normals(view, mu, alpha, count):
    """Neubelt's and Charlie's, over the half vectors, in polar coordinates about the normal, up to where the light sets. The cut of
    the visibility is at no, one or two of these half vectors, and they meet where r is the cut."""
    s = sqrt(1 - mu * mu)
    cut = cut_of(view, mu)
    meet = asin(sqrt(cut**2 - mu**2) / s) if cut > mu else mpf(0)
    azimuths = graded(mu, (meet or pi) / 2, count)
    if meet:
        for end in (meet / 2, pi / 2 - meet):
            for t, w in graded(sqrt(mu), sqrt(end), count):  # the root of the distance
                azimuths.append((meet - t * t if end == meet / 2 else meet + t * t, 2 * t * w))
    total = mpf(0)
    for sign in (1, -1):
        for chi, outer in azimuths:
            c = sign * sin(chi)
            r = sqrt(mu**2 + (s * c) ** 2)
            end = atan2(mu, -s * c) / 2
            turns = [asin(cut / r) / 2, (pi - asin(cut / r)) / 2] if 0 < cut < r else []
            ends = sorted({mpf(0), end, *(turn for turn in turns if turn < end)})
            for low, high in zip(ends, ends[1:]):  # t, the distance from the end
                half = (high - low) / 2
                nodes = [(low + t, w) for t, w in graded(min(mu / r, half), half, count)]
                nodes += [(high - t, w) for t, w in graded(min(mu, half), half, count)]
                for t, inner in nodes:
                    theta = end - t
                    l = r * sin(2 * t)
                    half_cosine = mu * cos(theta) + s * sin(theta) * c  # v.h
                    total += outer * inner * sin(theta) ** (1 + 1 / alpha) * half_cosine * view(mu, l, alpha)
    return (2 + 1 / alpha) / (2 * pi) * 8 * total


def sheen_by_angles(view, mu, alpha, count):
    """By Gauss over the elevation x and the azimuth of the light. Panels are graded to both of their ends."""
    top, middle = asin(mu), pi / 6
    cuts = sorted({mpf(0), top, middle, pi / 2, asin(cut_of(view, mu))})
    nodes = []
    for depth, far in ((0, 8), (8, 48)):  # x = cuts[1] exp(-t), as lambda has a root at the horizon
        for t, w in gauss(count):
            t, w = depth + (far - depth) * t**3, 3 * t * t * (far - depth) * w
            x = cuts[1] * exp(-t)
            nodes.append((x, w * x, (cuts[1] * expm1(-t) if cuts[1] == top else x - top) / 2))
    for a, b in zip(cuts[1:], cuts[2:]):
        for t, w in gauss(count):
            up = lambda u: u**6 * (462 + u * (-1980 + u * (3465 + u * (-3080 + u * (1386 - 252 * u)))))
            x = a + (b - a) * up(t)
            d = -(b - a) * up(1 - t) if b == top else (b - a) * up(t) if a == top else x - top
            nodes.append((x, w * (b - a) * 2772 * (t * (1 - t)) ** 5, d / 2))
    total = mpf(0)
    for x, weight, d in nodes:
        m = pi / 2 - x + d
        sines, c2m, s2d = cos(x) * sqrt(1 - mu * mu), cos(m) ** 2, sin(d) ** 2
        if sines > 0:
            ring = mpf(0)
            scale = s2d if alpha > 0.25 else 1  # a narrow lobe is nothing where sin^2 h is small
            for half, w in graded(sqrt(c2m * scale / sines), pi / 2, count):
                turn = sines * sin(half) ** 2
                ring += 4 * w * ((c2m * s2d + turn) / (c2m + turn)) ** (1 / (2 * alpha))
        else:
            ring = 2 * pi * s2d ** (1 / (2 * alpha))
        total += weight * cos(x) * view(mu, sin(x), alpha) * ring
    return (2 + 1 / alpha) / (2 * pi) * total


SHEENS = [("sheen-neubelt", neubelt), ("sheen-charlie", charlie), ("sheen-estevez-kulla", estevez_kulla)]


def is_narrow(mu, alpha):
    return min(mu, alpha) < mpf("0.001")


def values(mu, alpha):
    whole, bias = ggx_by_light(mu, alpha, *((110, 100) if is_narrow(mu, alpha) else (76, 68)))
    rows = [(f"ggx-{name}", value) for name, value in zip(MASKINGS, whole)]
    for k, name in enumerate(MASKINGS):
        rows += [(f"ggx-{name}-scale", whole[k] - bias[k]), (f"ggx-{name}-bias", bias[k])]
    if alpha >= mpf("0.001"):
        rows += [(name, sheen_by_light(view, mu, alpha)) for name, view in SHEENS]
    elif mu < mpf("0.1"):  # above it a narrow lobe gives nothing; its polynomial cancels
        rows += [(name, sheen_by_angles(view, mu, alpha, 130)) for name, view in SHEENS[:2]]
    return rows


def others(mu, alpha):
    """The same by other integrals."""
    normals, halves, angles = (150, 110, 120) if is_narrow(mu, alpha) else (72, 56, 88)
    whole, bias = ggx_by_normals(mu, alpha, normals)
    rows = whole + [part for k in range(3) for part in (whole[k] - bias[k], bias[k])]
    rows += [sheen_by_normals(view, mu, alpha, halves) for _, view in SHEENS[:2]]
    return rows + ([] if alpha < mpf("0.001") else [sheen_by_angles(estevez_kulla, mu, alpha, angles)])


def table():
    lines = {}
    for mu, alpha in POINTS:
        for name, value in values(mpf(mu), mpf(alpha)):
            lines.setdefault(name, []).append(f"{name},{mu},{alpha},{mp.nstr(value, 20)}")
    return "\n".join(["function,mu,alpha,value"] + [line for group in lines.values() for line in group]) + "\n"


def agreement(name, value, other):
    digits = 50 if value == other else int(floor(-log10(abs(value / other - 1))))
    print(f"{name}: {mp.nstr(value, 20)}, {digits} digits agree", flush=True)


def digits():
    for mu_text, alpha_text in POINTS:
        mu, alpha = mpf(mu_text), mpf(alpha_text)
        for (name, value), other in zip(values(mu, alpha), others(mu, alpha)):
            agreement(f"{name} at mu = {mu_text}, alpha = {alpha_text}", value, other)
    for text in ("0.01", "0.5", "1"):
        mu, one = mpf(text), mpf(1)
        whole = ggx_by_light(mu, one, 76, 2)[0]
        agreement(f"ggx-height-correlated at mu = {text}, alpha = 1, and 1 - mu log(1 + 1/mu)", whole[0], 1 - mu * log(1 + 1 / mu))
        for k in (1, 2):
            closed = 2 * (1 - log(mpf(2))) / (1 + mu)
            agreement(f"ggx-{MASKINGS[k]} at mu = {text}, alpha = 1, and 2 (1 - log 2)/(1 + mu)", whole[k], closed)
    # alpha = 1/2: the integral of (1 - (mu + l)/2) l/(mu + (1 - mu) l) over l.
    for text in ("0.01", "0.5"):
        mu = mpf(text)
        n = 1 - mu
        r = mu / n
        closed = ((1 - mu / 2) * (1 - r * log(1 / mu)) - (mpf(1) / 2 - r + r**2 * log(1 / mu)) / 2) / n
        agreement(f"sheen-neubelt at mu = {text}, alpha = 0.5, and the closed form", sheen_by_light(neubelt, mu, mpf("0.5")), closed)
    # mu = 1: sin^2 h = (1 - l)/2 for all azimuths.
    for text in ("0.01", "0.1", "0.5", "1"):
        alpha = mpf(text)
        m = 1 / (2 * alpha)
        closed = (2 + 1 / alpha) / 4 * mpf(2) ** -m * beta(2, m + 1)
        agreement(f"sheen-neubelt at mu = 1, alpha = {text}, and the closed form", sheen_by_light(neubelt, mpf(1), alpha), closed)
    # The limits. A surface of small alpha is a mirror; a grazing view sees no light lost by the height-correlated masking.
    for mu_text, alpha_text in (("0.5", "0.001"), ("0.5", "0.0001"), ("0.001", "0.1"), ("0.0001", "0.1")):
        whole, bias = ggx_by_light(mpf(mu_text), mpf(alpha_text), 100, 90)
        print(f"mu = {mu_text}, alpha = {alpha_text}: 1 - whole =", *(mp.nstr(1 - x, 6) for x in whole), "and bias - (1 - mu)^5 =",
              *(mp.nstr(x - (1 - mpf(mu_text)) ** 5, 6) for x in bias))


if __name__ != "__main__":
    pass  # another program uses the functions
elif sys.argv[1:2] == ["--digits"]:
    digits()
elif sys.argv[1:2] == ["--check"]:
    with open(sys.argv[2], encoding="utf-8") as file:
        if file.read() != table():
            sys.exit(f"{sys.argv[2]} differs from what this program computes")
else:
    sys.stdout.write(table())
