#pragma once

#include <string_view>
#include <vector>

#include "lint/known/known_set.hpp"
#include "lint/lint_text.hpp"

namespace shadefit::lint {

/// Whether a number that is not right may as well be that of another source of the same form: 1.875996 for
/// 1.875991 or for 1.875992. The other numbers of the site have to fit that source too.
bool has_rival_source(std::string_view text, const std::vector<KnownSet>& sets, const JudgedSite& site,
                      const JudgedNumber& number);

}  // namespace shadefit::lint
