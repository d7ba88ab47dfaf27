#include "reports/studies/study_proof_rows.hpp"

#include <fmt/format.h>

#include "fit/support/hex_float.hpp"
#include "reports/code/study_code.hpp"
#include "reports/io/joined.hpp"
#include "reports/io/utf8.hpp"
#include "reports/rows/fit_json.hpp"
#include "reports/studies/study_rows.hpp"

namespace shadefit {
namespace {

using Json = nlohmann::ordered_json;

std::string error_text(const Study& study) {
  const bool is_weighted = study.weight != "1";
  if (study.error == Error::absolute)
    return is_weighted ? fmt::format("({}) (form - target)", study.weight) : "form - target";
  return (is_weighted ? fmt::format("({}) ", study.weight) : "") + "(form - target)/target";
}

}  // namespace

OthersText proof_headline(const StudyCertificate& certificate) {
  const Study& study = certificate.subject.study;
  return formulas_text(study) + fmt::format(", {} error{}, proven in {} bits", name(study.error),
                                            study.weight == "1" ? "" : ", weight " + study.weight,
                                            certificate.precision);
}

Table study_proofs_table(const std::vector<ProvenStudy>& proofs) {
  const StudySubject& first = proofs.front().certified.certificate.subject;
  Table table;
  for (const auto& [name, value] : first.study.given) table.columns.push_back(name);
  for (const auto& [name, value] : first.parameters) table.columns.push_back(name);
  for (const char* column : {"from", "max error at least", "at most"}) table.columns.emplace_back(column);
  for (const StudyRange& range : first.study.over) table.columns.push_back("at " + range.variable);
  table.columns.emplace_back("boxes");
  for (const auto& [certified, from] : proofs) {
    const StudyCertificate& certificate = certified.certificate;
    std::vector<Cell>& row = table.rows.emplace_back();
    for (const auto& [name, value] : certificate.subject.study.given) row.emplace_back(value);
    for (const auto& [name, value] : certificate.subject.parameters) row.emplace_back(value);
    row.insert(row.end(), {std::string(from), all_of(certificate.lower), all_of(certificate.upper)});
    for (const double coordinate : certificate.attained) row.push_back(all_of(coordinate));
    row.emplace_back(static_cast<long>(count_boxes(certificate)));
  }
  return table;
}

std::string ends_text(const StudyCertificate& certificate) {
  std::string text;
  const auto line = [&](const std::string& variable, const char* verb, const std::string& formula,
                        double end) {
    if (!is_exactly(certificate.subject.study, formula, end))
      text += fmt::format("{} {} at {} = {}, the double nearest to {}.\n", variable, verb, end, hex_text(end),
                          formula);
  };
  const std::vector<StudyRange>& over = certificate.subject.study.over;
  for (std::size_t i = 0; i < over.size(); ++i) {
    line(over[i].variable, "begins", over[i].lower, certificate.ranges[i].lower);
    line(over[i].variable, "ends", over[i].upper, certificate.ranges[i].upper);
  }
  return text;
}

Json study_proof_json(const ProvenStudy& proof) {
  const StudyCertificate& certificate = proof.certified.certificate;
  const auto& [study, constants] = certificate.subject;
  Json over = Json::object(), at = Json::object();
  for (std::size_t i = 0; i < study.over.size(); ++i) {
    const StudyRange& range = study.over[i];
    const Domain& doubles = certificate.ranges[i];
    over[range.variable] = {{"range", {range.lower, range.upper}},
                            {"doubles", {doubles.lower, doubles.upper}}};
    at[range.variable] = certificate.attained[i];
  }
  return {{"schema", fit_json_schema},
          {"target", study.target},
          {"form", study.form},
          {"over", over},
          {"given", json_object(study.given)},
          {"error", name(study.error)},
          {"weight", study.weight},
          {"parameters", json_object(constants)},
          {"parameters_from", proof.from},
          {"certified_max_error", {certificate.lower, certificate.upper}},
          {"certified_max_error_at", at},
          {"boxes", count_boxes(certificate)},
          {"reached", proof.certified.is_reached}};
}

void add_study_proof(Json& fit, const ProvenStudy& proof) {
  const Json all = study_proof_json(proof);
  for (const char* key : {"certified_max_error", "certified_max_error_at", "boxes"}) fit[key] = all[key];
}

std::string statement_of(const StudyCertificate& certificate) {
  const auto& [study, parameters] = certificate.subject;
  std::string text;
  const auto line = [&](const char* what, const std::string& words) {
    text += fmt::format("  {:<9}{}\n", what, printable(words));
  };
  line("form", study.form);
  for (const auto& [name, value] : parameters) line("with", fmt::format("{} = {}", name, decimal_of(value)));
  line("target", study.target);
  for (const auto& [name, value] : study.given) line("given", fmt::format("{} = {}", name, value));
  for (const StudyDefinition& definition : study.definitions) line("let", definition_text(definition));
  line("error", fmt::format("{}: {}", name(study.error), error_text(study)));
  for (std::size_t i = 0; i < study.over.size(); ++i) {
    const Domain& range = certificate.ranges[i];
    line("range", fmt::format("{} from {} to {}", study.over[i].variable, range.lower, range.upper));
  }
  line("largest", fmt::format("at least {}, at most {}", certificate.lower, certificate.upper));
  std::vector<std::string> variables;
  for (const StudyRange& range : study.over) variables.push_back(range.variable);
  line("at", equations(variables, certificate.attained));
  return text;
}

}  // namespace shadefit
