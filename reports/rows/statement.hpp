#pragma once

#include <string>

#include "fit/proof/certificate.hpp"

namespace shadefit {

/// The statement of a certificate in words, one line each: the form and the target with their constants, the
/// exponent, the surface, the kind of error, the domain, the bounds and the place of the largest error, and
/// the proven properties of the form. Doubles are shortest decimals. The subject of the certificate must have
/// no `fault_of`.
std::string statement_of(const Certificate& certificate);

/// A formula with the values of constants; other variables stay.
Symbolic with_constants(const Symbolic& formula, const Constants& constants);

/// A constant's text in decimals: of a hexadecimal double its shortest decimal, any other text as it is.
std::string decimal_of(const std::string& text);

}  // namespace shadefit
