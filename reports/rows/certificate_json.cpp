#include "reports/rows/certificate_json.hpp"

#include <cstdint>
#include <limits>
#include <optional>
#include <utility>

#include "fit/support/hex_float.hpp"
#include "fit/support/json_document.hpp"
#include "fit/support/user_error.hpp"
#include "reports/io/digest.hpp"

namespace shadefit {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kind_of_file = "shadefit certificate";

std::string_view name(Origin side) {
  return side == Origin::peak ? "1 - c" : "c";
}

Json hex_list(const std::vector<double>& values) {
  Json list = Json::array();
  for (const double value : values) list.push_back(hex_text(value));
  return list;
}

Json places_json(const std::vector<Box>& places) {
  Json list = Json::array();
  for (const Box& place : places)
    list.push_back(
        {{"of", name(place.side)}, {"from", hex_text(place.lower)}, {"to", hex_text(place.upper)}});
  return list;
}

Json surface_json(const Surface& surface) {
  if (surface.f0) return {{"f0", hex_text(*surface.f0)}};
  if (!surface.is_named()) return {};
  return {{"formula", surface.is_exact() ? "exact" : "schlick"},
          {"ior", hex_text(surface.ior)},
          {"extinction", hex_text(surface.extinction)}};
}

/// Fields of a JSON object, each refused with its name where it is not what it has to be.
class Reader {
 public:
  Reader(const Json& json, std::string name) : json_(json), name_(std::move(name)) {}

  const Json& field(const char* key) const {
    if (!json_.is_object() || !json_.contains(key)) fail(key, "is missing");
    return json_.at(key);
  }
  std::string text(const char* key) const { return text_of(field(key), key); }
  double number(const char* key) const { return number_of(field(key), key); }
  std::vector<double> numbers(const char* key) const {
    std::vector<double> values;
    for (const Json& item : list(key)) values.push_back(number_of(item, key));
    return values;
  }
  const Json& list(const char* key) const {
    if (!field(key).is_array()) fail(key, "is not a list");
    return field(key);
  }
  int integer(const char* key) const {
    const Json& json = field(key);
    constexpr int most = std::numeric_limits<int>::max();
    const bool is_count = json.is_number_unsigned() && json.get<std::uint64_t>() <= std::uint64_t{most};
    if (!is_count) fail(key, "is not a whole number from 0 to " + std::to_string(most));
    return json.get<int>();
  }
  /// One of the texts that stand for values.
  template <class T>
  T choice(const char* key, const std::vector<std::pair<std::string_view, T>>& known) const {
    const std::string text = this->text(key);
    for (const auto& [name, value] : known) {
      if (name == text) return value;
    }
    fail(key, "is unknown: '" + text + "'");
  }
  Reader inner(const char* key) const { return {field(key), name_}; }
  Reader item(const Json& json) const { return {json, name_}; }
  std::string text_of(const Json& json, const char* key) const {
    if (!json.is_string()) fail(key, "is not a text");
    return json.get<std::string>();
  }
  [[noreturn]] void fail(const char* key, const std::string& rule) const {
    throw UserError("certificate '" + name_ + "': the field '" + key + "' " + rule);
  }

 private:
  double number_of(const Json& json, const char* key) const {
    const auto value = parse_hex(text_of(json, key));
    if (!value)
      fail(key, "holds '" + text_of(json, key) + "', which is no hexadecimal double as shadefit prints it");
    return *value;
  }

  const Json& json_;
  std::string name_;
};

const std::vector<std::pair<std::string_view, Origin>> origins{{name(Origin::horizon), Origin::horizon},
                                                               {name(Origin::peak), Origin::peak}};

Surface read_surface(const Reader& reader) {
  if (reader.field("surface").is_null()) return {};
  const Reader surface = reader.inner("surface");
  if (reader.field("surface").contains("f0")) {
    Surface any;
    any.f0 = surface.number("f0");
    return any;
  }
  return {surface.choice<Surface::Formula>(
              "formula", {{"exact", Surface::Formula::exact}, {"schlick", Surface::Formula::schlick}}),
          surface.number("ior"), surface.number("extinction"), std::nullopt};
}

Subject read_subject(const Reader& reader) {
  Subject subject;
  subject.family = reader.text("family");
  if (!reader.field("parameters").is_object()) reader.fail("parameters", "is not an object");
  for (const auto& [key, value] : reader.field("parameters").items())
    subject.parameters.emplace_back(key, reader.text_of(value, "parameters"));
  subject.setting.exponent = reader.field("exponent").is_null() ? 0 : reader.number("exponent");
  subject.setting.surface = read_surface(reader);
  subject.error = reader.choice<Error>(
      "error", {{name(Error::absolute), Error::absolute}, {name(Error::relative), Error::relative}});
  const auto domain = reader.numbers("domain");
  if (domain.size() != 2) reader.fail("domain", "is not a pair");
  subject.domain = {domain[0], domain[1]};
  return subject;
}

CurveShape read_curve(const Reader& reader) {
  CurveShape curve;
  for (const Json& item : reader.list("proven")) {
    const std::string text = reader.text_of(item, "proven");
    if (text == "falls with the angle" || text == "rises with the angle") {
      if (curve.trend != Trend::none) reader.fail("proven", "says twice how the form goes with the angle");
      curve.trend = text.starts_with("falls") ? Trend::falls : Trend::rises;
    } else if (text == "non-negative") {
      curve.is_non_negative = true;
    } else if (text == "at most 1") {
      curve.is_at_most_one = true;
    } else {
      reader.fail("proven", "is unknown: '" + text + "'");
    }
  }
  return curve;
}

}  // namespace

Json write_certificate_json(const Certificate& certificate) {
  const Subject& subject = certificate.subject;
  Json parameters = Json::object();
  for (const auto& [key, value] : subject.parameters) parameters[key] = value;
  Json proven = Json::array();
  const CurveShape& curve = certificate.curve;
  if (curve.trend != Trend::none) proven.push_back(std::string(name(curve.trend)) + " with the angle");
  if (curve.is_non_negative) proven.push_back("non-negative");
  if (curve.is_at_most_one) proven.push_back("at most 1");
  Json json{{"file", kind_of_file},
            {"schema", certificate_schema},
            {"family", subject.family},
            {"target", certificate.target},
            {"form", certificate.form},
            {"parameters", parameters},
            {"exponent", subject.setting.exponent > 0 ? Json(hex_text(subject.setting.exponent)) : Json()},
            {"surface", surface_json(subject.setting.surface)},
            {"error", name(subject.error)},
            {"domain", hex_list({subject.domain.lower, subject.domain.upper})},
            {"largest", hex_list({certificate.lower, certificate.upper})},
            {"attained",
             {{"of", name(certificate.attained.side)}, {"at", hex_text(certificate.attained.distance)}}},
            {"places", places_json(certificate.places)},
            {"proven", proven},
            {"precision", certificate.precision},
            {"boxes_in_c", hex_list(certificate.horizon)},
            {"boxes_in_1_minus_c", hex_list(certificate.peak)}};
  json[digest_field] = digest_of(json);
  return json;
}

std::string certificate_text(const Certificate& certificate) {
  return write_certificate_json(certificate).dump(1) + "\n";
}

ReadCertificate read_certificate(const std::string& text, const std::string& name) {
  const Json json = parse_own_json(text, "certificate '" + name + "'");
  const Reader reader(json, name);
  if (!json.is_object() || !json.contains("file") || json.at("file") != kind_of_file)
    throw UserError("'" + name + "' is not a certificate: its field 'file' does not say '" + kind_of_file +
                    "'");
  if (const int schema = reader.integer("schema"); schema != certificate_schema) {
    throw UserError("certificate '" + name + "' is of version " + std::to_string(schema) +
                    ": this shadefit reads version " + std::to_string(certificate_schema));
  }
  ReadCertificate result;
  const std::string digest = digest_of(json);
  if (const std::string stated = reader.text(digest_field); stated != digest)
    result.refused = "its digest is " + stated + ", that of its fields is " + digest;
  Certificate& certificate = result.certificate;
  certificate.subject = read_subject(reader);
  certificate.target = reader.text("target");
  certificate.form = reader.text("form");
  const auto largest = reader.numbers("largest");
  if (largest.size() != 2) reader.fail("largest", "is not a pair");
  certificate.lower = largest[0];
  certificate.upper = largest[1];
  const Reader attained = reader.inner("attained");
  certificate.attained = {attained.choice<Origin>("of", origins), attained.number("at")};
  for (const Json& item : reader.list("places")) {
    const Reader place = reader.item(item);
    certificate.places.push_back(
        {place.choice<Origin>("of", origins), place.number("from"), place.number("to")});
  }
  certificate.curve = read_curve(reader);
  certificate.precision = reader.integer("precision");
  certificate.horizon = reader.numbers("boxes_in_c");
  certificate.peak = reader.numbers("boxes_in_1_minus_c");
  // The digest is judged apart.
  Json written = write_certificate_json(certificate);
  written[digest_field] = json.at(digest_field);
  if (const std::string key = first_difference(json, written); !key.empty())
    reader.fail(key.c_str(), "is unknown, or not as shadefit writes it");
  return result;
}

}  // namespace shadefit
