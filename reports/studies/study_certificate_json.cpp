#include "reports/studies/study_certificate_json.hpp"

#include <vector>

#include "fit/support/hex_float.hpp"
#include "reports/io/digest.hpp"
#include "reports/rows/fit_json.hpp"

namespace shadefit {
namespace {

using Json = nlohmann::ordered_json;

/// Numbers as `hex_text` writes them.
Json hex_list(const std::vector<double>& values) {
  return json_array(values, hex_text);
}

Json definitions_json(const std::vector<StudyDefinition>& definitions) {
  return json_array(definitions, [](const StudyDefinition& definition) -> Json {
    return {{"name", definition.name}, {"of", definition.arguments}, {"is", definition.formula}};
  });
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
  Json json{{"file", study_certificate_kind},
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

}  // namespace shadefit
