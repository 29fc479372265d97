// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dewpoint-cli/calibrate/calibrate_commands.h"
#include "app/dewpoint-cli/calibrate/calibrate_output.h"
#include "app/dewpoint-cli/common/exit_code.h"
#include "app/wiring/open_project.h"
#include "core/base/angle.h"
#include "core/base/units.h"
#include "core/setup/calibration/floor_from_board.h"
#include "core/setup/calibration/moved_world.h"
#include "core/setup/calibration/world_step.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace dewpoint::app {
namespace {

struct WorldCommandOptions {
  std::string project;
  bool upright = false;
  std::string board;
  std::int64_t boardFrame = 0;
  std::vector<std::string> floor;
  std::vector<std::string> level;
  std::vector<std::string> xAxis;
  std::vector<std::string> origin;
  std::vector<std::string> length;
  double meters = 0.0;
  std::string turnAxis;
  std::vector<double> shift;
  double turnDegrees = 0.0;
  CalibrateOutput output;
};

Result<std::vector<MeasuredPoint>> pointsCalled(const Project& project,
                                                const std::vector<std::string>& names) {
  std::vector<MeasuredPoint> points;
  for (const std::string& name : names) {
    const auto found = std::ranges::find(project.measuredPoints, name, &MeasuredPoint::name);
    if (found == project.measuredPoints.end()) {
      return failure(ErrorCode::UnknownKey, project.file.string(), name,
                     "the project has no point with this name");
    }
    points.push_back(*found);
  }
  return points;
}

void printStep(std::string_view what, const WorldStepResult& step) {
  fmt::print("{:<8} rotated by {:.2f} degrees", what, inDegrees(step.rotationAngle));
  if (step.scale != 1.0) {
    fmt::print(", all lengths x {:.5f}", step.scale);
  }
  if (what == "floor") {
    fmt::print(", points within {:.2f} mm (RMS) of a plane", inMillimeters(step.floorRms));
  }
  fmt::print("\n");
}

/// The floor from the board that lies on it in one frame, if this is wanted.
Result<Project> onBoardFloor(Project project, const WorldCommandOptions& options) {
  if (options.board.empty()) {
    return project;
  }
  const auto board = parseBoard(options.board);
  if (!board) {
    return tl::make_unexpected(board.error());
  }
  auto inputs = openInputs(project);
  if (!inputs) {
    return tl::make_unexpected(inputs.error());
  }
  return withFloorFromBoard(project, *board, *inputs->source, options.boardFrame)
      .map([](FloorFromBoard found) {
        fmt::print("{:<8} rotated by {:.2f} degrees, board seen by {} camera{} with an error of "
                   "{:.2f} px (RMS)\n",
                   "board", inDegrees(found.rotationAngle), found.cameraCount,
                   found.cameraCount == 1 ? "" : "s", found.rmsPx);
        return std::move(found.project);
      });
}

/// One change after the other, in the order in which they make sense.
Result<Project> inNewWorld(Project project, const WorldCommandOptions& options) {
  struct Wanted {
    std::string_view what;
    WorldStep step;
    const std::vector<std::string>* points;
    bool isWanted;
  };
  const std::vector<std::string> none;
  for (const Wanted& one :
       {Wanted{"upright", WorldStep::Upright, &none, options.upright},
        {"floor", WorldStep::Floor, &options.floor, !options.floor.empty()},
        {"level", WorldStep::Level, &options.level, !options.level.empty()},
        {"length", WorldStep::Length, &options.length, !options.length.empty()},
        {"x axis", WorldStep::XAxis, &options.xAxis, !options.xAxis.empty()},
        {"origin", WorldStep::Origin, &options.origin, !options.origin.empty()}}) {
    if (!one.isWanted) {
      continue;
    }
    if (one.step == WorldStep::Upright && !canRotateUpright(project)) {
      fmt::print("upright  unchanged: the images are upright, or do not show which way is up\n");
      continue;
    }
    auto changed = pointsCalled(project, *one.points).and_then([&](const auto& points) {
      return withWorldStep(project, one.step, points, options.meters);
    });
    if (!changed) {
      return tl::make_unexpected(changed.error());
    }
    printStep(one.what, *changed);
    project = std::move(changed->project);
  }
  if (!options.turnAxis.empty()) {
    const WorldAxis axis = options.turnAxis == "x"   ? WorldAxis::X
                           : options.turnAxis == "y" ? WorldAxis::Y
                                                     : WorldAxis::Z;
    project = withMovedWorld(std::move(project), quarterTurns(axis, 1));
  }
  if (!options.shift.empty() || options.turnDegrees != 0.0) {
    const Eigen::Vector3d shift =
        options.shift.empty()
            ? Eigen::Vector3d::Zero().eval()
            : Eigen::Vector3d(options.shift[0], options.shift[1], options.shift[2]);
    project = withMovedWorld(std::move(project), rigidMotion(shift, options.turnDegrees * kDegree));
  }
  return project;
}

int moveWorld(const WorldCommandOptions& options) {
  if (options.output.writesProject && options.project.find(".toml") == std::string::npos) {
    reportError({ErrorCode::BadValue, "", "--apply", "only a project file can be changed"});
    return kExitUsage;
  }
  auto project = resolveProject(options.project);
  if (!project) {
    return reportError(project.error());
  }
  const auto moved = onBoardFloor(std::move(*project), options).and_then([&](Project onFloor) {
    return inNewWorld(std::move(onFloor), options);
  });
  if (!moved) {
    return reportError(moved.error());
  }
  fmt::print("{:<16} {:>9} {:>9} {:>9}\n", "camera", "x m", "y m", "z m");
  for (const ProjectCamera& camera : moved->cameras) {
    const Eigen::Vector3d center = camera.camera.center();
    fmt::print("{:<16} {:>9.4f} {:>9.4f} {:>9.4f}\n", camera.camera.name, center.x(), center.y(),
               center.z());
  }
  if (canRotateUpright(*moved)) {
    fmt::print("The images would be upright if the world were rotated: see --upright.\n");
  }
  const auto written = writeCalibrated(options.output, *moved, {});
  return written ? static_cast<int>(kExitDone) : reportError(written.error());
}

} // namespace

void addCalibrateWorldCommand(CLI::App& group, int& exitCode) {
  auto* command = group.add_subcommand(
      "world", "Set the floor, the origin, the axes and the scale of calibrated cameras.");
  auto options = std::make_shared<WorldCommandOptions>();
  command
      ->add_option("PROJECT", options->project,
                   "Project file (TOML); the points are its [[point]] tables, each clicked in the "
                   "images of at least two cameras")
      ->required();
  command->add_flag("--upright", options->upright,
                    "Rotate the world by quarter turns until the images are upright");
  auto* board = command->add_option(
      "--board", options->board,
      "Board that lies flat on the floor in --board-frame: its first corner becomes the origin, x "
      "runs along its rows, z up");
  command
      ->add_option("--board-frame", options->boardFrame,
                   "Frame in which the board lies on the floor, from 0")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str()
      ->needs(board);
  command
      ->add_option("--floor", options->floor,
                   "Names of three or more points on the floor, separated by commas: the first is "
                   "the origin, and the x axis points to the second")
      ->delimiter(',');
  command
      ->add_option("--level", options->level,
                   "Names of two points at the same height, separated by a comma")
      ->delimiter(',');
  auto* length =
      command
          ->add_option("--length", options->length,
                       "Names of two points at a measured distance, separated by a comma")
          ->delimiter(',');
  auto* meters =
      command->add_option("--meters", options->meters,
                          "Distance that you measured between the points of --length, meters");
  length->needs(meters);
  meters->needs(length);
  command
      ->add_option("--x-axis", options->xAxis,
                   "Names of two points, separated by a comma: the x axis points from the first to "
                   "the second, seen from above")
      ->delimiter(',');
  command->add_option("--origin", options->origin, "Name of the point that becomes the origin")
      ->expected(1);
  command
      ->add_option("--quarter-turn", options->turnAxis,
                   "Axis about which the cameras are rotated by 90 degrees")
      ->check(CLI::IsMember({"x", "y", "z"}));
  command
      ->add_option("--move", options->shift,
                   "X Y Z: how far to move all cameras along each axis, meters")
      ->expected(3);
  command->add_option(
      "--rotate", options->turnDegrees,
      "Angle by which to rotate all cameras about the vertical, before --move, degrees");
  command->add_option("--out", options->output.calibrationFile, "Calibration file to write");
  command->add_flag("--apply", options->output.writesProject,
                    "Write the cameras into the project file");
  command->callback([options, &exitCode] { exitCode = moveWorld(*options); });
}

} // namespace dewpoint::app
