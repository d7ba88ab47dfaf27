#!/usr/bin/python3
"""The least-squares fits of the families, for tests/references.hpp, in 50 digits.

    make_references.py                prints the file tests/references/fits.csv
    make_references.py --check FILE   compares it with FILE

shadefit samples the integrals at quadrature nodes; here they are sums of power series. With the moments
    I(m) = integral of c^m over the measure on [0, 1] = 1/(m+1)                                     (cosine)
                                                      = sqrt(pi)/2 Gamma((m+1)/2) / Gamma(m/2+1)    (angle)
                                                      = 1/(m+2)                                     (cosine-weighted)
an integral of c^m h(c) is the sum of h_n I(m + n) over the Taylor coefficients h_n of h. Every gradient of the families is a
combination of such integrals.
"""
import sys

from mpmath import exp, findroot, floor, gamma, hyp1f1, ln, loggamma, matrix, mp, mpf, pi, sqrt

mp.dps = 75
EXPONENTS = """0.1 0.2 0.37 0.5 0.9 1 1.5 2 2.5 3 3.7 4 4.99 5 6 6.3 7 7.7 8 9 10 11 11.3 12 13 14 15 17.9 23.3 24 24.1 25 37.5 50
    100 1000 12345.678 10000 250000 1000000"""


def moment(measure, m):
    if measure == "angle":
        return sqrt(pi) / 2 * gamma((m + 1) / 2) / gamma(m / 2 + 1)
    return 1 / (m + (2 if measure == "cosine-weighted" else 1))


def lobe_integral(measure, m, s):
    """Of c^m exp(s (c - 1)): the sum of I(m + j) s^j/j! times exp(-s)."""
    if measure == "cosine-weighted":
        return lobe_integral("cosine", m + 1, s)
    if measure == "cosine":
        return hyp1f1(1, m + 2, -s) / (m + 1)
    # Weights of Poisson, which count within 24 standard deviations, and 400 for a small s.
    spread = 24 * sqrt(s) + 400
    first = floor(max(s - spread, 0))
    weight = exp(first * ln(s) - s - loggamma(first + 1))
    now, after, total = moment(measure, m + first), moment(measure, m + first + 1), 0
    for j in range(int(first), int(s + spread) + 1):
        total += weight * now
        weight *= s / (j + 1)
        now, after = after, now * (m + j + 1) / (m + j + 2)
    return total


def best_offset(measure, k):
    def gradient(x):
        """Half the derivative of the integral of (exp(a(c-1)) - c^k)^2 by a = k + x."""
        a = k + x
        return (lobe_integral(measure, mpf(1), 2 * a) - lobe_integral(measure, mpf(0), 2 * a)
                - lobe_integral(measure, k + 1, a) + lobe_integral(measure, k, a))

    start = k * mpf("0.9") if k < 1 else mpf("0.7")
    return findroot(gradient, (start, start * mpf("1.05")), solver="secant", tol=mpf(10) ** -58, verify=False)


def quadratic_integral(measure, m, alpha, beta):
    """Of c^m exp(alpha c^2 + beta c), by its Taylor series: n h_n = beta h_(n-1) + 2 alpha h_(n-2)."""
    before, now, total = 0, mpf(1), 0
    moments = [moment(measure, mpf(m)), moment(measure, mpf(m + 1))]
    for n in range(1, 500):
        total += now * moments[0]
        before, now = now, (beta * now + 2 * alpha * before) / n
        after = moments[0] * (m + n) / (m + n + 1) if measure == "angle" else moment(measure, mpf(m + n + 1))
        moments = [moments[1], after]
    return total


def fresnel_gradient(measure, alpha, beta, p):
    """By the coefficient of c^p: of the integral of (h - (1-c)^5)^2, h = exp(alpha c^2 + beta c)."""
    terms = enumerate((1, -5, 10, -10, 5, -1))
    return (quadratic_integral(measure, p, 2 * alpha, 2 * beta)
            - sum(binomial * quadratic_integral(measure, p + j, alpha, beta) for j, binomial in terms))


def best_one_term(measure):
    root = findroot(lambda beta: fresnel_gradient(measure, 0, beta, 1), (-8 * ln(2), -mpf("8.1") * ln(2)), tol=mpf(10) ** -115)
    return -root / ln(2)


def best_quadratic(measure):
    def gradients(alpha, beta):
        return [fresnel_gradient(measure, alpha, beta, 2), fresnel_gradient(measure, alpha, beta, 1)]

    start = matrix([mpf("-5.5"), mpf(-7)]) * ln(2)
    return findroot(gradients, list(start), tol=mpf(10) ** -58) / ln(2)


def text_of(value):
    return mp.nstr(value, 50)


def table():
    lines = ["constant,parameter,exponent,measure,value"]
    for measure in ("cosine", "angle", "cosine-weighted"):
        lines += [f"sg-offset,x,{k},{measure},{text_of(best_offset(measure, mpf(k)))}" for k in EXPONENTS.split()]
        lines.append(f"fresnel-one-term,A,,{measure},{text_of(best_one_term(measure))}")
        lines += [f"fresnel-quadratic,{name},,{measure},{text_of(value)}" for name, value in zip("ab", best_quadratic(measure))]
    return "\n".join(lines) + "\n"


if sys.argv[1:2] == ["--check"]:
    with open(sys.argv[2], encoding="utf-8") as file:
        if file.read() != table():
            sys.exit(f"{sys.argv[2]} differs from what this program computes")
else:
    sys.stdout.write(table())
