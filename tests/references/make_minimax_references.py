#!/usr/bin/python3
"""The minimax fits of the families, for tests/fit/panels/minimax_test.cpp, in 40 digits.

    make_minimax_references.py                prints the file tests/references/minimax.csv
    make_minimax_references.py --check FILE   compares it with FILE

shadefit searches for extrema, solves linear programmes and polishes with the places held. Here the places are unknowns too: Newton
on the whole stationary system
    weight * error = +- level at every point of the alternation (0 or a bound at those of a constraint),
    its derivative by c = 0 at those inside the domain,
in 60 digits. Each problem starts from a few digits. No error at 4000 places may exceed the level.
"""
import sys

from mpmath import diff, exp, findroot, log, mp, mpf, workdps

mp.dps = 60


def exp2_of_polynomial(c, p):
    exponent = 0
    for coefficient in p:
        exponent = (exponent + coefficient) * c
    return mpf(2) ** exponent


FRESNEL = {
    "fresnel-one-term": lambda c, p: mpf(2) ** (-p[0] * c),
    "fresnel-quadratic": exp2_of_polynomial,
    "fresnel-cubic": exp2_of_polynomial,
    "fresnel-quartic": exp2_of_polynomial,
    "fresnel-fourth": lambda c, p: p[0] * (1 - c) ** 4,
    "fresnel-square": lambda c, p: (1 - c) ** 2 * (1 + p[1] * c + p[0] * c * c),
    "fresnel-rational": lambda c, p: (1 - c) ** 4 / (1 + p[0] * c),
}
LOBES = {
    "sg-offset": lambda c, p, k: exp((k + p[0]) * (c - 1)),
    "sg-scaled": lambda c, p, k: p[0] * exp((k + p[1]) * (c - 1)),
    "phong-blinn": lambda c, p, k: ((1 + c) / 2) ** (p[0] * k / 2),
}
NAMES = {"sg-offset": "x", "sg-scaled": "A x", "phong-blinn": "x", "fresnel-one-term": "A", "fresnel-quadratic": "a b",
         "fresnel-cubic": "a b d", "fresnel-quartic": "a b d g", "fresnel-fourth": "s", "fresnel-square": "a b", "fresnel-rational": "a"}

# Family, exponent, error and constraint or weight; the start, which ends with the level; each place with the sign of its error,
# 0 where the constraint holds. `from` and `to` are the ends of the domain, which do not move.
PROBLEMS = """
sg-offset,1,absolute,|0.94238 0.1434|0.6582- from+
sg-offset,1,relative,|3.9175 0.9022|0.20335- from+
phong-blinn,1,absolute,|6.3816 0.1095|0.61595- from+
phong-blinn,1,relative,|14.261 0.8715|0.16312- from+
sg-scaled,1,absolute,|1.1279 1.1766 0.1279|to+ 0.58736- from+
sg-offset,5,absolute,|0.71724 0.02628|0.91246- 0.5228+
sg-offset,5,relative,|2.742 0.4264|0.64583- from+
phong-blinn,5,absolute,|4.299 0.01437|0.90928- 0.5304+
phong-blinn,5,relative,|5.1851 0.2894|0.62792- from+
sg-scaled,5,absolute,|1.0228 0.88102 0.02282|to+ 0.88704- 0.50824+
sg-scaled,5,relative,|1.3605 3.2722 0.3605|to+ 0.60443- from+
sg-offset,37.5,absolute,|0.66965 0.003371|0.98774- 0.92545+
sg-offset,37.5,relative,|2.356 0.06858|0.94089- from+
phong-blinn,37.5,absolute,|4.0359 0.001706|0.98768- 0.92566+
phong-blinn,37.5,relative,|4.1269 0.0359|0.94036- from+
sg-scaled,37.5,absolute,|1.0029 0.81905 0.002912|to+ 0.98389- 0.92184+
sg-offset,1000,absolute,|0.663 0.0001257|0.99954- 0.99714+
sg-offset,1000,relative,|2.2975 0.002632|0.99771- from+
phong-blinn,1000,absolute,|4.0013 6.288e-05|0.99954- 0.99714+
sg-scaled,1000,absolute,|1.0001 0.81036 0.0001085|to+ 0.99939- 0.99699+
fresnel-one-term,,absolute,|8.2482 0.02628|0.4772+ 0.087544-
fresnel-one-term,,relative,|9.5842 0.1721|0.64862+ 0.22353-
fresnel-quadratic,,absolute,|-5.5513 -6.9961 0.003402|0.59329+ 0.2547- 0.052617+
fresnel-quadratic,,relative,|-7.2996 -6.4501 0.02807|0.69333+ 0.41004- 0.11586+
fresnel-cubic,,absolute,|-5.6404 -2.6626 -7.2762 0.0006815|0.68076+ 0.39277- 0.17725+ 0.036654-
fresnel-cubic,,relative,|-8.2424 -0.93371 -7.5154 0.006521|0.74481+ 0.51671- 0.29396+ 0.072625-
fresnel-quartic,,absolute,|-7.1014 0.42581 -4.0871 -7.1916 0.0001771|0.74416+ 0.50054- 0.29596+ 0.1329- 0.027343+
fresnel-quartic,,relative,|-11.263 4.7819 -5.4088 -7.0825 0.001899|0.78766+ 0.59228- 0.41126+ 0.21659- 0.049547+
fresnel-fourth,,absolute,|0.93991 0.06009|0.24807+ from-
fresnel-fourth,,relative,|0.76414 0.2264|0.50155+ from-
fresnel-square,,absolute,|2.214 -2.8767 0.004532|0.76109+ 0.38316- 0.084536+
fresnel-square,,relative,|1.9073 -2.7206 0.03541|0.82037+ 0.55292- 0.2221+
fresnel-rational,,absolute,|1.2616 0.008377|0.40431+ 0.076276-
fresnel-rational,,relative,|1.6407 0.05263|0.57282+ 0.18261-
fresnel-quadratic,,absolute,weight 1 + 4 c|-6.1088 -6.8551 0.008512|0.6465+ 0.30823- 0.073717+
fresnel-quadratic,,absolute,form >= target|-5.3132 -6.9723 0.004551|0.55384+ 0.254810 0.066143+
fresnel-quartic,,absolute,form >= target|-6.5414 0.12895 -4.0521 -7.1884 0.00025154|0.7133+ 0.490750 0.29475+ 0.137450 0.03535+
fresnel-quadratic,,absolute,form >= 0.001|-2.2111 -7.7547 0.01521|to0 0.48244+ 0.094883-
fresnel-quadratic,,absolute,b = -7|-5.5383 0.003425|0.5927+ 0.25348-
sg-scaled,5,absolute,form <= 1|1 0.71724 0.02628|to0 0.91246- 0.5228+
fresnel-square,,absolute,form >= target|2.2361 -2.8541 0.006452|0.72361+ 0.381970 0.10557+
"""


class Problem:
    def __init__(self, line):
        self.what, start, points = line.split("|")
        self.family, exponent, self.error, self.extra = self.what.split(",")
        self.exponent = mpf(exponent or 0)
        self.start = [mpf(number) for number in start.split()]
        self.points = [(point[:-1], {"+": 1, "-": -1, "0": 0}[point[-1]]) for point in points.split()]
        # A relative error of a lobe counts where it is visible: c^k = 1/255.
        is_cut = exponent and self.error == "relative"
        self.ends = {"from": exp(-log(255) / self.exponent) if is_cut else mpf(0), "to": mpf(1)}

    def form(self, c, p):
        if self.extra == "b = -7":
            p = [p[0], -7]
        return LOBES[self.family](c, p, self.exponent) if self.family in LOBES else FRESNEL[self.family](c, p)

    def target(self, c):
        return c**self.exponent if self.family in LOBES else (1 - c) ** 5

    def weighted_error(self, c, p):
        error = self.form(c, p) - self.target(c)
        if self.error == "relative":
            # of a lobe, and of F = 0.04 + 0.96 (1 - c)^5
            error = error / self.target(c) if self.family in LOBES else error / (mpf(1) / 24 + self.target(c))
        return (1 + 4 * c) * error if self.extra.startswith("weight") else error

    def constraint(self, c, p):
        bound = self.extra.split()[-1]
        return self.form(c, p) - (self.target(c) if bound == "target" else mpf(bound))

    def stationary(self):
        """The parameters and the level."""
        count = len(self.start) - 1

        def equations(*unknowns):
            p, level, moving, rows = unknowns[:count], unknowns[count], list(unknowns[count + 1 :]), []
            for place, sign in self.points:
                function = self.weighted_error if sign else self.constraint
                c = self.ends[place] if place in self.ends else moving.pop(0)
                rows.append(function(c, p) - sign * level)
                if place not in self.ends:
                    rows.append(diff(lambda at, held=function: held(at, p), c))
            return rows

        places = [mpf(place) for place, _ in self.points if place not in self.ends]
        # The equations have the digits of the level, and the answers 40.
        answer = list(findroot(equations, self.start + places, tol=mpf(10) ** -52, maxsteps=60, verify=False))[: count + 1]
        self.require_level(answer[:count], answer[count])
        return answer

    def require_level(self, p, level):
        with workdps(20):
            width = self.ends["to"] - self.ends["from"]
            largest = max(abs(self.weighted_error(self.ends["from"] + width * i / 4000, p)) for i in range(4001))
            if not 0 < largest <= level * (1 + mpf(10) ** -12):
                sys.exit(f"{self.what}: the level is exceeded")


def text_of(value):
    """40 digits, as C++ prints them."""
    return mp.nstr(value, 40, min_fixed=-5).removesuffix(".0").replace("e-", "e-0")


def table():
    lines = ["constant,parameter,exponent,error,extra,value"]
    for problem in map(Problem, PROBLEMS.split("\n")[1:-1]):
        family, rest = problem.what.split(",", 1)
        answer = problem.stationary()
        names = NAMES[family].split()[: len(answer) - 1] + ["level"]
        lines += [f"{family},{name},{rest},{text_of(value)}" for name, value in zip(names, answer)]
    return "\n".join(lines) + "\n"


if sys.argv[1:2] == ["--check"]:
    with open(sys.argv[2], encoding="utf-8") as file:
        if file.read() != table():
            sys.exit(f"{sys.argv[2]} differs from what this program computes")
else:
    sys.stdout.write(table())
