#include "bench/forms/swept_form.hpp"

#include <algorithm>
#include <vector>

#include "bench/forms/kernels.hpp"

namespace shadefit::bench {

FloatSubject subject_of(const SweptForm& swept) {
  const forms::FormEntry& exact = swept.target->forms.front();
  const auto given = forms::parameters_of(*swept.target, *swept.constants);
  return {[form = forms::kernels_of(swept.form->id).front().in_float,
           parameters = std::vector<float>(given.begin(), given.end())](const float* in, float* out,
                                                                        std::size_t count) {
            std::ranges::copy(form({{in, in + count}}, parameters), out);
          },
          [truth = forms::kernels_of(exact.id).front().in_double,
           parameters = forms::parameters_of(*swept.target, exact.constants.front())](
              const float* in, double* out, std::size_t count) {
            std::ranges::copy(truth({{in, in + count}}, parameters), out);
          }};
}

}  // namespace shadefit::bench
