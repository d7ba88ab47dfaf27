#pragma once

#include <deque>
#include <map>
#include <string>
#include <vector>

#include "fit/ledger/claim.hpp"

/// Reads claims from TOML.
namespace shadefit {

/// Topics of claims and what they refer to. Not to be copied: the topics point into it.
struct ReadClaims {
  std::vector<Topic> topics;
  std::map<std::string, Source, std::less<>> sources;
  std::deque<std::vector<Claim>> claims;         ///< of each topic
  std::deque<std::vector<Published>> constants;  ///< of each claim that has some
  std::deque<std::string> texts;
};

/// Adds the sources of a file: a table for each, with its author, year, title, place and address; or with
/// `of`, the id of a record that has this source.
void read_sources(const std::string& text, const std::string& name, ReadClaims& into);

/// Adds a topic: its title and its claims. `printed` and `inputs` are lists of pairs, a name and a value. A
/// value "=ID" is what the record of the constant ID prints, a derivation "=ID" is that of an earlier claim.
/// Where a claim has `constants` and prints nothing else, it prints their digits.
///
/// Both throw UserError with one line that names the file, the line and the rule: for a text that is not
/// TOML, an unknown key or id, a missing key, and a value of another type.
void read_topic(const std::string& text, const std::string& name, ReadClaims& into);

}  // namespace shadefit
