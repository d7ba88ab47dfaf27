#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace shadefit::side_by_side {

/// The right answer of a task: for each number its name and exponent, such as `a -` or `x 3`, and its decimal
/// text with 24 to 50 digits.
using Truth = std::map<std::string, std::string>;

/// The name of a number of a task. An exponent is text in any notation, and `-` or nothing without an
/// exponent: 1e6 and 1000000 are equal.
std::string answer_name(const std::string& parameter, const std::string& exponent);

/// The description of a task.
struct Task {
  std::string id, title;
  bool is_fit = false;     ///< ours must be ten times as fast
  std::string start = {};  ///< the start of the others' fits
  std::string why = {};    ///< the reason, if an exact peer is not ten times slower
  Truth truth;
};

/// All tasks with their right answers: fits from the references in that folder; the largest error of the
/// published pair by Newton on its slope, and the normalisation constants by their closed forms, in 50
/// digits.
std::vector<Task> tasks(const std::filesystem::path& references);

/// Correct digits: -log10 of the relative error, from 0 to 40; 0 for a number that is not finite. Computed in
/// 50 digits, because the difference of two doubles has no meaning beyond the fifteenth.
double correct_digits(const std::string& answer, const std::string& truth);

}  // namespace shadefit::side_by_side
