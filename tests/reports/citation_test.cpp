#include "reports/rows/citation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

namespace shadefit {
namespace {

const Source paper{"Walter, Li", 2007, "R.E versus N.H", "EGSR 2007, pp. 1-2", "https://doi.org/1"};
const Source post{"Lagarde", 2012, "A Title", "host.org/2012/post"};
const Source book{"Fisher, Woo", 1994, "Another Title", "Graphics Gems IV, pp. 3-4"};

TEST(Citation, NamesAuthorYearTitleAndPlace) {
  EXPECT_EQ(author_and_year(paper), "Walter, Li 2007");
  EXPECT_EQ(citation(post), "Lagarde 2012, A Title, host.org/2012/post");
}

TEST(Citation, TheAddressIsItsOwnOrThePlaceOfAPost) {
  EXPECT_EQ(address_of(paper), "https://doi.org/1");
  EXPECT_EQ(address_of(post), "https://host.org/2012/post");
  EXPECT_EQ(address_of(book), "");
  EXPECT_EQ(linked(paper), "[Walter, Li 2007](https://doi.org/1)");
  EXPECT_EQ(linked(book), "Fisher, Woo 1994");
}

TEST(Citation, BibtexHasThePlaceUnlessItIsTheAddress) {
  EXPECT_EQ(bibtex({work_of(paper)}),
            "\n@misc{walter2007reversus,\n  author = {Walter and Li},\n  title = {{R.E versus N.H}},\n"
            "  year = {2007},\n  howpublished = {EGSR 2007, pp. 1-2},\n  url = {https://doi.org/1},\n}\n");
  EXPECT_EQ(bibtex({work_of(post)}),
            "\n@misc{lagarde2012atitle,\n  author = {Lagarde},\n  title = {{A Title}},\n  year = {2012},\n"
            "  url = {https://host.org/2012/post},\n}\n");
}

TEST(Citation, AStudyCitesByFieldsAndWithoutThemByItsSource) {
  const auto set = [](const std::string& source, std::optional<CitedWork> cite) {
    return PublishedSet{.form = "", .values = {}, .source = source, .cite = std::move(cite)};
  };
  const CitedWork paper_of_two{.authors = {OthersText("Le Saec"), OthersText("Schlick, Christophe")},
                               .title = OthersText("An algorithm: k = 1.55 g - 0.55 g^3"),
                               .year = OthersText("1993"),
                               .howpublished = OthersText("Workshop"),
                               .note = OthersText("with a note"),
                               .url = "https://host.org/a_b"};
  const CitedWork code{.authors = {OthersText("Unity Technologies")},
                       .title = OthersText("BSDF.hlsl: F_Coat")};
  EXPECT_EQ(
      bibtex(works_of({set("a", paper_of_two), set("b", paper_of_two),
                       set("c", CitedWork{.authors = {OthersText("Le")},
                                          .title = OthersText("An algorithm"),
                                          .year = OthersText("1993")}),
                       set("d", code), set("Eberly 2014, Inverse functions", {})})),
      "\n@misc{le1993analgorithm,\n  author = {{Le Saec} and Schlick, Christophe},\n"
      "  title = {{An algorithm: k = 1.55 g - 0.55 g\\textasciicircum{}3}},\n  year = {1993},\n"
      "  howpublished = {Workshop},\n  note = {with a note},\n  url = {https://host.org/a_b},\n}\n"
      "\n@misc{le1993analgorithm-2,\n  author = {Le},\n  title = {{An algorithm}},\n  year = {1993},\n}\n"
      "\n@misc{unitybsdfhlslfcoat,\n  author = {{Unity Technologies}},\n"
      "  title = {{BSDF.hlsl: F\\_Coat}},\n}\n"
      "\n@misc{eberly,\n  title = {{Eberly 2014, Inverse functions}},\n}\n")
      << "each work once, with a key of its own, and nothing guessed from the words";
}

TEST(Citation, EachIdHasSourcesAndEachSourceAKeyOfItsOwn) {
  std::map<std::string, std::string> title_of;
  for (const std::string& id : cited_ids()) {
    const auto sources = sources_of(id);
    EXPECT_FALSE(sources.empty()) << id;
    for (const Source& source : sources) {
      const std::string entry = bibtex({work_of(source)});
      EXPECT_EQ(std::count(entry.begin(), entry.end(), '{'), std::count(entry.begin(), entry.end(), '}'))
          << entry;
      const auto key = title_of.emplace(entry.substr(0, entry.find(',')), source.title).first;
      EXPECT_EQ(key->second, source.title) << key->first;
    }
  }
  EXPECT_EQ(sources_of("phong-blinn").size(), 2u);
  EXPECT_TRUE(sources_of("nobody").empty());
}

}  // namespace
}  // namespace shadefit
