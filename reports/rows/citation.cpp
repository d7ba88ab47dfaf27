#include "reports/rows/citation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/algorithm/string/replace.hpp>
#include <cctype>
#include <map>
#include <set>

#include "approx/ledger/catalogue.hpp"
#include "approx/ledger/ledger.hpp"
#include "reports/io/escape.hpp"

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

/// All letters and digits of a text, in lower case.
std::string letters_and_digits(std::string_view text) {
  std::string out;
  for (const char c : text) {
    const auto letter = static_cast<unsigned char>(c);
    if (std::isalnum(letter) != 0) out += static_cast<char>(std::tolower(letter));
  }
  return out;
}

/// BibTeX separates authors by "and".
std::string with_and(std::string_view authors) {
  return boost::replace_all_copy(std::string(authors), ", ", " and ");
}

/// "Kulla, Conty 2017, Revisiting ..": a name has at most two words, so that "pbrt-v4 of August 2020" and
/// "Eberly, as cited by Lagarde 2014" stay parts of a title.
struct NamedWork {
  std::string author, year, title;
};

bool are_names(const std::string& authors) {
  for (std::size_t from = 0; from <= authors.size();) {
    const std::size_t end = std::min(authors.find(" and ", from), authors.size());
    const std::string name = authors.substr(from, end - from);
    if (name.empty() || std::ranges::count(name, ' ') > 1) return false;
    from = end + 5;
  }
  return true;
}

NamedWork named_work(std::string_view text) {
  const auto is_digit = [](char c) { return '0' <= c && c <= '9'; };
  for (std::size_t at = text.find(", "); at != std::string_view::npos; at = text.find(", ", at + 1)) {
    if (at < 6 || text[at - 5] != ' ') continue;
    const std::string_view year = text.substr(at - 4, 4);
    const std::string author = with_and(text.substr(0, at - 5));
    if (std::ranges::all_of(year, is_digit) && are_names(author))
      return {author, std::string(year), std::string(text.substr(at + 2))};
  }
  return {"", "", std::string(text)};
}

/// Calls `use` with each id of the ledger and the catalogue and a source that it has.
template <class Use>
void for_each_cited(const Use& use) {
  for (const Topic& topic : ledger) {
    for (const Claim& claim : topic.claims) use(claim.id, claim.source);
  }
  for (const Published& published : published_constants) {
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

std::string bibtex(const Source& source) {
  const std::string address = address_of(source);
  std::string out =
      fmt::format("@misc{{{}{}{},\n  author = {{{}}},\n  title = {{{{{}}}}},\n  year = {{{}}},\n",
                  first_letters(source.author, 1), source.year, first_letters(source.title, 2),
                  with_and(source.author), source.title, source.year);
  if (!is_address(source.place)) out += fmt::format("  howpublished = {{{}}},\n", source.place);
  if (!address.empty()) out += fmt::format("  url = {{{}}},\n", address);
  return out + "}\n";
}

std::vector<std::string> bibtex_of_texts(const std::vector<OthersText>& sources) {
  std::map<std::string, int> uses;
  std::vector<std::string> entries;
  for (const OthersText& source : sources) {
    const auto [author, year, title] = named_work(source.unescaped());
    // Titles of code often begin with the same words.
    std::string key = author.empty() ? letters_and_digits(title)
                                     : first_letters(author, 1) + year + first_letters(title, 2);
    const int before = uses[key]++;
    if (before > 0)
      key += before < 26 ? std::string(1, static_cast<char>('a' + before)) : fmt::format("-{}", before);
    std::string entry = fmt::format("@misc{{{},\n", key);
    if (!author.empty()) entry += fmt::format("  author = {{{}}},\n", for_latex(author));
    entry += fmt::format("  title = {{{{{}}}}},\n", for_latex(title));
    if (!year.empty()) entry += fmt::format("  year = {{{}}},\n", year);
    entries.push_back(entry + "}\n");
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
