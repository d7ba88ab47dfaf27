#include "app/commands/commands.hpp"
#include "fit/support/known.hpp"
#include "reports/rows/citation.hpp"

namespace shadefit {

Outcome cite_command(const CiteOptions& options) {
  std::string out = bibtex_of_shadefit(SHADEFIT_VERSION);
  if (!options.id) return {0, out, ""};
  require_known(*options.id, cited_ids(), "claim, constant or family");
  for (const Source& source : sources_of(*options.id)) out += "\n" + bibtex(source);
  return {0, out, ""};
}

}  // namespace shadefit
