#include "fit/formula/definition.hpp"

#include <algorithm>
#include <functional>

#include "fit/scalars/integral.hpp"

namespace shadefit {
namespace {

/// The size of what stands for a name.
using SizeOfName = std::function<std::size_t(const std::string&)>;

std::size_t size_of(const Symbolic& formula, const SizeOfName& size_of_name, std::size_t before = 0) {
  if (formula.kind() == Symbolic::Kind::variable) return before + size_of_name(formula.name());
  if (formula.kind() == Symbolic::Kind::integral) {
    const std::size_t body = size_of(formula.part(0), size_of_name);
    return size_of(formula.part(2), size_of_name,
                   size_of(formula.part(1), size_of_name, before + integral_nodes * body));
  }
  std::size_t size = before + 1;
  for (const Symbolic& part : formula.parts()) {
    if (size > most_operations) break;
    size = size_of(part, size_of_name, size);
  }
  return size;
}

/// The index of a name among the arguments. For any other name it is the number of arguments.
std::size_t place_of(const std::string& name, const Definition& definition) {
  const auto& all = definition.arguments;
  return static_cast<std::size_t>(std::find(all.begin(), all.end(), name) - all.begin());
}

}  // namespace

std::size_t size_of(const Symbolic& formula) {
  return size_of(formula, [](const std::string&) { return std::size_t{1}; });
}

std::size_t size_of(const Definition& definition, std::span<const Symbolic> given) {
  std::vector<std::size_t> sizes;
  for (const Symbolic& argument : given) sizes.push_back(size_of(argument));
  sizes.push_back(1);  // any other name counts as one
  return size_of(definition.formula,
                 [&](const std::string& name) { return sizes[place_of(name, definition)]; });
}

Symbolic put_in(const Definition& definition, std::span<const Symbolic> given) {
  return evaluate<Symbolic>(definition.formula, [&](const std::string& name) {
    const std::size_t place = place_of(name, definition);
    return place < given.size() ? given[place] : Symbolic::variable(name);
  });
}

}  // namespace shadefit
