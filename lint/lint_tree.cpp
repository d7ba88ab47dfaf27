#include "lint/lint_tree.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "lint/pins.hpp"
#include "lint/scan/characters.hpp"

namespace shadefit::lint {
namespace {

/// Finds lines and columns of a text, in rising order.
class PlaceFinder {
 public:
  explicit PlaceFinder(std::string_view text) : text_(text) {}

  TextPlace at(std::size_t offset) {
    if (offset < begin_) *this = PlaceFinder(text_);
    for (std::size_t end = text_.find('\n', begin_); end < offset; end = text_.find('\n', begin_)) {
      begin_ = end + 1;
      ++line_;
    }
    const std::string_view before = text_.substr(begin_, offset - begin_);
    // Bytes 10xxxxxx continue a code point.
    const auto points = std::ranges::count_if(before, [](char c) { return (c & 0xC0) != 0x80; });
    return {line_, points + 1};
  }

 private:
  std::string_view text_;
  std::size_t begin_ = 0;  ///< of the line
  long line_ = 1;
};

/// The reason in the first line of a site, in its last one, or in the line above.
std::optional<std::string> ignored_at(std::string_view text, std::size_t first, std::size_t last) {
  const std::size_t begin = line_begin(text, first);
  if (auto reason = ignore_reason(line_at(text, begin))) return reason;
  if (auto reason = ignore_reason(line_at(text, line_begin(text, last)))) return reason;
  return begin == 0 ? std::nullopt : ignore_reason(line_at(text, line_begin(text, begin - 1)));
}

/// Says where a site is in a file: at these bytes of its text.
void set_place(LintedSite& site, const std::string& file, std::string_view text, std::size_t begin,
               std::size_t end, PlaceFinder& places) {
  site.file = file;
  site.begin = places.at(begin);
  site.end = places.at(end);
  site.ignored = ignored_at(text, begin, end);
}

/// Removes pinned numbers from a site. True if anything is left to report.
bool leave_unpinned(LintedSite& site, const std::set<std::size_t>& pinned) {
  const std::size_t count =
      std::erase_if(site.numbers, [&](const LintedNumber& number) { return pinned.contains(number.offset); });
  return count == 0 || (!site.numbers.empty() &&
                        (!site.slip.empty() || std::ranges::any_of(site.numbers, [](const auto& number) {
                          return number.grade != Grade::right;
                        })));
}

}  // namespace

std::vector<LintedSite> lint_source(const std::string& file, std::string_view text, SourceLanguage language,
                                    const KnownConstants& known, const EffectLimits& limits,
                                    const Checkpoint& checkpoint, SkippedFiles* skipped) {
  std::vector<LintedSite> sites;
  std::set<std::size_t> pinned;
  PlaceFinder places(text);
  for (const Pin& pin : pins_of(text)) {
    if (!pin.number.empty()) pinned.insert(pin.number_offset);
    sites.push_back(judge_pin(pin, known.sets, limits));
    const bool is_faulty = sites.back().numbers.empty();
    const std::size_t begin = is_faulty ? pin.offset : pin.number_offset;
    set_place(sites.back(), file, text, begin, begin + (is_faulty ? pin.name : pin.number).size(), places);
  }
  for (LintedSite& site : judge_text(text, comments_of(language), known, limits, checkpoint)) {
    if (site.is_in_table) {
      if (skipped != nullptr) ++skipped->in_tables;
      continue;
    }
    const LintedNumber &first = site.numbers.front(), &last = site.numbers.back();
    set_place(site, file, text, first.offset, last.offset + last.text.size(), places);
    if (leave_unpinned(site, pinned)) sites.push_back(std::move(site));
  }
  std::ranges::stable_sort(sites, {}, &LintedSite::begin);
  return sites;
}

LintedTree lint_tree(const SourceTree& tree, const KnownConstants& known, const EffectLimits& limits,
                     const InParallel& how) {
  std::vector<LintedTree> found(tree.files.size());
  for_each_in_parallel(
      tree.files.size(),
      [&](std::size_t i, const Checkpoint& checkpoint) {
        const SourceFile& file = tree.files[i];
        const auto text = read_source(file, found[i].skipped);
        if (!text) return;
        found[i].files = 1;
        found[i].sites =
            lint_source(file.name, *text, file.language, known, limits, checkpoint, &found[i].skipped);
      },
      how);
  LintedTree linted{.sites = {}, .skipped = tree.skipped};
  for (LintedTree& one : found) {
    add(linted.skipped, one.skipped);
    linted.files += one.files;
    std::ranges::move(one.sites, std::back_inserter(linted.sites));
  }
  return linted;
}

}  // namespace shadefit::lint
