#include "app/lint/lint_fix.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <system_error>

#include "fit/support/bounded_file.hpp"
#include "fit/support/user_error.hpp"
#include "reports/io/output.hpp"

namespace shadefit {
namespace {

namespace fs = std::filesystem;

using SitesByFile = std::map<std::string, std::vector<lint::LintedSite>>;

SitesByFile by_file(const std::vector<lint::LintedSite>& sites) {
  SitesByFile files;
  for (const lint::LintedSite& site : sites) files[site.file].push_back(site);
  return files;
}

/// Throws UserError unless each number still stands where it was found.
void require_unchanged(const std::string& name, const std::string& text,
                       const std::vector<lint::LintedSite>& sites) {
  const auto require = [&](std::size_t offset, const std::string& number) {
    if (offset > text.size() || text.compare(offset, number.size(), number) != 0)
      throw UserError(fmt::format("'{}' changed while it was read: run lint again", name));
  };
  for (const lint::LintedSite& site : sites) {
    for (const lint::LintedNumber& number : site.numbers) {
      require(number.offset, number.text);
      for (const lint::NumberCopy& copy : number.copies) require(copy.offset, copy.text);
    }
  }
}

}  // namespace

std::vector<FixedFile> fixed_files(const lint::LintedTree& tree, lint::FixScope scope) {
  std::vector<FixedFile> files;
  for (const auto& [name, sites] : by_file(tree.sites)) {
    const bool is_right = std::all_of(sites.begin(), sites.end(), [](const lint::LintedSite& site) {
      return site.grade == lint::Grade::right;
    });
    if (is_right) continue;
    FixedFile file{.name = name, .before = read_bounded(name, lint::largest_source), .after = {}};
    require_unchanged(name, file.before, sites);
    const std::vector<lint::Fix> fixes = lint::fixes_of(sites, file.before, scope);
    file.after = lint::fixed_text(file.before, fixes);
    file.numbers = fixes.size();
    if (file.numbers > 0) files.push_back(std::move(file));
  }
  return files;
}

void judge_again(lint::LintedTree& tree, const std::vector<FixedFile>& files, const lint::SourceTree& sources,
                 const lint::KnownConstants& known, const lint::EffectLimits& limits,
                 const Checkpoint& checkpoint) {
  SitesByFile left = by_file(tree.sites);
  for (const FixedFile& file : files) {
    const auto source = std::find_if(sources.files.begin(), sources.files.end(),
                                     [&](const lint::SourceFile& one) { return one.name == file.name; });
    left[file.name] = lint_source(file.name, file.after, source->language, known, limits, checkpoint);
  }
  tree.sites.clear();
  for (auto& [name, sites] : left) std::move(sites.begin(), sites.end(), std::back_inserter(tree.sites));
}

std::function<void()> prepare_files(const std::vector<FixedFile>& files, const Checkpoint& checkpoint) {
  std::map<fs::path, std::vector<File>> by_folder;
  for (const FixedFile& file : files) {
    std::error_code error;
    const fs::path path = fs::canonical(file.name, error);
    if (error) throw UserError(fmt::format("cannot write '{}': {}", file.name, error.message()));
    by_folder[path.parent_path()].push_back({path.filename().string(), file.after});
  }
  std::vector<std::shared_ptr<Output>> outputs;
  for (const auto& [folder, of_folder] : by_folder) {
    outputs.push_back(std::make_shared<Output>(folder));
    outputs.back()->prepare(of_folder, {}, Foreign::replaced, checkpoint);
  }
  return [outputs] {
    for (const auto& output : outputs) output->put();
  };
}

}  // namespace shadefit
