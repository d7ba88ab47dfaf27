#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "approx/records/record.hpp"
#include "fit/catalogue/study_file.hpp"

/// Sources as people and programs cite them.
namespace shadefit {

/// "Lagarde 2012"
std::string author_and_year(const Source& source);

/// "author year, title, place"
std::string citation(const Source& source);

/// The web address of the source: its `address`, or its place if that is an address. Empty: not known.
std::string address_of(const Source& source);

/// "Lagarde 2012" as a Markdown link to its address, if there is one.
std::string linked(const Source& source);

/// The fields of a source. Records have surnames only.
CitedWork work_of(const Source& source);

/// The works of published sets. A set without fields has its source as title.
std::vector<CitedWork> works_of(const std::vector<PublishedSet>& sets);

/// A BibTeX entry for each work, once, after an empty line: @misc{lagarde2012sphericalgaussian, ..}. Entries
/// with equal keys get numbers: kang2002designof, kang2002designof-2.
std::string bibtex(const std::vector<CitedWork>& works);

/// The BibTeX entry of shadefit itself. CITATION.cff says the same.
std::string bibtex_of_shadefit(std::string_view version);

/// The ids of claims, of published constants, and of their families.
std::vector<std::string> cited_ids();

/// The sources of such an id, each once.
std::vector<Source> sources_of(std::string_view id);

}  // namespace shadefit
