#include "fit/catalogue/study_file.hpp"

#include <algorithm>
#include <cmath>

#include "fit/support/format.hpp"
#include "fit/support/user_error.hpp"

namespace shadefit {
namespace {

/// Each combination has the definitions.
constexpr double most_combined_bytes = 1 << 28;

}  // namespace

std::string_view name(StatedError error) {
  constexpr std::array<std::string_view, stated_errors.size()> names{
      "max_abs_error", "max_rel_error", "mean_abs_error", "mean_rel_error", "rms_error", "mean_square_error"};
  return names.at(static_cast<std::size_t>(error));
}

void take_form(Study& study, const StudyForm& form) {
  study.form = form.formula;
  study.residual = form.error;
  study.near_peak.form = form.near_peak;
  study.known_starts.clear();
  for (const PrintedValues& start : form.starts) {
    std::vector<Held>& known = study.known_starts.emplace_back();
    for (const auto& [parameter, value] : start)
      known.push_back({parameter, number_in(study, {"--form"}, value)});
  }
}

std::string fault_in(const StudyFile& file, const StudyFault& fault, const std::string& form) {
  const StudyPart& part = fault.part;
  const std::string key = part.option.substr(part.option.find_first_not_of('-'));
  const std::string& name = key == "form" ? form : part.name;
  const auto line = file.lines.find(name.empty() ? key : key + " " + name);
  return fmt::format("{}: {}{}", line == file.lines.end() ? "" : fmt::format(", line {}", line->second), key,
                     fault.rule);
}

bool is_for(const PublishedSet& set, const Study& study) {
  return std::all_of(set.given.begin(), set.given.end(), [&](const auto& given) {
    const auto found = study.given.find(given.first);
    return found != study.given.end() && found->second == given.second;
  });
}

std::string given_text(const Study& study) {
  std::string text;
  for (const auto& [name, value] : study.given) text += (text.empty() ? "" : ", ") + name + " = " + value;
  return text;
}

std::vector<Study> combinations(const Study& study,
                                const std::vector<std::pair<std::string, std::vector<std::string>>>& given) {
  double count = 1, bytes = sizeof(Study);
  for (const auto& [name, values] : given) count *= static_cast<double>(values.size());
  for (const StudyDefinition& definition : study.definitions)
    bytes += static_cast<double>(sizeof definition + definition.formula.size());
  const double most = std::min<double>(most_combinations, std::floor(most_combined_bytes / bytes));
  if (count > most)
    throw UserError(
        fmt::format("the given constants have {:g} combinations of values: at most {}", count, most));
  std::vector<Study> studies{study};
  for (const auto& [name, values] : given) {
    std::vector<Study> longer;
    for (const Study& one : studies) {
      for (const std::string& value : values) {
        longer.push_back(one);
        if (!longer.back().given.emplace(name, value).second)
          throw UserError("--given '" + name + "' is given a second time");
      }
    }
    studies = std::move(longer);
  }
  return studies;
}

}  // namespace shadefit
