#include "bench/forms/swept_form.hpp"

#include <fmt/format.h>

#include <vector>

#include "bench/forms/kernels.hpp"
#include "fit/support/user_error.hpp"

namespace shadefit::bench {

FloatSubject subject_of(const forms::Catalogue& catalogue, const SweptForm& swept, int exp2_degree) {
  const forms::FormKernels* kernels = forms::find_kernels(swept.form->id, exp2_degree);
  if (kernels == nullptr)
    throw UserError(
        fmt::format("--exp2-degree '{}' does not apply to {}: a form with an exp2 has 0 and 2 to 6",
                    exp2_degree, swept.form->id));
  const forms::FormEntry& exact = forms::reference_of(catalogue, swept.target->id);
  const auto given = forms::parameters_of(*swept.target, *swept.constants);
  return {[form = kernels->in_float, parameters = std::vector<float>(given.begin(), given.end())](
              const float* in, float* out, std::size_t count) {
            form({.in = {in}, .out = out, .size = count}, parameters);
          },
          [truth = forms::find_kernels(exact.id)->in_double,
           parameters = forms::parameters_of(*swept.target, exact.constants.front())](
              const float* in, double* out, std::size_t count) {
            const std::vector<double> cosines(in, in + count);
            truth({.in = {cosines.data()}, .out = out, .size = count}, parameters);
          }};
}

}  // namespace shadefit::bench
