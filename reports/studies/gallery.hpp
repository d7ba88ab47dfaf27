#pragma once

#include <string>
#include <vector>

#include "fit/better/better_study.hpp"
#include "fit/catalogue/study_file.hpp"
#include "reports/io/files.hpp"
#include "reports/io/table.hpp"

/// Studies side by side: a page with a table of all published constants, and a page for each study.
namespace shadefit {

/// A study with what was computed about it.
struct GalleryEntry {
  StudyFile file;
  std::vector<StudyComparison> comparisons;
};

/// All that the gallery needs of a study for its page and its rows in the tables.
struct JudgedStudy {
  std::string id;
  bool is_published;                    ///< whether it has published sets
  std::vector<std::vector<Cell>> rows;  ///< of `gallery_table`
  std::string page;                     ///< HTML
};

JudgedStudy judged_study(const GalleryEntry& entry);

/// The page of a study: what it approximates, each published set with its verdict, the errors as a picture,
/// the comparison, and code to copy.
std::string study_page(const GalleryEntry& entry);

/// A row for each published set: `id,form,source,used_in,verdict,error,published,instructions,best,ratio,
/// best_instructions,best_form,least,loses`. `best` keeps the properties of the published set. `least` is the
/// error of a fit with a smaller error that loses some of them.
Table gallery_table(const std::vector<JudgedStudy>& studies);

/// index.html, a page NAME.html for each study, and gallery.csv with the same rows.
std::vector<File> gallery_files(const std::vector<JudgedStudy>& studies);

}  // namespace shadefit
