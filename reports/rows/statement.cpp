#include "reports/rows/statement.hpp"

#include <fmt/format.h>

#include <vector>

#include "fit/support/hex_float.hpp"
#include "reports/io/joined.hpp"

namespace shadefit {
namespace {

std::string surface_text(const Surface& surface) {
  if (surface.extinction == 0)
    return fmt::format("a dielectric of index n = {}, f0 its reflectance at c = 1", surface.ior);
  return fmt::format("a conductor of index n + i k, n = {}, k = {}, f0 its reflectance at c = 1", surface.ior,
                     surface.extinction);
}

std::string error_text(const Subject& subject, bool is_fresnel) {
  const Surface& surface = subject.setting.surface;
  if (!is_fresnel) return subject.error == Error::absolute ? "form - target" : "(form - target)/target";
  if (subject.error == Error::absolute)
    return surface.is_named() ? "(1 - f0) (form - target), that of the reflectance" : "form - target";
  const std::string f0 = surface.is_named() ? ""
                                            : ", f0 = " + (surface.f0 ? fmt::format("{}", *surface.f0)
                                                                      : std::string(reference_f0));
  return "(1 - f0) (form - target)/F, F = f0 + (1 - f0) target" + f0;
}

std::string proven_text(const CurveShape& curve) {
  std::vector<std::string> parts;
  if (curve.trend != Trend::none) parts.push_back(std::string(name(curve.trend)) + " with the angle");
  if (curve.is_non_negative) parts.emplace_back("is non-negative");
  if (curve.is_at_most_one) parts.emplace_back("is at most 1");
  return fmt::format("the form {}", fmt::join(parts, ", "));
}

std::string places_text(const Certificate& certificate) {
  return "c in " + joined(certificate.places, " or ", [](const Box& place) {
           const Domain c = cosines_of(place);
           return fmt::format("[{}, {}]", c.lower, c.upper);
         });
}

}  // namespace

std::string decimal_of(const std::string& text) {
  const auto exact = parse_hex(text);
  return exact ? fmt::format("{}", *exact) : text;
}

Symbolic with_constants(const Symbolic& formula, const Constants& constants) {
  return evaluate<Symbolic>(formula, [&](const std::string& variable) {
    for (const auto& [name, text] : constants) {
      if (name == variable) return Symbolic::number(decimal_of(text));
    }
    return Symbolic::variable(variable);
  });
}

std::string statement_of(const Certificate& certificate) {
  const Subject& subject = certificate.subject;
  const FittableFamily& family = *find_family(subject.family);
  const Setting& setting = subject.setting;
  Constants constants = subject.parameters;
  constants.emplace_back("k", fmt::format("{}", setting.exponent));
  std::string text;
  const auto line = [&](const char* what, const std::string& words) {
    text += fmt::format("  {:<9}{}\n", what, words);
  };
  line("form", to_text(with_constants(family.form(), constants)));
  line("target",
       setting.surface.is_exact() ? certificate.target : to_text(with_constants(family.target(), constants)));
  if (family.has_exponent()) line("exponent", fmt::format("k = {}", setting.exponent));
  if (setting.surface.is_named()) line("surface", surface_text(setting.surface));
  line("error", fmt::format("{}: {}", name(subject.error), error_text(subject, family.is_fresnel())));
  line("domain", fmt::format("c from {} to {}", subject.domain.lower, subject.domain.upper));
  line("largest", fmt::format("at least {}, at most {}", certificate.lower, certificate.upper));
  line("at", places_text(certificate));
  if (certificate.curve != CurveShape{}) line("proven", proven_text(certificate.curve));
  return text;
}

}  // namespace shadefit
