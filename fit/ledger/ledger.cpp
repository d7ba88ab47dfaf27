#include "fit/ledger/ledger.hpp"

#include <algorithm>
#include <cstddef>

#include "fit/ledger/read_claims.hpp"
#include "fit/support/parallel.hpp"
#include "studies/claims_files.hpp"

namespace shadefit {

std::span<const Topic> ledger() {
  static const ReadClaims read = [] {
    ReadClaims claims;
    for (const EmbeddedFile& file : claims_files)
      (file.name == "sources" ? read_sources : read_topic)(std::string(file.text), std::string(file.name),
                                                           claims);
    return claims;
  }();
  return read.topics;
}

bool has_claim(std::string_view id) {
  const std::string line = "\nid = \"" + std::string(id) + "\"\n";
  return std::ranges::any_of(
      claims_files, [&](const EmbeddedFile& file) { return file.text.find(line) != std::string_view::npos; });
}

std::vector<JudgedClaim> judge_claims(const std::function<bool(std::string_view id)>& is_wanted, Fits& fits,
                                      const Checkpoint& checkpoint) {
  std::vector<JudgedClaim> judged;
  std::vector<std::size_t> by_fits, others;
  for (const Topic& topic : ledger()) {
    for (const Claim& claim : topic.claims) {
      if (!is_wanted(claim.id)) continue;
      (claim.constants.empty() ? others : by_fits).push_back(judged.size());
      judged.push_back({&topic, &claim, {}});
    }
  }
  const auto judge = [&](std::size_t i) { judged[i].finding = evaluate(*judged[i].claim, fits); };
  // The fits are for one thread. Claims that use none of them are judged beside those that do.
  const auto piece = [&](std::size_t place, const Checkpoint& next) {
    if (place > 0) return judge(others[place - 1]);
    for (const std::size_t i : by_fits) {
      next();
      judge(i);
    }
  };
  for_each_in_parallel(1 + others.size(), piece, {.before_each = checkpoint, .checkpoint = checkpoint});
  return judged;
}

}  // namespace shadefit
