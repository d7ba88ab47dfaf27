#pragma once

#include "app/options/outcome.hpp"
#include "reports/findings/finding.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

/// --format of the commands that check.
namespace shadefit {

using findings::FindingFormat;

/// Adds --format. SARIF is for findings with a place in a file: `has_places`.
CLI::Option* add_finding_format(CLI::App& command, FindingFormat& format, bool has_places);

/// The findings of a check of one thing by one rule: what is wrong at `place`, or nothing if `fault` is
/// empty.
findings::FindingReport one_check(const std::string& command, const findings::FindingRule& rule,
                                  const std::string& checked_words, const std::string& fault,
                                  const findings::FindingPlace& place);

/// The outcome of a check in that format: exit 1 where a finding fails it.
Outcome outcome_of(const findings::FindingReport& report, FindingFormat format);

}  // namespace shadefit
