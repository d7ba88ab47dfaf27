#include "bench/forms/accuracy.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "bench/forms/catalogue.hpp"
#include "bench/forms/kernels.hpp"
#include "fit/errors/effect.hpp"
#include "fit/scalars/half.hpp"
#include "reports/io/joined.hpp"

namespace shadefit::forms {
namespace {

/// The inputs of the forms: 4097 cosines that are floats, and the neighbours of the ends.
Inputs<double> grid_of(const Target& target) {
  Inputs<double> grid(3);
  const auto add = [&](const std::array<double, 3>& place) {
    for (std::size_t axis = 0; axis < 3; ++axis) grid[axis].push_back(place[axis]);
  };
  if (target.arguments == Arguments::normal_to_lights) {
    constexpr std::size_t normals = 1024;
    // besides the directions of the most lights of a target
    constexpr std::size_t first = 64;
    for (std::size_t i = 0; i < normals; ++i) add(spread_direction(first + i));
  } else if (target.arguments == Arguments::cosine_and_code) {
    constexpr int steps = 256, codes = 256;
    for (int i = 0; i <= steps; ++i) {
      for (int code = 0; code < codes; code += 5)
        add({static_cast<double>(i) / steps, static_cast<double>(code), 0});
    }
  } else {
    constexpr int steps = 4096;
    for (int i = 0; i <= steps; ++i)
      add({target.from + (target.to - target.from) * static_cast<double>(i) / steps, 0, 0});
    for (const double near : {0x1p-11, 0x1p-24}) {
      add({target.from + near, 0, 0});
      add({target.to - near, 0, 0});
    }
  }
  // The last place counts several times, up to a multiple of 64 places: the table's rms errors have this
  // weight.
  while (grid[0].size() % 64 != 0) add({grid[0].back(), grid[1].back(), grid[2].back()});
  return grid;
}

/// The places in an arithmetic, and the target there.
template <class R>
struct Places {
  Inputs<R> in;
  std::vector<long double> truth;

  Places(const Inputs<double>& grid, const Target& target, Kernel<long double> exact) {
    Inputs<long double> wide;
    for (const std::vector<double>& axis : grid) {
      std::vector<R>& rounded = in.emplace_back();
      for (const double x : axis) rounded.push_back(rounded_to<R>(x));
      std::vector<long double>& exactly = wide.emplace_back();
      for (const R x : rounded) exactly.push_back(static_cast<long double>(widened(x)));
    }
    const std::vector<double> given = parameters_of(target, {});
    truth = exact(wide, std::vector<long double>(given.begin(), given.end()));
  }

  double cosine(std::size_t i) const { return widened(in[0][i]); }

  /// The results of a form.
  std::vector<double> results(Kernel<R> kernel, const std::vector<double>& given) const {
    std::vector<R> parameters;
    for (const double p : given) parameters.push_back(rounded_to<R>(p));
    std::vector<double> results;
    for (const R x : kernel(in, parameters)) results.push_back(widened(x));
    return results;
  }
};

struct Errors {
  double absolute = 0, relative = 0, rms = 0, ulps = 0, codes = 0;
  double at = 0;
};

template <class R>
Errors errors_of(const Places<R>& places, const std::vector<double>& results) {
  Errors errors;
  Effect effect;
  long double square = 0;
  std::vector<double> off(results.size());
  for (std::size_t i = 0; i < results.size(); ++i) {
    const long double truth = places.truth[i], difference = static_cast<long double>(results[i]) - truth;
    off[i] = static_cast<double>(std::fabs(difference));
    square += difference * difference;
    errors.absolute = std::max(errors.absolute, off[i]);
    if (std::fabs(truth) >= static_cast<long double>(visible)) {
      // The distance between the numbers of the format around a normal one.
      const long double ulp = std::ldexp(1.0L, std::ilogb(truth) - std::numeric_limits<R>::digits + 1);
      errors.ulps = std::max(errors.ulps, static_cast<double>(std::fabs(difference) / ulp));
    }
    effect.show(static_cast<double>(truth), results[i], {{"c = ", places.cosine(i)}});
  }
  errors.relative = effect.relative.magnitude;
  errors.codes = effect.srgb_codes;
  errors.rms = static_cast<double>(std::sqrt(square / static_cast<long double>(results.size())));
  constexpr double equal = 1e-6;
  errors.at = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < results.size(); ++i) {
    if (off[i] >= (1 - equal) * errors.absolute) errors.at = std::min(errors.at, places.cosine(i));
  }
  return errors;
}

void append_row(Table& table, const Target& target, const FormEntry& form, const Constants& constants,
                std::string_view arithmetic, int degree, const Errors& errors) {
  // The truths are long doubles, 1/2048 of an ulp of double apart, and processors differ in their last digit.
  // So the errors of doubles have three digits.
  constexpr int few = 3, place_digits = 6;
  const int digits = arithmetic == "double" ? few : 6;
  const auto number = [](double value, int shown) { return Cell(Number{value, shown}); };
  const auto equation = [](const NamedNumber& given) { return given.name + " = " + given.printed; };
  std::string exp2;
  if (kernels_of(form.id).size() > 1) exp2 = degree == 0 ? "library" : std::to_string(degree);
  table.rows.push_back(
      {std::string(target.id), std::string(form.id), constants.id, joined(constants.numbers, ", ", equation),
       exp2, std::string(arithmetic), number(errors.absolute, digits),
       target.arguments == Arguments::normal_to_lights ? Cell() : number(errors.at, place_digits),
       number(errors.relative, digits), number(errors.rms, digits), number(errors.ulps, few),
       number(errors.codes, few)});
}

void append(Table& table, const Target& target, const Checkpoint& checkpoint) {
  const Inputs<double> grid = grid_of(target);
  const Kernel<long double> exact = kernels_of(target.forms.front().id).front().in_long_double;
  const Places<Eigen::half> halves(grid, target, exact);
  const Places<float> floats(grid, target, exact);
  const Places<double> doubles(grid, target, exact);
  for (const FormEntry& form : target.forms) {
    for (const Constants& constants : form.constants) {
      const auto add = [&](const auto& places, auto kernel, std::string_view arithmetic, int degree) {
        if (kernel == nullptr) return;
        checkpoint();
        append_row(table, target, form, constants, arithmetic, degree,
                   errors_of(places, places.results(kernel, parameters_of(target, constants))));
      };
      for (const FormKernels& kernels : kernels_of(form.id)) {
        const bool is_library = kernels.exp2_degree == 0;
        add(doubles, is_library ? kernels.exact_double : kernels.in_double, "double", kernels.exp2_degree);
        add(floats, is_library ? kernels.exact_float : kernels.in_float, "float", kernels.exp2_degree);
        add(halves, kernels.in_half, "half", kernels.exp2_degree);
      }
    }
  }
}

}  // namespace

Table accuracy_table(const Checkpoint& checkpoint, const std::function<void(double share)>& progress) {
  const std::vector<Target> targets = catalogue();
  Table table{.columns = {"target", "form", "constants", "values", "exp2", "arithmetic", "max_abs_error",
                          "max_abs_error_at", "max_rel_error", "rms_error", "max_ulps", "srgb_codes"},
              .rows = {}};
  for (const Target& target : targets) {
    progress(static_cast<double>(&target - targets.data()) / static_cast<double>(targets.size()));
    append(table, target, checkpoint);
  }
  return table;
}

}  // namespace shadefit::forms
