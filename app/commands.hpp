#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/command_line.hpp"
#include "app/progress.hpp"

/// The subcommands, once their arguments are parsed. Each throws UserError for input that is the user's to
/// mend; those that work for long call a checkpoint, between fits and until they begin to put files in place.
namespace shadefit {

struct ListOptions {
  std::optional<std::string> verdict;  ///< only the claims with this one; computes them
  bool json = false;
  bool latex = false;
};

struct RunOptions {
  std::string out = "out";
  std::vector<std::string> only;
  bool plots = true;
  bool force = false;  ///< files of others are replaced
};

struct FitOptions {
  std::string id;
  std::optional<std::string> exponent;  ///< empty: the record's own sweep
  std::string measure = "cosine";
  std::string norm = "least-squares";
  std::string error = "absolute";
  std::optional<std::string> f0;         ///< what relative errors of a Fresnel form are stated for
  std::optional<std::string> weight;     ///< a formula in c
  std::vector<std::string> fix;          ///< "NAME=VALUE" each
  std::vector<std::string> exact_at;     ///< ends of the domain
  std::optional<std::string> one_sided;  ///< "above" or "below"
  std::optional<std::string> at_most, at_least;
  std::optional<std::string> domain;      ///< "A:B" in cosines; empty: all of [0, 1]
  std::string target = "schlick";         ///< or "exact": the reflectance of a surface; Fresnel families only
  std::optional<std::string> ior;         ///< of the surface; empty: none in particular, of an exact one 1.5
  std::optional<std::string> extinction;  ///< empty: 0, a dielectric
  bool json = false;
  bool csv = false;
  bool latex = false;
  bool certify = false;              ///< with proofs
  std::optional<std::string> round;  ///< "half", "bfloat16", "float" or "decimal:N": with constants of it
  bool sensitivity = false;          ///< with what a change of each constant does
};

struct BetterOptions {
  FitOptions fit;                     ///< which form, where; how it is printed
  std::optional<std::string> target;  ///< empty: of a Fresnel form the usual three
};

struct CertifyOptions {
  FitOptions fit;                         ///< which form, where, and the fit where nothing was published
  std::optional<std::string> parameters;  ///< "a=-5.55473,b=-6.98316"; empty: published, else fitted
  std::string width = "1e-9";             ///< of the bounds, relative
  std::optional<std::string> out;         ///< a file for the certificate
  bool force = false;                     ///< as of `RunOptions`
};

struct EmitOptions {
  FitOptions fit;                         ///< which form, where, and the fit where nothing was published
  std::optional<std::string> parameters;  ///< as of `CertifyOptions`
  std::string language;                   ///< "glsl" ..; empty with `check`
  std::string precision = "float";        ///< or "half"
  std::optional<std::string> name;        ///< of the function; empty: the family's
  std::optional<std::string> out;         ///< a file; empty: printed
  bool force = false;                     ///< as of `RunOptions`
  std::optional<std::string> check;       ///< a file that was generated
};

struct VerifyOptions {
  std::string file;
};

struct StressOptions {
  std::string out = "out";
  bool force = false;  ///< as of `RunOptions`
};

struct ExplainOptions {
  std::string id;
};

struct CheckOptions {
  std::string baseline = "reports/baseline";
  bool all = false;  ///< the slow tables too
};

Outcome list_command(const ListOptions& options, const Checkpoint& checkpoint);
Outcome run_command(const RunOptions& options, const Checkpoint& checkpoint);
Outcome fit_command(const FitOptions& options, const Checkpoint& checkpoint, const Progress& progress);
Outcome better_command(const BetterOptions& options, const Checkpoint& checkpoint);
Outcome certify_command(const CertifyOptions& options, const Checkpoint& checkpoint,
                        const Progress& progress);
Outcome verify_command(const VerifyOptions& options, const Checkpoint& checkpoint, const Progress& progress);
Outcome emit_command(const EmitOptions& options, const Checkpoint& checkpoint, const Progress& progress);
Outcome explain_command(const ExplainOptions& options);
Outcome stress_command(const StressOptions& options, const Checkpoint& checkpoint, const Progress& progress);
Outcome check_command(const CheckOptions& options, const Checkpoint& checkpoint, const Progress& progress);

}  // namespace shadefit
