#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace shadefit::side_by_side {

/// The right answer of a task: each number's name and exponent, as `a -` or `x 3`, and its decimal text of 24
/// to 50 digits.
using Truth = std::map<std::string, std::string>;

/// The name of a number among those of a task. An exponent is text of any notation, `-` or nothing for none:
/// 1e6 and 1000000 are one.
std::string answer_name(const std::string& parameter, const std::string& exponent);

/// What a task is.
struct Task {
  std::string id, title;
  bool is_fit = false;     ///< ours has to be ten times as fast there
  std::string start = {};  ///< where the others' fits begin
  std::string why = {};    ///< where an exact peer is not ten times slower: the reason
  Truth truth;
};

/// All tasks with their right answers: fits from the references in that folder; the largest error of the
/// published pair by Newton on its slope, and the normalisation constants by their closed forms, in 50
/// digits.
std::vector<Task> tasks(const std::filesystem::path& references);

/// Correct digits: -log10 of the relative error, from 0 to 40; 0 for what is no finite number. Worked out in
/// 50 digits, since the difference of two doubles says nothing beyond the fifteenth.
double correct_digits(const std::string& answer, const std::string& truth);

}  // namespace shadefit::side_by_side
