#!/usr/bin/python3
"""The least level of a quotient of quadratics for the albedo of Imageworks' sheen, at 161 x 161 places, by SciPy.

It is the truth of MinimaxSurface.CurvatureDeterminesWhatTheTopsLeaveOpen. The places are denser at low cosines and roughnesses.
SLSQP lowers the level under the conditions of all places whose error is above 0.8 of it, from four starts. Needs python3-scipy.
"""
import numpy as np
from make_albedo_tables import sheen
from scipy.optimize import minimize

COUNT = 160
NEAR = 0.0183  # the level to three digits

t = np.linspace(0, 1, COUNT + 1) ** 2
x, y = (a.ravel() for a in np.meshgrid(0.02 + 0.98 * t, 0.05 + 0.95 * t, indexing="ij"))
truth = np.array([sheen(*place) for place in zip(x, y)])
above = np.stack([np.ones_like(x), x, y, x * y, x * x, y * y])
below = above[:5]  # the sixth, y^2, has the factor 1

# A first answer, to two digits: the descent starts there, and at three points beside it.
FIRST = np.array([0.019, -0.078, 0.42, -0.43, 0.060, 0.39, 0.00013, 0.072, 0.41, 1.15, -0.084])


def errors(p, i):
    return p[:6] @ above[:, i] / (p[6:] @ below[:, i] + y[i] ** 2) - truth[i]


def slopes(p, i):
    q = p[6:] @ below[:, i] + y[i] ** 2
    return np.vstack([above[:, i] / q, -(p[:6] @ above[:, i]) / q**2 * below[:, i]]).T


def descend(start):
    """The level in units of NEAR is the last unknown; the others are in units of FIRST."""
    unit, i = np.abs(FIRST), np.arange(len(x))
    for _ in range(6):  # conditions at the places that count, until they are the same
        found = minimize(
            lambda z: z[11],
            start,
            jac=lambda z: np.eye(12)[11],
            method="SLSQP",
            options={"maxiter": 1000, "ftol": 1e-13},
            constraints={
                "type": "ineq",
                "fun": lambda z: np.concatenate([z[11] - errors(z[:11] * unit, i) / NEAR, z[11] + errors(z[:11] * unit, i) / NEAR]),
                "jac": lambda z: np.vstack([np.hstack([s * slopes(z[:11] * unit, i) * unit / NEAR, np.ones((len(i), 1))]) for s in (-1, 1)]),
            },
        )
        start = found.x
        everywhere = np.abs(errors(start[:11] * unit, np.arange(len(x))))
        if everywhere.max() <= start[11] * NEAR * (1 + 1e-9):
            return start[11] * NEAR
        i = np.where(everywhere > 0.8 * everywhere.max())[0]
    return float("nan")


random = np.random.default_rng(1)
for k in range(4):
    beside = 1 + (0.02 * random.standard_normal(11) if k else 0)
    print(f"{descend(np.append(np.sign(FIRST) * beside, 1.5)):.9f}")
