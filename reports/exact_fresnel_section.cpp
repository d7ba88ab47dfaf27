#include "reports/exact_fresnel_section.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "approx/catalogue.hpp"
#include "fit/exact_fresnel.hpp"
#include "reports/writers.hpp"

namespace shadefit {
namespace {

/// The parameters that a family's forms are published with, by one source a row: those of a convention too.
std::vector<std::pair<std::string, std::vector<double>>> published_curves(const FittableFamily& family) {
  std::vector<std::pair<std::string, std::vector<double>>> curves;
  for (const Published& first : published_constants) {
    if (first.family != family.info.id || first.parameter != family.parameters.front()) continue;
    std::vector<double> parameters;
    std::string text;
    for (const std::string_view parameter : family.parameters) {
      const auto found =
          std::find_if(published_constants.begin(), published_constants.end(), [&](const Published& p) {
            return p.family == family.info.id && p.parameter == parameter &&
                   p.source.place == first.source.place;
          });
      parameters.push_back(constant<double>(found->printed));
      text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", parameter, found->printed);
    }
    curves.emplace_back("published, " + text, parameters);
  }
  return curves;
}

}  // namespace

std::string exact_fresnel_section(const FittableFamily& family) {
  Table table{{"n", "f0", "curve", "max abs error of F", "at c", "max rel error of F", "at c (rel)"}, {}};
  const auto add = [&](double ior, const std::string& curve, const Extremum& absolute,
                       const Extremum& relative) {
    table.rows.push_back({Number{ior, 4}, Number{reflectance_at_normal(ior), 4}, curve,
                          Number{absolute.magnitude, 4}, place(absolute.at), Number{relative.magnitude, 4},
                          place(relative.at)});
  };
  for (const double ior : {1.33, 1.5, 2.0}) {
    const auto schlick = schlick_against_exact(ior);
    add(ior, "Schlick's formula", schlick.absolute, schlick.relative);
    auto curves = published_curves(family);
    const Fit fit = family.fit({0, ior}, {});
    if (fit.status == Status::converged) {
      std::string values;
      for (std::size_t i = 0; i < fit.parameters.size(); ++i) {
        values += fmt::format("{}{} = {}", i == 0 ? "" : ", ", family.parameters[i],
                              text(converged(fit.parameters[i]), Precision::report));
      }
      curves.emplace_back("refitted, " + values, fit.parameters);
    }
    for (const auto& [curve, parameters] : curves) {
      add(ior, curve, family.max_abs_error({0, ior}, {}, parameters),
          *family.max_rel_error({0, ior}, {}, parameters));
    }
  }
  return "Against the exact dielectric in unpolarised light, from outside, the reflectance F itself with f0 from n:\n\n" +
         write_markdown(table, Precision::report) + "\n";
}

std::string exact_fresnel_lead(const Results& results) {
  const bool has_fresnel = std::any_of(results.refits.begin(), results.refits.end(),
                                       [](const Refit& refit) { return refit.family->is_fresnel; });
  if (!has_fresnel) return "";
  constexpr double ior = 1.5;
  std::string out = fmt::format(
      "Against the exact dielectric of index {} the reflectance is off by at most {:.3g} with Schlick's formula itself",
      ior, schlick_against_exact(ior).absolute.magnitude);
  for (const Refit& refit : results.refits) {
    if (!refit.family->is_fresnel) continue;
    const FittableFamily& family = *refit.family;
    const auto [curve, parameters] = published_curves(family).front();
    const Fit fit = family.fit({0, ior}, {});
    out += fmt::format(", {:.3g} with `{}` as {}, and {:.3g} with the same form refitted to the exact curve",
                       family.max_abs_error({0, ior}, {}, parameters).magnitude, to_text(family.form()),
                       curve, fit.max_abs_error.magnitude);
  }
  return out + ".\n\n";
}

}  // namespace shadefit
