#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "approx/records/record.hpp"
#include "fit/study/study_file.hpp"

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

/// A BibTeX entry: @misc{lagarde2012sphericalgaussian, ..}. Records have surnames only.
std::string bibtex(const Source& source);

/// The same for the published sets of a study, each work once: of the fields that its file has; without them
/// the source is the title. Entries with equal keys get letters: kang2002designof, kang2002designofb.
std::vector<std::string> bibtex_of_sets(const std::vector<PublishedSet>& sets);

/// The BibTeX entry of shadefit itself. CITATION.cff says the same.
std::string bibtex_of_shadefit(std::string_view version);

/// The ids of claims, of published constants, and of their families.
std::vector<std::string> cited_ids();

/// The sources of such an id, each once.
std::vector<Source> sources_of(std::string_view id);

}  // namespace shadefit
