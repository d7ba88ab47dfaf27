#include "reports/studies/study_certificate_json.hpp"

#include <tuple>

#include "fit/input/json_document.hpp"
#include "reports/io/digest.hpp"
#include "reports/io/own_fields.hpp"
#include "reports/rows/fit_json.hpp"

namespace shadefit {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kind_of_study_file = "shadefit certificate of a study";

Json definitions_json(const std::vector<StudyDefinition>& definitions) {
  return json_array(definitions, [](const StudyDefinition& definition) -> Json {
    return {{"name", definition.name}, {"of", definition.arguments}, {"is", definition.formula}};
  });
}

std::vector<StudyDefinition> read_definitions(const OwnFields& fields) {
  std::vector<StudyDefinition> definitions;
  for (const Json& item : fields.list("let")) {
    const OwnFields one = fields.item(item);
    definitions.push_back({one.text("name"), one.texts("of"), one.text("is")});
  }
  return definitions;
}

StudySubject read_study_subject(const OwnFields& fields) {
  StudySubject subject;
  subject.study.target = fields.text("target");
  subject.study.form = fields.text("form");
  subject.study.weight = fields.text("weight");
  subject.study.error = fields.choice("error", named_errors);
  subject.study.definitions = read_definitions(fields);
  for (const auto& [name, value] : fields.members("given")) subject.study.given.emplace(name, value);
  for (const Json& item : fields.list("over")) {
    const OwnFields range = fields.item(item);
    subject.study.over.push_back({range.text("variable"), range.text("from"), range.text("to")});
  }
  subject.parameters = fields.members("parameters");
  return subject;
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

bool is_study_certificate(const std::string& text, const std::string& name) {
  const Json json = parse_own_json(text, "certificate '" + name + "'");
  return json.is_object() && json.contains("file") && json.at("file") == kind_of_study_file;
}

ReadCertificate<StudyCertificate> read_study_certificate(const std::string& text, const std::string& name) {
  const std::string file = "certificate '" + name + "'";
  const Json json = parse_own_json(text, file);
  const OwnFields fields(json, file);
  fields.require_kind(kind_of_study_file, study_certificate_schema);
  ReadCertificate<StudyCertificate> result{.refused = fields.fault_of_digest()};
  StudyCertificate& certificate = result.certificate;
  certificate.subject = read_study_subject(fields);
  for (const Json& item : fields.list("over")) {
    const auto [lower, upper] = fields.item(item).interval("doubles");
    certificate.ranges.push_back({lower, upper});
  }
  std::tie(certificate.lower, certificate.upper) = fields.interval("largest");
  certificate.attained = fields.numbers("attained");
  certificate.precision = fields.whole("precision");
  certificate.boxes = fields.text("boxes");
  fields.require_written_as(write_study_certificate_json(certificate));
  return result;
}

}  // namespace shadefit
