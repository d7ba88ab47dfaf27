#!/usr/bin/env python3
"""A second verifier of shadefit's certificates, which shares nothing with the first: the formulas are the certificate's own
texts, parsed here, and the arithmetic is that of mpmath's intervals, in which every result holds all true results.

    verify_certificate.py FILE..    one line each, "FILE holds" or "FILE is refused: REASON"; exit 1 if any is refused

On each box |error| is bounded by its range, by the mean value form f(m) + f'(box) (box - m), or at both ends where it does
not turn; a box on which all of these are too wide is halved. The boxes of the certificate are not needed."""

import json
import re
import sys
import zlib

from mpmath import iv

iv.prec, DEEPEST = 168, 60  # bits, and halvings of one box


class Refused(Exception):
    pass


def span(low, high):
    return iv.mpf([low.a, high.b])


class Jet:
    """A value and its derivative by the variable, both intervals."""

    def __init__(self, value, slope=0):
        self.value, self.slope = iv.mpf(value), iv.mpf(slope)

    def __add__(self, other):
        return Jet(self.value + other.value, self.slope + other.slope)

    def __sub__(self, other):
        return Jet(self.value - other.value, self.slope - other.slope)

    def __neg__(self):
        return Jet(0) - self

    def __mul__(self, other):
        return Jet(self.value * other.value, self.slope * other.value + self.value * other.slope)

    def __truediv__(self, other):
        quotient = self.value / other.value
        return Jet(quotient, (self.slope - quotient * other.slope) / other.value)

    def __pow__(self, exponent):
        p = exponent.value
        return Jet(self.value ** p, p * self.value ** (p - 1) * self.slope)

    def exp(self):
        return Jet(iv.exp(self.value), iv.exp(self.value) * self.slope)

    def root_of_positive_part(self):
        root = iv.sqrt(span(*(iv.mpf(max(end, 0)) for end in (self.value.a, self.value.b))))
        return Jet(root, self.slope / (2 * root))


ONE, TWO = Jet(1), Jet(2)


def number(text):
    """A hexadecimal double, exactly; a decimal, enclosed."""
    if "0x" not in text:
        return iv.mpf(text)
    if re.sub(r"\.?0*p", "p", float.fromhex(text).hex()) == text:
        return iv.mpf(float.fromhex(text))
    raise Refused(f"'{text}' is not the text of a double")


class Formula:
    """A formula's text: Python's, but for ^ and for products, whose factors stand beside each other."""

    def __init__(self, text):
        if not re.fullmatch(r"[\w.,+\-*/^() ]+", text):
            raise Refused(f"the formula '{text}' is not understood")
        self.names = set(re.findall(r"[A-Za-z]\w*", text))
        products = re.sub(r"(?<=[\w)]) (?=[\w(])", "*", text).replace("^", "**")
        self.code = compile(re.sub(r"(?<![\w.])\d[\d.]*", r"number('\g<0>')", products), text, "eval")

    def evaluate(self, values):
        if self.names <= {*FUNCTIONS, *values}:
            return eval(self.code, {"__builtins__": {}}, {**FUNCTIONS, **values})
        raise Refused("a variable or a function of a formula is not known here")


def reflectance(c, n, k):
    """Fresnel's, in unpolarised light (Born, Wolf 1999, section 14.2); of a dielectric where k is 0."""
    s2 = (ONE - c) * (ONE + c)
    if k.value == 0:
        t = (ONE - s2 / (n * n)).root_of_positive_part()
        if t.value == 0:
            return ONE
        rs, rp = (c - n * t) / (c + n * t), (n * c - t) / (n * c + t)
        return (rs * rs + rp * rp) / TWO
    real, imaginary = n * n - k * k - s2, TWO * n * k
    m = (real * real + imaginary * imaginary).root_of_positive_part()
    cu = TWO * c * ((m + real) / TWO).root_of_positive_part()
    rs2 = (m - cu + c * c) / (m + cu + c * c)
    return rs2 * (ONE + (c * c * m - cu * s2 + s2 * s2) / (c * c * m + cu * s2 + s2 * s2)) / TWO


FUNCTIONS = {
    "number": lambda text: Jet(number(text)),
    "exp": Jet.exp,
    "exp2": lambda x: Jet.exp(x * Jet(iv.log(2))),
    "sqrt": Jet.root_of_positive_part,
    "dielectric_reflectance": lambda c, n: reflectance(c, n, Jet(0)),
    "conductor_reflectance": reflectance,
    "reflectance_at_normal": lambda n: reflectance(ONE, n, Jet(0)),
    "conductor_reflectance_at_normal": lambda n, k: reflectance(ONE, n, k),
    "weight_of_reflectance": lambda f, f0: (f - f0) / (ONE - f0),
    "schlick_reflectance": lambda f0, weight: f0 + (ONE - f0) * weight,
}


class Certificate:
    def __init__(self, fields):
        stated = fields.pop("digest")
        if stated != "%08x" % zlib.crc32(json.dumps(fields, separators=(",", ":"), ensure_ascii=False).encode()):
            raise Refused("its digest is not that of its fields")
        if len(fields["over"]) != 1 or any(let["of"] for let in fields["let"]):
            raise Refused("this verifier knows one variable, and no definitions with arguments")
        self.fields, self.variable = fields, fields["over"][0]["variable"]
        self.range = [number(text) for text in fields["over"][0]["doubles"]]
        self.form, self.target, self.weight = (Formula(fields[key]) for key in ("form", "target", "weight"))
        self.constants = {name: Jet(number(text)) for name, text in {**fields["given"], **fields["parameters"]}.items()}
        for let in fields["let"]:
            self.constants[let["name"]] = Formula(let["is"]).evaluate(self.constants)

    def error(self, side, distance):
        """At a distance from an end: a lobe needs many digits of 1 - c."""
        low, high = self.range
        values = {**self.constants, self.variable: Jet(low + distance, 1) if side == "lower" else Jet(high - distance, 1)}
        target = self.target.evaluate(values)
        difference = self.weight.evaluate(values) * (self.form.evaluate(values) - target)
        return difference if self.fields["error"] == "absolute" else difference / target

    def is_error_within(self, bound, side, low, high):
        middle = (low + high) / 2
        at_middle, on_box = self.error(side, middle).value, self.error(side, span(low, high))
        if not abs(at_middle) <= bound:
            raise Refused(f"the error exceeds its bound at {middle} from the {side} end")
        step = (span(low, high) - middle) * (1 if side == "lower" else -1)
        if abs(on_box.value) <= bound or abs(at_middle + on_box.slope * step) <= bound:
            return True
        is_one_way = on_box.slope >= 0 or on_box.slope <= 0
        return is_one_way and all(abs(self.error(side, end).value) <= bound for end in (low, high))

    def check(self):
        (low, high), (lower, upper) = self.range, [number(text) for text in self.fields["largest"]]
        if not (low < high and 0 <= lower <= upper):
            raise Refused("its range or its bounds are not intervals")
        at = number(self.fields["attained"][0])
        if not (low <= at <= high and abs(self.error("lower", at - low).value) >= lower):
            raise Refused("its lower bound is not attained where it says")
        for side in ("lower", "upper"):
            require(self.is_error_within, upper, side, iv.mpf(0), (high - low) / 2)


def require(rule, argument, side, low, high, depth=0):
    """Refuses unless the rule holds on parts that make up the box."""
    if rule(argument, side, low, high):
        return
    if depth == DEEPEST:
        raise Refused(f"{argument} may fail at {side} = {low}")
    middle = (low + high) / 2
    require(rule, argument, side, low, middle, depth + 1)
    require(rule, argument, side, middle, high, depth + 1)


def reason_to_refuse(file):
    try:
        with open(file, encoding="utf-8") as content:
            Certificate(json.load(content)).check()
        return ""
    except Refused as reason:
        return reason


if __name__ == "__main__":
    reasons = [reason_to_refuse(file) for file in sys.argv[1:]]
    for file, reason in zip(sys.argv[1:], reasons):
        print(f"{file} is refused: {reason}" if reason else f"{file} holds")
    sys.exit(any(reasons))
