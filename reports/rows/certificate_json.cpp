#include "reports/rows/certificate_json.hpp"

#include <optional>
#include <tuple>

#include "fit/input/json_document.hpp"
#include "fit/support/hex_float.hpp"
#include "reports/io/own_json.hpp"
#include "reports/rows/fit_json.hpp"

namespace shadefit {
namespace {

using Json = OwnJson;

constexpr const char* kind_of_file = "shadefit certificate";

std::string_view name(Origin side) {
  return side == Origin::peak ? "1 - c" : "c";
}

Json places_json(const std::vector<Box>& places) {
  return json_array(places, [](const Box& place) -> Json {
    return {{"of", name(place.side)}, {"from", hex_text(place.lower)}, {"to", hex_text(place.upper)}};
  });
}

Json surface_json(const Surface& surface) {
  if (surface.f0) return {{"f0", hex_text(*surface.f0)}};
  if (!surface.is_named()) return {};
  return {{"formula", surface.is_exact() ? "exact" : "schlick"},
          {"ior", hex_text(surface.ior)},
          {"extinction", hex_text(surface.extinction)}};
}

const std::vector<std::pair<std::string_view, Origin>> origins{{name(Origin::horizon), Origin::horizon},
                                                               {name(Origin::peak), Origin::peak}};

Surface read_surface(const Json& json) {
  Surface surface;
  if (json.is_null()) return surface;
  if (json.contains("f0")) {
    surface.f0 = own_number(json.at("f0"));
    return surface;
  }
  return {own_choice<Surface::Formula>(json.at("formula"), {{"exact", Surface::Formula::exact},
                                                            {"schlick", Surface::Formula::schlick}}),
          own_number(json.at("ior")), own_number(json.at("extinction")), std::nullopt};
}

Subject read_subject(const Json& json) {
  Subject subject;
  subject.family = json.at("family");
  subject.parameters = own_members(json.at("parameters"));
  const Json& exponent = json.at("exponent");
  subject.setting.exponent = exponent.is_null() ? 0 : own_number(exponent);
  subject.setting.surface = read_surface(json.at("surface"));
  subject.error = own_choice(json.at("error"), named_errors);
  std::tie(subject.domain.lower, subject.domain.upper) = own_interval(json.at("domain"));
  return subject;
}

CurveShape read_curve(const Json& proven) {
  CurveShape curve;
  for (const Json& item : proven) {
    const auto text = item.get<std::string>();
    if (text == "falls with the angle" || text == "rises with the angle") {
      if (curve.trend != Trend::none)
        throw std::invalid_argument("'proven' says twice how the form goes with the angle");
      curve.trend = text.starts_with("falls") ? Trend::falls : Trend::rises;
    } else if (text == "non-negative") {
      curve.is_non_negative = true;
    } else if (text == "at most 1") {
      curve.is_at_most_one = true;
    } else {
      throw std::invalid_argument("'" + text + "' is unknown");
    }
  }
  return curve;
}

ReadCertificate<Certificate> certificate_of(const Json& json) {
  require_kind(json, kind_of_file, certificate_schema);
  ReadCertificate<Certificate> result{.refused = fault_of_digest(json)};
  Certificate& certificate = result.certificate;
  certificate.subject = read_subject(json);
  certificate.target = json.at("target");
  certificate.form = json.at("form");
  std::tie(certificate.lower, certificate.upper) = own_interval(json.at("largest"));
  const Json& attained = json.at("attained");
  certificate.attained = {own_choice(attained.at("of"), origins), own_number(attained.at("at"))};
  for (const Json& place : json.at("places"))
    certificate.places.push_back(
        {own_choice(place.at("of"), origins), own_number(place.at("from")), own_number(place.at("to"))});
  certificate.curve = read_curve(json.at("proven"));
  certificate.precision = own_whole(json.at("precision"));
  certificate.horizon = own_numbers(json.at("boxes_in_c"));
  certificate.peak = own_numbers(json.at("boxes_in_1_minus_c"));
  require_written_as(json, write_certificate_json(certificate));
  return result;
}

}  // namespace

Json hex_list(const std::vector<double>& values) {
  return json_array(values, hex_text);
}

Json write_certificate_json(const Certificate& certificate) {
  const Subject& subject = certificate.subject;
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
            {"parameters", json_object(subject.parameters)},
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

ReadCertificate<Certificate> read_certificate(const std::string& text, const std::string& name) {
  const std::string file = "certificate '" + name + "'";
  const Json json = parse_own_json(text, file);
  return read_own(file, [&] { return certificate_of(json); });
}

}  // namespace shadefit
