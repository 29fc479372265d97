// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dewpoint-cli/calibrate/calibrate_commands.h"
#include "app/dewpoint-cli/common/exit_code.h"
#include "app/wiring/open_project.h"
#include "core/calibration/formats/calibration_file.h"
#include "core/project/project_save.h"
#include "core/session/run/tracking_run.h"
#include "core/setup/wand_views.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <memory>

namespace dewpoint::app {
namespace {

struct PointsCommandOptions {
  std::string project;
  std::string out;
  bool apply = false;
  PointSettings points;
};

const char* statusText(PoseStatus status) {
  switch (status) {
  case PoseStatus::None:
    return "";
  case PoseStatus::TooFew:
    return "too few points, four or more are needed";
  case PoseStatus::Collinear:
    return "its points lie on one line";
  case PoseStatus::Ambiguous:
    return "a second pose fits as well: add a point outside the plane";
  case PoseStatus::NoPose:
    return "no pose shows the points there";
  }
  return "";
}

void printCamera(const CameraRig& rig, const CameraFromPoints& found) {
  const std::string& name = rig[static_cast<std::size_t>(found.camera)].name;
  fmt::print("{:<16} {:>6} {:>8.3f}  {}\n", name, found.clicks, found.rmsPx,
             statusText(found.status));
  if (found.proposal) {
    const ImageSymmetry& symmetry = found.proposal->symmetry;
    fmt::print("{} seems to be {}{}{}: its points fit to {:.2f} px with rotate += {}{}.\n", name,
               symmetry.rotateDegrees != 0 ? "rotated" : "",
               symmetry.rotateDegrees != 0 && symmetry.mirrored ? " and " : "",
               symmetry.mirrored ? "mirrored" : "", found.proposal->rmsPx, symmetry.rotateDegrees,
               symmetry.mirrored ? " and mirror = true" : "");
  }
}

void printPoints(const Project& project, const PointSolution& solution) {
  fmt::print("{:<24} {:<16} {:>8} {:>8}\n", "point", "camera", "px", "mm");
  for (const ClickResidual& residual : solution.residuals) {
    fmt::print("{:<24} {:<16} {:>8.3f} {:>8.2f}\n",
               project.points[static_cast<std::size_t>(residual.point)].name,
               solution.rig[static_cast<std::size_t>(residual.camera)].name, residual.pixels,
               1000.0 * residual.meters);
  }
  if (solution.worst) {
    const std::string& name = project.points[static_cast<std::size_t>(*solution.worst)].name;
    fmt::print("{}: {}.\n", solution.worstExplains ? "Does not fit the rest" : "Worst", name);
  }
}

int calibrate(const PointsCommandOptions& options) {
  if (options.apply && options.project.find(".toml") == std::string::npos) {
    report({ErrorCode::BadValue, "", "--apply", "only a project file can be changed"});
    return kExitUsage;
  }
  const auto project = resolveProject(options.project);
  if (!project) {
    return report(project.error());
  }
  if (project->points.empty()) {
    return report(
        {ErrorCode::MissingKey, options.project, "point", "no measured point to calibrate from"});
  }
  const PointSolution solution = solveFromPoints(rigOf(*project), project->points, options.points);
  fmt::print("{:<16} {:>6} {:>8}\n", "camera", "points", "px");
  for (const CameraFromPoints& found : solution.cameras) {
    printCamera(solution.rig, found);
  }
  printPoints(*project, solution);
  auto written = options.out.empty() ? Status() : saveCalibration(solution.rig, options.out);
  if (written && options.apply) {
    written = saveProject(withCameras(*project, solution.rig), options.project);
  }
  return written ? static_cast<int>(kExitDone) : report(written.error());
}

} // namespace

void addCalibratePointsCommand(CLI::App& group, int& exitCode) {
  auto* command = group.add_subcommand(
      "points", "Find the cameras from measured points that were clicked in the images.");
  auto options = std::make_shared<PointsCommandOptions>();
  command->add_option("PROJECT", options->project, "Project file (TOML) with [[point]] tables")
      ->required();
  command->add_flag("--focal", options->points.alsoFocal, "Find the focal lengths too");
  command->add_option("--out", options->out, "Calibration file to write");
  command->add_flag("--apply", options->apply, "Write the cameras into the project file");
  command->callback([options, &exitCode] { exitCode = calibrate(*options); });
}

} // namespace dewpoint::app
