#include "reports/studies/study_certificate_json.hpp"

#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "fit/input/json_document.hpp"
#include "fit/support/hex_float.hpp"
#include "fit/support/user_error.hpp"
#include "reports/io/own_json.hpp"
#include "reports/rows/fit_json.hpp"

namespace shadefit {
namespace {

using Json = OwnJson;

constexpr const char* kind_of_study_file = "shadefit certificate of a study";
/// Of a family, before families were proven as studies.
constexpr const char* former_kind = "shadefit certificate";

const std::vector<std::pair<std::string_view, Error>> named_errors{{name(Error::absolute), Error::absolute},
                                                                   {name(Error::relative), Error::relative}};

/// Numbers as `hex_text` writes them.
Json hex_list(const std::vector<double>& values) {
  return json_array(values, hex_text);
}

Json definitions_json(const std::vector<StudyDefinition>& definitions) {
  return json_array(definitions, [](const StudyDefinition& definition) -> Json {
    return {{"name", definition.name}, {"of", definition.arguments}, {"is", definition.formula}};
  });
}

StudySubject read_study_subject(const Json& json) {
  StudySubject subject;
  Study& study = subject.study;
  study.target = json.at("target");
  study.form = json.at("form");
  study.weight = json.at("weight");
  study.error = own_choice(json.at("error"), named_errors);
  for (const Json& let : json.at("let"))
    study.definitions.push_back({let.at("name"), let.at("of"), let.at("is")});
  for (const auto& [name, value] : own_members(json.at("given"))) study.given.emplace(name, value);
  for (const Json& range : json.at("over"))
    study.over.push_back({range.at("variable"), range.at("from"), range.at("to")});
  subject.parameters = own_members(json.at("parameters"));
  return subject;
}

ReadCertificate study_certificate_of(const Json& json) {
  require_kind(json, kind_of_study_file, study_certificate_schema);
  ReadCertificate result{.refused = fault_of_digest(json)};
  StudyCertificate& certificate = result.certificate;
  certificate.subject = read_study_subject(json);
  for (const Json& range : json.at("over")) {
    const auto [lower, upper] = own_interval(range.at("doubles"));
    certificate.ranges.push_back({lower, upper});
  }
  std::tie(certificate.lower, certificate.upper) = own_interval(json.at("largest"));
  certificate.attained = own_numbers(json.at("attained"));
  certificate.precision = own_whole(json.at("precision"));
  certificate.boxes = json.at("boxes");
  require_written_as(json, write_study_certificate_json(certificate));
  return result;
}

}  // namespace

Json write_study_certificate_json(const StudyCertificate& certificate) {
  const auto& [study, parameters] = certificate.subject;
  Json over = Json::array();
  for (std::size_t i = 0; i < study.over.size(); ++i)
    over.push_back({{"variable", study.over[i].variable},
                    {"from", study.over[i].lower},
                    {"to", study.over[i].upper},
                    {"doubles", hex_list({certificate.ranges.at(i).lower, certificate.ranges.at(i).upper})}});
  Json json{{"file", kind_of_study_file},
            {"schema", study_certificate_schema},
            {"target", study.target},
            {"form", study.form},
            {"weight", study.weight},
            {"error", name(study.error)},
            {"let", definitions_json(study.definitions)},
            {"given", json_object(study.given)},
            {"over", over},
            {"parameters", json_object(parameters)},
            {"largest", hex_list({certificate.lower, certificate.upper})},
            {"attained", hex_list(certificate.attained)},
            {"precision", certificate.precision},
            {"boxes", certificate.boxes}};
  json[digest_field] = digest_of(json);
  return json;
}

std::string certificate_text(const StudyCertificate& certificate) {
  return write_study_certificate_json(certificate).dump(1) + "\n";
}

ReadCertificate read_study_certificate(const std::string& text, const std::string& name) {
  const std::string file = "certificate '" + name + "'";
  const Json json = parse_own_json(text, file);
  if (json.is_object() && json.contains("file") && json.at("file") == former_kind)
    throw UserError(file +
                    " is of a family, by an earlier build: families are proven as studies now; make it "
                    "again with 'shadefit certify'");
  return read_own(file, [&] { return study_certificate_of(json); });
}

}  // namespace shadefit
