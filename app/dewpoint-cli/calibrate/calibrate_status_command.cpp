// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dewpoint-cli/calibrate/calibrate_commands.h"
#include "app/dewpoint-cli/common/exit_code.h"
#include "app/wiring/open_project.h"
#include "core/base/units.h"
#include "core/setup/calibration/calibration_guide.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <string>

namespace dewpoint::app {
namespace {

std::string lensText(const ItemStatus& lens) {
  return std::string(originText(lens)) +
         (lens.error ? fmt::format(" +-{:.2f} px", *lens.error) : "") +
         (lens.isPoor ? " (poor)" : "");
}

std::string poseText(const ItemStatus& pose) {
  return std::string(originText(pose)) +
         (pose.error ? fmt::format(" +-{:.1f} mm", inMillimeters(*pose.error)) : "") +
         (pose.isPoor ? " (poor)" : "");
}

void printWorld(const CalibrationStatus& status) {
  fmt::print("scale     {}{}\n", originText(status.scale),
             status.scale.error ? fmt::format(" +-{:.2f} % (95 %)", inPercent(*status.scale.error))
                                : "");
  fmt::print("floor     {}\n",
             status.isUpright ? originText(status.floor) : "the z axis does not seem to point up");
  fmt::print("accuracy  {}\n", status.errorInVolume
                                   ? fmt::format("{:.1f} mm in the calibrated volume (95 %)",
                                                 inMillimeters(*status.errorInVolume))
                                   : "not measured");
  if (status.errorOutsideVolume) {
    fmt::print("          {:.1f} mm outside this volume (95 %, extrapolated)\n",
               inMillimeters(*status.errorOutsideVolume));
  }
  if (status.lengthCheck) {
    fmt::print("length    {:.4f} m measured, {:.4f} m found\n", status.lengthCheck->measuredLength,
               status.lengthCheck->calibratedLength);
  }
}

int printStatus(const std::string& name) {
  const auto project = resolveProject(name);
  if (!project) {
    return reportError(project.error());
  }
  const CalibrationStatus status = calibrationStatus(*project);
  std::size_t width = 6;
  for (const ProjectCamera& camera : project->cameras) {
    width = std::max(width, camera.camera.name.size());
  }
  fmt::print("{:<{}}  {:<26} {:<26} {:>9}\n", "camera", width, "lens", "position", "delay ms");
  for (std::size_t k = 0; k < status.cameras.size(); ++k) {
    const CameraCalibrationStatus& camera = status.cameras[k];
    fmt::print("{:<{}}  {:<26} {:<26} {:>9.1f}\n", project->cameras[k].camera.name, width,
               lensText(camera.lens), poseText(camera.pose), inMilliseconds(camera.delaySeconds));
  }
  printWorld(status);
  return kExitDone;
}

} // namespace

void addCalibrateStatusCommand(CLI::App& group, int& exitCode) {
  auto* command = group.add_subcommand(
      "status",
      "Print what is known about the calibration of each camera, and how accurate it is.");
  auto project = std::make_shared<std::string>();
  command->add_option("PROJECT", *project, "Project file (TOML), or a built-in scene: demo")
      ->required();
  command->callback([project, &exitCode] { exitCode = printStatus(*project); });
}

} // namespace dewpoint::app
