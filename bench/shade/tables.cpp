#include "bench/shade/tables.hpp"

#include <fmt/format.h>

#include "fit/decimal.hpp"
#include "reports/writers.hpp"

namespace shadefit::shade {
namespace {

/// Times repeat to a per cent or so, and of errors nobody reads more.
constexpr int shown_digits = 3;

Cell shown(double value) {
  return Number{value, shown_digits};
}

std::vector<Cell> row_of_way(const MeasuredWay& way) {
  return {way.name,
          way.tolerance ? Cell(Number{*way.tolerance, 4}) : Cell(),
          way.form,
          shown(way.ns),
          shown(way.errors.most),
          shown(way.errors.mean),
          shown(way.errors.most_codes),
          shown(way.errors.mean_codes)};
}

std::vector<Cell> console_row(const MeasuredWay& way, double reference_ns) {
  return {way.name,
          shown(way.ns),
          shown(reference_ns / way.ns),
          shown(way.errors.most),
          shown(way.errors.mean),
          shown(way.errors.most_codes),
          shown(way.errors.mean_codes)};
}

std::string percent(double share) {
  return fmt::format("{} %", decimal(100 * share, shown_digits));
}

/// How many times as fast: a whole number, or one decimal of a small one.
std::string ratio(double value) {
  constexpr double rounds_to_ten = 9.95;
  return value < rounds_to_ten ? fmt::format("{:.1f}", value) : fmt::format("{:.0f}", value);
}

std::string verdict_line(const Measurement& m) {
  const char* const is_within = m.is_published_within() ? "are within" : "are not within";
  if (m.skipped.by_materials == 1)
    return fmt::format(
        "Planned: no material has a lobe, and nothing is computed. The published constants {} the "
        "tolerance.\n",
        is_within);
  return fmt::format(
      "Planned: {} x as fast as the reference, {} x as the published constants, which {} the tolerance.\n",
      ratio(m.times_reference()), ratio(m.times_published()), is_within);
}

std::string skipped_line(const Measurement& m) {
  if (m.skipped.by_materials == 1) return "";
  const double terms = m.skipped.by_terms;
  // slopes and three channels may take more operations than the power that they stand for
  const std::string by_terms =
      terms < 0 ? percent(-terms) + " more operations" : percent(terms) + " of the operations skipped";
  return fmt::format(
      "Skipped: {} of the samples by their materials, {} of the others by culling. Terms of a sample: {}.\n",
      percent(m.skipped.by_materials), percent(m.skipped.by_culling), by_terms);
}

}  // namespace

Table shade_table(const Measurement& measurement) {
  Table table{.columns = {"way", "tolerance", "form", "ns_per_sample", "max_error", "mean_error", "max_codes",
                          "mean_codes"},
              .rows = {}};
  for (const MeasuredWay* way : {&measurement.reference, &measurement.published, &measurement.planned})
    table.rows.push_back(row_of_way(*way));
  for (const MeasuredWay& way : measurement.sweep) table.rows.push_back(row_of_way(way));
  return table;
}

std::string shade_text(const Measurement& measurement) {
  Table table{.columns = {"way", "ns/sample", "times reference", "max error", "mean error", "max codes",
                          "mean codes"},
              .rows = {}};
  for (const MeasuredWay* way : {&measurement.reference, &measurement.published, &measurement.planned})
    table.rows.push_back(console_row(*way, measurement.reference.ns));
  return write_console(table, Precision::report) + "\n" + verdict_line(measurement) +
         skipped_line(measurement) +
         fmt::format(
             "Timed: the specular term, its cosines given, of {} samples on one core, {}; a sample is a pixel "
             "under one light, and an error is one of that.\n",
             measurement.samples, forms::name(measurement.width)) +
         (measurement.is_half
              ? "The plan is for half, and was shaded in float: what half rounds is in the plan alone.\n"
              : "");
}

std::string broken_lines(const Measurement& measurement) {
  std::string lines;
  for (const MeasuredWay& way : broken_promises(measurement)) {
    lines += fmt::format(
        "shadefit: the plan for a tolerance of {} is off by {} of one light, which is above its {}\n",
        decimal(*way.tolerance, 4), decimal_above(way.errors.most_on(measurement.scale), 4),
        decimal(way.allowed, 4));
  }
  return lines;
}

}  // namespace shadefit::shade
