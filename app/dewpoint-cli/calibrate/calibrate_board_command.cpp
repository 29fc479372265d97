// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dewpoint-cli/calibrate/calibrate_commands.h"
#include "app/dewpoint-cli/calibrate/calibrate_output.h"
#include "app/dewpoint-cli/common/exit_code.h"
#include "app/dewpoint-cli/common/frame_range.h"
#include "app/wiring/open_project.h"
#include "core/base/units.h"
#include "core/setup/calibration/board_outcome.h"
#include "core/setup/calibration/mirrored_videos.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <memory>

namespace dewpoint::app {
namespace {

struct BoardOptions {
  std::vector<std::string> inputs;
  std::string board;
  std::string frames;
  std::string model = "5";
  std::string pixels = "measured";
  std::string corners = "sample";
  bool searchAll = false;
  bool mendMirrored = false;
  BoardCalibrationRequest request;
  CalibrateOutput output;
};

/// The text options that stand for values.
Status takeRequest(BoardOptions& options) {
  const auto board = parseBoard(options.board);
  if (!board) {
    return tl::make_unexpected(board.error());
  }
  const auto frames = parseFrames(options.frames);
  if (!frames) {
    return tl::make_unexpected(frames.error());
  }
  options.request.board = *board;
  options.request.firstFrame = frames->first;
  options.request.endFrame = frames->end;
  options.request.checksForOtherBoardFirst = !options.searchAll;
  options.request.model = options.model == "8"         ? IntrinsicsModel::EightCoefficients
                          : options.model == "fisheye" ? IntrinsicsModel::Fisheye
                                                       : IntrinsicsModel::FiveCoefficients;
  options.request.pixelShape = options.pixels == "square" ? PixelShape::Square
                               : options.pixels == "free" ? PixelShape::Free
                                                          : PixelShape::Measured;
  return {};
}

void printLens(const Camera& camera) {
  const auto& in = camera.intrinsics;
  const auto& d = camera.distortion;
  const int count = camera.lens == LensModel::Fisheye           ? 4
                    : d[5] != 0.0 || d[6] != 0.0 || d[7] != 0.0 ? 8
                                                                : 5;
  fmt::print("K [[{:.4f}, 0, {:.4f}], [0, {:.4f}, {:.4f}], [0, 0, 1]]\n", in.focalX, in.centerX,
             in.focalY, in.centerY);
  fmt::print("{} [{:.6f}]\n",
             camera.lens == LensModel::Fisheye ? "fisheye distortion" : "distortion",
             fmt::join(d.begin(), d.begin() + count, ", "));
}

void printViews(const std::vector<ViewFit>& views) {
  for (const ViewFit& view : views) {
    if (!view.isUsed) {
      fmt::print("left out: {}: {}\n", view.name, view.reason);
    } else if (view.isDoubtful) {
      fmt::print("doubtful: {}: {}\n", view.name, view.reason);
    }
  }
}

void printIntrinsics(const BoardDetections::PerCamera& seen, const IntrinsicsResult& result,
                     bool named) {
  if (named) {
    fmt::print("{}\n", seen.name);
  }
  fmt::print("the board was found in {} of {} images; {} are used\n", seen.views.size(),
             seen.searchedImageCount, std::ranges::count(result.views, true, &ViewFit::isUsed));
  if (const std::string missed = missedImagesText(seen); !missed.empty()) {
    fmt::print("{}\n", missed);
  }
  fmt::print("RMS {:.4f} px\n", result.rmsPx);
  printLens(result.camera);
  const auto& focal = result.parameters.front();
  fmt::print("{} {:.2f} +- {:.2f} px; error of a ray at most {:.2f} px (1 sigma) anywhere in the "
             "image; the corners cover {:.0f} % of it\n",
             focal.name, focal.value, focal.sigma, result.maxProjectionSigmaPx,
             inPercent(result.coverage.coveredFraction()));
  printViews(result.views);
}

void printLenses(const BoardDetections& seen, const LensesFromBoards& lenses) {
  for (std::size_t k = 0; k < lenses.cameras.size(); ++k) {
    if (lenses.cameras[k]) {
      printIntrinsics(seen.cameras[k], *lenses.cameras[k], lenses.cameras.size() > 1);
    }
  }
  for (const Error& kept : lenses.keptIntrinsicsReasons) {
    fmt::print("note: {}.\n", keptIntrinsicsText(kept));
  }
}

void printPositions(const BoardDetections& seen, const BoardOutcome& outcome) {
  const ExtrinsicsResult& result = *outcome.extrinsics;
  fmt::print("RMS {:.4f} px over {} board poses\n", result.rmsPx, result.boardPoses.size());
  for (std::size_t k = 0; k < result.cameras.size(); ++k) {
    const Camera& camera = result.cameras[k];
    const CameraFit& fit = result.cameraFits[k];
    const Eigen::Vector3d center = camera.center();
    const Eigen::Vector3d axis = camera.opticalAxis();
    fmt::print("{}\n", seen.cameras[k].name);
    if (std::ranges::none_of(fit.views, &ViewFit::isUsed)) {
      fmt::print("{} in {} images; it keeps its pose\n",
                 fit.views.empty() ? "never saw the board" : "fits in none of its views",
                 seen.cameras[k].searchedImageCount);
      printViews(fit.views);
      continue;
    }
    fmt::print("RMS {:.4f} px; at {:.4f} {:.4f} {:.4f} m, looking along {:.4f} {:.4f} {:.4f}",
               fit.rmsPx, center.x(), center.y(), center.z(), axis.x(), axis.y(), axis.z());
    if (fit.centerSigma > 0.0) {
      fmt::print("; +- {:.2f} mm, {:.3f} degrees relative to the first camera",
                 inMillimeters(fit.centerSigma), inDegrees(fit.rotationSigma));
    }
    fmt::print("\n");
    printViews(fit.views);
  }
  for (const std::string& notice : result.notices) {
    fmt::print("note: {}.\n", notice);
  }
  printAccuracy(outcome.accuracy, outcome.accuracySummary, result.faults);
}

/// Calibrates, says what was found, and writes it.
int calibrate(const BoardOptions& options, const BoardGoal& goal, const Project& project,
              const BoardDetections& seen, const CalibrationProgress& progress) {
  const auto outcome = calibrateFromBoards(project, seen, options.request, goal, progress);
  if (!outcome) {
    return reportCalibrationError(outcome.error());
  }
  if (outcome->lenses) {
    printLenses(seen, *outcome->lenses);
  }
  if (outcome->extrinsics) {
    printPositions(seen, *outcome);
  }
  const auto written = writeCalibrated(options.output, outcome->project, outcome->report);
  return written ? static_cast<int>(kExitDone) : reportError(written.error());
}

int intrinsicsOfPictures(const BoardOptions& options) {
  const std::vector<std::filesystem::path> files(options.inputs.begin(), options.inputs.end());
  const auto effort =
      options.corners == "sample" ? DetectionEffort::Sample : DetectionEffort::Exact;
  const auto progress = interruptibleProgress();
  const auto seen = findBoards(files, options.request.board, effort, progress,
                               options.request.checksForOtherBoardFirst);
  if (!seen) {
    return reportCalibrationError(seen.error());
  }
  if (const auto text = mirroredText(mirroredVideos(*seen), {"camera"}); !text.empty()) {
    fmt::print("note: {}\n", text);
  }
  Project project;
  project.cameras.emplace_back().camera.name = "camera";
  BoardOptions all = options;
  all.request.maxViews =
      std::max<int>(options.request.maxViews, static_cast<int>(files.size())); // all of them
  return calibrate(all, {true, false}, project, *seen, progress);
}

/// A project's recording, with the board looked for in it.
struct FoundBoards {
  Project project;
  BoardDetections seen;
};

Result<FoundBoards> readBoards(const BoardOptions& options, const CalibrationProgress& progress) {
  auto project = resolveProject(options.inputs.front());
  if (!project) {
    return tl::make_unexpected(project.error());
  }
  if (options.output.writesProject && project->file.empty()) {
    return failure(ErrorCode::BadValue, "", "--apply", "a built-in scene has no project file");
  }
  auto inputs = openInputs(std::move(*project));
  if (!inputs) {
    return tl::make_unexpected(inputs.error());
  }
  auto seen = findBoards(inputs->project, *inputs->source, options.request, progress);
  if (!seen) {
    return tl::make_unexpected(seen.error());
  }
  return FoundBoards{std::move(inputs->project), std::move(*seen)};
}

/// Names mirrored videos. If this is wanted, mirrors their images and searches them again.
Result<FoundBoards> withoutMirroredVideos(const BoardOptions& options, FoundBoards found,
                                          const CalibrationProgress& progress) {
  const MirroredVideos mirrored = mirroredVideos(found.seen);
  if (mirrored.cause == MirroredVideos::Cause::None) {
    return found;
  }
  std::vector<std::string> names;
  for (const auto& camera : found.seen.cameras) {
    names.push_back(camera.name);
  }
  const std::string text = mirroredText(mirrored, names);
  if (!options.mendMirrored) {
    fmt::print("note: {} Mirror its images with --mend-mirrored.\n", text);
    return found;
  }
  fmt::print("note: {} Its images are mirrored now.\n", text);
  auto inputs = openInputs(withUnmirroredVideos(std::move(found.project), mirrored));
  if (!inputs) {
    return tl::make_unexpected(inputs.error());
  }
  auto seen = findBoards(inputs->project, *inputs->source, options.request, progress);
  if (!seen) {
    return tl::make_unexpected(seen.error());
  }
  return FoundBoards{std::move(inputs->project), std::move(*seen)};
}

int calibrateProject(const BoardOptions& options, const BoardGoal& goal) {
  const auto progress = interruptibleProgress();
  const auto searched = readBoards(options, progress).and_then([&](FoundBoards found) {
    return withoutMirroredVideos(options, std::move(found), progress);
  });
  if (!searched) {
    return reportCalibrationError(searched.error());
  }
  return calibrate(options, goal, searched->project, searched->seen, progress);
}

int intrinsics(BoardOptions& options) {
  if (const auto taken = takeRequest(options); !taken) {
    reportError(taken.error());
    return kExitUsage;
  }
  if (isSingleProject(options.inputs)) {
    return calibrateProject(options, {true, false});
  }
  if (options.output.writesProject) {
    reportError({ErrorCode::BadValue, "", "--apply",
                 "image files have no project file to write to; use --out"});
    return kExitUsage;
  }
  if (!options.frames.empty()) {
    reportError({ErrorCode::BadValue, "", "--frames",
                 "this option is only for recordings; omit it for image files"});
    return kExitUsage;
  }
  if (options.mendMirrored) {
    reportError({ErrorCode::BadValue, "", "--mend-mirrored",
                 "image files have no project; mirror the files"});
    return kExitUsage;
  }
  return intrinsicsOfPictures(options);
}

int extrinsics(BoardOptions& options) {
  if (const auto taken = takeRequest(options); !taken) {
    reportError(taken.error());
    return kExitUsage;
  }
  return calibrateProject(options, {false, true});
}

void addBoardOptions(CLI::App& command, BoardOptions& options) {
  command
      .add_option("--board", options.board,
                  "chessboard:9x6:0.025 (inner corners, square in meters) or "
                  "charuco:7x5:0.054:0.040:DICT_4X4_50[:legacy][:inverted] (squares, square and "
                  "marker in meters)")
      ->required();
  command
      .add_option("--looks", options.request.maxSearchedFrames,
                  "Number of frames of the recording to search for the board")
      ->check(CLI::Range(1, 1000000))
      ->capture_default_str();
  command.add_option("--frames", options.frames,
                     "Search only frames A to B-1 of a recording, as A:B (either may be empty)");
  command.add_flag("--mend-mirrored", options.mendMirrored,
                   "Mirror the images of each camera that shows a ChArUco board only mirrored, and "
                   "search them again. With --apply, the project file keeps this");
  command.add_flag("--search-all", options.searchAll,
                   "Search all of these frames, even if the first few that are searched show only "
                   "another board");
}

} // namespace

void addCalibrateIntrinsicsCommand(CLI::App& group, int& exitCode) {
  auto* command = group.add_subcommand(
      "intrinsics", "Calibrate the intrinsics of cameras from images of a board.");
  auto options = std::make_shared<BoardOptions>();
  command
      ->add_option("INPUT", options->inputs,
                   "Project file (TOML), whose recordings are used, or image files of one camera")
      ->required();
  addBoardOptions(*command, *options);
  command
      ->add_option("--model", options->model,
                   "Lens model: number of distortion coefficients (5 or 8), or fisheye")
      ->check(CLI::IsMember({"5", "8", "fisheye"}))
      ->capture_default_str();
  command
      ->add_option("--pixels", options->pixels,
                   "Shape of the pixels: square, free, or measured (square unless the images "
                   "clearly show otherwise)")
      ->check(CLI::IsMember({"measured", "square", "free"}))
      ->capture_default_str();
  command
      ->add_option(
          "--corners", options->corners,
          "For image files: \"sample\" refines chessboard corners as OpenCV's sample program does, "
          "for comparable results; \"exact\" keeps neighboring corners out of the search window")
      ->check(CLI::IsMember({"sample", "exact"}))
      ->capture_default_str();
  command
      ->add_option("--views", options->request.maxViews, "Number of images of a recording to use")
      ->check(CLI::Range(3, 1000))
      ->capture_default_str();
  addOutputOptions(*command, options->output, true);
  command->callback([options, &exitCode] { exitCode = intrinsics(*options); });
}

void addCalibrateExtrinsicsCommand(CLI::App& group, int& exitCode) {
  auto* command = group.add_subcommand(
      "extrinsics",
      "Calibrate the poses of cameras from a board that several of them see at once.");
  auto options = std::make_shared<BoardOptions>();
  options->inputs.resize(1);
  command
      ->add_option("PROJECT", options->inputs.front(), "Project file (TOML) with known intrinsics")
      ->required();
  addBoardOptions(*command, *options);
  command
      ->add_option("--world-frame", options->request.floorFrame,
                   "Frame in which the board lies on the floor and defines the world: X along the "
                   "rows of the board, Y toward its upper edge, Z up. Without this option, the "
                   "first camera keeps its pose")
      ->check(CLI::Range(std::int64_t{0}, std::int64_t{1} << 40));
  command->add_option("--instants", options->request.maxInstants, "Number of board poses to use")
      ->check(CLI::Range(1, 10000))
      ->capture_default_str();
  command->add_flag("--refine-lenses", options->request.refinesIntrinsics,
                    "Refine the intrinsics together with the poses");
  addOutputOptions(*command, options->output, true);
  command->callback([options, &exitCode] { exitCode = extrinsics(*options); });
}

} // namespace dewpoint::app
