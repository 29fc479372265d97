// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dewpoint-cli/calibrate/calibrate_output.h"

#include "app/dewpoint-cli/common/exit_code.h"
#include "app/dewpoint-cli/common/interruption.h"
#include "app/dewpoint-cli/common/progress.h"
#include "core/base/text_file.h"
#include "core/calibration/formats/calibration_file.h"
#include "core/project/project_save.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <optional>

namespace dewpoint::app {
namespace {

constexpr std::int64_t kProgressSteps = 1000;

/// Before the progress bar.
const char* nameOf(CalibrationStage stage) {
  switch (stage) {
  case CalibrationStage::BoardDetection:
    return "looking for the board";
  case CalibrationStage::Intrinsics:
    return "solving";
  case CalibrationStage::Chaining:
    return "chaining";
  case CalibrationStage::Adjustment:
    return "adjusting";
  case CalibrationStage::Assessment:
    return "judging";
  case CalibrationStage::PlacementSearch:
    return "places";
  }
  return "";
}

} // namespace

bool isSingleProject(const std::vector<std::string>& inputs) {
  const std::filesystem::path first(inputs.front());
  return inputs.size() == 1 && (first.extension() == ".toml" || first.extension() == ".dewpoint" ||
                                !first.has_extension());
}

void addOutputOptions(CLI::App& command, CalibrateOutput& output, bool ofProject) {
  command.add_option("--out", output.calibrationFile, "Calibration file (TOML) to write");
  command.add_option("--report", output.reportFile,
                     "HTML report to write: residuals, coverage, errors of each image");
  if (ofProject) {
    command.add_flag("--apply", output.writesProject, "Write the result into the project file");
  }
}

Status writeCalibrated(const CalibrateOutput& output, const Project& calibrated,
                       const std::string& reportHtml) {
  CameraRig rig;
  for (const ProjectCamera& camera : calibrated.cameras) {
    rig.push_back(camera.camera);
  }
  if (!output.reportFile.empty()) {
    if (const auto written = writeTextFile(output.reportFile, reportHtml); !written) {
      return written;
    }
  }
  if (!output.calibrationFile.empty()) {
    if (const auto written = saveCalibration(rig, output.calibrationFile); !written) {
      return written;
    }
  }
  return output.writesProject ? saveProject(calibrated, calibrated.file) : Status();
}

CalibrationProgress interruptibleProgress() {
  catchInterruption();
  struct Shown {
    std::optional<CalibrationStage> stage;
    std::unique_ptr<Progress> bar;
    ~Shown() {
      if (bar != nullptr) {
        bar->finish();
      }
    }
  };
  return [shown = std::make_shared<Shown>()](CalibrationStage stage, double part) {
    if (shown->stage != stage) {
      shown->stage = stage;
      if (shown->bar != nullptr) {
        shown->bar->finish();
      }
      shown->bar = std::make_unique<Progress>(nameOf(stage), kProgressSteps);
    }
    shown->bar->show(static_cast<std::int64_t>(part * static_cast<double>(kProgressSteps)));
    return !wasInterruptionRequested();
  };
}

void printAccuracy(const std::optional<CalibrationAccuracy>& accuracy, const std::string& sentence,
                   const std::vector<DetectedFault>& faults) {
  fmt::print("Calibration accuracy: {}\n", sentence);
  if (accuracy && accuracy->errorInflationFactor > 1.0) {
    fmt::print("Solutions from parts of the recording vary {:.1f} times more than noise predicts. "
               "The stated accuracy includes this.\n",
               accuracy->errorInflationFactor);
  }
  for (const DetectedFault& fault : faults) {
    fmt::print("Fault: {}\n", fault.sentence);
  }
}

int reportCalibrationError(const Error& error) {
  if (error.code == ErrorCode::Canceled) {
    fmt::print(stderr, "dewpoint-cli: stopped; the previous calibration is kept.\n");
    return kExitInterrupted;
  }
  return reportError(error);
}

} // namespace dewpoint::app
