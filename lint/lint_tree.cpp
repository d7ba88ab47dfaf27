#include "lint/lint_tree.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "lint/pins/judge_pin.hpp"

namespace shadefit::lint {
namespace {

CommentStyle comments_of(SourceLanguage language) {
  switch (language) {
    case SourceLanguage::python:
      return CommentStyle::hash;
    case SourceLanguage::markdown:
      return CommentStyle::none;
    case SourceLanguage::rust:
      return CommentStyle::rust;
    default:
      return CommentStyle::c;
  }
}

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
    const auto points =
        std::count_if(before.begin(), before.end(), [](char c) { return (c & 0xC0) != 0x80; });
    return {line_, points + 1};
  }

 private:
  std::string_view text_;
  std::size_t begin_ = 0;  ///< of the line
  long line_ = 1;
};

std::size_t line_begin(std::string_view text, std::size_t offset) {
  const std::size_t end = offset == 0 ? std::string_view::npos : text.rfind('\n', offset - 1);
  return end == std::string_view::npos ? 0 : end + 1;
}

std::string_view line_at(std::string_view text, std::size_t begin) {
  return text.substr(begin, text.find('\n', begin) - begin);
}

/// The reason in the first line of a site, in its last one, or in the line above.
std::optional<std::string> ignored_at(std::string_view text, std::size_t first, std::size_t last) {
  const std::size_t begin = line_begin(text, first);
  if (auto reason = ignore_reason(line_at(text, begin))) return reason;
  if (auto reason = ignore_reason(line_at(text, line_begin(text, last)))) return reason;
  return begin == 0 ? std::nullopt : ignore_reason(line_at(text, line_begin(text, begin - 1)));
}

LintedSite linted(const std::string& file, std::string_view text, const KnownSet& set,
                  const JudgedSite& judged, PlaceFinder& places) {
  const JudgedNumber &first = judged.numbers.front(), &last = judged.numbers.back();
  LintedSite site{.file = file,
                  .begin = places.at(first.offset),
                  .end = places.at(last.offset + last.length),
                  .id = set.id,
                  .form = set.form,
                  .times = set.times,
                  .source = set.source,
                  .numbers = {},
                  .grade = judged.graded.grade,
                  .effect = judged.graded.effect,
                  .is_shown = judged.graded.is_shown,
                  .slip = judged.slip,
                  .replaced = judged.replaced,
                  .is_in_comment = judged.is_in_comment,
                  .ignored = ignored_at(text, first.offset, last.offset)};
  for (const JudgedNumber& number : judged.numbers) {
    const KnownConstant& constant = set.constants[number.constant];
    const auto text_of = [&](const NumberPlace& place) {
      return std::string(text.substr(place.offset, place.length));
    };
    site.numbers.push_back({constant.name, constant.printed, text_of(number), number.grade, number.offset,
                            number.evidence != NumberEvidence::none});
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
  const std::size_t first = is_faulty ? pin.offset : pin.number_offset;
  const std::size_t length = is_faulty ? pin.name.size() : pin.number.size();
  LintedSite site;
  site.file = file;
  site.begin = places.at(first);
  site.end = places.at(first + length);
  site.is_pinned = true;
  site.ignored = ignored_at(text, first, first);
  if (is_faulty) {
    site.id = pin.name;
    site.grade = Grade::wrong;
    site.fault = judged.fault;
    return site;
  }
  const KnownSet& set = sets[judged.set];
  const KnownConstant& constant = set.constants[judged.constant];
  site.id = set.id;
  site.form = set.form;
  site.source = set.source;
  site.grade = judged.graded.grade;
  site.effect = judged.graded.effect;
  site.is_shown = judged.graded.is_shown;
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
                        (!site.slip.empty() ||
                         std::any_of(site.numbers.begin(), site.numbers.end(),
                                     [](const auto& number) { return number.grade != Grade::right; })));
}

}  // namespace

std::vector<LintedSite> lint_source(const std::string& file, std::string_view text, SourceLanguage language,
                                    const KnownConstants& known, const EffectLimits& limits,
                                    const Checkpoint& checkpoint) {
  SkippedFiles skipped;
  return lint_source(file, text, language, known, limits, skipped, checkpoint);
}

std::vector<LintedSite> lint_source(const std::string& file, std::string_view text, SourceLanguage language,
                                    const KnownConstants& known, const EffectLimits& limits,
                                    SkippedFiles& skipped, const Checkpoint& checkpoint) {
  std::vector<LintedSite> sites;
  std::set<std::size_t> pinned;
  PlaceFinder places(text);
  for (const Pin& pin : pins_of(text)) {
    if (!pin.number.empty()) pinned.insert(pin.number_offset);
    sites.push_back(linted(file, text, known.sets, judge_pin(pin, known.sets, limits), places));
  }
  for (const JudgedSite& judged : judge_text(text, comments_of(language), known, limits, checkpoint)) {
    if (judged.is_in_table) {
      ++skipped.in_tables;
      continue;
    }
    LintedSite site = linted(file, text, known.sets[judged.set], judged, places);
    if (leave_unpinned(site, pinned)) sites.push_back(std::move(site));
  }
  std::stable_sort(sites.begin(), sites.end(), [](const LintedSite& a, const LintedSite& b) {
    return std::pair(a.begin.line, a.begin.column) < std::pair(b.begin.line, b.begin.column);
  });
  return sites;
}

std::size_t count_pieces(const SourceTree& tree) {
  return (tree.files.size() + files_of_a_piece - 1) / files_of_a_piece;
}

LintedTree lint_tree(const SourceTree& tree, const KnownConstants& known, const EffectLimits& limits,
                     const InParallel& how) {
  struct OfFile {
    std::vector<LintedSite> sites;
    std::optional<std::uintmax_t> bytes;
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
          found[i].bytes = text->size();
          found[i].sites =
              lint_source(file.name, *text, file.language, known, limits, found[i].skipped, checkpoint);
        }
      },
      how);
  LintedTree linted{.sites = {}, .skipped = tree.skipped};
  for (OfFile& one : found) {
    add(linted.skipped, one.skipped);
    if (one.bytes) {
      ++linted.files;
      linted.bytes += *one.bytes;
    }
    std::move(one.sites.begin(), one.sites.end(), std::back_inserter(linted.sites));
  }
  return linted;
}

}  // namespace shadefit::lint
