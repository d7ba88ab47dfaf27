#include "reports/studies/gallery.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <sstream>

#include "fit/better/prove_contenders.hpp"
#include "fit/bounds/study_certificate.hpp"
#include "fit/support/user_error.hpp"
#include "reports/code/shader_code.hpp"
#include "reports/figures/pictures.hpp"
#include "reports/io/escape.hpp"
#include "reports/io/joined.hpp"
#include "reports/studies/html.hpp"
#include "reports/studies/study_comparison.hpp"
#include "reports/studies/study_extras.hpp"
#include "reports/studies/study_report.hpp"
#include "reports/studies/study_rows.hpp"

namespace shadefit {
namespace {

std::string facts(const std::vector<OthersText>& lines) {
  std::string out = "<ul class=\"facts\">\n";
  for (const OthersText& line : lines) out += fmt::format("<li>{}</li>\n", for_html(line));
  return out + "</ul>\n";
}

/// The contenders of the picture: the first published set of the file, and what is better at its cost.
std::vector<const StudyContender*> shown(const StudyComparison& comparison) {
  if (comparison.contenders.empty()) return {};
  const StudyContender* published = first_published(comparison);
  if (published == nullptr) return {&comparison.contenders.front()};
  std::vector<const StudyContender*> contenders{published};
  if (const auto* best = better_at_the_same_cost(comparison, *published)) contenders.push_back(best);
  return contenders;
}

OthersText words_of(const StudyContender& contender) {
  return contender.published != nullptr
             ? "as published: " + short_source(contender.origin)
             : "better at no more instructions: " + contender.form + ", " + contender.origin;
}

/// ", g = 0.5": the given constants of a comparison, to follow a heading.
std::string behind(const StudyComparison& comparison) {
  const std::string given = given_text(comparison.study);
  return for_html(given.empty() ? given : ", " + given);
}

/// The heading of a figure, with the id that addresses name: ID.html#error, or ID.html#error-g-0.3 for a
/// given constant.
std::string figure_heading(const char* id, const std::string& text, const StudyComparison& comparison) {
  OthersText whole = std::string(id);
  for (const auto& [name, value] : comparison.study.given) whole += "-" + name + "-" + value;
  return fmt::format("<h2 id=\"{}\">{}{}</h2>\n", for_html(whole), text, behind(comparison));
}

std::string keys_of(const std::vector<const StudyContender*>& contenders) {
  std::string keys;
  for (std::size_t i = 0; i < contenders.size(); ++i)
    keys += fmt::format("<li class=\"key-{}\">{}{}</li>\n", i + 1,
                        i == 0 ? "solid: " : "dashed: ", for_html(words_of(*contenders[i])));
  return "<ul>\n" + keys + "</ul>\n";
}

/// "x, at r = 0.446, where the published values are off by the most codes".
std::string line_in_words(const StudyComparison& comparison, const std::optional<double>& y) {
  const std::string& first = comparison.variables.front();
  if (!y) return first;
  return fmt::format("{}, at {} = {}, where the published values are off by the most codes", first,
                     comparison.variables[1], in_digits(*y, 3));
}

std::string ramps(const StudyComparison& comparison, const std::vector<const StudyContender*>& contenders) {
  const auto [svg, line] = grey_ramps(comparison, contenders);
  if (svg.empty()) return "";
  return figure_heading("greys", "As greys", comparison) + svg +
         fmt::format("<p class=\"soft\">Left to right over {}. {}</p>\n", line_in_words(comparison, line),
                     comparison.is_encoded
                         ? "Values are a signal for a display: 255 times a value is its code."
                         : "Values are linear, shown in 8-bit sRGB.");
}

/// The error of one variable as curves, of two as maps.
std::string picture(const StudyComparison& comparison) {
  const auto contenders = shown(comparison);
  if (const std::string curves = error_curve_svg(comparison, contenders); !curves.empty())
    return figure_heading("error", "Error curve: " + curve_in_words(comparison.error), comparison) + curves +
           keys_of(contenders) + ramps(comparison, contenders);
  const std::string maps = heat_map_svg(comparison, contenders);
  if (maps.empty()) return "";
  OthersText words =
      std::string("Blue is too large, red too small; the strongest colour is the largest error of both.");
  if (contenders.size() > 1) words += " Right: " + words_of(*contenders[1]) + ".";
  return figure_heading("error", "Error map", comparison) + maps +
         fmt::format("<p>{}</p>\n", for_html(words)) + ramps(comparison, contenders);
}

std::string evidence_in_words(const ContenderInFormat& in_format) {
  using Evidence = ContenderInFormat::Evidence;
  if (in_format.evidence == Evidence::none) return in_format.reason;
  if (in_format.evidence == Evidence::proven) return "proven";
  return in_format.evidence == Evidence::every_row ? "every row"
                                                   : fmt::format("every {} of the range", in_format.format);
}

/// The rows of one contender: its constants in float and in half, and its errors there.
void append_formats(const StudyContender& contender, Table& table) {
  constexpr int digits = 4;  // the proven bounds are as wide
  for (const ContenderInFormat& in_format : contender.formats) {
    const bool is_bounded = in_format.evidence != ContenderInFormat::Evidence::none;
    table.rows.push_back({contender.published != nullptr ? "published"
                          : in_format.is_moved           ? "searched in half"
                                                         : "better",
                          contender.form, word(in_format.format), equations(in_format.constants),
                          is_bounded ? at_most(in_format.bound, digits) : Cell{},
                          evidence_in_words(in_format)});
  }
}

/// Why a page has no constants in float and half; empty if nothing speaks against them.
std::string without_formats(const StudyComparison& comparison) {
  const StudyContender* published = first_published(comparison);
  const std::string reason = published == nullptr ? "the study has no published set"
                                                  : fault_of(subject_of(comparison.study, *published));
  if (reason.empty()) return "";
  return fmt::format(
      "<h2>In float and half{}</h2>\n<p>The constants are not rounded to float and half: {}.</p>\n",
      behind(comparison), for_html(reason));
}

std::string formats(const StudyComparison& comparison) {
  Table table{
      {"set", "form", "format", "constants", error_in_words(comparison.error) + " at most", "known by"}, {}};
  bool has_search = false;
  for (const StudyContender* contender : shown(comparison)) {
    append_formats(*contender, table);
    for (const ContenderInFormat& in_format : contender->formats)
      has_search = has_search || in_format.is_moved;
  }
  if (table.rows.empty()) return without_formats(comparison);
  return fmt::format(
      "<h2>In float and half{}</h2>\n{}<p class=\"soft\">All constants, numbers, operations and functions are rounded to nearest.{}</p>\n",
      behind(comparison), html_table(table, false),
      has_search ? " The search keeps exact ends; other properties may be lost." : "");
}

/// Code line by line.
std::string html_of_code(const std::string& code) {
  std::istringstream lines(code);
  std::string html;
  for (std::string line; std::getline(lines, line);) html += for_html(line) + "\n";
  return html;
}

/// The best contender of the first target as code, in each language that has its functions.
std::string code_of(const GalleryEntry& entry) {
  const StudyComparison& comparison = entry.comparisons.front();
  const auto contenders = shown(comparison);
  if (contenders.empty()) return "";
  const StudyContender& best = *contenders.back();
  ShaderFunction function{entry.file.id, comparison.variables, best.code};
  std::ranges::replace(function.name, '-', '_');
  std::vector<OthersText> comment{best.formula, words_of(best)};
  if (const std::string given = given_text(comparison.study); !given.empty()) comment.push_back(given);
  std::string options, blocks;
  for (const Language language : languages) {
    std::string code;
    try {
      const std::array functions{function};
      code = shader_code(functions, language, ShaderPrecision::float32, comment);
    } catch (const UserError&) {
      continue;  // the language lacks a function
    }
    options += fmt::format("<option>{}</option>", name(language));
    blocks += fmt::format(
        "<div class=\"code\" data-language=\"{}\"><button type=\"button\">copy</button><pre>{}</pre></div>\n",
        name(language), html_of_code(code));
  }
  return fmt::format(
      "<h2>Code{}</h2>\n<p><label>Language <select autocomplete=\"off\">{}</select></label> <span class=\"soft\">{}</span></p>\n{}",
      behind(comparison), options, for_html(words_of(best)), blocks);
}

}  // namespace

std::string study_page(const GalleryEntry& entry) {
  std::string body = fmt::format("<p><a href=\"index.html\">All constants</a></p>\n<h1>{}</h1>\n",
                                 for_html(study_title(entry.file)));
  body += facts(study_statement(entry.file));
  for (const PublishedSet& set : entry.file.published) {
    const auto lines = published_lines(set, entry.comparisons);
    body += fmt::format("<h2>{}</h2>\n", for_html(lines.front()));
    body += facts({lines.begin() + 1, lines.end()});
  }
  for (const StudyComparison& comparison : entry.comparisons) {
    body += picture(comparison);
    body += formats(comparison);
    body += fmt::format("<h2>{}</h2>\n{}", "All forms compared" + behind(comparison),
                        html_table(study_comparison_table(comparison), false));
    if (!comparison.left_out.empty())
      body += "<h2>Fits that did not converge</h2>\n" +
              facts({comparison.left_out.begin(), comparison.left_out.end()});
  }
  body += fmt::format(
      "<p class=\"soft\">{} The largest errors are sampled. <code>beats</code> names published rows with a larger error at no fewer instructions.</p>\n",
      for_html(std::string(proven_in_words)));
  body += code_of(entry);
  return html_page(study_title(entry.file), body);
}

}  // namespace shadefit
