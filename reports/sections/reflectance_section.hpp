#pragma once

#include <string>
#include <vector>

#include "fit/integrals/reflectance.hpp"
#include "reports/table/table.hpp"

/// The part of the report on normalised lobes at views other than v = n.
namespace shadefit {

/// One row per constant, exponent and view angle: reflectance.csv.
Table reflectance_table(const std::vector<ReflectanceCurve>& curves);

/// A table of reflectances for each constant, one of the largest, and their effect on energy.
std::string reflectance_section(const std::vector<ReflectanceCurve>& curves);

}  // namespace shadefit
