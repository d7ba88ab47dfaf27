#include <algorithm>
#include <stdexcept>

#include "fit/catalogue/family.hpp"
#include "fit/catalogue/read_families.hpp"
#include "studies/catalogue_files.hpp"

namespace shadefit {
namespace {

const Catalogue& catalogue() {
  static const Catalogue read = [] {
    Catalogue all;
    for (const EmbeddedFile& file : catalogue_files)
      read_families(std::string(file.text), std::string(file.name), all);
    return all;
  }();
  return read;
}

}  // namespace

std::span<const Family> families() {
  return catalogue().families;
}

std::span<const Published> published_constants() {
  return catalogue().published;
}

const Published* find_published(std::string_view id) {
  const auto all = published_constants();
  const auto found = std::ranges::find(all, id, &Published::id);
  return found == all.end() ? nullptr : &*found;
}

std::size_t parameter_index(const Family& family, std::string_view name) {
  const auto found = std::ranges::find(family.parameters, name);
  if (found == family.parameters.end())
    throw std::logic_error("a record names a parameter that its family lacks");
  return static_cast<std::size_t>(found - family.parameters.begin());
}

const Family* find_family(std::string_view id) {
  const auto all = families();
  const auto found = std::ranges::find(all, id, &Family::id);
  return found == all.end() ? nullptr : &*found;
}

}  // namespace shadefit
