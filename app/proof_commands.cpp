#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "app/commands.hpp"
#include "app/fit_arguments.hpp"
#include "app/metric_options.hpp"
#include "approx/catalogue.hpp"
#include "fit/certificate.hpp"
#include "fit/enclosure.hpp"
#include "fit/refit.hpp"
#include "fit/sweep.hpp"
#include "fit/user_error.hpp"
#include "reports/certificate_json.hpp"
#include "reports/files.hpp"
#include "reports/fit_json.hpp"
#include "reports/proofs.hpp"
#include "reports/utf8.hpp"
#include "reports/writers.hpp"

/// The subcommands `certify` and `verify`.
namespace shadefit {
namespace {

using Parameters = std::vector<std::pair<std::string, std::string>>;

/// "a=-5.55473,b=-6.98316", in the order of the family where the names are its own.
Parameters parse_parameters(const std::string& text, const FittableFamily& family) {
  Parameters parameters;
  for (std::size_t start = 0; start <= text.size();) {
    const std::size_t end = std::min(text.find(',', start), text.size());
    const std::string part = text.substr(start, end - start);
    const std::size_t equals = part.find('=');
    if (equals == 0 || equals == std::string::npos)
      throw UserError(fmt::format("--parameters '{}' is not a list NAME=VALUE, by commas", text));
    parameters.emplace_back(part.substr(0, equals), part.substr(equals + 1));
    start = end + 1;
  }
  const auto rank = [&](const auto& parameter) {
    return std::find(family.parameters.begin(), family.parameters.end(), parameter.first) -
           family.parameters.begin();
  };
  std::stable_sort(parameters.begin(), parameters.end(),
                   [&](const auto& a, const auto& b) { return rank(a) < rank(b); });
  return parameters;
}

/// The number that was published for a parameter of a fit: of the record that was asked for, else the first
/// that is meant as the best fit in that setting.
const Published* published_for(const FittableFamily& family, std::string_view parameter,
                               const Setting& setting, const Published* asked) {
  if (asked != nullptr && asked->parameter == parameter) return asked;
  for (const Published& p : published_constants) {
    if (p.family != family.info.id || p.parameter != parameter || p.statement != Statement::best_fit)
      continue;
    if (!family.has_exponent() || exponents_of(p) == std::vector{setting.exponent}) return &p;
  }
  return nullptr;
}

/// Whose values a subject has.
struct ChosenSubject {
  Subject subject;
  std::string_view from;
};

ChosenSubject chosen_constants(const CertifyOptions& options, const NamedFit& named, const Setting& setting,
                               const Metric& metric, Error error) {
  const FittableFamily& family = *named.family;
  Subject subject{std::string(family.info.id), {}, setting, error, metric.domain};
  if (options.parameters) {
    subject.parameters = parse_parameters(*options.parameters, family);
    return {subject, "given"};
  }
  for (const std::string_view parameter : family.parameters) {
    if (const Published* p = published_for(family, parameter, setting, named.published))
      subject.parameters.emplace_back(parameter, p->printed);
  }
  if (subject.parameters.size() == family.parameters.size()) return {subject, "published"};
  const Fit fit = family.fit(setting, metric);
  if (fit.status != Status::converged) {
    throw UserError(fmt::format(
        "{}{}: nothing was published for it and its fit did not converge: give --parameters", family.info.id,
        family.has_exponent() ? fmt::format(" at exponent {}", setting.exponent) : ""));
  }
  return {subject_of(fit, error), "fitted"};
}

/// A relative width that bounds can have.
double parse_relative_width(const std::string& text) {
  const auto width = parse_number(text);
  if (!width) throw UserError(fmt::format("--width '{}' is not a finite number", text));
  if (!(*width > 0 && *width < 1))
    throw UserError(
        fmt::format("--width '{}' is no relative width: it must be greater than 0 and less than 1", text));
  if (*width < least_width)
    throw UserError(fmt::format("--width '{}' cannot be reached: the bounds are doubles, {} is the least",
                                text, least_width));
  return *width;
}

/// Where a certificate goes: the directory and the name of its file.
std::pair<std::filesystem::path, std::string> parse_file(const std::string& text) {
  const std::filesystem::path path(text);
  const std::string name = path.filename().string();
  if (name.empty() || name == "." || name == ".." || std::filesystem::is_directory(path))
    throw UserError(fmt::format("--out '{}' names no file for the certificate", text));
  const std::filesystem::path directory = path.has_parent_path() ? path.parent_path() : ".";
  require_directory(directory);
  return {directory, name};
}

std::string not_reached(const Certificate& certificate, double width) {
  const Setting& setting = certificate.subject.setting;
  return fmt::format("shadefit: {}{}: the width {} was not reached: the largest error is in [{}, {}]\n",
                     certificate.subject.family,
                     setting.exponent > 0 ? fmt::format(" at exponent {}", setting.exponent) : "", width,
                     certificate.lower, certificate.upper);
}

}  // namespace

Outcome certify_command(const CertifyOptions& options, const Checkpoint& checkpoint) {
  const NamedFit named = find_fit(options.fit.id);
  const FittableFamily& family = *named.family;
  const double width = parse_relative_width(options.width);
  const std::vector<Setting> settings = settings_for(family, named.published, options.fit);
  const Metric metric = parse_metric(options.fit, family, settings);
  const Error error = metric.error;
  if (options.out && settings.size() != 1)
    throw UserError(fmt::format("--out '{}' takes one certificate, not {}: name one --exponent", *options.out,
                                settings.size()));
  const auto file = options.out ? std::optional(parse_file(*options.out)) : std::nullopt;

  std::vector<CertifiedForm> forms;
  std::string err;
  for (const Setting& setting : settings) {
    checkpoint();
    const ChosenSubject chosen = chosen_constants(options, named, setting, metric, error);
    forms.push_back({certify(chosen.subject, width), chosen.from});
    if (!forms.back().certified.is_reached) err += not_reached(forms.back().certified.certificate, width);
  }
  const Certificate& first = forms.front().certified.certificate;
  if (file) write_files(file->first, {{file->second, certificate_text(first)}}, checkpoint);

  std::string out;
  if (options.fit.json) {
    auto array = nlohmann::ordered_json::array();
    for (const CertifiedForm& form : forms) array.push_back(write_certified_json(form));
    out = json_text_of_each(array);
  } else {
    out = fmt::format("{}: {} ~ {}, {} error on {}, proven in {} bits\n", family.info.id, first.target,
                      first.form, name(error), to_text(first.subject.domain), first.precision) +
          write_console(certificates_table(family, forms), Precision::full);
    if (options.out) out += fmt::format("\nCertificate: {}\n", printable(*options.out));
  }
  return {err.empty() ? 0 : 1, out, err};
}

Outcome verify_command(const VerifyOptions& options) {
  const ReadCertificate read = read_certificate(read_file(options.file), options.file);
  const Certificate& certificate = read.certificate;
  const std::string reason = read.refused.empty() ? reason_to_refuse(certificate) : read.refused;
  const std::string file = printable(options.file);
  if (!reason.empty())
    return {1, "", fmt::format("shadefit: certificate '{}' is refused: {}\n", file, one_line(reason))};
  const std::size_t ends = certificate.horizon.size() + certificate.peak.size();
  const std::size_t sides = (certificate.horizon.empty() ? 0 : 1) + (certificate.peak.empty() ? 0 : 1);
  return {
      0,
      fmt::format("certificate '{}' holds: the largest {} error of {} is in [{}, {}], checked on {} boxes\n",
                  file, name(certificate.subject.error), certificate.form, certificate.lower,
                  certificate.upper, ends - sides),
      ""};
}

}  // namespace shadefit
