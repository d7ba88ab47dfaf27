"""The tasks of bench/peers/run with SciPy, as its users write them; task_program.hpp says the protocol."""

import os
import sys
import time
import warnings

import numpy as np
from scipy import integrate, optimize

SWEEP = [float(k) for k in range(3, 16)]
LARGE = [100.0, 1e3, 1e4, 1e6]
POWERS = [2.0**i for i in range(1, 12)]
PUBLISHED = (float(os.environ["PUBLISHED_A"]), float(os.environ["PUBLISHED_B"]))
C = np.linspace(0, 1, 1001)
THETA = np.linspace(0, np.pi / 2, 1001)


def pair(c, a, b):
    return np.exp2((a * c + b) * c)


def schlick(c):
    return (1 - c) ** 5


def named(values, names="ab"):
    return [(name, None, value) for name, value in zip(names, values)]


def pair_curve_fit():
    return named(optimize.curve_fit(pair, C, schlick(C), p0=(-5, -5))[0])


def pair_bfgs():
    return named(optimize.minimize(lambda p: integrate.quad(lambda c: (pair(c, *p) - schlick(c)) ** 2, 0, 1)[0], (-5, -5)).x)


def pair_fsolve():
    def gradient(p):
        def slope(c, power):
            form = pair(c, *p)
            return (form - schlick(c)) * form * c**power

        return [integrate.quad(slope, 0, 1, args=(n,), epsabs=1e-15, epsrel=1e-12)[0] for n in (2, 1)]

    return named(optimize.fsolve(gradient, (-5, -5), xtol=1e-15))


def lobe_curve_fit(k):
    return optimize.curve_fit(lambda c, x: np.exp((k + x) * (c - 1)), C, C**k, p0=0.5)[0][0]


def lobe_minimize_scalar(k):
    return optimize.minimize_scalar(
        lambda x: integrate.quad(lambda c: (np.exp((k + x) * (c - 1)) - c**k) ** 2, 0, 1)[0]
    ).x


def root_of(slope, end, low, high):
    def gradient(x):
        return integrate.quad(slope, 0, end, args=(x,), epsabs=1e-15, epsrel=1e-12)[0]

    return optimize.brentq(gradient, low, high, xtol=4e-16, rtol=4 * np.finfo(float).eps)


def lobe_root(k):
    def slope(t, x):
        form = np.exp(-(k + x) * t / k)
        return (form - np.exp(k * np.log1p(-t / k))) * form * t

    return root_of(slope, min(k, 24), 0, 2)


def blinn_curve_fit(rho):
    root = np.sqrt(np.sin(THETA))
    target = root * np.maximum(np.cos(THETA), 0) ** rho
    return optimize.curve_fit(lambda t, x: root * np.cos(t / 2) ** (x * rho), THETA, target, p0=3)[0][0]


def blinn_root(rho):
    def slope(t, x):
        half = np.log1p(-t / (2 * rho))
        form = np.exp(x * rho / 2 * half)
        return (form - np.exp(rho * np.log1p(-t / rho))) * form * half

    return root_of(slope, min(rho, 24), 3, 6)


def sweep(exponents, fit):
    answer = []
    for k in exponents:
        try:
            answer.append(("x", k, fit(k)))
        except RuntimeError:
            pass  # it says that it failed
    return answer


def minimax(relative):
    target = schlick(C)
    weight = 0.96 / (0.04 + 0.96 * target) if relative else 1
    return named(
        optimize.minimize(lambda p: np.max(np.abs(weight * (pair(C, *p) - target))), PUBLISHED, method="Nelder-Mead").x
    )


def largest_error():
    def error(c):
        return np.abs(pair(c, *PUBLISHED) - schlick(c))

    i = int(np.argmax(error(C)))
    bounds = (C[max(i - 1, 0)], C[min(i + 1, 1000)])
    found = optimize.minimize_scalar(lambda c: -error(c), bounds=bounds, method="bounded", options={"xatol": 1e-9})
    return [("level", None, -found.fun)]


def constants():
    lobes = {
        "norm-phong": lambda c, n: c**n,
        "norm-phong-brdf": lambda c, n: c**n * c,
        "norm-blinn-phong": lambda c, n: ((1 + c) / 2) ** (n / 2),
        "norm-blinn-phong-brdf": lambda c, n: ((1 + c) / 2) ** (n / 2) * c,
    }
    answer = []
    for n in (0.1, 1.0, 2.0, 8.0, 64.0, 2048.0, 1e5, 1e6):
        for name, lobe in lobes.items():
            value = integrate.quad(lambda t: lobe(np.cos(t), n) * np.sin(t), 0, np.pi / 2, epsabs=0, epsrel=1e-12)[0]
            answer.append((name, n, 1 / (2 * np.pi * value) if value else np.inf))
    return answer


def plane():
    t, w = np.polynomial.legendre.leggauss(30)
    t, w = (1 + t) / 2, w / 2
    x, y = (v.ravel() for v in np.meshgrid(t, t))
    root, target = np.sqrt(np.outer(w, w)).ravel(), np.exp(-x - y / 2) + x * y / 2
    above, below = np.stack([np.ones_like(x), x, y, x * y]), np.stack([x, y, x * y, x * x])
    fit = optimize.least_squares(
        lambda p: root * (p[:4] @ above / (1 + p[4:] @ below) - target),
        np.array([1.0, 0, 0, 0, 0, 0, 0, 0]),
        method="lm",
        xtol=1e-15,
        ftol=1e-15,
        gtol=1e-15,
    )
    return named(fit.x, "abdghkmn")


TASKS = [
    ("T1", "curve_fit, 1001 samples", pair_curve_fit),
    ("T1", "minimize(quad), BFGS", pair_bfgs),
    ("T1", "fsolve on the quad gradient (by an expert)", pair_fsolve),
    ("T2", "curve_fit, 1001 samples", lambda: sweep(SWEEP, lobe_curve_fit)),
    ("T2", "minimize_scalar(quad in c)", lambda: sweep(SWEEP, lobe_minimize_scalar)),
    ("T2", "brentq on the quad gradient in t (by an expert)", lambda: sweep(SWEEP, lobe_root)),
    ("T2-large", "curve_fit, 1001 samples", lambda: sweep(LARGE, lobe_curve_fit)),
    ("T2-large", "minimize_scalar(quad in c)", lambda: sweep(LARGE, lobe_minimize_scalar)),
    ("T2-large", "brentq on the quad gradient in t (by an expert)", lambda: sweep(LARGE, lobe_root)),
    ("T3", "curve_fit, 1001 samples", lambda: sweep(POWERS, blinn_curve_fit)),
    ("T3", "brentq on the quad gradient in t (by an expert)", lambda: sweep(POWERS, blinn_root)),
    ("T4-absolute", "Nelder-Mead on the largest of 1001 samples", lambda: minimax(False)),
    ("T4-relative", "Nelder-Mead on the largest of 1001 samples", lambda: minimax(True)),
    ("T5", "grid of 1001, bounded Brent", largest_error),
    ("T6", "quad in the angle", constants),
    ("T7", "least_squares lm, 30 x 30 nodes, tight", plane),
]

warnings.simplefilter("ignore")
budget = float(sys.argv[1])
for task, way, run in TASKS:
    times = []
    while len(times) < 3 or sum(times) < budget:
        start = time.perf_counter()
        answer = run()
        times.append(time.perf_counter() - start)
    numbers = "".join("%s %s %.17g;" % (name, "-" if k is None else "%.17g" % k, value) for name, k, value in answer)
    print("%s\t%s\t%.9g\t%s" % (task, way, min(times), numbers))
