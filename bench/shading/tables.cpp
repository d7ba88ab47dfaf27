#include "bench/shading/tables.hpp"

#include <fmt/format.h>

#include <array>

#include "fit/support/decimal.hpp"

namespace shadefit::shade {
namespace {

/// Times are repeatable to about a percent, and errors need no more digits.
constexpr int shown_digits = 3;

/// The device of the ways on this processor.
constexpr const char* cpu = "CPU";

Cell shown(double value) {
  return Number{value, shown_digits};
}

std::vector<Cell> row_of_way(const MeasuredWay& way, const std::string& device) {
  return {way.name,
          way.tolerance ? Cell(Number{*way.tolerance, 4}) : Cell(),
          way.form,
          shown(way.ns),
          shown(way.errors.most),
          shown(way.errors.mean),
          shown(way.errors.most_codes),
          shown(way.errors.mean_codes),
          device};
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

/// A ratio of times: a whole number, or one decimal for small ones.
std::string ratio(double value) {
  constexpr double rounds_to_ten = 9.95;
  return value < rounds_to_ten ? fmt::format("{:.1f}", value) : fmt::format("{:.0f}", value);
}

/// The rows of a device, each with its id before it.
void append_rows(Table& table, const DeviceMeasurement& there) {
  for (auto& row : table.rows) row.insert(row.begin(), std::string(cpu));
  table.columns.insert(table.columns.begin(), "device");
  for (const MeasuredWay& way : there.ways) {
    std::vector<Cell> row = console_row(way, there.ways.front().ns);
    row.insert(row.begin(), there.id);
    table.rows.push_back(std::move(row));
  }
}

std::string device_lines(const Measurement& m, const DeviceMeasurement& there) {
  const MeasuredWay &published = there.ways[1], &culled = there.ways[2], &planned = there.ways[3];
  const double error = planned.errors.most_on(m.scale);
  std::string lines = fmt::format("{} is {}.", there.id, there.name);
  if (m.skipped.by_materials < 1)
    lines += fmt::format(
        " Planned: {} ns a shaded sample there. The published constants take {} x as long with every term, and {} x in "
        "the plan's code. Their error is {} x the plan's.",
        decimal(planned.ns, shown_digits), ratio(published.ns / planned.ns), ratio(culled.ns / planned.ns),
        error > 0 ? ratio(culled.errors.most_on(m.scale) / error) : "inf");
  return lines +
         fmt::format(
             "\nTimed there: {} pixels under {} lights each, by {}, less {} ns a pixel to read and to write "
             "it.\n",
             there.pixels, there.lights, there.clock, decimal(there.empty_ns, shown_digits));
}

std::string verdict_line(const Measurement& m) {
  const char* const is_within = m.is_published_within() ? "are within" : "are not within";
  if (m.skipped.by_materials == 1)
    return fmt::format(
        "Planned: no material has a lobe, and nothing is computed. The published constants {} the "
        "tolerance.\n",
        is_within);
  const double error = m.planned.errors.most_on(m.scale);
  const double published = m.published_culled.errors.most_on(m.scale);
  return fmt::format(
      "Planned: {} ns a shaded sample. The reference in float takes {} x as long; the published constants take {} x "
      "as long with every term, and {} x in the plan's kernel. Their error is {} x the plan's, and they {} the "
      "tolerance.\n",
      decimal(m.planned.ns, shown_digits), ratio(m.reference.ns / m.planned.ns),
      ratio(m.published.ns / m.planned.ns), ratio(m.published_culled.ns / m.planned.ns),
      error > 0 ? ratio(published / error) : "inf", is_within);
}

std::string skipped_line(const Measurement& m) {
  if (m.skipped.by_materials == 1) return "";
  const double terms = m.skipped.by_terms;
  // slopes and three channels may cost more than the power
  const std::string by_terms =
      terms < 0 ? percent(-terms) + " dearer than" : percent(terms) + " cheaper than";
  return fmt::format(
      "The plan skips {} of the shaded samples by their materials, and culls {} of the others. What is left of "
      "a sample is {} the reference, by instructions.\n",
      percent(m.skipped.by_materials), percent(m.skipped.by_culling), by_terms);
}

/// The plan and the ways that it is compared with.
std::array<const MeasuredWay*, 4> compared(const Measurement& m) {
  return {&m.reference, &m.published, &m.published_culled, &m.planned};
}

}  // namespace

Table shade_table(const Measurement& measurement) {
  Table table{.columns = {"way", "tolerance", "form", "ns_per_sample", "max_error", "mean_error", "max_codes",
                          "mean_codes", "device"},
              .rows = {}};
  for (const MeasuredWay* way : compared(measurement)) table.rows.push_back(row_of_way(*way, cpu));
  for (const MeasuredWay& way : measurement.sweep) table.rows.push_back(row_of_way(way, cpu));
  if (!measurement.on_device) return table;
  for (const MeasuredWay& way : measurement.on_device->ways)
    table.rows.push_back(row_of_way(way, measurement.on_device->name));
  return table;
}

std::string shade_text(const Measurement& measurement, const Terminal& terminal) {
  Table table{.columns = {"way", "ns/sample", "times reference", "max error", "mean error", "max codes",
                          "mean codes"},
              .rows = {}};
  for (const MeasuredWay* way : compared(measurement))
    table.rows.push_back(console_row(*way, measurement.reference.ns));
  if (measurement.on_device) append_rows(table, *measurement.on_device);
  return write_console(table, Precision::report, terminal) + "\n" + verdict_line(measurement) +
         skipped_line(measurement) +
         fmt::format(
             "Timed: the specular term in float, its cosines given, of {} shaded samples on one core, {}. A shaded "
             "sample is a pixel under one light, of a material that is not black; an error is one of that.\n",
             measurement.samples, forms::name(measurement.width)) +
         (measurement.is_half
              ? "The plan is for half, and was shaded in float: what half rounds is in the plan alone.\n"
              : "") +
         (measurement.on_device ? device_lines(measurement, *measurement.on_device) : "");
}

std::string broken_lines(const Measurement& measurement) {
  std::string lines;
  for (const MeasuredWay& way : broken_promises(measurement)) {
    lines += fmt::format(
        "shadefit: the plan for a tolerance of {} is off by {} of one light{}, which is above its {}\n",
        decimal(*way.tolerance, 4), decimal_above(way.errors.most_on(measurement.scale), 4),
        way.device.empty() ? "" : " on " + way.device, decimal(way.allowed, 4));
  }
  return lines;
}

}  // namespace shadefit::shade
