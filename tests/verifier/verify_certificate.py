#!/usr/bin/env python3
"""A second verifier of shadefit's certificates, which shares nothing with the first: the formulas are the certificate's own
texts, parsed here, and the arithmetic is that of mpmath's intervals, in which every result holds all true results.

    verify_certificate.py FILE..    one line each, "FILE holds" or "FILE is refused: REASON"; exit 1 if any is refused

On each box |error| is bounded by its range, by the mean value form f(m) + f'(box) (box - m), or at both ends where it does
not turn; a box on which all of these are too wide is halved."""

import json
import re
import sys
import zlib

from mpmath import iv

iv.prec, DEEPEST = 168, 60  # bits, and halvings of one box
REFERENCE_F0 = "0.04"  # what relative errors are stated for where the certificate names no surface


class Refused(Exception):
    pass


def span(low, high):
    return iv.mpf([low.a, high.b])


class Jet:
    """A value and its derivative with respect to c, both intervals."""

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
        if not re.fullmatch(r"[\w.+\-*/^() ]+", text):
            raise Refused(f"the formula '{text}' is not understood")
        self.names = set(re.findall(r"[A-Za-z]\w*", text))
        products = re.sub(r"(?<=[\w)]) (?=[\w(])", "*", text).replace("^", "**")
        self.code = compile(re.sub(r"(?<![\w.])\d[\d.]*", r"number('\g<0>')", products), text, "eval")

    def evaluate(self, values):
        functions = {"number": lambda text: Jet(number(text)), "exp": Jet.exp, "exp2": lambda x: Jet.exp(x * Jet(iv.log(2)))}
        if self.names <= {*functions, *values}:
            return eval(self.code, {"__builtins__": {}}, {**functions, **values})
        raise Refused("a variable of a formula has no value")


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


class Certificate:
    def __init__(self, fields):
        stated = fields.pop("digest")
        if stated != "%08x" % zlib.crc32(json.dumps(fields, separators=(",", ":"), ensure_ascii=False).encode()):
            raise Refused("its digest is not that of its fields")
        self.fields, self.form = fields, Formula(fields["form"])
        self.target = Formula(fields["target"].partition(",")[0])
        self.constants = {name: Jet(number(text)) for name, text in fields["parameters"].items()}
        surface = fields["surface"] or {"f0": REFERENCE_F0}
        if fields["exponent"] is not None:
            self.constants["k"] = Jet(number(fields["exponent"]))
        self.index = [Jet(number(surface[key])) for key in ("ior", "extinction") if key in surface]
        self.f0 = reflectance(ONE, *self.index) if self.index else Jet(number(surface["f0"]))

    def values(self, side, distance):
        c = Jet(distance, 1) if side == "c" else Jet(1 - distance, 1)
        values = {"c": c, "f0": self.f0, **self.constants}
        return {**values, "F": reflectance(c, *self.index)} if "F" in self.target.names else values

    def error(self, side, distance):
        values = self.values(side, distance)
        target = self.target.evaluate(values)
        difference = self.form.evaluate(values) - target
        if self.fields["error"] == "absolute":
            return (ONE - self.f0) * difference if self.index else difference
        if "k" in self.constants:
            return difference / target
        return (ONE - self.f0) * difference / (self.f0 + (ONE - self.f0) * target)

    def is_error_within(self, bound, side, low, high):
        middle = (low + high) / 2
        at_middle, on_box = self.error(side, middle).value, self.error(side, span(low, high))
        if not abs(at_middle) <= bound:
            raise Refused(f"the error exceeds its bound at {side} = {middle}")
        step = (span(low, high) - middle) * (1 if side == "c" else -1)
        if abs(on_box.value) <= bound or abs(at_middle + on_box.slope * step) <= bound:
            return True
        is_one_way = on_box.slope >= 0 or on_box.slope <= 0
        return is_one_way and all(abs(self.error(side, end).value) <= bound for end in (low, high))

    def does_form_satisfy(self, statement, side, low, high):
        form = self.form.evaluate(self.values(side, span(low, high)))  # the angle rises as c falls
        return {"falls with the angle": form.slope >= 0, "rises with the angle": form.slope <= 0,
                "non-negative": form.value >= 0, "at most 1": form.value <= 1}[statement]

    def check(self):
        (low, high), (lower, upper) = ([number(text) for text in self.fields[key]] for key in ("domain", "largest"))
        if not (0 <= low < high <= 1 and 0 <= lower <= upper):
            raise Refused("its domain or its bounds are not an intervals")
        half, boxes, sides = iv.mpf(0.5), [], {}
        for side, key, begin, end in (("c", "boxes_in_c", low, min(high, half)),
                                      ("1 - c", "boxes_in_1_minus_c", 1 - high, min(1 - low, half))):
            sides[side], ends = (begin, end), [number(text) for text in self.fields[key]]
            boxes += [(side, *box) for box in zip(ends, ends[1:])]
            is_cut = len(ends) > 1 and (ends[0], ends[-1]) == (begin, end) and all(a < b for a, b in zip(ends, ends[1:]))
            if not (is_cut if begin < end else not ends):
                raise Refused(f"its boxes in {side} are not the domain")
        side, at = self.fields["attained"]["of"], number(self.fields["attained"]["at"])
        if not (sides[side][0] <= at <= sides[side][1] and abs(self.error(side, at).value) >= lower):
            raise Refused("its lower bound is not attained where it says")
        places = [(place["of"], number(place["from"]), number(place["to"])) for place in self.fields["places"]]
        for side, begin, end in boxes:
            is_place = any(p[0] == side and p[1] <= begin and end <= p[2] for p in places)
            require(self.is_error_within, upper if is_place else lower, side, begin, end)
            for statement in self.fields["proven"]:
                require(self.does_form_satisfy, statement, side, begin, end)


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
