#include "lint/lint_tree.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "lint/pins.hpp"
#include "lint/scan/characters.hpp"

namespace shadefit::lint {
namespace {

/// Most files take microseconds.
constexpr std::size_t files_of_a_piece = 32;

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

/// A site between two numbers of a file.
LintedSite site_between(const std::string& file, std::string_view text, const NumberPlace& first,
                        const NumberPlace& last, PlaceFinder& places) {
  LintedSite site;
  site.file = file;
  site.begin = places.at(first.offset);
  site.end = places.at(last.offset + last.length);
  site.ignored = ignored_at(text, first.offset, last.offset);
  return site;
}

void add_set(LintedSite& site, const KnownSet& set, const GradedSite& graded) {
  site.id = set.id;
  site.form = set.form;
  site.source = set.source;
  site.grade = graded.grade;
  site.effect = graded.effect;
  site.is_shown = graded.is_shown;
  site.is_encoded = set.is_encoded;
}

LintedSite linted(const std::string& file, std::string_view text, const KnownSet& set,
                  const JudgedSite& judged, PlaceFinder& places) {
  LintedSite site = site_between(file, text, judged.numbers.front(), judged.numbers.back(), places);
  add_set(site, set, judged.graded);
  site.slip = judged.slip;
  site.replaced = judged.replaced;
  site.is_in_comment = judged.is_in_comment;
  for (const JudgedNumber& number : judged.numbers) {
    const KnownConstant& constant = set.constants[number.constant];
    const auto text_of = [&](const NumberPlace& place) {
      return std::string(text.substr(place.offset, place.length));
    };
    site.numbers.push_back(
        {constant.name, constant.printed, text_of(number), number.grade, number.offset, number.is_certain});
    for (const NumberPlace& copy : number.copies)
      site.numbers.back().copies.push_back({copy.offset, text_of(copy)});
  }
  return site;
}

/// A mark as a site: at its number, or at its name if it pins no number.
LintedSite linted(const std::string& file, std::string_view text, const std::vector<KnownSet>& sets,
                  const JudgedPin& judged, PlaceFinder& places) {
  const Pin& pin = judged.pin;
  const bool is_faulty = !judged.fault.empty();
  const NumberPlace place = is_faulty ? NumberPlace{pin.offset, pin.name.size()}
                                      : NumberPlace{pin.number_offset, pin.number.size()};
  LintedSite site = site_between(file, text, place, place, places);
  site.is_pinned = true;
  if (is_faulty) {
    site.id = pin.name;
    site.grade = Grade::wrong;
    site.fault = judged.fault;
    return site;
  }
  const KnownSet& set = sets[judged.set];
  const KnownConstant& constant = set.constants[judged.constant];
  add_set(site, set, judged.graded);
  site.replaced = judged.replaced;
  site.numbers = {
      {constant.name, constant.printed, std::string(pin.number), judged.digits, pin.number_offset, true}};
  return site;
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
    sites.push_back(linted(file, text, known.sets, judge_pin(pin, known.sets, limits), places));
  }
  for (const JudgedSite& judged : judge_text(text, comments_of(language), known, limits, checkpoint)) {
    if (judged.is_in_table) {
      if (skipped != nullptr) ++skipped->in_tables;
      continue;
    }
    LintedSite site = linted(file, text, known.sets[judged.set], judged, places);
    if (leave_unpinned(site, pinned)) sites.push_back(std::move(site));
  }
  std::ranges::stable_sort(sites, {}, &LintedSite::begin);
  return sites;
}

std::size_t count_pieces(const SourceTree& tree) {
  return (tree.files.size() + files_of_a_piece - 1) / files_of_a_piece;
}

LintedTree lint_tree(const SourceTree& tree, const KnownConstants& known, const EffectLimits& limits,
                     const InParallel& how) {
  struct OfFile {
    std::vector<LintedSite> sites;
    bool is_read = false;
    SkippedFiles skipped;
  };
  std::vector<OfFile> found(tree.files.size());
  for_each_in_parallel(
      count_pieces(tree),
      [&](std::size_t piece, const Checkpoint& checkpoint) {
        const std::size_t first = piece * files_of_a_piece;
        for (std::size_t i = first; i < std::min(first + files_of_a_piece, tree.files.size()); ++i) {
          checkpoint();
          const SourceFile& file = tree.files[i];
          const auto text = read_source(file, found[i].skipped);
          if (!text) continue;
          found[i].is_read = true;
          found[i].sites =
              lint_source(file.name, *text, file.language, known, limits, checkpoint, &found[i].skipped);
        }
      },
      how);
  LintedTree linted{.sites = {}, .skipped = tree.skipped};
  for (OfFile& one : found) {
    add(linted.skipped, one.skipped);
    if (one.is_read) ++linted.files;
    std::ranges::move(one.sites, std::back_inserter(linted.sites));
  }
  return linted;
}

}  // namespace shadefit::lint
