#include "reports/rows/certificate_json.hpp"

#include <optional>
#include <tuple>

#include "fit/input/json_document.hpp"
#include "fit/support/hex_float.hpp"
#include "reports/io/digest.hpp"
#include "reports/io/own_fields.hpp"
#include "reports/rows/fit_json.hpp"

namespace shadefit {
namespace {

using Json = nlohmann::ordered_json;

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

Surface read_surface(const OwnFields& fields) {
  if (fields.field("surface").is_null()) return {};
  const OwnFields surface = fields.inner("surface");
  if (fields.field("surface").contains("f0")) {
    Surface any;
    any.f0 = surface.number("f0");
    return any;
  }
  return {surface.choice<Surface::Formula>(
              "formula", {{"exact", Surface::Formula::exact}, {"schlick", Surface::Formula::schlick}}),
          surface.number("ior"), surface.number("extinction"), std::nullopt};
}

Subject read_subject(const OwnFields& fields) {
  Subject subject;
  subject.family = fields.text("family");
  subject.parameters = fields.members("parameters");
  subject.setting.exponent = fields.field("exponent").is_null() ? 0 : fields.number("exponent");
  subject.setting.surface = read_surface(fields);
  subject.error = fields.choice("error", named_errors);
  std::tie(subject.domain.lower, subject.domain.upper) = fields.interval("domain");
  return subject;
}

CurveShape read_curve(const OwnFields& fields) {
  CurveShape curve;
  for (const std::string& text : fields.texts("proven")) {
    if (text == "falls with the angle" || text == "rises with the angle") {
      if (curve.trend != Trend::none) fields.fail("proven", "says twice how the form goes with the angle");
      curve.trend = text.starts_with("falls") ? Trend::falls : Trend::rises;
    } else if (text == "non-negative") {
      curve.is_non_negative = true;
    } else if (text == "at most 1") {
      curve.is_at_most_one = true;
    } else {
      fields.fail("proven", "is unknown: '" + text + "'");
    }
  }
  return curve;
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
  const OwnFields fields(json, file);
  fields.require_kind(kind_of_file, certificate_schema);
  ReadCertificate<Certificate> result{.refused = fields.fault_of_digest()};
  Certificate& certificate = result.certificate;
  certificate.subject = read_subject(fields);
  certificate.target = fields.text("target");
  certificate.form = fields.text("form");
  std::tie(certificate.lower, certificate.upper) = fields.interval("largest");
  const OwnFields attained = fields.inner("attained");
  certificate.attained = {attained.choice("of", origins), attained.number("at")};
  for (const Json& item : fields.list("places")) {
    const OwnFields place = fields.item(item);
    certificate.places.push_back({place.choice("of", origins), place.number("from"), place.number("to")});
  }
  certificate.curve = read_curve(fields);
  certificate.precision = fields.whole("precision");
  certificate.horizon = fields.numbers("boxes_in_c");
  certificate.peak = fields.numbers("boxes_in_1_minus_c");
  fields.require_written_as(write_certificate_json(certificate));
  return result;
}

}  // namespace shadefit
