// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/board_calibration.h"

#include "core/base/thread_team.h"
#include "core/calibration/view_choice.h"

#include <fmt/format.h>
#include <opencv2/imgcodecs.hpp>

#include <algorithm>
#include <thread>

namespace dewpoint {
namespace {

constexpr std::int64_t kFewFrames = 60; // so few are stills: time is spent on each
constexpr std::int64_t kSeekFrom = 12;  // frames to pass over: fewer are read faster than sought

/// One instant: the board in the images of all cameras, which are shared among threads.
void detectAll(const BoardDetector& detector, DetectionEffort effort, const FrameSet& frames,
               ThreadTeam& team, SeenBoards& seen) {
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
    ++camera.looked;
    if (found[k]) {
      camera.views.push_back({fmt::format("frame {}", frames.index), frames.index, *found[k]});
    }
  }
}

/// The frames to look at: evenly spread, and the one that makes the world.
std::vector<std::int64_t> framesToLookAt(std::int64_t total, const BoardWish& wish) {
  const std::int64_t stride = std::max<std::int64_t>(1, (total + wish.looks - 1) / wish.looks);
  std::vector<std::int64_t> frames;
  for (std::int64_t frame = 0; frame < total; frame += stride) {
    frames.push_back(frame);
  }
  const std::int64_t world = wish.worldFrame.value_or(0);
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

} // namespace

Result<SeenBoards> lookForBoards(const Project& project, FrameSetSource& source,
                                 const BoardWish& wish, const CalibrationProgress& progress) {
  const auto total = source.frameCount();
  if (!total) {
    return failure(ErrorCode::BadValue, project.file.string(), "camera",
                   "they are live; the board is looked for in a recording");
  }
  SeenBoards seen;
  for (const ProjectCamera& camera : project.cameras) {
    seen.cameras.push_back({camera.camera.name, 0, 0, 0, {}});
  }
  const BoardDetector detector(wish.board);
  const auto effort = *total <= kFewFrames ? DetectionEffort::Exact : DetectionEffort::Live;
  const auto threads =
      std::min<std::size_t>(seen.cameras.size(), std::thread::hardware_concurrency());
  ThreadTeam team(static_cast<int>(std::max<std::size_t>(1, threads)));
  const auto frames = framesToLookAt(*total, wish);
  std::int64_t next = -1;
  for (std::size_t k = 0; k < frames.size(); ++k) {
    if (!goesOn(progress, "looking for the board",
                static_cast<double>(k) / static_cast<double>(frames.size()))) {
      return cancelled();
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

Result<SeenBoards> lookForBoards(const std::vector<std::filesystem::path>& pictures,
                                 const BoardDescription& board, DetectionEffort effort,
                                 const CalibrationProgress& progress) {
  SeenBoards seen;
  auto& camera = seen.cameras.emplace_back();
  camera.name = "camera";
  const BoardDetector detector(board);
  for (const auto& file : pictures) {
    if (!goesOn(progress, "looking for the board",
                static_cast<double>(camera.looked) / static_cast<double>(pictures.size()))) {
      return cancelled();
    }
    if (!std::filesystem::exists(file)) {
      return failure(ErrorCode::FileMissing, file.string(), "", "");
    }
    const cv::Mat picture = cv::imread(file.string(), cv::IMREAD_GRAYSCALE);
    if (picture.empty()) {
      return failure(ErrorCode::FileUnreadable, file.string(), "", "not a picture");
    }
    if (camera.looked == 0) {
      camera.width = picture.cols;
      camera.height = picture.rows;
    }
    if (picture.cols != camera.width || picture.rows != camera.height) {
      return failure(ErrorCode::Mismatch, file.string(), "",
                     fmt::format("{} x {} pixels, the first picture has {} x {}", picture.cols,
                                 picture.rows, camera.width, camera.height));
    }
    if (auto found = detector.detect(picture, effort)) {
      camera.views.push_back({file.filename().string(), camera.looked, std::move(*found)});
    }
    ++camera.looked;
  }
  return seen;
}

Result<std::vector<IntrinsicsResult>> intrinsicsFromBoards(const SeenBoards& seen,
                                                           const BoardWish& wish,
                                                           const CalibrationProgress& progress) {
  std::vector<IntrinsicsResult> results;
  for (const auto& camera : seen.cameras) {
    IntrinsicsRequest request;
    request.board = wish.board;
    request.views = chooseViews(wish.board, camera.views, camera.width, camera.height, wish.views);
    request.width = camera.width;
    request.height = camera.height;
    request.model = wish.model;
    request.pixels = wish.pixels;
    auto result = calibrateIntrinsics(request, progress);
    if (!result) {
      return tl::make_unexpected(named(result.error(), camera.name));
    }
    result->camera.name = camera.name;
    results.push_back(std::move(*result));
  }
  return results;
}

Result<ExtrinsicsResult> extrinsicsFromBoards(const Project& project, const SeenBoards& seen,
                                              const BoardWish& wish,
                                              const CalibrationProgress& progress) {
  std::vector<std::vector<BoardView>> views;
  std::vector<int> widths;
  for (const auto& camera : seen.cameras) {
    views.push_back(camera.views);
    widths.push_back(camera.width);
  }
  const auto chosen = chooseInstants(views, widths, wish.instants, wish.worldFrame);
  ExtrinsicsRequest request;
  request.board = wish.board;
  request.worldInstant = wish.worldFrame;
  request.refineIntrinsics = wish.refineIntrinsics;
  for (std::size_t k = 0; k < project.cameras.size(); ++k) {
    const auto& in = project.cameras[k].camera.intrinsics;
    const auto& camera = seen.cameras[k];
    if (in.width != camera.width || in.height != camera.height) {
      return failure(ErrorCode::Mismatch, project.file.string(), camera.name,
                     fmt::format("its images have {} x {} pixels, its calibration {} x {}",
                                 camera.width, camera.height, in.width, in.height));
    }
    request.cameras.push_back({project.cameras[k].camera, chosen[k]});
  }
  return calibrateExtrinsics(request, progress);
}

BoardReport reportOf(const SeenBoards& seen, const BoardWish& wish,
                     const std::vector<IntrinsicsResult>& results) {
  BoardReport report;
  report.title = fmt::format("Lenses of {} camera{} from a board", results.size(),
                             results.size() == 1 ? "" : "s");
  report.board = wish.board;
  for (std::size_t k = 0; k < results.size(); ++k) {
    report.cameras.push_back(reportPart(seen.cameras[k].name, results[k]));
  }
  return report;
}

} // namespace dewpoint
