#include "reports/studies/study_certificate_json.hpp"

#include <utility>

#include "fit/support/hex_float.hpp"
#include "fit/support/json_document.hpp"
#include "reports/io/digest.hpp"
#include "reports/io/own_fields.hpp"

namespace shadefit {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kind_of_study_file = "shadefit certificate of a study";

Json hex_pair(double lower, double upper) {
  return {hex_text(lower), hex_text(upper)};
}

Domain read_pair(const OwnFields& fields, const char* key) {
  const Json& pair = fields.pair(key);
  return {fields.number_of(pair[0], key), fields.number_of(pair[1], key)};
}

Json definitions_json(const std::vector<StudyDefinition>& definitions) {
  Json list = Json::array();
  for (const StudyDefinition& definition : definitions)
    list.push_back({{"name", definition.name}, {"of", definition.arguments}, {"is", definition.formula}});
  return list;
}

std::vector<StudyDefinition> read_definitions(const OwnFields& fields) {
  std::vector<StudyDefinition> definitions;
  for (const Json& item : fields.list("let")) {
    const OwnFields one = fields.item(item);
    StudyDefinition definition{one.text("name"), {}, one.text("is")};
    for (const Json& argument : one.list("of")) definition.arguments.push_back(one.text_of(argument, "of"));
    definitions.push_back(definition);
  }
  return definitions;
}

/// The members of an object of texts.
Constants read_texts(const OwnFields& fields, const char* key) {
  if (!fields.field(key).is_object()) fields.fail(key, "is not an object");
  Constants texts;
  for (const auto& [name, value] : fields.field(key).items())
    texts.emplace_back(name, fields.text_of(value, key));
  return texts;
}

Error read_error(const OwnFields& fields) {
  const std::string text = fields.text("error");
  for (const Error error : {Error::absolute, Error::relative}) {
    if (text == name(error)) return error;
  }
  fields.fail("error", "is unknown: '" + text + "'");
}

StudySubject read_study_subject(const OwnFields& fields) {
  StudySubject subject;
  subject.study.target = fields.text("target");
  subject.study.form = fields.text("form");
  subject.study.weight = fields.text("weight");
  subject.study.error = read_error(fields);
  subject.study.definitions = read_definitions(fields);
  for (const auto& [name, value] : read_texts(fields, "given")) subject.study.given.emplace(name, value);
  for (const Json& item : fields.list("over")) {
    const OwnFields range = fields.item(item);
    subject.study.over.push_back({range.text("variable"), range.text("from"), range.text("to")});
  }
  subject.parameters = read_texts(fields, "parameters");
  return subject;
}

}  // namespace

Json write_study_certificate_json(const StudyCertificate& certificate) {
  const auto& [study, parameters] = certificate.subject;
  Json over = Json::array(), given = Json::object(), constants = Json::object(), attained = Json::array();
  for (std::size_t i = 0; i < study.over.size(); ++i)
    over.push_back({{"variable", study.over[i].variable},
                    {"from", study.over[i].lower},
                    {"to", study.over[i].upper},
                    {"doubles", hex_pair(certificate.ranges.at(i).lower, certificate.ranges.at(i).upper)}});
  for (const auto& [name, value] : study.given) given[name] = value;
  for (const auto& [name, value] : parameters) constants[name] = value;
  for (const double coordinate : certificate.attained) attained.push_back(hex_text(coordinate));
  Json json{{"file", kind_of_study_file},
            {"schema", study_certificate_schema},
            {"target", study.target},
            {"form", study.form},
            {"weight", study.weight},
            {"error", name(study.error)},
            {"let", definitions_json(study.definitions)},
            {"given", given},
            {"over", over},
            {"parameters", constants},
            {"largest", hex_pair(certificate.lower, certificate.upper)},
            {"attained", attained},
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

ReadStudyCertificate read_study_certificate(const std::string& text, const std::string& name) {
  const std::string file = "certificate '" + name + "'";
  const Json json = parse_own_json(text, file);
  const OwnFields fields(json, file);
  fields.require_kind(kind_of_study_file, study_certificate_schema);
  ReadStudyCertificate result;
  const std::string digest = digest_of(json);
  if (const std::string stated = fields.text(digest_field); stated != digest)
    result.refused = "its digest is " + stated + ", that of its fields is " + digest +
                     ": it was changed after it was written";
  StudyCertificate& certificate = result.certificate;
  certificate.subject = read_study_subject(fields);
  for (const Json& item : fields.list("over"))
    certificate.ranges.push_back(read_pair(fields.item(item), "doubles"));
  const Domain largest = read_pair(fields, "largest");
  certificate.lower = largest.lower;
  certificate.upper = largest.upper;
  certificate.attained = fields.numbers("attained");
  certificate.precision = fields.whole<int>("precision");
  certificate.boxes = fields.text("boxes");
  fields.require_written_as(write_study_certificate_json(certificate));
  return result;
}

}  // namespace shadefit
