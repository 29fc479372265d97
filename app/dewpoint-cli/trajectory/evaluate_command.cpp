// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dewpoint-cli/commands.h"
#include "app/dewpoint-cli/common/exit_code.h"
#include "core/base/sha256.h"
#include "core/base/text_file.h"
#include "core/calibration/formats/calibration_format.h"
#include "core/experiment/metrics/identity_evaluation.h"
#include "core/trajectory/evaluation_text.h"
#include "core/trajectory/export/trajectory_export.h"
#include "core/trajectory/jobs/gathered_jobs.h"
#include "core/trajectory/trajectory_reader.h"
#include "core/trajectory/truth_unit.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <memory>
#include <utility>

namespace dewpoint::app {
namespace {

struct EvaluateOptions {
  std::string trajectory;
  std::string truth;
  std::string truthUnit;
  double gate = kDefaultGate;
  bool json = false;
  bool identities = false;
  bool ground = false;
  bool save = false;
};

/// Writes evaluation.json into the folder of a run.
Status saveEvaluation(const std::filesystem::path& folder,
                      const std::vector<Evaluation>& evaluations) {
  return sha256OfFile(folder / "trajectory.csv").and_then([&](const std::string& sum) {
    return writeTextFile(folder / kEvaluationFile, evaluationFileText(evaluations, sum));
  });
}

/// The truth in meters; a note if it seems to be in another unit, which was not given.
Result<Trajectory> readTruth(const EvaluateOptions& options, const Trajectory& estimate) {
  auto truth = readTrajectory(options.truth);
  if (!truth) {
    return truth;
  }
  if (!options.truthUnit.empty()) {
    return toMeters(std::move(*truth), parseLengthUnit(options.truthUnit).value_or(1.0));
  }
  if (const auto unit = likelyTruthUnitInMeters(estimate, *truth)) {
    const bool isMillimeter = *unit < 0.005;
    fmt::print(stderr,
               "dewpoint-cli: note: the positions in {} fit if they are in {}; evaluate with "
               "--truth-unit {}.\n",
               options.truth, isMillimeter ? "millimeters" : "centimeters",
               isMillimeter ? "mm" : "cm");
  }
  return truth;
}

/// A name in a file can be any bytes.
std::string jsonOutput(const nlohmann::json& json) {
  return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace);
}

int evaluateIdentity(const EvaluateOptions& options, const Trajectory& estimate,
                     const Trajectory& truth) {
  const auto evaluation = evaluateIdentities(estimate, truth, {options.gate, options.ground});
  if (!evaluation) {
    return reportError(evaluation.error());
  }
  if (options.json) {
    fmt::print("{}\n", jsonOutput(identityJson(*evaluation)));
  } else {
    fmt::print("{}", identityText(*evaluation));
  }
  return kExitDone;
}

int evaluateFiles(const EvaluateOptions& options) {
  if (options.save && !std::filesystem::is_directory(options.trajectory)) {
    reportError(
        {ErrorCode::BadValue, options.trajectory, "--save", "it is not the folder of a run"});
    return kExitUsage;
  }
  const auto estimate = readExportSource(options.trajectory);
  if (!estimate) {
    return reportError(estimate.error());
  }
  const auto truth = readTruth(options, *estimate);
  if (!truth) {
    return reportError(truth.error());
  }
  if (options.identities) {
    return evaluateIdentity(options, *estimate, *truth);
  }
  const auto evaluations = evaluate(*estimate, *truth, options.gate);
  if (!evaluations) {
    return reportError(evaluations.error());
  }
  if (options.save) {
    if (const auto saved = saveEvaluation(options.trajectory, *evaluations); !saved) {
      return reportError(saved.error());
    }
  }
  if (options.json) {
    fmt::print("{}\n", jsonOutput(evaluationJson(*evaluations)));
  } else {
    fmt::print("{}", evaluationText(*evaluations));
  }
  return kExitDone;
}

} // namespace

void addEvaluateCommand(CLI::App& app, int& exitCode) {
  auto* command = app.add_subcommand("evaluate", "Compare a trajectory with the ground truth.");
  auto options = std::make_shared<EvaluateOptions>();
  command
      ->add_option("TRAJECTORY", options->trajectory,
                   "Trajectory (CSV) to evaluate, or the folder of a run")
      ->required();
  command->add_option("TRUTH", options->truth, "True positions (CSV)")->required();
  command
      ->add_option("--truth-unit", options->truthUnit,
                   "Unit of the positions in TRUTH: m, mm, cm, in, ft, or the length of one unit "
                   "in meters; m unless given")
      ->check(lengthUnitProblem);
  command->add_option("--gate", options->gate, "Error in meters above which a frame counts as lost")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command->add_flag("--json", options->json, "Print JSON (meters) instead of a table (mm)");
  command->add_flag("--identities", options->identities,
                    "Compare several targets with the ground truth whatever their names are, and "
                    "compute CLEAR MOT, HOTA and GOSPA");
  command
      ->add_flag("--save", options->save,
                 "Write evaluation.json into the run's folder, for dewpoint-cli gather")
      ->excludes("--identities");
  command->add_flag("--ground", options->ground, "With --identities: ignore heights");
  command->callback([options, &exitCode] { exitCode = evaluateFiles(*options); });
}

} // namespace dewpoint::app
