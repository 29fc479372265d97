// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/calibration/mirrored_videos.h"

#include "core/setup/calibration/calibrated_project.h"
#include "core/setup/calibration/frame_picker.h"

#include <fmt/format.h>
#include <opencv2/core.hpp>

#include <algorithm>
#include <utility>

namespace dewpoint::setup {
namespace {

/// Images of a side of the board: fewer could be mistakes. A marker read by chance has no neighbors
/// at their places, so that a board found by chance has never been seen.
constexpr int kLeastImages = 3;

} // namespace

MirroringCounts countMirroredImages(const BoardDescription& board,
                                    const std::vector<cv::Mat>& images) {
  MirroringCounts sides;
  if (board.kind != BoardDescription::Kind::Charuco) {
    return sides;
  }
  const BoardDetector detector(board);
  for (const cv::Mat& image : images) {
    if (detector.detect(image, DetectionEffort::Live)) {
      ++sides.unmirroredCount;
      continue;
    }
    cv::Mat flipped;
    cv::flip(image, flipped, 1);
    sides.mirroredCount += detector.detect(flipped, DetectionEffort::Live) ? 1 : 0;
  }
  return sides;
}

MirroredVideos mirroredVideos(const std::vector<MirroringCounts>& cameras) {
  MirroredVideos found;
  bool isSeenPlain = false;
  for (std::size_t k = 0; k < cameras.size(); ++k) {
    const MirroringCounts& sides = cameras[k];
    if (sides.unmirroredCount == 0 && sides.mirroredCount >= kLeastImages) {
      found.mirroredCameras.push_back(k);
    }
    isSeenPlain =
        isSeenPlain || (sides.mirroredCount == 0 && sides.unmirroredCount >= kLeastImages);
  }
  if (!found.mirroredCameras.empty()) {
    found.cause =
        isSeenPlain ? MirroredVideos::Cause::Videos : MirroredVideos::Cause::BoardOrVideos;
  }
  return found;
}

MirroredVideos mirroredVideos(const BoardDetections& seen) {
  std::vector<MirroringCounts> sides;
  for (const auto& camera : seen.cameras) {
    sides.push_back(camera.mirroringCounts);
    sides.back().unmirroredCount += static_cast<int>(camera.views.size());
  }
  return mirroredVideos(sides);
}

Result<MirroredVideos> findMirroredVideos(FrameSetSource& source, const BoardDescription& board,
                                          int frames, const CalibrationProgress& progress) {
  if (board.kind != BoardDescription::Kind::Charuco) {
    return MirroredVideos();
  }
  const auto total = source.frameCount();
  if (!total) {
    return failure(ErrorCode::BadValue, "", "camera",
                   "the cameras are live, but a recording is needed");
  }
  FramePicker picker(source);
  std::vector<MirroringCounts> sides;
  for (const std::int64_t frame : evenlySpacedFrames(*total, frames)) {
    if (!reportProgress(progress, CalibrationStage::BoardDetection, 1.0)) {
      return canceledError();
    }
    const auto set = picker.read(frame);
    if (!set) {
      return tl::make_unexpected(set.error());
    }
    for (std::size_t k = 0; *set != nullptr && k < (*set)->frames.size(); ++k) {
      sides.resize(std::max(sides.size(), k + 1));
      if ((*set)->frames[k] != nullptr) {
        const MirroringCounts one =
            countMirroredImages(board, {reducedGrayImage((*set)->frames[k]->image)});
        sides[k].unmirroredCount += one.unmirroredCount;
        sides[k].mirroredCount += one.mirroredCount;
      }
    }
  }
  return mirroredVideos(sides);
}

std::string mirroredText(const MirroredVideos& mirrored, const std::vector<std::string>& names) {
  std::vector<std::string> listed;
  for (const std::size_t camera : mirrored.mirroredCameras) {
    listed.push_back(fmt::format("'{}'", names.at(camera)));
  }
  const std::string cameras = fmt::format("{}", fmt::join(listed, ", "));
  switch (mirrored.cause) {
  case MirroredVideos::Cause::Videos:
    return fmt::format("The video of {} is mirrored left to right: it shows the board mirrored, "
                       "but another camera shows it as it is.",
                       cameras);
  case MirroredVideos::Cause::BoardOrVideos:
    return fmt::format("The board or the video of {} is mirrored left to right: no camera shows "
                       "the board as it is.",
                       cameras);
  case MirroredVideos::Cause::None:
    break;
  }
  return {};
}

Project withUnmirroredVideos(Project project, const MirroredVideos& mirrored) {
  for (const std::size_t camera : mirrored.mirroredCameras) {
    if (camera < project.cameras.size() && canSetImageSymmetry(project.cameras[camera])) {
      project = withImageSymmetry(std::move(project), static_cast<int>(camera), {0, true});
    }
  }
  return project;
}

} // namespace dewpoint::setup
