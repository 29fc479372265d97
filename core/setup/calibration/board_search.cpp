// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/calibration/board_search.h"

#include "core/base/thread_count.h"
#include "core/base/thread_team.h"
#include "core/setup/calibration/frame_picker.h"
#include "core/setup/calibration/mirrored_videos.h"
#include "core/setup/calibration/missed_images.h"

#include <fmt/format.h>

#include <algorithm>

namespace dewpoint::setup {
namespace {

constexpr std::int64_t kFewFrames = 60; // so few are stills: time is spent on each

// Tuned; where no source is named here or in the docs, the origin is not recorded.
constexpr std::int64_t kLongRecording =
    std::int64_t{3} * kBoardProposalFrames;  // less is searched in no time
constexpr double kLookShare = 0.1;           // of the time of a search
constexpr std::size_t kMostImagesOfAll = 16; // of all cameras: a guess takes 0.2 s an image
constexpr int kRarelySeen = 50;              // one of so many images: as good as never

/// A few images of each camera, to be searched for any board.
class KeptImages {
public:
  explicit KeptImages(std::size_t cameras) : ofCameras_(cameras) {}

  void keep(std::size_t camera, const cv::Mat& image) {
    ofCameras_[camera].push_back(reducedGrayImage(image));
  }
  void keep(const FrameSet& set) {
    for (std::size_t k = 0; k < std::min(set.frames.size(), ofCameras_.size()); ++k) {
      if (set.frames[k] != nullptr) {
        keep(k, set.frames[k]->image);
      }
    }
  }
  const std::vector<cv::Mat>& of(std::size_t camera) const { return ofCameras_[camera]; }
  /// All images, those of one time together.
  std::vector<cv::Mat> ofAll() const {
    std::vector<cv::Mat> images;
    for (std::size_t k = 0; images.size() < total(); ++k) {
      for (const auto& camera : ofCameras_) {
        if (k < camera.size()) {
          images.push_back(camera[k]);
        }
      }
    }
    return images;
  }

private:
  std::size_t total() const {
    std::size_t count = 0;
    for (const auto& camera : ofCameras_) {
      count += camera.size();
    }
    return count;
  }

  std::vector<std::vector<cv::Mat>> ofCameras_;
};

/// Every part of a work that reports its own progress from 0 to 1.
CalibrationProgress partOfSearch(const CalibrationProgress& progress, double from, double until) {
  return [=](CalibrationStage stage, double part) {
    return reportProgress(progress, stage, from + (until - from) * part);
  };
}

std::vector<cv::Mat> thinnedOut(const std::vector<cv::Mat>& images, std::size_t count) {
  std::vector<cv::Mat> chosen;
  for (std::size_t k = 0; k < std::min(count, images.size()); ++k) {
    chosen.push_back(images[k * images.size() / std::min(count, images.size())]);
  }
  return chosen;
}

/// The most likely board, if it is another one than the requested one; Canceled.
Result<std::optional<BoardGuess>> otherBoardIn(const std::vector<cv::Mat>& images,
                                               const BoardDescription& requested,
                                               const CalibrationProgress& progress) {
  return guessBoards(images, requested, progress)
      .map([&](const std::vector<BoardGuess>& guesses) -> std::optional<BoardGuess> {
        if (guesses.empty() ||
            (!guesses.front().isMirrored && isSameBoard(guesses.front().board, requested))) {
          return std::nullopt;
        }
        return guesses.front();
      });
}

std::size_t boardViewsOf(const BoardDetections& seen) {
  std::size_t count = 0;
  for (const auto& camera : seen.cameras) {
    count += camera.views.size();
  }
  return count;
}

int imagesSearched(const BoardDetections& seen) {
  int count = 0;
  for (const auto& camera : seen.cameras) {
    count += camera.searchedImageCount;
  }
  return count;
}

/// Where to look for any other board than the requested one.
enum class OtherBoards {
  OfAll,  ///< in the images of all cameras, if they show the requested one almost nowhere
  OfEach, ///< else also in those of each camera that never saw the requested one
};

/// Looks for any board where the requested one was not found. Canceled.
Status addOtherBoards(OtherBoards where, const KeptImages& kept, const BoardDescription& requested,
                      const CalibrationProgress& progress, BoardDetections& seen) {
  const CalibrationProgress last = partOfSearch(progress, 1.0, 1.0);
  if (static_cast<int>(boardViewsOf(seen)) * kRarelySeen <= imagesSearched(seen)) {
    auto other = otherBoardIn(thinnedOut(kept.ofAll(), kMostImagesOfAll), requested, last);
    if (!other) {
      return tl::make_unexpected(other.error());
    }
    // A few views of the requested board are worth more than as many of a mere guess.
    if (*other && (*other)->imageCount > static_cast<int>(boardViewsOf(seen))) {
      for (std::size_t k = 0; (*other)->isMirrored && k < seen.cameras.size(); ++k) {
        seen.cameras[k].mirroringCounts = countMirroredImages((*other)->board, kept.of(k));
      }
      seen.otherBoard = std::move(*other);
    }
    return {};
  }
  for (std::size_t k = 0; where == OtherBoards::OfEach && k < seen.cameras.size(); ++k) {
    if (!seen.cameras[k].views.empty()) {
      continue;
    }
    auto other = otherBoardIn(kept.of(k), requested, last);
    if (!other) {
      return tl::make_unexpected(other.error());
    }
    if (*other && (*other)->isMirrored) {
      seen.cameras[k].mirroringCounts = countMirroredImages((*other)->board, kept.of(k));
    }
    seen.cameras[k].otherBoard = std::move(*other);
  }
  return {};
}

/// One instant: the board in the images of all cameras, which are shared among threads.
void detectAll(const BoardDetector& detector, DetectionEffort effort, const FrameSet& frames,
               ThreadTeam& team, BoardDetections& seen, MissedImages& missed) {
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
    camera.imageWidth = frames.frames[k]->image.cols;
    camera.imageHeight = frames.frames[k]->image.rows;
    ++camera.searchedImageCount;
    if (found[k]) {
      camera.views.push_back({fmt::format("frame {}", frames.index), frames.index, *found[k]});
    } else {
      missed.add(k, {}, frames.index, frames.frames[k]->image, camera);
    }
  }
}

/// The frames to look at: evenly spread over those requested, and the one that makes the world.
std::vector<std::int64_t> framesToSearch(std::int64_t total,
                                         const BoardCalibrationRequest& request) {
  const std::int64_t end = std::min(total, request.endFrame.value_or(total));
  const std::int64_t count = end - request.firstFrame;
  const std::int64_t stride = std::max<std::int64_t>(1, (count + request.maxSearchedFrames - 1) /
                                                            request.maxSearchedFrames);
  std::vector<std::int64_t> frames;
  for (std::int64_t frame = request.firstFrame; frame < end; frame += stride) {
    frames.push_back(frame);
  }
  const std::int64_t world = request.floorFrame.value_or(request.firstFrame);
  if (const auto at = std::ranges::lower_bound(frames, world);
      world < total && (at == frames.end() || *at != world)) {
    frames.insert(at, world);
  }
  return frames;
}

/// The frames of a search that are looked at first.
std::vector<std::int64_t> someOf(const std::vector<std::int64_t>& frames) {
  std::vector<std::int64_t> some;
  for (const std::int64_t k :
       evenlySpacedFrames(static_cast<std::int64_t>(frames.size()), kBoardProposalFrames)) {
    some.push_back(frames[static_cast<std::size_t>(k)]);
  }
  return some;
}

BoardDetections nothingSeen(const Project& project, const FrameSetSource& source) {
  BoardDetections seen;
  for (const ProjectCamera& camera : project.cameras) {
    seen.cameras.push_back({camera.camera.name, 0, 0, 0, {}});
  }
  if (source.framesPerSecond() > 0.0) {
    seen.framesPerSecond = source.framesPerSecond();
  }
  return seen;
}

/// The search itself, in the given frames, with a few images to be looked at afterwards.
Status searchFrames(const std::vector<std::int64_t>& frames, const BoardDetector& detector,
                    DetectionEffort effort, FrameSetSource& source,
                    const CalibrationProgress& progress, BoardDetections& seen, KeptImages& kept,
                    MissedImages& missed) {
  ThreadTeam team(threadCountForTasks(seen.cameras.size()));
  FramePicker picker(source);
  const auto keep =
      evenlySpacedFrames(static_cast<std::int64_t>(frames.size()), kBoardProposalFrames);
  for (std::size_t k = 0; k < frames.size(); ++k) {
    if (!reportProgress(progress, CalibrationStage::BoardDetection,
                        static_cast<double>(k) / static_cast<double>(frames.size()))) {
      return canceledError();
    }
    const auto set = picker.read(frames[k]);
    if (!set) {
      return tl::make_unexpected(set.error());
    }
    if (*set == nullptr) {
      break; // the recording is shorter than it says
    }
    detectAll(detector, effort, **set, team, seen, missed);
    if (std::ranges::binary_search(keep, static_cast<std::int64_t>(k))) {
      kept.keep(**set);
    }
  }
  return {};
}

/// Searches, then looks at a few images of cameras that saw nothing.
Result<BoardDetections> searchedFrames(OtherBoards where, const std::vector<std::int64_t>& frames,
                                       const BoardDetector& detector, DetectionEffort effort,
                                       FrameSetSource& source, const CalibrationProgress& progress,
                                       BoardDetections seen) {
  KeptImages kept(seen.cameras.size());
  MissedImages missed(seen.cameras.size(),
                      where == OtherBoards::OfEach && effort != DetectionEffort::Live);
  if (const auto done =
          searchFrames(frames, detector, effort, source, progress, seen, kept, missed)
              .and_then(
                  [&] { return addOtherBoards(where, kept, detector.board(), progress, seen); })
              .and_then([&] { return missed.explainMisses(detector, progress, seen); });
      !done) {
    return tl::make_unexpected(done.error());
  }
  return seen;
}

Result<BoardDetections> searchedPictures(OtherBoards where,
                                         const std::vector<std::filesystem::path>& pictures,
                                         const BoardDetector& detector, DetectionEffort effort,
                                         const CalibrationProgress& progress) {
  BoardDetections seen;
  auto& camera = seen.cameras.emplace_back();
  camera.name = "camera";
  KeptImages kept(1);
  MissedImages missed(1, where == OtherBoards::OfEach);
  const auto keep =
      evenlySpacedFrames(static_cast<std::int64_t>(pictures.size()), kBoardProposalFrames);
  for (const auto& file : pictures) {
    if (!reportProgress(progress, CalibrationStage::BoardDetection,
                        static_cast<double>(camera.searchedImageCount) /
                            static_cast<double>(pictures.size()))) {
      return canceledError();
    }
    const auto picture = readGrayPicture(file);
    if (!picture) {
      return tl::make_unexpected(picture.error());
    }
    if (camera.searchedImageCount == 0) {
      camera.imageWidth = picture->cols;
      camera.imageHeight = picture->rows;
    }
    if (picture->cols != camera.imageWidth || picture->rows != camera.imageHeight) {
      return failure(ErrorCode::Mismatch, file.string(), "",
                     fmt::format("{} x {} pixels, but the first image has {} x {}", picture->cols,
                                 picture->rows, camera.imageWidth, camera.imageHeight));
    }
    if (auto found = detector.detect(*picture, effort)) {
      camera.views.push_back(
          {file.filename().string(), camera.searchedImageCount, std::move(*found)});
    } else {
      missed.add(0, file.filename().string(), camera.searchedImageCount, *picture, camera);
    }
    if (std::ranges::binary_search(keep, static_cast<std::int64_t>(camera.searchedImageCount))) {
      kept.keep(0, *picture);
    }
    ++camera.searchedImageCount;
  }
  if (const auto added =
          addOtherBoards(where, kept, detector.board(), progress, seen).and_then([&] {
            return missed.explainMisses(detector, partOfSearch(progress, 1.0, 1.0), seen);
          });
      !added) {
    return tl::make_unexpected(added.error());
  }
  return seen;
}

} // namespace

bool BoardDetections::hasOnlyOtherBoard() const {
  return otherBoard && boardViewsOf(*this) == 0;
}

const BoardGuess* BoardDetections::otherBoardSeenBy(const PerCamera& camera) const {
  return camera.otherBoard ? &*camera.otherBoard : otherBoard ? &*otherBoard : nullptr;
}

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
  const BoardDetector detector(request.board);
  const auto effort = *total <= kFewFrames ? DetectionEffort::Exact : DetectionEffort::Live;
  const BoardDetections nothing = nothingSeen(project, source);
  const auto frames = framesToSearch(*total, request);
  const bool isLong = static_cast<std::int64_t>(frames.size()) > kLongRecording;
  if (request.checksForOtherBoardFirst && isLong) {
    auto first = searchedFrames(OtherBoards::OfAll, someOf(frames), detector, effort, source,
                                partOfSearch(progress, 0.0, kLookShare), nothing);
    if (!first) {
      return first;
    }
    if (first->hasOnlyOtherBoard()) {
      first->hasSearchedAllFrames = false;
      return first;
    }
  }
  return searchedFrames(OtherBoards::OfEach, frames, detector, effort, source,
                        partOfSearch(progress, isLong ? kLookShare : 0.0, 1.0), nothing);
}

Result<BoardDetections> findBoards(const std::vector<std::filesystem::path>& pictures,
                                   const BoardDescription& board, DetectionEffort effort,
                                   const CalibrationProgress& progress,
                                   bool checksForOtherBoardFirst) {
  const BoardDetector detector(board);
  const auto count = static_cast<std::int64_t>(pictures.size());
  const bool isLong = count > kLongRecording;
  if (checksForOtherBoardFirst && isLong) {
    std::vector<std::filesystem::path> few;
    for (const std::int64_t k : evenlySpacedFrames(count, kBoardProposalFrames)) {
      few.push_back(pictures[static_cast<std::size_t>(k)]);
    }
    auto first = searchedPictures(OtherBoards::OfAll, few, detector, effort,
                                  partOfSearch(progress, 0.0, kLookShare));
    if (!first) {
      return first;
    }
    if (first->hasOnlyOtherBoard()) {
      first->hasSearchedAllFrames = false;
      return first;
    }
  }
  return searchedPictures(OtherBoards::OfEach, pictures, detector, effort,
                          partOfSearch(progress, isLong ? kLookShare : 0.0, 1.0));
}

} // namespace dewpoint::setup
