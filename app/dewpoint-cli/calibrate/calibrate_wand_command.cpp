// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dewpoint-cli/calibrate/calibrate_commands.h"
#include "app/dewpoint-cli/calibrate/calibrate_output.h"
#include "app/dewpoint-cli/common/exit_code.h"
#include "app/dewpoint-cli/common/frame_range.h"
#include "app/dewpoint-cli/common/interruption.h"
#include "app/dewpoint-cli/common/progress.h"
#include "app/wiring/open_project.h"
#include "core/base/angle.h"
#include "core/base/text_file.h"
#include "core/base/units.h"
#include "core/calibration/formats/calibration_file.h"
#include "core/project/project_save.h"
#include "core/setup/calibration/wand_refinement.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <memory>
#include <optional>

namespace dewpoint::app {
namespace {

struct WandCommandOptions {
  std::string project;
  std::string target;
  std::vector<std::string> stick;
  std::vector<double> distance, drop, offBy;
  std::string frames, out, report;
  bool apply = false;
  WandOptions wand;
};

Status settle(WandCommandOptions& options) {
  WandOptions& wand = options.wand;
  const auto wrong = [](const char* option, const char* why) {
    return failure(ErrorCode::BadValue, "", option, why);
  };
  wand.targets = options.stick;
  if (!options.target.empty()) {
    wand.targets = {options.target};
  }
  if (options.stick.empty() != !(wand.stickLength > 0.0)) {
    return wrong("--stick", "--stick and --length must be used together");
  }
  if (!options.distance.empty()) {
    wand.touchedDistance =
        TouchedDistance{options.distance[0], options.distance[1], options.distance[2]};
  }
  if (!options.drop.empty()) {
    wand.freeFallSpan = std::array<double, 2>{options.drop[0], options.drop[1]};
  }
  if (!options.offBy.empty()) {
    wand.initialPositionError = options.offBy[0];
    wand.initialRotationError = options.offBy[1] * kDegree;
  }
  const auto frames = parseFrames(options.frames);
  if (!frames) {
    return tl::make_unexpected(frames.error());
  }
  wand.firstFrame = frames->first;
  wand.endFrame = frames->end;
  if (options.apply && options.project.find(".toml") == std::string::npos) {
    return wrong("--apply", "only a project file can be changed");
  }
  return {};
}

/// The bar of whatever is being done.
class WandBars {
public:
  bool show(const WandCalibrationProgress& work) {
    if (!bar_ || work.isSearching != looking_) {
      finish();
      bar_.emplace(work.isSearching ? "looking" : "solving", work.totalStepCount);
      looking_ = work.isSearching;
    }
    bar_->show(work.doneStepCount);
    return !wasInterruptionRequested();
  }
  void finish() {
    if (bar_) {
      bar_->finish();
    }
    bar_.reset();
  }

private:
  std::optional<Progress> bar_;
  bool looking_ = true;
};

void printCameras(const WandRefinement& refinement) {
  const WandOptions& options = refinement.options;
  const WandResult& result = refinement.result;
  fmt::print("{:<16} {:>6} {:>8} {:>7} {:>9} {:>9}", "camera", "views", "dropped", "px", "moved cm",
             "rotated deg");
  fmt::print("{}{}\n", options.estimatesTimeOffsets ? "  delay ms" : "",
             options.estimatesFocalLengths ? "   focal" : "");
  for (std::size_t c = 0; c < result.cameras.size(); ++c) {
    const Camera& camera = result.cameras[c];
    const PoseShift shift = poseShift(refinement.camerasBefore[c], camera);
    fmt::print("{:<16} {:>6} {:>8} {:>7} {:>9.2f} {:>11.2f}", camera.name, result.usedViewCounts[c],
               result.droppedViewCounts[c],
               result.usedViewCounts[c] > 0
                   ? fmt::format("{:.3f}", result.cameraMedianResidualPx[c])
                   : "-",
               inCentimeters(shift.meters), inDegrees(shift.radians));
    if (options.estimatesTimeOffsets) {
      fmt::print(" {:>9.2f}", -inMilliseconds(result.timeOffsets[c]) + 0.0); // no -0.00
    }
    if (options.estimatesFocalLengths) {
      fmt::print(" {:>7.1f}", camera.intrinsics.focalX);
    }
    fmt::print("\n");
  }
}

void printDecisions(const WandOptions& options, const WandResult& result) {
  fmt::print("Median reprojection error {:.3f} px; best of {} starts; {:.1f} s.\n",
             result.medianResidualPx, result.starts.size(), result.computationSeconds);
  const char* source = result.scaleMethod == WandScale::Stick      ? "the length of the wand"
                       : result.scaleMethod == WandScale::Distance ? "the measured distance"
                       : result.scaleMethod == WandScale::Diameter ? "the ball's diameter"
                                                                   : "the earlier calibration";
  fmt::print("Size: from {}, {:+.2f} % compared with before", source,
             inPercent(result.scaleFactor - 1.0));
  if (result.scaleSigma > 0.0) {
    fmt::print(" (+-{:.2f} %)", inPercent(result.scaleSigma));
  }
  fmt::print(".\n");
  if (result.isFloorFound) {
    fmt::print("Floor: from {} positions, flat to {:.1f} mm; z = 0 on the floor.\n",
               options.floorTimes.size(), inMillimeters(result.floorRmsDistance));
  } else if (!options.floorTimes.empty()) {
    fmt::print("Floor: height from {} positions. Give three or more to measure the upward "
               "direction, too.\n",
               options.floorTimes.size());
  }
  if (result.freeFall) {
    fmt::print("Fall: gravity {:.2f} +- {:.2f} m/s^2 from {} frames; 9.81 is expected.\n",
               result.freeFall->gravity, result.freeFall->gravitySigma,
               result.freeFall->usedPositionCount);
  }
  if (result.isFloorFound || result.freeFall) {
    fmt::print("Upward direction: rotated by {:.2f} degrees.\n",
               inDegrees(result.upCorrectionAngle));
  } else {
    fmt::print("World: the upward direction is unchanged.\n");
  }
}

void printAccuracyOf(const WandRefinement& refinement) {
  const auto& accuracy = refinement.accuracy;
  printAccuracy(accuracy ? std::optional(*accuracy) : std::nullopt,
                accuracy ? accuracySummary(*accuracy) : "none; " + errorSentence(accuracy.error()),
                refinement.result.faults);
}

int calibrate(WandCommandOptions options) {
  if (const auto settled = settle(options); !settled) {
    reportError(settled.error());
    return kExitUsage;
  }
  auto inputs = resolveProject(options.project).and_then([](Project project) {
    return openInputs(std::move(project));
  });
  if (!inputs) {
    return reportError(inputs.error());
  }
  catchInterruption();
  WandBars bars;
  const auto result =
      refineFromRecording(inputs->project, *inputs->source, options.wand,
                          [&](const WandCalibrationProgress& work) { return bars.show(work); });
  bars.finish();
  if (!result) {
    return reportError(result.error());
  }
  printCameras(*result);
  printDecisions(options.wand, result->result);
  printAccuracyOf(*result);
  for (const FarOffCamera& camera : farOffCameras(*result)) {
    fmt::print("note: {}\n", farOffText(camera, result->camerasBefore));
  }
  const CameraRig& cameras = result->result.cameras;
  for (const MotionGap& gap : result->gaps) {
    fmt::print("note: {}\n", motionGapText(gap, result->camerasBefore));
  }
  const std::optional<std::string> kept =
      isUnnecessary(*result)               ? std::optional(unnecessaryRefinementText(*result))
      : areOldCamerasMoreAccurate(*result) ? std::optional(oldCamerasMoreAccurateText(*result))
                                           : std::nullopt;
  const bool better = !isInaccurate(*result) && !kept;
  if (kept && options.apply) {
    reportError({ErrorCode::Undetermined, inputs->project.file.string(), "cameras",
                 *kept + "; the project was not changed"});
  } else if (kept) {
    fmt::print("note: {}\n", *kept);
  } else if (!better) {
    reportError(
        {ErrorCode::Undetermined, inputs->project.file.string(), "cameras",
         fmt::format(
             "less accurate than before (error up to {:.2f} m): wave through more of the volume{}",
             options.wand.initialPositionError,
             options.apply ? "; the project was not changed" : "")});
  }
  auto written = options.out.empty() ? Status() : saveCalibration(cameras, options.out);
  if (written && options.apply && better) {
    written = saveProject(withRefinement(inputs->project, *result), options.project);
  }
  if (written && !options.report.empty()) {
    written = writeTextFile(options.report, htmlText(*result));
  }
  if (!written) {
    return reportError(written.error());
  }
  return better || !options.apply ? kExitDone : kExitBadInput;
}

} // namespace

void addCalibrateWandCommand(CLI::App& group, int& exitCode) {
  auto* command = group.add_subcommand("wand", "Refine the calibration from a recording in which "
                                               "you wave a ball, or a wand with two balls.");
  auto options = std::make_shared<WandCommandOptions>();
  WandOptions& wand = options->wand;
  const auto positive = CLI::Range(1e-6, 1e6);
  command->add_option("PROJECT", options->project, "Project file (TOML), or a built-in scene: demo")
      ->required();
  auto* target = command->add_option("--target", options->target,
                                     "The ball; optional if the project has only one target");
  command->add_option("--stick", options->stick, "The targets at both ends of the wand")
      ->expected(2)
      ->excludes(target);
  auto* length = command
                     ->add_option("--length", wand.stickLength,
                                  "Distance between the centers of the balls, meters")
                     ->check(positive);
  command->add_option("--frames", options->frames,
                      "Only frames A to B-1, as A:B (either may be empty)");
  command->add_flag("--offsets", wand.estimatesTimeOffsets,
                    "Find the delay of each camera relative to the first; --apply saves it");
  command->add_flag("--focal", wand.estimatesFocalLengths, "Find the focal lengths");
  command->add_flag("--k1", wand.estimatesDistortion, "Find the first distortion coefficient");
  auto* distance = command
                       ->add_option("--distance", options->distance,
                                    "T1 T2 METERS: at the times T1 and T2, in seconds, the ball "
                                    "was held at two positions that are METERS apart")
                       ->expected(3)
                       ->excludes(length);
  command->add_flag("--diameter", wand.usesBallDiameter, "Scale from the ball's diameter")
      ->excludes(length)
      ->excludes(distance);
  command->add_option("--floor", wand.floorTimes,
                      "Times in seconds at which the ball touched the floor");
  command
      ->add_option("--drop", options->drop,
                   "FROM UNTIL: times in seconds between which the ball fell freely")
      ->expected(2);
  command
      ->add_option(
          "--off-by", options->offBy,
          fmt::format("METERS DEGREES: how far off the cameras may be at the start ({} {:.1f})",
                      kInitialPositionError, inDegrees(kInitialRotationError)))
      ->expected(2);
  command->add_option("--out", options->out, "Calibration file to write");
  command->add_option("--report", options->report,
                      "HTML report to write: residuals, coverage and a 3D drawing");
  command->add_flag("--apply", options->apply, "Write the cameras into the project file");
  command->callback([options, &exitCode] { exitCode = calibrate(*options); });
}

} // namespace dewpoint::app
