#include "reports/gallery/gallery_shard.hpp"

#include <fmt/format.h>

#include <charconv>

#include "fit/support/json_document.hpp"
#include "reports/io/digest.hpp"
#include "reports/io/own_fields.hpp"
#include "reports/rows/fit_json.hpp"

namespace shadefit {
namespace {

using Json = nlohmann::ordered_json;

/// null, a text, [a text of others], a whole number, or [text of a number, digits]. Numbers have the digits
/// that are shown, so the file has the same bytes on every machine.
Json cell_json(const Cell& cell) {
  if (const auto* words = std::get_if<std::string>(&cell)) return *words;
  if (const auto* others = std::get_if<OthersText>(&cell)) return Json::array({*others});
  if (const auto* whole = std::get_if<long>(&cell)) return *whole;
  const auto* number = std::get_if<Number>(&cell);
  if (number == nullptr) return nullptr;
  return Json::array({text(cell, Precision::report), static_cast<unsigned>(number->digits)});
}

Cell cell_of(const OwnFields& fields, const Json& json) {
  if (json.is_null()) return {};
  if (json.is_string()) return json.get<std::string>();
  if (json.is_number_integer()) return json.get<long>();
  if (json.is_array() && json.size() == 1) return OthersText(fields.text_of(json[0], "rows"));
  if (!json.is_array() || json.size() != 2) fields.fail("rows", "has a cell that shadefit does not write");
  const std::string shown = fields.text_of(json[0], "rows");
  Number number{0, fields.whole_of<int>(json[1], "rows")};
  const auto [stop, error] = std::from_chars(shown.data(), shown.data() + shown.size(), number.value);
  if (error != std::errc{}) fields.fail("rows", fmt::format("holds '{}', which is not a number", shown));
  return number;  // what follows the number is found when the content is compared with what would be written
}

Json judged_json(const JudgedStudy& study) {
  const Json rows = json_array(study.rows, [](const auto& row) { return json_array(row, cell_json); });
  return {{"id", study.id}, {"is_published", study.is_published}, {"rows", rows}, {"page", study.page}};
}

JudgedStudy read_judged(const OwnFields& fields) {
  if (!fields.field("is_published").is_boolean()) fields.fail("is_published", "is not true or false");
  JudgedStudy study{fields.text("id"), fields.field("is_published").get<bool>(), {}, fields.text("page")};
  const std::size_t columns = gallery_table({}).columns.size();
  for (const Json& row : fields.list("rows")) {
    if (!row.is_array() || row.size() != columns)
      fields.fail("rows", fmt::format("has a row that is not a list of {} cells", columns));
    auto& cells = study.rows.emplace_back();
    for (const Json& cell : row) cells.push_back(cell_of(fields, cell));
  }
  return study;
}

Json gallery_shard_json(const GalleryShard& shard) {
  const auto listed_json = [](const ListedStudy& study) -> Json {
    return {{"id", study.id}, {"digest", study.digest}};
  };
  Json json{{"file", gallery_kind},
            {"schema", gallery_schema},
            {version_field, shard.version},
            {"studies", json_array(shard.studies, listed_json)},
            {"shard", {shard.shard.index, shard.shard.of}},
            {"judged", json_array(shard.judged, judged_json)}};
  json[digest_field] = digest_of(json);
  return json;
}

void require_studies_of_the_shard(const OwnFields& fields, const GalleryShard& shard) {
  std::vector<std::string> wanted, found;
  for (std::size_t k = 0; k < shard.studies.size(); ++k)
    if (belongs(k, shard.shard)) wanted.push_back(shard.studies[k].id);
  for (const JudgedStudy& study : shard.judged) found.push_back(study.id);
  if (found != wanted) fields.fail("judged", "has other studies than its shard");
}

}  // namespace

std::string shard_text(const GalleryShard& shard) {
  return gallery_shard_json(shard).dump(1) + "\n";
}

GalleryShard parse_gallery_shard(const std::string& text, const std::string& name) {
  const Json json = parse_own_json(text, name);
  const OwnFields fields(json, name);
  fields.require_kind(gallery_kind, gallery_schema);
  fields.require_digest();
  GalleryShard shard{fields.text(version_field), {}, read_shard(fields), {}};
  for (const Json& study : fields.list("studies")) {
    const OwnFields listed = fields.item(study);
    // The page of a study is a file of that name in the directory --out.
    if (listed.text("id").find('/') != std::string::npos) listed.fail("id", "has a '/'");
    shard.studies.push_back({listed.text("id"), listed.text("digest")});
  }
  for (const Json& study : fields.list("judged")) shard.judged.push_back(read_judged(fields.item(study)));
  require_studies_of_the_shard(fields, shard);
  fields.require_written_as(gallery_shard_json(shard));
  return shard;
}

std::vector<JudgedStudy> merge(const std::vector<NamedGalleryShard>& shards, const std::string& version) {
  std::vector<Part> parts;
  for (const auto& [name, shard] : shards) {
    Part part{.file = name, .identity = {{version_field, shard.version}}, .shard = shard.shard};
    for (const auto& [id, digest] : shard.studies) part.identity.emplace_back("study", id + " " + digest);
    parts.push_back(std::move(part));
  }
  require_whole(parts, version);
  std::vector<JudgedStudy> whole(shards.front().shard.studies.size());
  for (const NamedGalleryShard& named : shards) {
    std::size_t k = named.shard.shard.index - 1;
    for (const JudgedStudy& study : named.shard.judged) {
      whole[k] = study;
      k += named.shard.shard.of;
    }
  }
  return whole;
}

}  // namespace shadefit
