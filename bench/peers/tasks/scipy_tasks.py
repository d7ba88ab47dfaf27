"""The tasks of bench/peers/run with SciPy, as its users write them; task_program.hpp says the protocol."""

import os
import sys
import time
import warnings

import numpy as np
import scipy
from scipy import integrate, optimize

SWEEP = [float(k) for k in range(3, 16)]
LARGE = [100.0, 1e3, 1e4, 1e6]
POWERS = [2.0**i for i in range(1, 12)]
PUBLISHED = (float(os.environ["PUBLISHED_A"]), float(os.environ["PUBLISHED_B"]))


class Answer:
    def __init__(self):
        self.values, self.notes = [], []

    def add(self, name, value, exponent=None):
        self.values.append((name, exponent, float(value)))

    def remark(self, text):
        if text not in self.notes:
            self.notes.append(text)


def pair(c, a, b):
    return np.exp2((a * c + b) * c)


def schlick(c):
    return (1 - c) ** 5


def pair_answer(p):
    answer = Answer()
    answer.add("a", p[0])
    answer.add("b", p[1])
    return answer


# ---- T1: the Fresnel pair by least squares -----------------------------------------------------------------


def pair_curve_fit():
    c = np.linspace(0, 1, 1001)
    return pair_answer(optimize.curve_fit(pair, c, schlick(c), p0=(-5, -5))[0])


def pair_least_squares():
    c = np.linspace(0, 1, 1001)
    target = schlick(c)
    return pair_answer(optimize.least_squares(lambda p: pair(c, *p) - target, (-5, -5)).x)


def pair_integral(p):
    return integrate.quad(lambda c: (pair(c, *p) - schlick(c)) ** 2, 0, 1)[0]


def pair_minimize(method, options=None):
    result = optimize.minimize(pair_integral, (-5, -5), method=method, options=options)
    answer = pair_answer(result.x)
    answer.remark("success=%s" % result.success)
    return answer


def pair_fsolve():
    def gradient(p):
        def slope(c, power):
            form = pair(c, *p)
            return (form - schlick(c)) * form * c**power

        return [integrate.quad(slope, 0, 1, args=(n,), epsabs=1e-15, epsrel=1e-12)[0] for n in (2, 1)]

    return pair_answer(optimize.fsolve(gradient, (-5, -5), xtol=1e-15))


def nodes(end):
    x, w = np.polynomial.legendre.leggauss(64)
    return end * (1 + x) / 2, w * end / 2


def pair_on_nodes():
    c, w = nodes(1)
    target, root = schlick(c), np.sqrt(w)
    fit = optimize.least_squares(
        lambda p: root * (pair(c, *p) - target), (-5, -5), method="lm", xtol=1e-15, ftol=1e-15, gtol=1e-15
    )
    return pair_answer(fit.x)


# ---- T2 and T3: sweeps of one parameter ----------------------------------------------------------------------


def sweep(exponents, fit, start):
    """fit(k) gives x and what the tool said of itself."""
    answer = Answer()
    for k in exponents:
        try:
            x, said = fit(k)
        except RuntimeError as error:
            answer.remark("%s at %g" % (str(error).split("\n")[0], k))
            continue
        answer.add("x", x, k)
        if x == start:
            answer.remark("returned its start%s" % said)
    return answer


def lobe_curve_fit(k):
    c = np.linspace(0, 1, 1001)
    return optimize.curve_fit(lambda c, x: np.exp((k + x) * (c - 1)), c, c**k, p0=0.5)[0][0], ""


def lobe_integral(x, k):
    x = float(np.squeeze(x))
    return integrate.quad(lambda c: (np.exp((k + x) * (c - 1)) - c**k) ** 2, 0, 1)[0]


def lobe_minimize_scalar(k):
    return optimize.minimize_scalar(lobe_integral, args=(k,)).x, ""


def lobe_bfgs(k):
    result = optimize.minimize(lobe_integral, 0.5, args=(k,))
    return result.x[0], " with success=%s" % result.success


def lobe_root(k):
    def gradient(x):
        def slope(t):
            form = np.exp(-(k + x) * t / k)
            return (form - np.exp(k * np.log1p(-t / k))) * form * t

        return integrate.quad(slope, 0, min(k, 24), epsabs=1e-15, epsrel=1e-12)[0]

    return optimize.brentq(gradient, 0, 2, xtol=4e-16, rtol=4 * np.finfo(float).eps), ""


def lobe_on_nodes(k):
    t, w = nodes(min(k, 24))
    target, root = np.exp(k * np.log1p(-t / k)), np.sqrt(w)
    fit = optimize.least_squares(
        lambda x: root * (np.exp(-(k + x[0]) * t / k) - target), 0.5, method="lm", xtol=1e-15, ftol=1e-15, gtol=1e-15
    )
    return fit.x[0], " with success=%s" % fit.success


def blinn_curve_fit(rho):
    theta = np.linspace(0, np.pi / 2, 1001)
    root = np.sqrt(np.sin(theta))
    target = root * np.maximum(np.cos(theta), 0) ** rho
    return optimize.curve_fit(lambda t, x: root * np.cos(t / 2) ** (x * rho), theta, target, p0=3)[0][0], ""


def blinn_integral(x, rho):
    x = float(np.squeeze(x))
    return integrate.quad(
        lambda t: (np.cos(t / 2) ** (x * rho) - np.cos(t) ** rho) ** 2 * np.sin(t), 0, np.pi / 2
    )[0]


def blinn_minimize_scalar(rho):
    return optimize.minimize_scalar(blinn_integral, args=(rho,)).x, ""


def blinn_bfgs(rho):
    result = optimize.minimize(blinn_integral, 3, args=(rho,))
    return result.x[0], " with success=%s" % result.success


def blinn_root(rho):
    def gradient(x):
        def slope(t):
            half = np.log1p(-t / (2 * rho))
            form = np.exp(x * rho / 2 * half)
            return (form - np.exp(rho * np.log1p(-t / rho))) * form * half

        return integrate.quad(slope, 0, min(rho, 24), epsabs=1e-15, epsrel=1e-12)[0]

    return optimize.brentq(gradient, 3, 6, xtol=4e-16, rtol=4 * np.finfo(float).eps), ""


# ---- T4: minimax ---------------------------------------------------------------------------------------------


def weight(c, relative):
    return 0.96 / (0.04 + 0.96 * schlick(c)) if relative else np.ones_like(c)


def minimax_simplex(relative, options=None):
    c = np.linspace(0, 1, 1001)
    target, w = schlick(c), weight(c, relative)
    result = optimize.minimize(
        lambda p: np.max(np.abs(w * (pair(c, *p) - target))), PUBLISHED, method="Nelder-Mead", options=options
    )
    return pair_answer(result.x)


def minimax_epigraph(relative):
    c = np.linspace(0, 1, 1001)
    target, w = schlick(c), weight(c, relative)

    def slack(p):
        error = w * (pair(c, p[0], p[1]) - target)
        return np.concatenate([p[2] - error, p[2] + error])

    def slopes(p):
        by_b = w * pair(c, p[0], p[1]) * np.log(2) * c
        rows = np.column_stack([by_b * c, by_b])
        one = np.ones((c.size, 1))
        return np.block([[-rows, one], [rows, one]])

    start = [*PUBLISHED, np.max(np.abs(w * (pair(c, *PUBLISHED) - target)))]
    result = optimize.minimize(
        lambda p: p[2],
        start,
        jac=lambda p: np.array([0.0, 0.0, 1.0]),
        method="SLSQP",
        constraints={"type": "ineq", "fun": slack, "jac": slopes},
        options={"ftol": 1e-15},
    )
    answer = pair_answer(result.x)
    answer.remark("success=%s" % result.success)
    return answer


# ---- T5 and T6: the largest error, integrals -------------------------------------------------------------------


def error(c):
    return np.abs(pair(c, *PUBLISHED) - schlick(c))


def largest_on_grid(count):
    answer = Answer()
    answer.add("level", np.max(error(np.linspace(0, 1, count))))
    return answer


def largest_refined():
    c = np.linspace(0, 1, 1001)
    i = int(np.argmax(error(c)))
    bounds = (c[max(i - 1, 0)], c[min(i + 1, 1000)])
    answer = Answer()
    found = optimize.minimize_scalar(lambda c: -error(c), bounds=bounds, method="bounded", options={"xatol": 1e-9})
    answer.add("level", -found.fun)
    return answer


def constants(in_angle):
    lobes = {
        "norm-phong": lambda c, n: c**n,
        "norm-phong-brdf": lambda c, n: c**n * c,
        "norm-blinn-phong": lambda c, n: ((1 + c) / 2) ** (n / 2),
        "norm-blinn-phong-brdf": lambda c, n: ((1 + c) / 2) ** (n / 2) * c,
    }
    answer = Answer()
    for n in (0.1, 1.0, 2.0, 8.0, 64.0, 2048.0, 1e5, 1e6):
        for name, lobe in lobes.items():
            integrand, end = lobe, 1
            if in_angle:
                integrand, end = lambda t, n: lobe(np.cos(t), n) * np.sin(t), np.pi / 2
            value, _, _, *warning = integrate.quad(integrand, 0, end, args=(n,), epsabs=0, epsrel=1e-12, full_output=1)
            answer.add(name, 1 / (2 * np.pi * value) if value else np.inf, n)
            if value == 0:
                answer.remark("integral 0 %s a warning" % ("with" if warning else "without"))
    return answer


# ---- T7: a rational form of two variables --------------------------------------------------------------------


def plane_fit(method, tight):
    t, w = np.polynomial.legendre.leggauss(30)
    t, w = (1 + t) / 2, w / 2
    x, y = (v.ravel() for v in np.meshgrid(t, t))
    root, target = np.sqrt(np.outer(w, w)).ravel(), np.exp(-x - y / 2) + x * y / 2
    above, below = np.stack([np.ones_like(x), x, y, x * y]), np.stack([x, y, x * y, x * x])
    scaled_above, minus_below = root * above, -root * below

    def error(p):
        return root * (p[:4] @ above / (1 + p[4:] @ below) - target)

    def slopes(p):
        inverse = 1 / (1 + p[4:] @ below)
        return np.concatenate([scaled_above * inverse, minus_below * (p[:4] @ above * inverse * inverse)]).T

    start = np.array([1.0, 0, 0, 0, 0, 0, 0, 0])
    options = {"xtol": 1e-15, "ftol": 1e-15, "gtol": 1e-15} if tight else {}
    fit = optimize.least_squares(error, start, jac=slopes, method=method, **options)
    answer = Answer()
    for name, value in zip("abdghkmn", fit.x):
        answer.add(name, value)
    return answer


TIGHT = {"xatol": 1e-14, "fatol": 1e-18, "maxiter": 2000, "maxfev": 2000}
VARIANTS = [
    ("T1", "curve_fit, 1001 samples", pair_curve_fit),
    ("T1", "least_squares, 1001 samples", pair_least_squares),
    ("T1", "minimize(quad), BFGS", lambda: pair_minimize("BFGS")),
    ("T1", "minimize(quad), Nelder-Mead", lambda: pair_minimize("Nelder-Mead")),
    ("T1", "minimize(quad), Nelder-Mead, tight", lambda: pair_minimize("Nelder-Mead", TIGHT)),
    ("T1", "least_squares lm, 64 Gauss-Legendre nodes, tight", pair_on_nodes),
    ("T1", "fsolve on the quad gradient (expert)", pair_fsolve),
]
for task, exponents in (("T2", SWEEP), ("T2-large", LARGE)):
    for name, fit, start in (
        ("curve_fit, 1001 samples", lobe_curve_fit, 0.5),
        ("minimize_scalar(quad in c)", lobe_minimize_scalar, None),
        ("minimize(quad), BFGS", lobe_bfgs, 0.5),
        ("least_squares lm, 64 nodes in t, tight", lobe_on_nodes, 0.5),
        ("brentq on the quad gradient in t (expert)", lobe_root, None),
    ):
        VARIANTS.append((task, name, lambda e=exponents, f=fit, s=start: sweep(e, f, s)))
for name, fit in (
    ("curve_fit, 1001 samples", blinn_curve_fit),
    ("minimize_scalar(quad)", blinn_minimize_scalar),
    ("minimize(quad), BFGS", blinn_bfgs),
    ("brentq on the quad gradient in t (expert)", blinn_root),
):
    VARIANTS.append(("T3", name, lambda f=fit: sweep(POWERS, f, 3)))
for task, relative in (("T4-absolute", False), ("T4-relative", True)):
    VARIANTS += [
        (task, "Nelder-Mead on the largest of 1001 samples", lambda r=relative: minimax_simplex(r)),
        (task, "Nelder-Mead, tight", lambda r=relative: minimax_simplex(r, TIGHT)),
        (task, "SLSQP, epigraph of 1001 samples", lambda r=relative: minimax_epigraph(r)),
    ]
VARIANTS += [
    ("T5", "grid of 1001", lambda: largest_on_grid(1001)),
    ("T5", "grid of 1e6", lambda: largest_on_grid(1000001)),
    ("T5", "grid of 1001, bounded Brent", largest_refined),
    ("T6", "quad in the angle", lambda: constants(True)),
    ("T6", "quad in the cosine", lambda: constants(False)),
    ("T7", "least_squares lm, 30 x 30 nodes, analytic Jacobian", lambda: plane_fit("lm", False)),
    ("T7", "least_squares lm, 30 x 30 nodes, analytic Jacobian, tight", lambda: plane_fit("lm", True)),
    ("T7", "least_squares trf, 30 x 30 nodes, analytic Jacobian", lambda: plane_fit("trf", False)),
    ("T7", "least_squares trf, 30 x 30 nodes, analytic Jacobian, tight", lambda: plane_fit("trf", True)),
]


def main(arguments):
    if arguments == ["--list"]:
        print("version SciPy %s, NumPy %s" % (scipy.__version__, np.__version__))
        for task, name, _ in VARIANTS:
            print("%s\t%s\t%s" % (task, name, "expert" if "expert" in name or "nodes" in name else "judged"))
        return 0
    runs = {(task, name): run for task, name, run in VARIANTS}
    if len(arguments) != 3 or tuple(arguments[:2]) not in runs:
        print("usage: scipy_tasks.py --list, or TASK VARIANT SECONDS as it lists them", file=sys.stderr)
        return 2
    run, budget = runs[tuple(arguments[:2])], float(arguments[2])
    warnings.simplefilter("ignore")
    answer = run()
    for name, exponent, value in answer.values:
        print("value %s %s %.17g" % (name, "-" if exponent is None else "%.17g" % exponent, value))
    for text in answer.notes:
        print("note " + text)
    times = []
    while budget > 0 and (len(times) < 3 or sum(times) < budget):
        start = time.perf_counter()
        run()
        times.append(time.perf_counter() - start)
    if times:
        print("seconds %.9g" % min(times))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
