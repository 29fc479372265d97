// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/calibration/board_calibration.h"

#include "core/base/thread_count.h"
#include "core/base/thread_team.h"
#include "core/calibration/board/view_choice.h"
#include "core/calibration/quality/board_accuracy.h"

#include <fmt/format.h>
#include <opencv2/imgcodecs.hpp>

#include <algorithm>

namespace dewpoint::setup {
namespace {

constexpr std::int64_t kFewFrames = 60; // so few are stills: time is spent on each
constexpr std::int64_t kSeekFrom = 12;  // frames to pass over: fewer are read faster than sought

/// One instant: the board in the images of all cameras, which are shared among threads.
void detectAll(const BoardDetector& detector, DetectionEffort effort, const FrameSet& frames,
               ThreadTeam& team, BoardDetections& seen) {
  std::vector<std::optional<BoardDetection>> found(seen.cameras.size());
  const auto count = static_cast<std::int64_t>(seen.cameras.size());
  team.forEachRange(count, [&](std::int64_t begin, std::int64_t end) {
    for (auto k = static_cast<std::size_t>(begin); k < static_cast<std::size_t>(end); ++k) {
      if (frames.frames[k] != nullptr) {
        found[k] = detector.detect(frames.frames[k]->image, effort);
      }
    }
  });
  for (std::size_t k = 0; k < found.size(); ++k) {
    auto& camera = seen.cameras[k];
    if (frames.frames[k] == nullptr) {
      continue;
    }
    camera.width = frames.frames[k]->image.cols;
    camera.height = frames.frames[k]->image.rows;
    ++camera.searched;
    if (found[k]) {
      camera.views.push_back({fmt::format("frame {}", frames.index), frames.index, *found[k]});
    }
  }
}

/// The frames to look at: evenly spread over those requested, and the one that makes the world.
std::vector<std::int64_t> framesToSearch(std::int64_t total,
                                         const BoardCalibrationRequest& request) {
  const std::int64_t end = std::min(total, request.endFrame.value_or(total));
  const std::int64_t count = end - request.firstFrame;
  const std::int64_t stride =
      std::max<std::int64_t>(1, (count + request.frameLimit - 1) / request.frameLimit);
  std::vector<std::int64_t> frames;
  for (std::int64_t frame = request.firstFrame; frame < end; frame += stride) {
    frames.push_back(frame);
  }
  const std::int64_t world = request.worldFrame.value_or(request.firstFrame);
  if (const auto at = std::ranges::lower_bound(frames, world);
      world < total && (at == frames.end() || *at != world)) {
    frames.insert(at, world);
  }
  return frames;
}

Error named(Error error, const std::string& camera) {
  error.field = error.field.empty() ? camera : camera + ": " + error.field;
  return error;
}

Result<IntrinsicsResult> lensOf(const BoardDetections::PerCamera& camera,
                                const BoardCalibrationRequest& request,
                                const CalibrationProgress& progress) {
  if (camera.views.empty()) {
    return failure(ErrorCode::Undetermined, "", "",
                   fmt::format("it never saw the board in {} images", camera.searched));
  }
  IntrinsicsRequest lensRequest;
  lensRequest.board = request.board;
  lensRequest.views =
      chooseViews(request.board, camera.views, camera.width, camera.height, request.views);
  lensRequest.width = camera.width;
  lensRequest.height = camera.height;
  lensRequest.model = request.model;
  lensRequest.pixels = request.pixels;
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
void addUnusedCameras(const Project& project, const std::vector<std::size_t>& taking,
                      ExtrinsicsResult& result) {
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
    fits[taking[i]] = std::move(result.fits[i]);
  }
  for (std::size_t k = 0; k < cameras.size(); ++k) {
    if (std::ranges::find(taking, k) == taking.end()) {
      result.notices.push_back(
          fmt::format("'{}' never saw the board: it keeps its pose", cameras[k].name));
    }
  }
  for (CameraColumn& column : result.covariance.columns) {
    column.camera = taking[column.camera];
  }
  for (DetectedFault& fault : result.faults) {
    for (std::size_t& camera : fault.cameras) {
      camera = taking[camera];
    }
  }
  result.cameras = std::move(cameras);
  result.fits = std::move(fits);
}

} // namespace

Result<BoardDetections> findBoards(const Project& project, FrameSetSource& source,
                                   const BoardCalibrationRequest& request,
                                   const CalibrationProgress& progress) {
  const auto total = source.frameCount();
  if (!total) {
    return failure(ErrorCode::BadValue, project.file.string(), "camera",
                   "the cameras are live, but a recording is needed");
  }
  if (request.firstFrame >= *total) {
    return failure(ErrorCode::BadValue, project.file.string(), "--frames",
                   fmt::format("the recording has only {} frames", *total));
  }
  BoardDetections seen;
  for (const ProjectCamera& camera : project.cameras) {
    seen.cameras.push_back({camera.camera.name, 0, 0, 0, {}});
  }
  if (source.framesPerSecond() > 0.0) {
    seen.framesPerSecond = source.framesPerSecond();
  }
  const BoardDetector detector(request.board);
  const auto effort = *total <= kFewFrames ? DetectionEffort::Exact : DetectionEffort::Live;
  ThreadTeam team(threadCountForTasks(seen.cameras.size()));
  const auto frames = framesToSearch(*total, request);
  std::int64_t next = -1;
  for (std::size_t k = 0; k < frames.size(); ++k) {
    if (!reportProgress(progress, CalibrationStage::BoardDetection,
                        static_cast<double>(k) / static_cast<double>(frames.size()))) {
      return canceled();
    }
    if (next < 0 || frames[k] - next > kSeekFrom) {
      if (const auto sought = source.seek(frames[k]); !sought) {
        return tl::make_unexpected(sought.error());
      }
      next = frames[k];
    }
    Result<FrameSetPtr> set = nullptr;
    do {
      set = source.next();
      if (!set) {
        return tl::make_unexpected(set.error());
      }
    } while (*set != nullptr && next++ < frames[k]);
    if (*set == nullptr) {
      break; // the recording is shorter than it says
    }
    detectAll(detector, effort, **set, team, seen);
  }
  return seen;
}

Result<BoardDetections> findBoards(const std::vector<std::filesystem::path>& pictures,
                                   const BoardDescription& board, DetectionEffort effort,
                                   const CalibrationProgress& progress) {
  BoardDetections seen;
  auto& camera = seen.cameras.emplace_back();
  camera.name = "camera";
  const BoardDetector detector(board);
  for (const auto& file : pictures) {
    if (!reportProgress(progress, CalibrationStage::BoardDetection,
                        static_cast<double>(camera.searched) /
                            static_cast<double>(pictures.size()))) {
      return canceled();
    }
    if (!std::filesystem::exists(file)) {
      return failure(ErrorCode::FileMissing, file.string(), "", "");
    }
    const cv::Mat picture = cv::imread(file.string(), cv::IMREAD_GRAYSCALE);
    if (picture.empty()) {
      return failure(ErrorCode::FileUnreadable, file.string(), "", "it is not an image");
    }
    if (camera.searched == 0) {
      camera.width = picture.cols;
      camera.height = picture.rows;
    }
    if (picture.cols != camera.width || picture.rows != camera.height) {
      return failure(ErrorCode::Mismatch, file.string(), "",
                     fmt::format("{} x {} pixels, but the first image has {} x {}", picture.cols,
                                 picture.rows, camera.width, camera.height));
    }
    if (auto found = detector.detect(picture, effort)) {
      camera.views.push_back({file.filename().string(), camera.searched, std::move(*found)});
    }
    ++camera.searched;
  }
  return seen;
}

Result<LensesFromBoards> intrinsicsFromBoards(const BoardDetections& seen,
                                              const BoardCalibrationRequest& request,
                                              const CalibrationProgress& progress) {
  LensesFromBoards lenses;
  std::optional<Error> first;
  for (const auto& camera : seen.cameras) {
    auto result = lensOf(camera, request, progress);
    if (!result && result.error().code == ErrorCode::Canceled) {
      return tl::make_unexpected(result.error());
    }
    if (!result) {
      first = first.value_or(named(result.error(), camera.name));
      lenses.kept.push_back(result.error());
      lenses.kept.back().field = camera.name;
      lenses.cameras.emplace_back();
      continue;
    }
    result->camera.name = camera.name;
    lenses.cameras.emplace_back(std::move(*result));
  }
  if (first && lenses.kept.size() == lenses.cameras.size()) {
    return tl::make_unexpected(*first);
  }
  return lenses;
}

Result<ExtrinsicsResult> extrinsicsFromBoards(const Project& project, const BoardDetections& seen,
                                              const BoardCalibrationRequest& request,
                                              const CalibrationProgress& progress) {
  const auto taking = camerasWithViews(seen);
  std::vector<std::vector<BoardView>> views;
  std::vector<int> widths;
  for (const std::size_t k : taking) {
    views.push_back(seen.cameras[k].views);
    widths.push_back(seen.cameras[k].width);
  }
  const auto chosen = chooseInstants(views, widths, request.instants, request.worldFrame);
  ExtrinsicsRequest rigRequest;
  rigRequest.board = request.board;
  rigRequest.worldInstant = request.worldFrame;
  rigRequest.refineIntrinsics = request.refineIntrinsics;
  for (std::size_t i = 0; i < taking.size(); ++i) {
    const auto& in = project.cameras[taking[i]].camera.intrinsics;
    const auto& camera = seen.cameras[taking[i]];
    if (!chosen[i].empty() && (in.width != camera.width || in.height != camera.height)) {
      return failure(ErrorCode::Mismatch, project.file.string(), camera.name,
                     fmt::format("its images have {} x {} pixels, its calibration {} x {}",
                                 camera.width, camera.height, in.width, in.height));
    }
    rigRequest.cameras.push_back({project.cameras[taking[i]].camera, chosen[i]});
  }
  auto result = calibrateExtrinsics(rigRequest, progress);
  if (!result && result.error().code == ErrorCode::Canceled) {
    return result;
  }
  if (!reportProgress(progress, CalibrationStage::Assessment, 0.0)) {
    return canceled();
  }
  for (std::size_t i = 0; i < taking.size(); ++i) {
    rigRequest.cameras[i].views = std::move(views[i]); // all of them, not only the best
  }
  const auto report =
      findBoardFaults(rigRequest, seen.framesPerSecond, result ? &*result : nullptr);
  if (!result && !report.faults.empty()) {
    result.error().detail += "; " + report.faults.front().sentence;
  }
  if (result) {
    result->faults = report.faults;
    addUnusedCameras(project, taking, *result);
  }
  return result;
}

BoardReport reportOf(const BoardDetections& seen, const BoardCalibrationRequest& request,
                     const LensesFromBoards& lenses) {
  BoardReport report;
  report.board = request.board;
  for (std::size_t k = 0; k < lenses.cameras.size(); ++k) {
    if (lenses.cameras[k]) {
      report.cameras.push_back(reportPart(seen.cameras[k].name, *lenses.cameras[k]));
    }
  }
  report.title = fmt::format("Intrinsics of {} camera{} from a board", report.cameras.size(),
                             report.cameras.size() == 1 ? "" : "s");
  for (const Error& kept : lenses.kept) {
    report.notices.push_back(keptIntrinsicsText(kept));
  }
  return report;
}

std::string keptIntrinsicsText(const Error& kept) {
  return fmt::format("{} keeps its intrinsics: {}", kept.field, kept.detail);
}

} // namespace dewpoint::setup
