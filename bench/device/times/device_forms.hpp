#pragma once

#include <functional>
#include <string>
#include <vector>

#include "bench/device/times/timing_shader.hpp"
#include "bench/forms/catalogue.hpp"
#include "bench/tradeoff/grid_errors.hpp"
#include "fit/better/better_study.hpp"

/// What is measured on a device: forms of the catalogue or of a study.
namespace shadefit::device {

/// The floats of each argument, the same number for all.
using Places = bench::Grid;

/// What forms approximate.
struct DeviceTarget {
  bench::TimedTarget heading;
  std::vector<Range> ranges;  ///< of its arguments
  Places places;              ///< where its forms are compared with it
  /// The target in double at any places. Empty if the rows have their errors already, those of exact
  /// arithmetic.
  std::function<std::vector<double>(const Places&)> truth;
};

/// A form with one set of its constants.
struct DeviceForm {
  std::size_t target;    ///< its place among the targets
  bench::TimedForm row;  ///< names, and an error that is already known
  std::string shape;     ///< forms of one target with the same text here have the same time
  ShaderFunction function;
};

struct DeviceForms {
  std::vector<DeviceTarget> targets;
  std::vector<DeviceForm> forms;  ///< those of one shape follow each other
};

/// The forms of the catalogue for these targets, or for all of them. Forms of several lights are left out:
/// they are sums of one light. Throws UserError if only such targets are asked for.
DeviceForms catalogue_forms(const forms::Catalogue& catalogue, const std::vector<std::string>& targets);

/// The forms of a study and its targets. Throws UserError for a form that has no code in GLSL.
DeviceForms study_forms(const std::string& id, const std::vector<StudyComparison>& comparisons);

}  // namespace shadefit::device
