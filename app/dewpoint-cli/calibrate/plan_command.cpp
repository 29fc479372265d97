// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dewpoint-cli/commands.h"
#include "app/dewpoint-cli/common/exit_code.h"
#include "app/dewpoint-cli/common/interruption.h"
#include "app/wiring/open_project.h"
#include "core/base/angle.h"
#include "core/base/units.h"
#include "core/calibration/formats/calibration_file.h"
#include "core/calibration/manual/interactive_pose.h"
#include "core/calibration/planning/camera_placement.h"
#include "core/calibration/planning/rig_map.h"
#include "core/geometry/camera_name.h"
#include "core/project/project_rig.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <memory>
#include <optional>
#include <vector>

namespace dewpoint::app {
namespace {

struct PlanOptions {
  std::string project;
  std::vector<double> volume;        ///< least x, y, z, then largest; empty: the project's room
  std::vector<int> size;             ///< of the new camera's images
  std::optional<double> fieldOfView; ///< degrees
  std::string out;
  PlacementSettings placement;
};

/// Like the project's first camera where it is not said.
Camera newCamera(const PlanOptions& options, const CameraRig& rig) {
  constexpr int kUsualWidth = 640; // pixels
  constexpr int kUsualHeight = 480;
  constexpr double kUsual = 1.0; // radians
  const bool known = !rig.empty() && rig.front().intrinsics.width > 0;
  const std::vector<int> like =
      known ? std::vector{rig.front().intrinsics.width, rig.front().intrinsics.height}
            : std::vector{kUsualWidth, kUsualHeight};
  const std::vector<int>& size = options.size.empty() ? like : options.size;
  const double angle = options.fieldOfView ? *options.fieldOfView * kDegree
                       : known             ? fieldOfView(rig.front())
                                           : kUsual;
  return idealCamera(unusedCameraName(rig), size[0], size[1], angle);
}

Result<Eigen::AlignedBox3d> volumeOf(const PlanOptions& options, const Project& project) {
  const CameraRig rig = rigOf(project);
  Eigen::AlignedBox3d volume = roomVolume(rig, project.grid.value_or(referenceGridFor(rig)));
  if (const auto& v = options.volume; !v.empty()) {
    volume = {Eigen::Vector3d(v[0], v[1], v[2]), Eigen::Vector3d(v[3], v[4], v[5])};
  }
  if (volume.isEmpty() || volume.sizes().minCoeff() <= 0.0) {
    return failure(ErrorCode::BadValue, "", "--volume",
                   "expected the smallest x, y, z first, then the largest");
  }
  return volume;
}

void printRig(const CameraRig& rig, const PlacementSettings& settings) {
  const RigMap map =
      RigMapper().map(gridOver(settings.volume, kMapCells), settings.pixelSigma, rig);
  const RigMapSummary summary = summaryOf(map, settings.maxGoodSigma);
  const Eigen::Vector3d low = settings.volume.min();
  const Eigen::Vector3d high = settings.volume.max();
  fmt::print("volume                  {:.2f} {:.2f} {:.2f} to {:.2f} {:.2f} {:.2f} m\n", low.x(),
             low.y(), low.z(), high.x(), high.y(), high.z());
  fmt::print("cameras                 {}\n", rig.size());
  fmt::print("within {:.4g} mm         {:.1f} % of the volume\n",
             inMillimeters(settings.maxGoodSigma), inPercent(summary.fractionWithinLimit));
  fmt::print("fewer than two cameras  {:.1f} %\n", inPercent(summary.fractionSeenByTooFew));
}

int plan(PlanOptions& options) {
  const auto project = resolveProject(options.project);
  if (!project) {
    return reportError(project.error());
  }
  const auto volume = volumeOf(options, *project);
  if (!volume) {
    reportError(volume.error());
    return kExitUsage;
  }
  options.placement.volume = *volume;
  options.placement.reportedCellCount = kMapCells;
  CameraRig rig = rigOf(*project);
  printRig(rig, options.placement);
  catchInterruption();
  const auto found =
      placeCamera(rig, newCamera(options, rig), options.placement,
                  [](CalibrationStage, double) { return !wasInterruptionRequested(); });
  if (!found) {
    return found.error().code == ErrorCode::Canceled ? static_cast<int>(kExitInterrupted)
                                                     : reportError(found.error());
  }
  const Eigen::Vector3d center = found->camera.center();
  const Heading heading = headingOf(found->camera);
  fmt::print(
      "best new position       {:.2f} {:.2f} {:.2f} m, yaw {:.1f} degrees, pitch {:.1f} degrees\n",
      center.x(), center.y(), center.z(), inDegrees(heading.yaw), inDegrees(heading.pitch));
  fmt::print("within {:.4g} mm then    {:.1f} % of the volume, {:.1f} % before\n",
             inMillimeters(options.placement.maxGoodSigma),
             inPercent(found->goodVolumeFractionAfter), inPercent(found->goodVolumeFractionBefore));
  if (!options.out.empty()) {
    rig.push_back(found->camera);
    if (const auto written = saveCalibration(rig, options.out); !written) {
      return reportError(written.error());
    }
  }
  return kExitDone;
}

} // namespace

void addPlanCommand(CLI::App& app, int& exitCode) {
  auto* command = app.add_subcommand("plan", "Compute how accurately the cameras measure in a "
                                             "volume, and the best position for another camera.");
  auto options = std::make_shared<PlanOptions>();
  PlacementSettings& placement = options->placement;
  command->add_option("PROJECT", options->project, "Project file (TOML), or a built-in scene")
      ->required();
  command
      ->add_option("--volume", options->volume,
                   "X Y Z X Y Z: lower and upper corner of the volume, meters; the room above the "
                   "project's floor grid if omitted")
      ->expected(6);
  command->add_option("--size", options->size, "Width and height of the new camera's images")
      ->expected(2)
      ->check(CLI::Range(16, 100000));
  command
      ->add_option("--fov", options->fieldOfView,
                   "Horizontal field of view of the new camera, degrees")
      ->check(CLI::Range(1.0, 170.0));
  command
      ->add_option("--wall", placement.wallDistance,
                   "Distance from the volume to the walls and the ceiling on which the camera can "
                   "be mounted, meters")
      ->check(CLI::Range(0.0, 1000.0))
      ->capture_default_str();
  command
      ->add_option("--pixel-sigma", placement.pixelSigma,
                   "Standard deviation with which the target is found in an image, pixels")
      ->check(CLI::Range(0.001, 100.0))
      ->capture_default_str();
  command
      ->add_option(
          "--good", placement.maxGoodSigma,
          "Largest standard deviation of a position that counts as accurate enough, meters")
      ->check(CLI::Range(1e-6, 10.0))
      ->capture_default_str();
  command->add_option("--out", options->out, "Calibration file to write, with the new camera");
  command->callback([options, &exitCode] { exitCode = plan(*options); });
}

} // namespace dewpoint::app
