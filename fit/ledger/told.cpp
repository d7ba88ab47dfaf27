#include "fit/ledger/told.hpp"

#include <algorithm>
#include <stdexcept>

#include "fit/support/format.hpp"
#include "fit/support/sweep.hpp"

namespace shadefit {

std::string_view given_text(const Claim& claim, std::string_view name) {
  for (const auto& [kind, quantities] : {std::pair{"input", &claim.inputs}, {"printed", &claim.printed}}) {
    for (std::size_t i = 0; i < quantities->size(); ++i) {
      std::string given((*quantities)[i].name);
      std::ranges::replace(given, ' ', '_');
      if (given == name || fmt::format("{}_{}", kind, i) == name) return (*quantities)[i].value;
    }
  }
  throw std::logic_error(fmt::format("{} tells of '{}', which nothing gives", claim.id, name));
}

double given_number(const Claim& claim, std::string_view name) {
  for (const std::string_view end : {"_first", "_last"}) {
    if (!name.ends_with(end)) continue;
    const auto sweep = parse_sweep(given_text(claim, name.substr(0, name.size() - end.size())));
    return end == "_first" ? sweep.front() : sweep.back();
  }
  return number_of(given_text(claim, name));
}

}  // namespace shadefit
