#pragma once

#include <string>
#include <string_view>

#include "reports/io/table.hpp"

/// A figure of the report: numbers, and how to draw them.
namespace shadefit {

/// The files in `plots/` with one name: data, script and, once drawn, the picture.
struct Figure {
  std::string name;         ///< "lobe": lobe.csv, lobe.gnuplot, lobe.svg
  std::string_view family;  ///< the family in whose section the report shows it
  std::string caption;      ///< one sentence
  Table data;
  std::string script;  ///< of gnuplot; reads NAME.csv beside it
};

}  // namespace shadefit
