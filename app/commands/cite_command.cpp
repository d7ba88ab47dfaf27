#include <algorithm>

#include "app/commands/commands.hpp"
#include "app/studies/find_study.hpp"
#include "fit/support/known.hpp"
#include "reports/rows/citation.hpp"

namespace shadefit {

Outcome cite_command(const CiteOptions& options) {
  std::string out = bibtex_of_shadefit(SHADEFIT_VERSION);
  if (!options.id) return {0, out, ""};
  std::vector<std::string> known = cited_ids();
  const bool is_built_in = std::ranges::find(known, *options.id) != known.end();
  for (const Source& source : sources_of(*options.id)) out += "\n" + bibtex(source);
  if (is_built_in) return {0, out, ""};
  const auto folders = study_folders(options.studies);
  const auto study = find_study(*options.id, folders);
  for (const std::string& id : study_ids(folders)) known.push_back(id);
  if (!study) require_known(*options.id, known, "claim, constant, family or study");
  for (const std::string& entry : bibtex_of_sets(study->published)) out += "\n" + entry;
  return {0, out, ""};
}

}  // namespace shadefit
