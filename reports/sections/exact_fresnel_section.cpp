#include "reports/sections/sections.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "approx/records/optical_constants.hpp"
#include "reports/io/joined.hpp"
#include "reports/io/writers.hpp"
#include "reports/rows/citation.hpp"
#include "reports/sections/prose.hpp"

namespace shadefit {
namespace {

bool is_glass(const FresnelLink& link) {
  return link.surface->extinction == "0" && link.surface->ior == glass.ior;
}

std::string parameters_text(const FresnelLink& link) {
  if (link.family == nullptr || link.status != Status::converged) return "";
  return equations(link.family->parameters, link.parameters,
                   [](double value) { return text(converged(value), Precision::report); });
}

/// "fresnel-quadratic-a", "fresnel-quadratic refitted", "schlick": the name of a curve for programs.
std::string curve_id(const FresnelLink& link) {
  if (link.family == nullptr) return "schlick";
  return link.published.empty() ? std::string(link.family->id) + " refitted" : std::string(link.published);
}

/// The name for people.
std::string curve_text(const FresnelLink& link) {
  if (link.family == nullptr) return "Schlick's formula";
  const std::string form = fmt::format("${}$", to_latex(link.family->form));
  if (link.status != Status::converged) return fmt::format("{}, refitted: {}", form, name(link.status));
  return fmt::format("{}, {} {}", form,
                     link.published.empty() ? "refitted:" : "published:", parameters_text(link));
}

/// "$2^{-A c}$ (A = 8.35)"
std::string published_text(const FresnelLink& link) {
  return fmt::format("${}$ ({})", to_latex(link.family->form), parameters_text(link));
}

std::string surface_text(const OpticalConstants& surface) {
  if (surface.extinction == "0") return fmt::format("{}, n = {}", surface.material, surface.ior);
  return fmt::format("{} at {} nm, n = {}, k = {}", surface.material, surface.wavelength, surface.ior,
                     surface.extinction);
}

/// The curve, then the absolute error, the relative error and the codes from either reference. Schlick's
/// formula has none from itself, and a refit that failed has none.
std::vector<Cell> chain_row(const FresnelLink& link) {
  constexpr int digits = 3;
  std::vector<Cell> row{curve_text(link)};
  for (const ReflectanceError* errors : {&link.from_schlick, &link.from_exact}) {
    const bool is_from_itself = link.family == nullptr && errors == &link.from_schlick;
    if (link.status == Status::converged && !is_from_itself) {
      row.insert(row.end(),
                 {Number{errors->absolute.magnitude, digits},
                  Number{100 * errors->relative.magnitude, digits}, Number{errors->srgb_codes, digits}});
    } else {
      row.resize(row.size() + 3);
    }
  }
  return row;
}

const std::vector<std::string> chain_columns{"curve", "from Schlick", "in %", "codes", "from the exact F",
                                             "in % ", "codes "};

const FresnelLink* worst(const std::vector<FresnelLink>& chain, bool of_metals) {
  const FresnelLink* found = nullptr;
  for (const FresnelLink& link : chain) {
    const bool counts = link.family == nullptr && (link.surface->extinction != "0") == of_metals;
    if (!counts) continue;
    if (found == nullptr || link.from_exact.absolute.magnitude > found->from_exact.absolute.magnitude)
      found = &link;
  }
  return found;
}

std::string sources_text(const std::vector<FresnelLink>& chain) {
  std::string text;
  std::string_view last;
  for (const FresnelLink& link : chain) {
    const Source& source = link.surface->source;
    if (link.surface->extinction == "0" || source.title == last) continue;
    last = source.title;
    text += fmt::format("{}{}", text.empty() ? "" : ", ", linked(source));
  }
  return text;
}

}  // namespace

Table fresnel_table(const std::vector<FresnelLink>& chain) {
  Table table{
      {"surface", "wavelength", "ior", "extinction", "f0", "curve", "parameters", "schlick_max_abs_error",
       "schlick_max_rel_error", "schlick_srgb_codes", "exact_max_abs_error", "exact_max_abs_error_at",
       "exact_max_rel_error", "exact_max_rel_error_at", "exact_srgb_codes", "source", "status"},
      {}};
  const auto number = [](std::string_view text) {
    return text.empty() ? Cell() : Cell(Number{constant<double>(text), 10});
  };
  for (const FresnelLink& link : chain) {
    const auto cell = [&](double value) {
      return link.status == Status::converged ? Cell(Number{value, 6}) : Cell();
    };
    const auto at = [&](const Extremum& e) {
      return link.status == Status::converged ? place(e.at) : Cell();
    };
    table.rows.push_back({std::string(link.surface->material), number(link.surface->wavelength),
                          number(link.surface->ior), number(link.surface->extinction), Number{link.f0, 6},
                          curve_id(link), parameters_text(link), cell(link.from_schlick.absolute.magnitude),
                          cell(link.from_schlick.relative.magnitude), cell(link.from_schlick.srgb_codes),
                          cell(link.from_exact.absolute.magnitude), at(link.from_exact.absolute),
                          cell(link.from_exact.relative.magnitude), at(link.from_exact.relative),
                          cell(link.from_exact.srgb_codes), author_and_year(link.surface->source),
                          std::string(name(link.status))});
  }
  return table;
}

std::string exact_fresnel_section(const std::vector<FresnelLink>& chain) {
  std::string out = section_text("exact-fresnel");
  const FresnelLink* dielectric = worst(chain, false);
  const FresnelLink* metal = worst(chain, true);
  out += fmt::format(
      "Schlick's formula is off by up to {:.3g} ({:.3g} codes) on the dielectrics here, worst for {}, and by "
      "up to "
      "{:.3g} ({:.3g} codes) on the metals, worst for {}. The optical constants of metals are those of {}.\n\n",
      dielectric->from_exact.absolute.magnitude, dielectric->from_exact.srgb_codes,
      surface_text(*dielectric->surface), metal->from_exact.absolute.magnitude, metal->from_exact.srgb_codes,
      surface_text(*metal->surface), sources_text(chain));
  for (auto first = chain.begin(); first != chain.end();) {
    const auto last =
        std::find_if(first, chain.end(), [&](const FresnelLink& l) { return l.surface != first->surface; });
    Table table{chain_columns};
    std::transform(first, last, std::back_inserter(table.rows), chain_row);
    out +=
        fmt::format("{}, f0 = {:.4g}:\n\n", surface_text(*first->surface), first->f0) + markdown_block(table);
    first = last;
  }
  return out;
}

std::string exact_fresnel_headline(const std::vector<FresnelLink>& chain) {
  const FresnelLink *schlick = nullptr, *truest = nullptr, *closest = nullptr;
  for (const FresnelLink& link : chain) {
    if (!is_glass(link)) continue;
    if (link.family == nullptr) schlick = &link;
    if (link.published.empty()) continue;
    const auto nearer = [&](const FresnelLink* best, const ReflectanceError FresnelLink::*from) {
      return best == nullptr || (link.*from).absolute.magnitude < (best->*from).absolute.magnitude;
    };
    if (nearer(truest, &FresnelLink::from_exact)) truest = &link;
    if (nearer(closest, &FresnelLink::from_schlick)) closest = &link;
  }
  if (schlick == nullptr || truest == nullptr) return "";
  const double off = schlick->from_exact.absolute.magnitude, near = closest->from_schlick.absolute.magnitude;
  return fmt::format(
      "The Fresnel constants were fitted to Schlick's formula, which is itself off by up to {:.3g} in "
      "reflectance on glass (n = {}). The published {} is at most {:.3g} from Schlick's formula. "
      "Schlick's formula is up to {:.2g} times as far from the exact reflectance. The published curve "
      "closest to the exact reflectance of that glass is {}, off by {:.3g}.\n\n",
      off, glass.ior, published_text(*closest), near, off / near, published_text(*truest),
      truest->from_exact.absolute.magnitude);
}

std::string exact_fresnel_lead(const std::vector<FresnelLink>& chain) {
  const std::string headline = exact_fresnel_headline(chain);
  if (headline.empty()) return "";
  Table glass_table{chain_columns};
  for (const FresnelLink& link : chain) {
    if (is_glass(link)) glass_table.rows.push_back(chain_row(link));
  }
  return headline + markdown_block(glass_table) +
         "Each error is the largest error of the reflectance F over all angles, with f0 = 0.04: absolute, in "
         "percent of F, and "
         "in 8-bit sRGB codes. More dielectrics, and metals: [Exact Fresnel](#exact-fresnel).\n\n";
}

}  // namespace shadefit
