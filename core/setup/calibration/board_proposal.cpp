// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/calibration/board_proposal.h"

#include "core/setup/calibration/frame_picker.h"

#include <fmt/format.h>

#include <utility>

namespace dewpoint::setup {
namespace {

Result<std::vector<BoardGuess>> orNotFound(Result<std::vector<BoardGuess>> guesses,
                                           std::size_t images) {
  if (guesses && guesses->empty()) {
    return failure(ErrorCode::NotFound, "", "board",
                   fmt::format("{} image{} searched", images, images == 1 ? "" : "s"));
  }
  return guesses;
}

} // namespace

Result<std::vector<BoardGuess>> proposeBoards(FrameSetSource& source,
                                              const BoardDescription& requested, int frames,
                                              const CalibrationProgress& progress) {
  const auto total = source.frameCount();
  if (!total) {
    return failure(ErrorCode::BadValue, "", "camera",
                   "the cameras are live, but a recording is needed");
  }
  FramePicker picker(source);
  std::vector<cv::Mat> images;
  for (const std::int64_t frame : evenlySpacedFrames(*total, frames)) {
    if (!reportProgress(progress, CalibrationStage::BoardDetection, 0.0)) {
      return canceledError();
    }
    const auto set = picker.read(frame);
    if (!set) {
      return tl::make_unexpected(set.error());
    }
    for (std::size_t k = 0; *set != nullptr && k < (*set)->frames.size(); ++k) {
      if ((*set)->frames[k] != nullptr) {
        images.push_back(reducedGrayImage((*set)->frames[k]->image));
      }
    }
  }
  return orNotFound(guessBoards(images, requested, progress), images.size());
}

Result<std::vector<BoardGuess>> proposeBoards(const std::vector<std::filesystem::path>& pictures,
                                              const BoardDescription& requested, int count,
                                              const CalibrationProgress& progress) {
  std::vector<cv::Mat> images;
  for (const std::int64_t k :
       evenlySpacedFrames(static_cast<std::int64_t>(pictures.size()), count)) {
    const auto picture = readGrayPicture(pictures[static_cast<std::size_t>(k)]);
    if (!picture) {
      return tl::make_unexpected(picture.error());
    }
    images.push_back(reducedGrayImage(*picture));
  }
  return orNotFound(guessBoards(images, requested, progress), images.size());
}

Result<std::vector<BoardGuess>> proposeBoards(const FrameSet& frames,
                                              const BoardDescription& requested,
                                              const CalibrationProgress& progress) {
  std::vector<cv::Mat> images;
  for (const FramePtr& frame : frames.frames) {
    if (frame != nullptr) {
      images.push_back(frame->image);
    }
  }
  return orNotFound(guessBoards(images, requested, progress), images.size());
}

} // namespace dewpoint::setup
