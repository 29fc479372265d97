// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/calibration/board_calibration.h"

#include "core/calibration/board/view_choice.h"
#include "core/calibration/quality/board_accuracy.h"
#include "core/setup/calibration/missed_images.h"

#include <fmt/format.h>

#include <algorithm>

namespace dewpoint::setup {
namespace {

Error named(Error error, const std::string& camera) {
  error.field = error.field.empty() ? camera : camera + ": " + error.field;
  return error;
}

/// The board that was seen instead of the requested one, as the error of a calibration.
tl::unexpected<Error> otherBoardError(const BoardDetections& seen,
                                      const BoardDescription& requested) {
  return failure(ErrorCode::NotFound, "", boardText(requested),
                 guessAdviceSentence(*seen.otherBoard));
}

/// Appends what a few images show instead, if anything.
Error withOtherBoard(Error error, const BoardGuess* other) {
  if (other != nullptr) {
    error.detail += "; " + guessAdviceSentence(*other);
  }
  return error;
}

Result<IntrinsicsResult> lensOf(const BoardDetections::PerCamera& camera,
                                const BoardCalibrationRequest& request,
                                const CalibrationProgress& progress) {
  if (camera.views.empty()) {
    std::string text =
        fmt::format("it never saw the board in {} images", camera.searchedImageCount);
    if (hasExplainedMiss(camera)) {
      text += "; " + missedImagesText(camera);
    }
    return failure(ErrorCode::Undetermined, "", "", std::move(text));
  }
  IntrinsicsRequest lensRequest;
  lensRequest.board = request.board;
  lensRequest.views = chooseViews(request.board, camera.views, camera.imageWidth,
                                  camera.imageHeight, request.maxViews);
  lensRequest.width = camera.imageWidth;
  lensRequest.height = camera.imageHeight;
  lensRequest.model = request.model;
  lensRequest.pixelShape = request.pixelShape;
  return calibrateIntrinsics(lensRequest, progress);
}

/// The cameras that poses are found of: those that saw the board, if that are two; else all, so
/// that the error names them.
std::vector<std::size_t> camerasWithViews(const BoardDetections& seen) {
  std::vector<std::size_t> with;
  std::vector<std::size_t> all;
  for (std::size_t k = 0; k < seen.cameras.size(); ++k) {
    all.push_back(k);
    if (!seen.cameras[k].views.empty()) {
      with.push_back(k);
    }
  }
  return with.size() < 2 ? all : with;
}

/// Cameras that took no part get their places in the result, as they were.
void addUnusedCameras(const Project& project, const BoardDetections& seen,
                      const std::vector<std::size_t>& taking, ExtrinsicsResult& result) {
  if (taking.size() == project.cameras.size()) {
    return;
  }
  CameraRig cameras;
  std::vector<CameraFit> fits(project.cameras.size());
  for (const ProjectCamera& camera : project.cameras) {
    cameras.push_back(camera.camera);
  }
  for (std::size_t i = 0; i < taking.size(); ++i) {
    cameras[taking[i]] = result.cameras[i];
    fits[taking[i]] = std::move(result.cameraFits[i]);
  }
  for (const auto& camera : seen.cameras) {
    if (camera.otherBoard) {
      result.notices.push_back(
          fmt::format("'{}': {}", camera.name, guessAdviceSentence(*camera.otherBoard)));
    }
  }
  for (std::size_t k = 0; k < cameras.size(); ++k) {
    if (std::ranges::find(taking, k) == taking.end()) {
      result.notices.push_back(
          fmt::format("'{}' never saw the board: it keeps its pose", cameras[k].name));
    }
  }
  for (CameraParameterColumn& column : result.covariance.columns) {
    column.camera = taking[column.camera];
  }
  for (DetectedFault& fault : result.faults) {
    for (std::size_t& camera : fault.cameras) {
      camera = taking[camera];
    }
  }
  result.cameras = std::move(cameras);
  result.cameraFits = std::move(fits);
}

} // namespace

Result<LensesFromBoards> intrinsicsFromBoards(const BoardDetections& seen,
                                              const BoardCalibrationRequest& request,
                                              const CalibrationProgress& progress) {
  if (seen.hasOnlyOtherBoard()) {
    return otherBoardError(seen, request.board);
  }
  LensesFromBoards lenses;
  std::optional<Error> first;
  for (const auto& camera : seen.cameras) {
    auto result = lensOf(camera, request, progress);
    if (!result && result.error().code == ErrorCode::Canceled) {
      return tl::make_unexpected(result.error());
    }
    if (!result) {
      result.error() = withOtherBoard(std::move(result.error()), seen.otherBoardSeenBy(camera));
      first = first.value_or(named(result.error(), camera.name));
      lenses.keptIntrinsicsReasons.push_back(result.error());
      lenses.keptIntrinsicsReasons.back().field = camera.name;
      lenses.cameras.emplace_back();
      continue;
    }
    result->camera.name = camera.name;
    lenses.cameras.emplace_back(std::move(*result));
  }
  if (first && lenses.keptIntrinsicsReasons.size() == lenses.cameras.size()) {
    return tl::make_unexpected(*first);
  }
  return lenses;
}

Result<ExtrinsicsResult> extrinsicsFromBoards(const Project& project, const BoardDetections& seen,
                                              const BoardCalibrationRequest& request,
                                              const CalibrationProgress& progress) {
  if (seen.hasOnlyOtherBoard()) {
    return otherBoardError(seen, request.board);
  }
  const auto taking = camerasWithViews(seen);
  std::vector<std::vector<BoardView>> views;
  std::vector<int> widths;
  for (const std::size_t k : taking) {
    views.push_back(seen.cameras[k].views);
    widths.push_back(seen.cameras[k].imageWidth);
  }
  const auto chosen = chooseInstants(views, widths, request.maxInstants, request.floorFrame);
  ExtrinsicsRequest rigRequest;
  rigRequest.board = request.board;
  rigRequest.worldDefiningInstant = request.floorFrame;
  rigRequest.refinesIntrinsics = request.refinesIntrinsics;
  for (std::size_t i = 0; i < taking.size(); ++i) {
    const auto& in = project.cameras[taking[i]].camera.intrinsics;
    const auto& camera = seen.cameras[taking[i]];
    if (!chosen[i].empty() && (in.width != camera.imageWidth || in.height != camera.imageHeight)) {
      const bool isRotated = in.width == camera.imageHeight && in.height == camera.imageWidth;
      return failure(ErrorCode::Mismatch, project.file.string(), camera.name,
                     fmt::format("its images have {} x {} pixels, its calibration {} x {}{}",
                                 camera.imageWidth, camera.imageHeight, in.width, in.height,
                                 isRotated ? "; its video is probably rotated by 90 degrees: set "
                                             "rotate = 90 or 270 for this camera"
                                           : ""));
    }
    const ProjectCamera& given = project.cameras[taking[i]];
    const auto& lens = given.calibrationRecord.lens;
    rigRequest.cameras.push_back(
        {given.camera, chosen[i],
         lens && describes(*lens, given.camera) ? lens->error : std::nullopt});
  }
  auto result = calibrateExtrinsics(rigRequest, progress);
  if (!result && result.error().code == ErrorCode::Canceled) {
    return result;
  }
  if (!reportProgress(progress, CalibrationStage::Assessment, 0.0)) {
    return canceledError();
  }
  for (std::size_t i = 0; i < taking.size(); ++i) {
    rigRequest.cameras[i].views = std::move(views[i]); // all of them, not only the best
  }
  const auto report =
      findBoardFaults(rigRequest, seen.framesPerSecond, result ? &*result : nullptr);
  for (const auto& camera : seen.cameras) {
    if (const BoardGuess* other = seen.otherBoardSeenBy(camera); !result && other != nullptr) {
      result.error() = withOtherBoard(std::move(result.error()), other);
      break;
    }
  }
  if (!result && !report.faults.empty()) {
    result.error().detail += "; " + report.faults.front().sentence;
  }
  if (result) {
    result->faults = report.faults;
    addUnusedCameras(project, seen, taking, *result);
  }
  return result;
}

BoardReport reportOf(const BoardDetections& seen, const BoardCalibrationRequest& request,
                     const LensesFromBoards& lenses) {
  BoardReport report;
  report.board = request.board;
  for (std::size_t k = 0; k < lenses.cameras.size(); ++k) {
    if (lenses.cameras[k]) {
      report.cameras.push_back(reportPartOf(seen.cameras[k].name, *lenses.cameras[k]));
    }
  }
  report.title = fmt::format("Intrinsics of {} camera{} from a board", report.cameras.size(),
                             report.cameras.size() == 1 ? "" : "s");
  for (const Error& kept : lenses.keptIntrinsicsReasons) {
    report.notices.push_back(keptIntrinsicsText(kept));
  }
  return report;
}

std::string keptIntrinsicsText(const Error& kept) {
  return fmt::format("{} keeps its intrinsics: {}", kept.field, kept.detail);
}

} // namespace dewpoint::setup
