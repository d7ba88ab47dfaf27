#include "app/studies/load_rows.hpp"

#include "fit/support/bounded_file.hpp"
#include "fit/support/user_error.hpp"

namespace shadefit {

void load_rows(StudyFile& file, const std::filesystem::path& table) {
  std::vector<std::string> variables;
  for (const StudyRange& range : file.study.over) variables.push_back(range.variable);
  const std::string text = read_bounded(table, most_row_bytes);
  file.study.rows = std::make_shared<const MeasuredRows>(read_measured_rows(text, table.string(), variables));
  if (file.study.rows->sigma.empty() || file.has_weight) return;
  if (file.study.error == Error::relative)
    throw UserError(
        "--error 'relative' needs a --weight, as the table has sigma: 1/sigma weights errors that are absolute");
  file.study.weight = "1/sigma";
}

}  // namespace shadefit
