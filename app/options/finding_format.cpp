#include "app/options/finding_format.hpp"

#include "app/options/option_values.hpp"

namespace shadefit {

CLI::Option* add_finding_format(CLI::App& command, FindingFormat& format, bool has_places) {
  auto choices = by_name(findings::finding_formats);
  std::erase_if(choices,
                [&](const auto& choice) { return choice.second == FindingFormat::sarif && !has_places; });
  return add_choice(command, "--format", format, choices,
                    "of what is printed, for people, dashboards and code hosts");
}

Outcome outcome_of(const findings::FindingReport& report, FindingFormat format) {
  return {findings::passes(report) ? 0 : 1, findings::write_findings(report, format), ""};
}

}  // namespace shadefit
