#include "app/exhaustive/swept_form.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "bench/tradeoff/measure.hpp"
#include "fit/support/known.hpp"
#include "fit/support/user_error.hpp"

namespace shadefit {
namespace {

const forms::FormEntry& find_form(const forms::Catalogue& catalogue, const std::string& id) {
  std::vector<std::string> known;
  for (const forms::FormEntry& form : catalogue.forms) {
    if (form.arguments == forms::Arguments::cosine) known.emplace_back(form.id);
    if (form.id != id) continue;
    if (form.arguments == forms::Arguments::cosine) return form;
    throw UserError(
        fmt::format("--exhaustive '{}' is not a form of one cosine: it reads {} of each element", id,
                    form.arguments == forms::Arguments::cosine_and_code ? "a gloss too" : "a normal"));
  }
  require_known(id, known, "form of one cosine");
  throw std::logic_error("a form that is known and was not found");
}

const forms::Constants& find_constants(const forms::FormEntry& form, const std::optional<std::string>& id) {
  if (!id) return form.constants.front();
  std::vector<std::string> known;
  for (const forms::Constants& constants : form.constants) {
    if (constants.id == *id) return constants;
    known.push_back(constants.id);
  }
  throw UserError(fmt::format("--constants '{}' is not a set of {}: it must be one of {}", *id, form.id,
                              fmt::join(known, ", ")));
}

/// The kernel of a form. Throws UserError for a degree that the form does not have.
const forms::CompiledForm find_kernel(std::span<const forms::CompiledForm> all, std::string_view form,
                                      int exp2_degree) {
  std::vector<int> known;
  for (const forms::CompiledForm& compiled : all) {
    if (compiled.form != form || compiled.in_float == nullptr) continue;
    if (compiled.exp2_degree == exp2_degree) return compiled;
    known.push_back(compiled.exp2_degree);
  }
  throw UserError(fmt::format("--exp2-degree '{}' is not compiled for {}: it must be one of {}", exp2_degree,
                              form, fmt::join(known, ", ")));
}

}  // namespace

SweptForm chosen_by(const forms::Catalogue& catalogue, const BenchOptions& options) {
  const forms::FormEntry& form = find_form(catalogue, *options.exhaustive);
  return {&form, &forms::target_of(catalogue, form.target), &find_constants(form, options.constants),
          options.exp2_degree, options.width.value_or(forms::Width::sse2)};
}

std::vector<SweptForm> all_of_one_cosine(const forms::Catalogue& catalogue) {
  std::vector<SweptForm> all;
  for (const forms::FormEntry& form : catalogue.forms) {
    if (form.arguments != forms::Arguments::cosine) continue;
    for (const forms::Constants& constants : form.constants)
      all.push_back({&form, &forms::target_of(catalogue, form.target), &constants});
  }
  return all;
}

std::string set_of(const SweptForm& form) {
  return form.constants->numbers.empty() ? "" : form.constants->id;
}

std::string words_of(const SweptForm& form) {
  const std::string set = set_of(form);
  return fmt::format("{}{}{}", form.form->id, set.empty() ? "" : ", ", set);
}

std::vector<float> in_float(const std::vector<double>& numbers) {
  return {numbers.begin(), numbers.end()};
}

bench::FloatSubject subject_of(const forms::Catalogue& catalogue, const SweptForm& chosen) {
  const auto form = find_kernel(forms::compiled_forms(chosen.width), chosen.form->id, chosen.exp2_degree);
  const auto exact = std::ranges::find_if(catalogue.forms, [&](const auto& other) {
    return other.target == chosen.target->id;  // the first form of a target is the target itself
  });
  const auto truth = find_kernel(forms::compiled_forms(forms::Width::scalar), exact->id, 0);
  const auto parameters = in_float(forms::parameters_of(*chosen.target, *chosen.constants));
  const auto given = forms::parameters_of(*chosen.target, exact->constants.front());
  return {[=](const float* in, float* out, std::size_t count) {
            form.in_float({.in = {in}, .out = out, .size = count}, parameters);
          },
          [=](const float* in, double* out, std::size_t count) {
            // In pieces that fit on the stack, because several threads run here at once.
            std::array<double, 256> cosines;
            for (std::size_t first = 0; first < count; first += cosines.size()) {
              const std::size_t piece = std::min(cosines.size(), count - first);
              std::copy_n(in + first, piece, cosines.begin());
              truth.in_double({.in = {cosines.data()}, .out = out + first, .size = piece}, given);
            }
          }};
}

}  // namespace shadefit
