// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dewpoint-cli/calibrate/calibrate_commands.h"
#include "app/dewpoint-cli/common/exit_code.h"
#include "app/wiring/open_project.h"
#include "core/base/units.h"
#include "core/calibration/formats/calibration_file.h"
#include "core/project/project_save.h"
#include "core/session/run/tracking_run.h"
#include "core/setup/calibration/wand_views.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <memory>

namespace dewpoint::app {
namespace {

struct PointsCommandOptions {
  std::string project;
  std::string out;
  bool apply = false;
  bool acceptOrientation = false;
  PointSettings points;
};

const char* statusText(PoseStatus status) {
  switch (status) {
  case PoseStatus::None:
    return "";
  case PoseStatus::TooFew:
    return "too few points; at least four are needed";
  case PoseStatus::Collinear:
    return "its points lie on one line";
  case PoseStatus::Ambiguous:
    return "a second pose fits equally well: add a point outside the plane";
  case PoseStatus::NoPose:
    return "no pose fits the clicked points";
  }
  return "";
}

const ProjectCamera& cameraOf(const Project& project, const CameraFromPoints& found) {
  return project.cameras[static_cast<std::size_t>(found.camera)];
}

/// "rotate = 180, mirror = true", as in a project file.
std::string orientationText(const ImageSymmetry& symmetry) {
  return fmt::format("rotate = {}, mirror = {}", symmetry.rotateDegrees, symmetry.isMirrored);
}

void printProposal(const Project& project, const CameraFromPoints& found) {
  const ProjectCamera& camera = cameraOf(project, found);
  const ImageSymmetry& symmetry = found.proposal->symmetry;
  const ImageSymmetry source = combined({camera.rotateDegrees, camera.isMirrored}, symmetry);
  fmt::print("{} seems to be {}{}{}: its points fit within {:.2f} px with {}{}.\n",
             camera.camera.name, symmetry.rotateDegrees != 0 ? "rotated" : "",
             symmetry.rotateDegrees != 0 && symmetry.isMirrored ? " and " : "",
             symmetry.isMirrored ? "mirrored" : "", found.proposal->rmsPx, orientationText(source),
             canSetImageSymmetry(camera) ? "; --accept-orientation sets it" : "");
}

void printCamera(const Project& project, const CameraFromPoints& found) {
  fmt::print("{:<16} {:>6} {:>8.3f}  {}\n", cameraOf(project, found).camera.name, found.clickCount,
             found.rmsPx, statusText(found.status));
  if (found.proposal) {
    printProposal(project, found);
  }
}

/// Sets what was proposed, and tells of it.
Project withOrientations(const Project& project, const PointSolution& solution) {
  Project changed = withProposedSymmetries(project, solution.cameras);
  for (const CameraFromPoints& found : solution.cameras) {
    const ProjectCamera& camera = cameraOf(changed, found);
    const ImageSymmetry set{camera.rotateDegrees, camera.isMirrored};
    const ProjectCamera& before = cameraOf(project, found);
    if (set != ImageSymmetry{before.rotateDegrees, before.isMirrored}) {
      fmt::print("{}: {} now.\n", camera.camera.name, orientationText(set));
    }
  }
  return changed;
}

void printPoints(const Project& project, const PointSolution& solution) {
  fmt::print("{:<24} {:<16} {:>8} {:>8}\n", "point", "camera", "px", "mm");
  for (const ClickResidual& residual : solution.residuals) {
    fmt::print("{:<24} {:<16} {:>8.3f} {:>8.2f}\n",
               project.measuredPoints[static_cast<std::size_t>(residual.pointIndex)].name,
               solution.rig[static_cast<std::size_t>(residual.camera)].name,
               residual.imageDistancePx, inMillimeters(residual.rayDistance));
  }
  if (solution.worstPoint) {
    const std::string& name =
        project.measuredPoints[static_cast<std::size_t>(*solution.worstPoint)].name;
    fmt::print("{}: {}.\n", solution.isWorstPointWrong ? "Does not fit the other points" : "Worst",
               name);
  }
}

int calibrate(const PointsCommandOptions& options) {
  if (options.apply && options.project.find(".toml") == std::string::npos) {
    reportError({ErrorCode::BadValue, "", "--apply", "only a project file can be changed"});
    return kExitUsage;
  }
  if (options.acceptOrientation && !options.apply) {
    reportError({ErrorCode::BadValue, "", "--accept-orientation",
                 "this is set in the project file, so --apply is needed as well"});
    return kExitUsage;
  }
  auto project = resolveProject(options.project);
  if (!project) {
    return reportError(project.error());
  }
  if (project->measuredPoints.empty()) {
    return reportError({ErrorCode::MissingKey, options.project, "point",
                        "there is no measured point to calibrate with"});
  }
  PointSolution solution =
      solveFromPoints(rigOf(*project), project->measuredPoints, options.points);
  if (options.acceptOrientation) {
    *project = withOrientations(*project, solution);
    solution = solveFromPoints(rigOf(*project), project->measuredPoints, options.points);
  }
  fmt::print("{:<16} {:>6} {:>8}\n", "camera", "points", "px");
  for (const CameraFromPoints& found : solution.cameras) {
    printCamera(*project, found);
  }
  printPoints(*project, solution);
  auto written = options.out.empty() ? Status() : saveCalibration(solution.rig, options.out);
  if (written && options.apply) {
    written = saveProject(withPointSolution(*project, solution, options.points.estimatesFocal),
                          options.project);
  }
  return written ? static_cast<int>(kExitDone) : reportError(written.error());
}

} // namespace

void addCalibratePointsCommand(CLI::App& group, int& exitCode) {
  auto* command = group.add_subcommand(
      "points", "Calibrate the cameras from measured points that were clicked in the images.");
  auto options = std::make_shared<PointsCommandOptions>();
  command->add_option("PROJECT", options->project, "Project file (TOML) with [[point]] tables")
      ->required();
  command->add_flag("--focal", options->points.estimatesFocal, "Calibrate the focal lengths, too");
  command->add_option("--out", options->out, "Calibration file to write");
  command->add_flag("--apply", options->apply, "Write the cameras into the project file");
  command->add_flag(
      "--accept-orientation", options->acceptOrientation,
      "Rotate or mirror the images of cameras whose points fit only that way; requires --apply");
  command->callback([options, &exitCode] { exitCode = calibrate(*options); });
}

} // namespace dewpoint::app
