#include <fmt/format.h>

#include "app/commands/commands.hpp"
#include "app/commands/study_commands.hpp"
#include "app/options/fit_arguments.hpp"
#include "app/output/output_file.hpp"
#include "app/studies/chosen_study.hpp"
#include "approx/catalogue.hpp"
#include "fit/input/bounded_file.hpp"
#include "fit/proof/bound_width.hpp"
#include "fit/proof/certificate.hpp"
#include "fit/support/user_error.hpp"
#include "fit/verdicts/refit.hpp"
#include "reports/io/utf8.hpp"
#include "reports/rows/certificate_json.hpp"
#include "reports/rows/fit_json.hpp"
#include "reports/rows/proofs.hpp"
#include "reports/rows/statement.hpp"
#include "reports/studies/study_certificate_json.hpp"
#include "reports/table/writers.hpp"

/// The subcommands `certify` and `verify`.
namespace shadefit {
namespace {

/// Options of a fit that a proof of a family does not look at: they count with --form.
void refuse_options_of_fits(const Metric& metric) {
  const Constraints& constraints = metric.constraints;
  const auto refuse = [](const char* option, const std::string& value) {
    throw UserError(fmt::format("{} '{}' belongs to --form, a formula of your own", option, value));
  };
  if (metric.norm != Norm::least_squares) refuse("--norm", std::string(name(metric.norm)));
  if (!metric.weight.empty()) refuse("--weight", metric.weight);
  if (!constraints.held.empty())
    refuse("--fix", constraints.held.front().parameter + "=" + to_text(constraints.held.front().value));
  refuse_minimax_constraints(constraints);
}

VerifiedCertificate verify_family(const std::string& text, const std::string& file, const ShareDone& done) {
  const auto read = read_certificate(text, file);
  const Certificate& certificate = read.certificate;
  const std::string reason = read.refused.empty() ? reason_to_refuse(certificate, done) : read.refused;
  if (!reason.empty()) return {reason, ""};
  const std::size_t ends = certificate.horizon.size() + certificate.peak.size();
  const std::size_t sides = (certificate.horizon.empty() ? 0 : 1) + (certificate.peak.empty() ? 0 : 1);
  return {"", fmt::format(
                  "certificate '{}' holds: the largest {} error of {} is in [{}, {}], checked on {} boxes\n",
                  printable(file), name(certificate.subject.error), certificate.form, certificate.lower,
                  certificate.upper, ends - sides) +
                  statement_of(certificate)};
}

/// The check as findings: one, if the certificate is refused.
findings::FindingReport certificate_findings(const std::string& file, const std::string& refused) {
  return one_check("verify",
                   {"refused-certificate", "A certificate does not hold",
                    "Nothing is proven by it. Make it again: shadefit certify FORM --out FILE."},
                   "certificates", refused, {.path = file});
}

}  // namespace

Outcome certify_command(const CertifyOptions& options, const Checkpoint& checkpoint,
                        const Progress& progress) {
  if (const auto study = chosen_study(options.fit, checkpoint))
    return certify_study_command(*study, options, checkpoint, progress);
  if (options.fit.id.empty())
    throw UserError(
        "certify needs a family, a published constant, a study or --form (see 'shadefit list' and 'shadefit help certify')");
  refuse_options_of_fits(options.fit.metric);
  const NamedFit named = find_fit(options.fit.id);
  const FittableFamily& family = *named.family;
  const double width = options.width.value_or(usual_width);
  const std::vector<Setting> settings = settings_for(family, named.published, options.fit);
  const Metric metric = metric_for(options.fit, family, settings);
  const Error error = metric.error;
  if (options.out && settings.size() != 1)
    throw UserError(fmt::format("--out '{}' takes one certificate, not {}: name one --exponent", *options.out,
                                settings.size()));
  const auto file = options.out ? std::optional(OutputFile(*options.out, "the certificate")) : std::nullopt;

  std::vector<CertifiedForm> forms;
  const Checkpoint next = stepping(checkpoint, progress, "certify", settings.size());
  std::string err;
  for (const Setting& setting : settings) {
    next();
    const ChosenSubject chosen =
        chosen_constants(options.parameters, named, setting, metric, options.fit, checkpoint);
    forms.push_back({certify(chosen.subject, width, checkpoint), chosen.from});
    const std::string at =
        setting.exponent > 0 ? fmt::format(" at exponent {}", setting.exponent) : std::string();
    const auto& [certificate, is_reached, curve] = forms.back().certified;
    if (!is_reached) err += not_reached_line(certificate.subject.family + at, certificate, width);
  }
  const Certificate& first = forms.front().certified.certificate;
  std::function<void()> put;
  if (file) put = file->prepare(certificate_text(first), options.force, checkpoint);

  std::string out;
  if (options.fit.json) {
    out = json_text_of_each(json_array(forms, write_certified_json));
  } else {
    out = fmt::format("{}: {} ~ {}, {} error on {}, proven in {} bits\n", family.info.id, first.target,
                      first.form, name(error), to_text(first.subject.domain), first.precision) +
          write_console(certificates_table(family, forms), Precision::full, options.fit.terminal);
    if (options.out) out += fmt::format("\nCertificate: {}\n", printable(*options.out));
  }
  return {err.empty() ? 0 : 1, out, err, put};
}

Outcome verify_command(const VerifyOptions& options, const Checkpoint& checkpoint, const Progress& progress) {
  const auto done = bar(checkpoint, progress, "verify");
  const std::string text = read_bounded(options.file, most_certificate_bytes);
  const auto [refused, statement] = is_study_certificate(text, options.file)
                                        ? verify_study(text, options.file, done)
                                        : verify_family(text, options.file, done);
  if (options.format != FindingFormat::text)
    return outcome_of(certificate_findings(options.file, refused), options.format);
  if (refused.empty()) return {0, statement, ""};
  return {
      1, "",
      fmt::format("shadefit: certificate '{}' is refused: {}\n", printable(options.file), one_line(refused))};
}

}  // namespace shadefit
