#include "reports/rows/citation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/algorithm/string/finder.hpp>
#include <boost/algorithm/string/iter_find.hpp>
#include <cctype>
#include <iterator>
#include <map>
#include <set>

#include "fit/catalogue/family.hpp"
#include "fit/ledger/ledger.hpp"
#include "reports/io/escape.hpp"
#include "reports/io/joined.hpp"

namespace shadefit {
namespace {

/// A web address without its scheme: "host.org/path".
bool is_address(std::string_view place) {
  return place.find(' ') == std::string_view::npos && place.find('.') != std::string_view::npos;
}

/// The letters of the first `count` words of a text, in lower case.
std::string first_letters(std::string_view text, int count) {
  std::string letters;
  for (const char c : text) {
    const auto letter = static_cast<unsigned char>(c);
    if (c == ' ' && --count == 0) break;
    if (std::isalpha(letter) != 0) letters += static_cast<char>(std::tolower(letter));
  }
  return letters;
}

/// A name in braces if BibTeX would take its words apart: "{Le Saec}", "{Unity Technologies}".
std::string bibtex_name(const OthersText& author) {
  const std::string& name = author.unescaped();
  const bool is_one = name.find(' ') == std::string::npos || name.find(',') != std::string::npos;
  return is_one ? for_latex(author) : "{" + for_latex(author) + "}";
}

/// Calls `use` with each id of the ledger and the catalogue and a source that it has.
template <class Use>
void for_each_cited(const Use& use) {
  for (const Topic& topic : ledger()) {
    for (const Claim& claim : topic.claims) use(claim.id, claim.source);
  }
  for (const Published& published : published_constants()) {
    for (const std::string_view id : {published.id, published.family}) use(id, published.source);
  }
}

}  // namespace

std::string author_and_year(const Source& source) {
  return fmt::format("{} {}", source.author, source.year);
}

std::string citation(const Source& source) {
  return fmt::format("{}, {}, {}", author_and_year(source), source.title, source.place);
}

std::string address_of(const Source& source) {
  if (!source.address.empty()) return std::string(source.address);
  return is_address(source.place) ? fmt::format("https://{}", source.place) : "";
}

std::string linked(const Source& source) {
  const std::string address = address_of(source);
  return address.empty() ? author_and_year(source)
                         : fmt::format("[{}]({})", author_and_year(source), address);
}

CitedWork work_of(const Source& source) {
  CitedWork work{.title = OthersText(std::string(source.title)),
                 .year = OthersText(std::to_string(source.year)),
                 .howpublished = OthersText(std::string(is_address(source.place) ? "" : source.place)),
                 .url = address_of(source)};
  std::vector<std::string> authors;
  boost::algorithm::iter_split(authors, source.author, boost::first_finder(", "));
  work.authors.assign(authors.begin(), authors.end());
  return work;
}

std::vector<CitedWork> works_of(const std::vector<PublishedSet>& sets) {
  std::vector<CitedWork> works;
  for (const PublishedSet& set : sets) works.push_back(set.cite.value_or(CitedWork{.title = set.source}));
  return works;
}

std::string bibtex(const std::vector<CitedWork>& works) {
  std::map<std::string, int> uses;
  std::set<std::string> seen;
  std::string entries;
  for (const CitedWork& work : works) {
    std::string body;
    const auto add = [&](const char* field, const std::string& value) {
      if (!value.empty()) body += fmt::format("  {} = {{{}}},\n", field, value);
    };
    add("author", joined(work.authors, " and ", bibtex_name));
    add("title", work.title.empty() ? "" : "{" + for_latex(work.title) + "}");
    add("year", for_latex(work.year));
    add("howpublished", for_latex(work.howpublished));
    add("note", for_latex(work.note));
    add("url", work.url);
    if (!seen.insert(body).second) continue;
    std::string key = work.authors.empty() ? "" : first_letters(work.authors.front().unescaped(), 1);
    std::ranges::copy_if(work.year.unescaped(), std::back_inserter(key),
                         [](char c) { return '0' <= c && c <= '9'; });
    key += first_letters(work.title.unescaped(), 2);
    if (key.empty()) key = "source";
    // Titles of code often begin with the same words.
    if (const int before = uses[key]++; before > 0) key += fmt::format("-{}", before + 1);
    entries += fmt::format("\n@misc{{{},\n{}}}\n", key, body);
  }
  return entries;
}

std::string bibtex_of_shadefit(std::string_view version) {
  return fmt::format(
      "@software{{shadefit,\n  author = {{{{The shadefit authors}}}},\n"
      "  title = {{{{shadefit: refitted and checked approximation constants of real-time shading}}}},\n"
      "  version = {{{}}},\n}}\n",
      version);
}

std::vector<std::string> cited_ids() {
  std::set<std::string> ids;
  for_each_cited([&](std::string_view id, const Source&) { ids.emplace(id); });
  return {ids.begin(), ids.end()};
}

std::vector<Source> sources_of(std::string_view id) {
  std::vector<Source> found;
  for_each_cited([&](std::string_view cited, const Source& source) {
    const bool is_there = std::ranges::find(found, source.title, &Source::title) != found.end();
    if (cited == id && !is_there) found.push_back(source);
  });
  return found;
}

}  // namespace shadefit
