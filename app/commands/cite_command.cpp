#include "app/commands/commands.hpp"
#include "app/studies/find_study.hpp"
#include "fit/input/known.hpp"
#include "reports/rows/citation.hpp"

namespace shadefit {

Outcome cite_command(const CiteOptions& options, const Watched&) {
  std::vector<CitedWork> works;
  if (options.id) {
    std::vector<std::string> known = cited_ids();
    for (const Source& source : sources_of(*options.id)) works.push_back(work_of(source));
    if (works.empty()) {
      const auto folders = study_folders(options.studies);
      const auto study = find_study(*options.id, folders);
      for (const std::string& id : study_ids(folders)) known.push_back(id);
      if (!study) require_known(*options.id, known, "claim, constant, family or study");
      works = works_of(study->published);
    }
  }
  return {0, bibtex_of_shadefit(SHADEFIT_VERSION) + bibtex(works), ""};
}

}  // namespace shadefit
