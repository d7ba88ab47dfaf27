#pragma once

#include "fit/ledger/finding.hpp"

/// Claims that are data: formulas of the inputs and of the printed numbers, searches, verdicts and effects.
namespace shadefit {

// clang-format off
/// The finding of a claim by the instructions of its record.
///
/// A definition is a list of texts, the first of which is its name. It is computed where a formula uses it,
/// with the variables that are bound there:
///   f(x, y)  FORMULA                     a formula of arguments; "=NAME": the formula that an input has
///   name     FORMULA
///   name     most PLACES FORMULA         the largest value
///   name     place PLACES FORMULA OTHER  the value of OTHER where FORMULA is largest
///   name     sum PLACES FORMULA          or count PLACES CONDITION
///   name     root x FROM TO CONDITION    the last x up to which it holds, by 60 halvings
///   name     integral x FROM TO FORMULA  by Gauss-Kronrod and tanh-sinh; for this in another variable, with
///                                        FROM TO FORMULA of that
///   name     doubt INTEGRAL              of the rules: their estimates and their difference
///   name     largest FORMULA             the largest magnitude of a function of c and of y = 1 - c
///   name     largest-at FORMULA          its cosine
///   name     sampled x FORMULA           the largest value over x in [0, 1], without a derivative
///   name     optimum FAMILY INDEX        a parameter of the unrounded optimum
///   name     units PRINTED FORMULA       the difference in units of the last printed digit
///   name     unit PRINTED                that unit
///   name     in FORMAT FORMULA           in half, float, double, long double, or the one that a variable stands for
///   name     least FORMAT                the least normal number; or greatest FORMAT
///   name     last FORMAT x FROM TO FORMULA  the last x of the format with a finite value of at least 0
///   name     squares FORMULA             the binary logarithm, by squaring (in 50 digits)
///   name     roots FORMULA               2^FORMULA, by square roots (in 50 digits)
/// and for words, whose texts have holes:
///   name     text TEXT
///   name     if CONDITION TEXT TEXT
///   name     judged VERDICT              the name of a verdict of the first kind below
///   name     list PLACES TEXT SEPARATOR  without SEPARATOR: "a, b and c"; texts that are empty are left out
///   name     ranges x FORMULA            "from c = 0.5 to 1": where it is positive, x in [0, 1]
///   name     runs PLACES CONDITION       "0 to 1 and 250 to 255": the places where it holds
///   name     fraction FORMULA            "7/8" if one with a denominator up to 4096 is within 1e-12 of it
/// PLACES are "x in INPUT", "i in FROM .. TO" (whole steps), "i in printed" (then `printed_i` is that number),
/// "t in conventions" (then `t_gamma`, 0 for sRGB, and `t_codes` are those of a transfer function), "v in words of
/// INPUT" (rows of numbers and of names, which stand for their numbers; then `v_place` counts them from 0), or
/// several of these, by ", ". `{x_name}` is the item of a list as it stands. x is the number at its end. An item
/// without a number has its place in the list for x.
///
/// A verdict is "printed_0 = FORMULA", which judges the digits of a printed number or of an input, or a
/// formula of the names of verdicts and of `undecided`. The worst counts. `{verdict_0}` is the name of the first.
///
/// An effect is a list of texts:
///   power FROM TO LEAD                   of a lobe's power
///   factor FROM TO LEAD                  of a factor on greys
///   none TEXT                            the reason
///   value BEFORE AFTER WHAT LEAD LABEL FORMULA ..
///   each BEFORE AFTER WHAT LEAD PLACES LABEL FORMULA ..
///   curve BEFORE AFTER WHAT LEAD CONCENTRATION  of functions of c and y; with PLACES LABEL FORMULA at each
/// LABEL is "grey {}/255", with a place for the number of its formula.
///
/// Throws std::invalid_argument where a formula has no finite value.
// clang-format on
Finding computed_by_its_record(const Claim& claim);

}  // namespace shadefit
