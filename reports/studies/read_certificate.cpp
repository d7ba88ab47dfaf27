#include <fmt/format.h>

#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "fit/input/json_document.hpp"
#include "fit/support/hex_float.hpp"
#include "fit/support/user_error.hpp"
#include "reports/io/digest.hpp"
#include "reports/studies/study_certificate_json.hpp"

/// A value that breaks a rule throws std::invalid_argument, or an exception of nlohmann::json.
namespace shadefit {
namespace {

using Json = nlohmann::ordered_json;

/// Of a family, before families were proven as studies.
constexpr const char* former_kind = "shadefit certificate";

/// Doubles that are written as `hex_text` writes them.
std::vector<double> numbers_of(const Json& list) {
  std::vector<double> values;
  for (const Json& item : list) {
    const auto text = item.get<std::string>();
    const auto value = parse_hex(text);
    if (!value)
      throw std::invalid_argument(
          fmt::format("'{}' is not a hexadecimal double as shadefit prints it", text));
    values.push_back(*value);
  }
  return values;
}

/// A pair of such numbers.
std::pair<double, double> interval_of(const Json& list) {
  const std::vector<double> ends = numbers_of(list);
  if (ends.size() != 2) throw std::invalid_argument("an interval is not a pair");
  return {ends.front(), ends.back()};
}

/// A whole number >= 0.
int whole_of(const Json& json) {
  constexpr auto most = std::uint64_t{std::numeric_limits<int>::max()};
  if (!json.is_number_unsigned() || json.get<std::uint64_t>() > most)
    throw std::invalid_argument(fmt::format("{} is not a whole number from 0 to {}", json.dump(), most));
  return json.get<int>();
}

Error error_of(const Json& json) {
  const auto text = json.get<std::string>();
  for (const Error error : {Error::absolute, Error::relative}) {
    if (name(error) == text) return error;
  }
  throw std::invalid_argument("'" + text + "' is unknown");
}

StudySubject read_study_subject(const Json& json) {
  StudySubject subject;
  Study& study = subject.study;
  study.target = json.at("target");
  study.form = json.at("form");
  study.weight = json.at("weight");
  study.error = error_of(json.at("error"));
  for (const Json& let : json.at("let"))
    study.definitions.push_back({let.at("name"), let.at("of"), let.at("is")});
  for (const auto& [name, value] : json.at("given").items())
    study.given.emplace(name, value.get<std::string>());
  for (const Json& range : json.at("over"))
    study.over.push_back({range.at("variable"), range.at("from"), range.at("to")});
  for (const auto& [name, value] : json.at("parameters").items())
    subject.parameters.emplace_back(name, value.get<std::string>());
  return subject;
}

/// Refuses a field that differs from `written`, the output of shadefit for the data that was read. The digest
/// is checked separately.
void require_written_as(const Json& json, const Json& written) {
  for (const auto& [key, value] : json.items()) {
    const auto found = written.find(key);
    if (key != digest_field && (found == written.end() || *found != value))
      throw std::invalid_argument("'" + key + "' is unknown, or not as shadefit writes it");
  }
}

ReadCertificate study_certificate_of(const Json& json) {
  if (json.at("file") != study_certificate_kind)
    throw std::invalid_argument(fmt::format("'file' does not say '{}'", study_certificate_kind));
  if (const int found = whole_of(json.at("schema")); found != study_certificate_schema)
    throw std::invalid_argument(
        fmt::format("version {}: this shadefit reads version {}", found, study_certificate_schema));
  ReadCertificate result;
  const auto stated = json.at(digest_field).get<std::string>(), digest = digest_of(json);
  if (stated != digest)
    result.refused = fmt::format(
        "its digest is {}, that of its fields is {}: it was changed after it was written", stated, digest);
  StudyCertificate& certificate = result.certificate;
  certificate.subject = read_study_subject(json);
  for (const Json& range : json.at("over")) {
    const auto [lower, upper] = interval_of(range.at("doubles"));
    certificate.ranges.push_back({lower, upper});
  }
  std::tie(certificate.lower, certificate.upper) = interval_of(json.at("largest"));
  certificate.attained = numbers_of(json.at("attained"));
  certificate.precision = whole_of(json.at("precision"));
  certificate.boxes = json.at("boxes");
  require_written_as(json, write_study_certificate_json(certificate));
  return result;
}

}  // namespace

ReadCertificate read_study_certificate(const std::string& text, const std::string& name) {
  const std::string file = "certificate '" + name + "'";
  const Json json = parse_own_json(text, file);
  if (json.is_object() && json.contains("file") && json.at("file") == former_kind)
    throw UserError(file +
                    " is of a family, by an earlier build: families are proven as studies now; make it "
                    "again with 'shadefit certify'");
  try {
    return study_certificate_of(json);
  } catch (const Json::exception& error) {
    const std::string_view words(error.what());  // "[json.exception.out_of_range.403] key 'a' not found"
    throw UserError(fmt::format("{}: {}", file, words.substr(words.find(']') + 2)));
  } catch (const std::invalid_argument& error) {
    throw UserError(fmt::format("{}: {}", file, error.what()));
  }
}

}  // namespace shadefit
