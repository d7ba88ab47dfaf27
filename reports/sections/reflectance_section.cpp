#include "reports/sections/sections.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "reports/io/joined.hpp"
#include "reports/io/writers.hpp"
#include "reports/sections/prose.hpp"

namespace shadefit {
namespace {

/// An angle in degrees. An extremum has half the digits of a double, so all of these are right.
Cell angle(double degrees) {
  return Number{degrees, 6};
}

/// A reflectance for people.
Cell rounded(double reflectance) {
  return Number{reflectance, 6};
}

using Curves = std::vector<const ReflectanceCurve*>;

Curves curves_of(const std::vector<ReflectanceCurve>& curves, const Normalisation& record) {
  Curves found;
  for (const auto& curve : curves) {
    if (curve.record == &record) found.push_back(&curve);
  }
  return found;
}

/// View angles down, exponents across.
Table constant_table(const Curves& curves, double Reflectance::*value) {
  Table table{{"view angle"}};
  for (const auto* curve : curves) table.columns.push_back(fmt::format("a = {}", curve->exponent));
  for (std::size_t i = 0; i < view_angles.size(); ++i) {
    auto& row = table.rows.emplace_back(std::vector<Cell>{angle(view_angles[i])});
    for (const auto* curve : curves) row.push_back(rounded(curve->points[i].*value));
  }
  return table;
}

std::string constant_part(const ReflectedConstant& constant, const Curves& curves) {
  const auto& record = *constant.record;
  std::string out = fmt::format("`{}`, `{} {}`:\n\n", record.id, record.printed, record.lobe) +
                    markdown_block(constant_table(curves, &Reflectance::reflectance));
  if (constant.has_cosine) return out;
  return out + fmt::format("`{}` times n.l, `{} {} (n.l)`:\n\n", record.id, record.printed, record.lobe) +
         markdown_block(constant_table(curves, &Reflectance::with_cosine));
}

Table largest_table(const std::vector<ReflectanceCurve>& curves) {
  Table table{
      {"constant", "a", "largest", "at angle", "largest with n.l", "at angle (n.l)", "creates energy below"},
      {}};
  for (const auto& curve : curves) {
    table.rows.push_back({std::string(curve.record->id), Number{curve.exponent, 10},
                          converged(curve.largest.value), angle(curve.largest.view_angle),
                          converged(curve.largest_with_cosine.value),
                          angle(curve.largest_with_cosine.view_angle),
                          curve.conserves_from ? angle(*curve.conserves_from) : Cell()});
  }
  return table;
}

/// The exponents of curves, by commas.
std::string exponents_text(const Curves& curves) {
  return joined(curves, ", ", [](const auto* curve) { return fmt::format("{}", curve->exponent); });
}

/// The effect of a constant on energy, from its curves. Peaks that are equal within rounding are listed
/// together.
std::string energy_sentence(const Normalisation& record, const Curves& curves) {
  double largest = 0;
  for (const auto* curve : curves) largest = std::max(largest, curve->largest_with_cosine.value);
  Curves worst, creating;
  for (const auto* curve : curves) {
    if (curve->largest_with_cosine.value >= largest * (1 - energy_tolerance)) worst.push_back(curve);
    if (curve->conserves_from) creating.push_back(curve);
  }
  const std::string peak =
      fmt::format("{} at {} degrees for a = {}", in_digits(largest, 6),
                  in_digits(worst.front()->largest_with_cosine.view_angle, 4), exponents_text(worst));
  if (creating.empty()) {
    return fmt::format("- `{}` creates no energy for a = {}: its reflectance with n.l is at most {}.\n",
                       record.id, exponents_text(curves), peak);
  }
  const std::string where = joined(creating, ", ", [](const auto* curve) {
    return fmt::format("below {} degrees for a = {}", in_digits(*curve->conserves_from, 4), curve->exponent);
  });
  return fmt::format("- `{}` creates energy: {}. Its reflectance is largest, {}.\n", record.id, where, peak);
}

}  // namespace

Table reflectance_table(const std::vector<ReflectanceCurve>& curves) {
  Table table{{"constant", "exponent", "view_angle", "reflectance", "estimated_error", "with_cosine"}};
  for (const auto& curve : curves) {
    for (const Reflectance& point : curve.points) {
      const bool is_good = point.estimated_error <= reflectance_tolerance;
      table.rows.push_back({std::string(curve.record->id), Number{curve.exponent, 10},
                            angle(point.view_angle), converged(point.reflectance),
                            Number{is_good ? reflectance_tolerance : point.estimated_error, 2},
                            converged(point.with_cosine)});
    }
  }
  return table;
}

std::string reflectance_section(const std::vector<ReflectanceCurve>& curves) {
  std::string out = section_text("reflectance");
  std::string sentences;
  for (const ReflectedConstant& constant : reflected_constants) {
    const Curves found = curves_of(curves, *constant.record);
    if (found.empty()) continue;
    out += constant_part(constant, found);
    sentences += energy_sentence(*constant.record, found);
  }
  return out +
         "The largest R over all view angles, and the view angle below which R with n.l exceeds 1:\n\n" +
         markdown_block(largest_table(curves)) + sentences + "\n";
}

}  // namespace shadefit
