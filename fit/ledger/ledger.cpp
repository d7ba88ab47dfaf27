#include "fit/ledger/ledger.hpp"

#include <algorithm>

#include "fit/ledger/read_claims.hpp"
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
  for (const Topic& topic : ledger()) {
    for (const Claim& claim : topic.claims) {
      if (!is_wanted(claim.id)) continue;
      checkpoint();
      judged.push_back({&topic, &claim, evaluate(claim, fits)});
    }
  }
  return judged;
}

const Claim* find_claim(std::string_view id) {
  for (const Topic& topic : ledger()) {
    for (const Claim& claim : topic.claims) {
      if (claim.id == id) return &claim;
    }
  }
  return nullptr;
}

}  // namespace shadefit
