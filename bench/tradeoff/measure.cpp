#include "bench/tradeoff/measure.hpp"

#include <algorithm>
#include <map>
#include <memory>
#include <tuple>
#include <utility>

#include "bench/timing/workload.hpp"

namespace shadefit::bench {
namespace {

/// A timed kernel, without its constants: the common part of its rows.
struct Timed {
  TimedForm row;
  const forms::FormEntry* form;  ///< null: a floor
};

/// Long arrays, and the start of the next call.
template <class Real>
struct Memory {
  Workload<Real> arrays;
  std::size_t next = 0;

  forms::Arrays<Real> slice() {
    const std::size_t first = next;
    next = (next + memory_slice) % (arrays.size() / memory_slice * memory_slice);
    return arrays.slice(first, memory_slice);
  }
};

/// The arrays of all targets of a precision, made when they are first needed. Targets with the same inputs
/// share them. Long arrays, of which there should be few, hold cosines in [0, 1] and codes, or normals.
template <class Real>
class Workloads {
 public:
  explicit Workloads(std::size_t last_cache) : bytes_(memory_bytes(last_cache)) {}

  std::shared_ptr<Workload<Real>> in_cache(const forms::Target& target) {
    auto& found = near_[{target.arguments, target.from, target.to}];
    if (!found) {
      found = std::make_shared<Workload<Real>>(target, first_cache_elements(target.arguments, sizeof(Real)));
    }
    return found;
  }
  std::shared_ptr<Memory<Real>> in_memory(const forms::Target& target) {
    const bool has_normals = target.arguments == forms::Arguments::normal_to_lights;
    auto& found = far_[has_normals];
    if (!found) {
      const forms::Target like{
          .id = {},
          .text = {},
          .arguments = has_normals ? forms::Arguments::normal_to_lights : forms::Arguments::cosine_and_code,
          .parameters = {}};
      const std::size_t size = bytes_ / sizeof(Real) / (has_normals ? 2 : 1);
      found = std::make_shared<Memory<Real>>(Memory<Real>{Workload<Real>(like, size)});
    }
    return found;
  }

 private:
  std::size_t bytes_;
  std::map<std::tuple<forms::Arguments, double, double>, std::shared_ptr<Workload<Real>>> near_;
  std::map<bool, std::shared_ptr<Memory<Real>>> far_;
};

template <class Real>
Work work_of(forms::Kernel<Real> kernel, const forms::Target& target, std::vector<Real> parameters,
             DataPlace place, Workloads<Real>& workloads) {
  if (place == DataPlace::first_cache) {
    const auto arrays = workloads.in_cache(target);
    const std::size_t size = arrays->size();
    return {[=] {
              const auto all = arrays->slice(0, size);
              kernel(all, parameters);
              keep(all.out);
            },
            size};
  }
  const auto memory = workloads.in_memory(target);
  return {[=] {
            const auto slice = memory->slice();
            kernel(slice, parameters);
            keep(slice.out);
          },
          memory_slice, false};
}

/// The timed work, in the order of the catalogue.
class Programme {
 public:
  Programme(const forms::Catalogue& catalogue, const WantedForms& wanted, std::size_t last_cache)
      : has_little_memory_(wanted.has_little_memory), floats_(last_cache), doubles_(last_cache) {
    for (const forms::Width width : wanted.widths) {
      const auto compiled = forms::compiled_forms(width);
      for (const char* floor : {forms::Copy::id, forms::MultiplyAdds::id})
        add_all(compiled, floor, catalogue.targets.front(), nullptr, width);
      for (const forms::FormEntry& form : catalogue.forms) {
        if (forms::is_wanted(wanted.targets, form.target))
          add_all(compiled, form.id, forms::target_of(catalogue, form.target), &form, width);
      }
    }
  }

  std::vector<Timed> timed;
  std::vector<Work> work;

 private:
  /// Every version of a form at a width.
  void add_all(std::span<const forms::CompiledForm> compiled, std::string_view id,
               const forms::Target& target, const forms::FormEntry* form, forms::Width width) {
    for (const forms::CompiledForm& version : compiled) {
      if (version.form != id) continue;
      const auto given =
          form == nullptr ? std::vector<double>{} : forms::parameters_of(target, form->constants.front());
      add(version, version.in_float, target, form, given, width, DataPlace::first_cache, floats_);
      add(version, version.in_double, target, form, given, width, DataPlace::first_cache, doubles_);
      if (!has_little_memory_ || target.arguments != forms::Arguments::normal_to_lights)
        add(version, version.in_float, target, form, given, width, DataPlace::memory, floats_);
      if (!has_little_memory_)
        add(version, version.in_double, target, form, given, width, DataPlace::memory, doubles_);
    }
  }

  template <class Real>
  void add(const forms::CompiledForm& version, forms::Kernel<Real> kernel, const forms::Target& target,
           const forms::FormEntry* form, const std::vector<double>& given, forms::Width width,
           DataPlace place, Workloads<Real>& workloads) {
    if (kernel == nullptr) return;
    TimedForm row;
    row.target = form == nullptr ? "" : target.id;
    row.form = version.form;
    row.exp2_degree = version.exp2_degree;
    row.is_double = sizeof(Real) == sizeof(double);
    row.width = width;
    row.place = place;
    timed.push_back({row, form});
    std::vector<Real> parameters;
    for (const double value : given) parameters.push_back(static_cast<Real>(value));
    work.push_back(work_of(kernel, target, std::move(parameters), place, workloads));
  }

  bool has_little_memory_;
  Workloads<float> floats_;
  Workloads<double> doubles_;
};

/// "sg, published-sg-offset-mean, exp2 of degree 3".
std::string label_of(const TimedForm& row) {
  std::string label = row.form;
  if (row.constants != "none" && !row.constants.empty()) label += ", " + row.constants;
  if (row.exp2_degree > 0) label += ", exp2 of degree " + std::to_string(row.exp2_degree);
  return label;
}

std::optional<double> error_of(const std::vector<FormError>& errors, const TimedForm& row) {
  for (const FormError& error : errors) {
    if (error.target == row.target && error.form == row.form && error.constants == row.constants &&
        error.exp2_degree == row.exp2_degree && error.is_double == row.is_double)
      return error.max_abs_error;
  }
  return std::nullopt;
}

}  // namespace

Trade measure(const forms::Catalogue& catalogue, const std::vector<FormError>& errors,
              const WantedForms& wanted, const Clock& clock, const std::function<void(double)>& between) {
  Trade trade;
  trade.machine = this_machine();
  trade.widths = wanted.widths;
  const Programme programme(catalogue, wanted, trade.machine.last_cache);
  const auto samples = time_interleaved(programme.work, wanted.plan, clock, between);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    TimedForm row = programme.timed[i].row;
    row.take(samples[i], programme.work[i]);
    const forms::FormEntry* form = programme.timed[i].form;
    if (form == nullptr) {
      row.label = row.form;
      trade.copies.push_back(std::move(row));
      continue;
    }
    row.is_reference = form == &forms::reference_of(catalogue, form->target);
    for (const forms::Constants& constants : form->constants) {
      row.constants = constants.id;
      row.label = label_of(row);
      row.max_abs_error = error_of(errors, row);
      trade.forms.push_back(row);
    }
  }
  for (const forms::Target& target : catalogue.targets) {
    const bool is_timed = std::ranges::find(trade.forms, target.id, &TimedForm::target) != trade.forms.end();
    if (is_timed) {
      trade.targets.push_back(
          {std::string(target.id), std::string(target.id) + ": " + std::string(target.text)});
    }
  }
  relate(trade);
  trade.goals = goals_of(trade);
  return trade;
}

}  // namespace shadefit::bench
