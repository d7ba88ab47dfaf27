#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "app/studies/find_study.hpp"
#include "approx/scalar.hpp"
#include "fit/scalars/in_50_digits.hpp"
#include "fit/tape/tape_program.hpp"
#include "fit/verdicts/study_verdict.hpp"
#include "reports/io/csv.hpp"
#include "reports/io/files.hpp"

/// Each printed digit of each published set of the committed studies is changed once. The table
/// changed_digits.csv beside this file says how many of the changes are noticed, and by what.
///   by_verdict  the changed digits have another verdict, by the fits that were tried for the published ones
///   by_effect   the curve moves somewhere, in the doubles in which effects are computed
///   in_float    it moves so much that a shader in float can tell: the others of `by_effect` are digits that
///               a float does not hold
///   beyond      the others, by the curve in 50 digits
///   effect      the smallest change of these, as a share of the size of the curve; empty if there are none
namespace shadefit {
namespace {

const std::filesystem::path source_folder = SHADEFIT_SOURCE_DIR;

/// The digits of a constant, by what notices their change; one change may be noticed by verdict and effect.
struct Noticed {
  int digits = 0, by_verdict = 0, by_effect = 0, in_float = 0, beyond = 0;
  double effect = HUGE_VAL;  ///< the smallest of those that are beyond doubles
};

/// Where curves are compared: the rows of a study, or an even grid with its ends.
std::vector<std::vector<double>> places_of(const ReadStudy& study) {
  std::vector<std::vector<double>> places{{}};
  if (study.rows) {
    places.assign(study.rows->value.size(), {});
    for (std::size_t row = 0; row < places.size(); ++row)
      for (const auto& column : study.rows->places) places[row].push_back(column[row]);
    return places;
  }
  const int steps = study.axes.size() == 1 ? 256 : 32;
  for (const StudyAxis& axis : study.axes) {
    std::vector<std::vector<double>> next;
    for (const auto& place : places) {
      for (int i = 0; i <= steps; ++i) {
        next.push_back(place);
        next.back().push_back(axis.lower + (axis.upper - axis.lower) * i / steps);
      }
    }
    places = std::move(next);
  }
  return places;
}

/// The form at all places, for printed constants.
std::vector<double> curve_of(const Tape& form, const std::vector<std::vector<double>>& places,
                             const std::vector<std::string>& printed) {
  std::vector<double> constants;
  for (const std::string& text : printed) constants.push_back(constant<double>(text));
  TapeProgram<double> program(form, constants);
  std::vector<double> values;
  for (const auto& place : places) {
    program.run(place);
    values.push_back(program.output(0));
  }
  return values;
}

/// The power of two at or below the largest value of a curve.
double size_of(const std::vector<double>& curve) {
  double largest = 0;
  for (const double value : curve) largest = std::max(largest, std::abs(value));
  return std::ldexp(1.0, std::ilogb(largest));
}

/// Changes of a curve that count, as shares of its size. Half a unit in the last place of a float: less is
/// rounded away. Of a double eight units, because its some ten operations round too.
constexpr double float_step = std::numeric_limits<float>::epsilon() / 2.0;
constexpr double double_step = 8 * std::numeric_limits<double>::epsilon();

/// A change that makes a finite value infinite or NaN moves the curve too.
bool moves(const std::vector<double>& before, const std::vector<double>& after, double step) {
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (std::isfinite(before[i]) && !(std::abs(after[i] - before[i]) <= step)) return true;
  }
  return false;
}

/// The largest change of a form by other printed constants, computed in 50 digits.
double change_in_50_digits(const ReadStudy& study, const std::vector<std::vector<double>>& places,
                           const std::vector<std::string>& before, const std::vector<std::string>& after) {
  Decimal50 largest = 0;
  for (const auto& place : places) {
    const auto value = [&](const std::vector<std::string>& printed) {
      return in_50_digits(study.form, [&](const std::string& name) {
        for (std::size_t i = 0; i < study.axes.size(); ++i)
          if (study.axes[i].variable == name) return Decimal50(place[i]);
        const auto found = std::find(study.parameters.begin(), study.parameters.end(), name);
        return Decimal50(printed[static_cast<std::size_t>(found - study.parameters.begin())]);
      });
    };
    const Decimal50 change = abs(value(after) - value(before));
    if (change > largest) largest = change;
  }
  return static_cast<double>(largest);
}

/// 9 becomes 0. A zero before the first other digit is printed too, so it is changed as well. An exponent is
/// not: it has no digits of the constant.
Noticed changes_of(const ReadStudy& study, std::vector<std::string> printed, std::size_t parameter,
                   const Tape& form, const std::vector<std::vector<double>>& places, const TriedFits& tried) {
  const Verdict published = judge_digits(tried, printed).verdict;
  const std::vector<double> curve = curve_of(form, places, printed);
  const double size = size_of(curve);
  const std::vector<std::string> all = printed;
  Noticed noticed;
  std::string& text = printed[parameter];
  const std::string original = text;
  const std::size_t end = std::min(text.find_first_of("eE"), text.size());
  for (std::size_t k = 0; k < end; ++k) {
    if (text[k] < '0' || text[k] > '9') continue;
    text[k] = text[k] == '9' ? '0' : static_cast<char>(text[k] + 1);
    const bool by_verdict = judge_digits(tried, printed).verdict != published;
    const std::vector<double> changed = curve_of(form, places, printed);
    const bool by_effect = moves(curve, changed, double_step * size);
    if (!by_effect) {
      const double effect = change_in_50_digits(study, places, all, printed) / size;
      noticed.beyond += effect > 0 ? 1 : 0;
      noticed.effect = std::min(noticed.effect, effect);
    }
    text = original;
    ++noticed.digits;
    noticed.by_verdict += by_verdict ? 1 : 0;
    noticed.by_effect += by_effect ? 1 : 0;
    noticed.in_float += moves(curve, changed, float_step * size) ? 1 : 0;
  }
  return noticed;
}

/// The rows of the table for a study. A set that was published for any given constants is judged for the
/// first of them.
std::string rows_of(const StudyFile& file) {
  std::string rows;
  const std::vector<Study> studies = combinations(file.study, file.given);
  for (std::size_t k = 0; k < file.published.size(); ++k) {
    const PublishedSet& set = file.published[k];
    const auto first =
        std::find_if(studies.begin(), studies.end(), [&](const Study& study) { return is_for(set, study); });
    if (first == studies.end()) continue;
    Study study = *first;
    for (const StudyForm& form : file.forms)
      if (form.id == set.form) study.form = form.formula;
    const ReadStudy read = read_study(study);
    StudyObjective asked = objective_of(study, file.norm, file.constraints);
    asked.recompute = file.recompute;
    const TriedFits tried = tried_fits(asked, set);
    const auto places = places_of(read);
    std::vector<std::string> inputs;
    for (const StudyAxis& axis : read.axes) inputs.push_back(axis.variable);
    inputs.insert(inputs.end(), read.parameters.begin(), read.parameters.end());
    const Tape form = tape_of(read.form, inputs);
    const std::vector<std::string> printed = values_of(set, read.parameters);
    const auto verdict = name(judge_digits(tried, printed).verdict);
    for (std::size_t i = 0; i < printed.size(); ++i) {
      const Noticed noticed = changes_of(read, printed, i, form, places, tried);
      rows += fmt::format("{},{},{},{},{},{},{},{},{},{},{}\n", file.id, k + 1, verdict, read.parameters[i],
                          printed[i], noticed.digits, noticed.by_verdict, noticed.by_effect, noticed.in_float,
                          noticed.beyond, noticed.beyond > 0 ? fmt::format("{:.1e}", noticed.effect) : "");
    }
  }
  return rows;
}

const std::filesystem::path expected_digits = source_folder / "tests/fit/verdicts/changed_digits.csv";

std::vector<std::string> committed_studies() {
  std::vector<std::string> ids;
  for (const auto& path : study_files({source_folder / "studies"})) ids.push_back(path.stem().string());
  return ids;
}

class ChangedDigit : public ::testing::TestWithParam<std::string> {};

TEST_P(ChangedDigit, IsNoticed) {
  std::string expected;
  for (const auto& row : parse_csv(read_file(expected_digits), "changed_digits.csv").rows)
    if (row.front() == GetParam()) expected += fmt::format("{}\n", fmt::join(row, ","));
  EXPECT_EQ(rows_of(load_study(source_folder / "studies" / (GetParam() + ".toml"))), expected)
      << "the first are the rows that belong into " << expected_digits;
}

INSTANTIATE_TEST_SUITE_P(Studies, ChangedDigit, ::testing::ValuesIn(committed_studies()),
                         [](const auto& study) {
                           std::string name = study.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

/// The sum of a column of the table.
int total(const std::string& column) {
  const CsvTable table = parse_csv(read_file(expected_digits), "changed_digits.csv");
  const auto at = std::find(table.columns.begin(), table.columns.end(), column) - table.columns.begin();
  int sum = 0;
  for (const auto& row : table.rows) sum += std::stoi(row.at(static_cast<std::size_t>(at)));
  return sum;
}

// 27 of the 30 that only 50 digits show are in four constants of Mesa with up to 22 digits. The others are
// the last ones of x^0.454545454545455, and of a coefficient of 9.8e-3 with 13 digits. They move the curve by
// less than its doubles round, and no verdict tells them apart: these sets are refuted already.
TEST(ChangedDigits, AreNoticedInAllStudies) {
  EXPECT_EQ(total("digits"), 3080);
  EXPECT_EQ(total("by_verdict"), 390);
  EXPECT_EQ(total("by_effect"), 3050);
  EXPECT_EQ(total("in_float"), 2808);
  EXPECT_EQ(total("beyond"), 30);
}

}  // namespace
}  // namespace shadefit
