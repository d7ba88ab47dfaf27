#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "fit/input/json_document.hpp"
#include "fit/support/user_error.hpp"
#include "reports/io/own_json.hpp"
#include "reports/studies/study_certificate_json.hpp"

namespace shadefit {
namespace {

/// Of a family, before families were proven as studies.
constexpr const char* former_kind = "shadefit certificate";

const std::vector<std::pair<std::string_view, Error>> named_errors{{name(Error::absolute), Error::absolute},
                                                                   {name(Error::relative), Error::relative}};

StudySubject read_study_subject(const OwnJson& json) {
  StudySubject subject;
  Study& study = subject.study;
  study.target = json.at("target");
  study.form = json.at("form");
  study.weight = json.at("weight");
  study.error = own_choice(json.at("error"), named_errors);
  for (const OwnJson& let : json.at("let"))
    study.definitions.push_back({let.at("name"), let.at("of"), let.at("is")});
  for (const auto& [name, value] : own_members(json.at("given"))) study.given.emplace(name, value);
  for (const OwnJson& range : json.at("over"))
    study.over.push_back({range.at("variable"), range.at("from"), range.at("to")});
  subject.parameters = own_members(json.at("parameters"));
  return subject;
}

ReadCertificate study_certificate_of(const OwnJson& json) {
  require_kind(json, study_certificate_kind, study_certificate_schema);
  ReadCertificate result{.refused = fault_of_digest(json)};
  StudyCertificate& certificate = result.certificate;
  certificate.subject = read_study_subject(json);
  for (const OwnJson& range : json.at("over")) {
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

ReadCertificate read_study_certificate(const std::string& text, const std::string& name) {
  const std::string file = "certificate '" + name + "'";
  const OwnJson json = parse_own_json(text, file);
  if (json.is_object() && json.contains("file") && json.at("file") == former_kind)
    throw UserError(file +
                    " is of a family, by an earlier build: families are proven as studies now; make it "
                    "again with 'shadefit certify'");
  return read_own(file, [&] { return study_certificate_of(json); });
}

}  // namespace shadefit
