#!/usr/bin/python3
"""Prints the right answers of seen_fits_test.cpp: a target, then its first parameter, and its second or its level.

Least squares by mpmath's quadrature between places around each feature. Minimax by Remez' exchange on a grid of known features, with the
highest places refined.
"""
import mpmath as mp

mp.mp.dps = 30


def around(place, width):
    return [place + k * width for k in (-60, -20, -8, -4, -2, -1, 0, 1, 2, 4, 8, 20, 60)]


def integral(f, lower, upper, places):
    inside = sorted({x for x in places if lower < x < upper})
    return mp.quad(f, [lower, *inside, upper])


def line(f, lower, upper, places=()):
    """The line that is nearest in the mean square."""
    m = [integral(lambda x, k=k: x**k * f(x), lower, upper, places) for k in (0, 1)]
    g = mp.matrix(2, 2)
    for i in range(2):
        for k in range(2):
            g[i, k] = (mp.mpf(upper) ** (i + k + 1) - mp.mpf(lower) ** (i + k + 1)) / (i + k + 1)
    return mp.lu_solve(g, mp.matrix(m))


def exponential(f, upper, places):
    """The nearest a exp(-b x): both derivatives of the mean square are 0."""
    def slopes(a, b):
        error = lambda x: a * mp.e ** (-b * x) - f(x)
        return [integral(lambda x: error(x) * mp.e ** (-b * x), 0, upper, places),
                integral(lambda x: error(x) * x * mp.e ** (-b * x), 0, upper, places)]
    return mp.findroot(slopes, (1, 1))


def least_level(basis, f, grid, weight=lambda x: 1):
    """Remez' exchange of one place: the constants and the level."""
    n = len(basis)
    reference = [grid[i * (len(grid) - 1) // n] for i in range(n + 1)]
    error = None
    for _ in range(60):
        a = mp.matrix(n + 1, n + 1)
        for i, x in enumerate(reference):
            for k in range(n):
                a[i, k] = basis[k](x) * weight(x)
            a[i, n] = (-1) ** i
        c = mp.lu_solve(a, mp.matrix([f(x) * weight(x) for x in reference]))
        error = lambda x, c=c: (f(x) - sum(c[k] * basis[k](x) for k in range(n))) * weight(x)
        tops = []
        values = [error(x) for x in grid]
        start = 0
        for i in range(1, len(grid) + 1):
            if i == len(grid) or (values[i] > 0) != (values[start] > 0):
                top = max(range(start, i), key=lambda j: abs(values[j]))
                low, high = grid[max(top - 1, 0)], grid[min(top + 1, len(grid) - 1)]
                for _ in range(60):
                    third = (high - low) / 3
                    if abs(error(low + third)) < abs(error(high - third)):
                        low += third
                    else:
                        high -= third
                tops.append(max((low, high, grid[top]), key=lambda x: abs(error(x))))
                start = i
        while len(tops) > n + 1:
            tops.pop(0 if abs(error(tops[0])) < abs(error(tops[-1])) else -1)
        reference = tops
        if max(abs(error(x)) for x in tops) < abs(c[n]) * (1 + mp.mpf(10) ** -14):
            return c
    raise SystemExit("the exchange does not settle")


def even(lower, upper, count=400):
    return [mp.mpf(lower) + (mp.mpf(upper) - lower) * i / count for i in range(count + 1)]


def show(name, answer, *at):
    print(name, *(mp.nstr(abs(answer[i]) if i == len(answer) - 1 and i > 1 else answer[i], 17) for i in at))


bell = lambda x, place, width: mp.e ** -(((x - mp.mpf(place)) / mp.mpf(width)) ** 2)
show("acos", line(lambda x: mp.acos(x) + mp.mpf("0.1") * bell(x, "0.3432", "0.003"), 0, 1,
                  around(mp.mpf("0.3432"), mp.mpf("0.003")) + [1 - mp.mpf(10) ** -k for k in range(1, 15)]), 0, 1)
show("exp", exponential(lambda x: mp.e ** -x + mp.mpf("0.2") * bell(x, "1.2345", "0.01"), 4,
                        around(mp.mpf("1.2345"), mp.mpf("0.01"))), 0, 1)
hat = lambda x: max(0, 1 - abs(x - mp.mpf("0.3432")) / mp.mpf("0.0001"))
show("hat", line(hat, 0, 1, [mp.mpf("0.3431"), mp.mpf("0.3432"), mp.mpf("0.3433")]), 0, 1)
show("pole", (mp.mpf(4) / mp.mpf("0.7") - mp.mpf(6) / mp.mpf("1.7"), mp.mpf(12) / mp.mpf("1.7") - mp.mpf(6) / mp.mpf("0.7")), 0, 1)
narrow = mp.mpf("0.2232")
show("narrow", least_level([lambda x: 1, lambda x: x], lambda x: 1 / (1 + x) + bell(x, "0.2232", "0.0005") / 2,
                           sorted(even(0, 1) + [narrow + mp.mpf(k) / 200000 for k in range(-800, 801)])), 0, 2)
limit = lambda f, at_zero: lambda x: at_zero if x == 0 else f(x)
show("log(1 + x)/x", least_level([lambda x: 1, lambda x: x], limit(lambda x: mp.log1p(x) / x, 1), even(0, 1)), 0, 2)
show("(1 - cos x)/x^2", line(limit(lambda x: (1 - mp.cos(x)) / x**2, mp.mpf(1) / 2), 0, 1), 0, 1)
show("sin, relative", least_level([lambda x: 1, lambda x: x**2], limit(lambda x: mp.sin(x) / x, 1), even(0, 0.125),
                                  limit(lambda x: x / mp.sin(x), 1)), 0, 2)
show("x log x", least_level([lambda x: x, lambda x: x**2, lambda x: x**3], limit(lambda x: x * mp.log(x), 0),
                            sorted(even(0, 1) + [mp.mpf(2) ** -k for k in range(9, 60)])), 0, 3)
show("sin(x)/x", least_level([lambda x: x**2, lambda x: x**4], limit(lambda x: mp.sin(x) / x - 1, 0), even(0, mp.pi)), 0, 2)
