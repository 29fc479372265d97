// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/calibration/missed_images.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace dewpoint::setup {
namespace {

constexpr std::size_t kMostExplained = 12; ///< images of a camera: each takes up to seconds

/// Whether the board was seen in a frame between two others.
bool isSeenBetween(const BoardDetections::PerCamera& camera, std::int64_t first,
                   std::int64_t last) {
  return std::ranges::any_of(camera.views, [&](const BoardView& view) {
    return view.instant > first && view.instant < last;
  });
}

std::string runText(const MissedRun& run) {
  std::string text = !run.file.empty() ? run.file
                     : run.firstNumber == run.lastNumber
                         ? fmt::format("{}", run.firstNumber)
                         : fmt::format("{}-{}", run.firstNumber, run.lastNumber);
  const std::string reason = missReasonText(run.missReason);
  return reason.empty() ? text : fmt::format("{} ({})", text, reason);
}

} // namespace

void MissedImages::add(std::size_t index, std::string file, std::int64_t instant,
                       const cv::Mat& image, BoardDetections::PerCamera& camera) {
  camera.missedImages.push_back({std::move(file), instant, {}});
  if (explained_ && images_[index].size() < kMostExplained) {
    images_[index].push_back(image);
  }
}

Status MissedImages::explainMisses(const BoardDetector& detector,
                                   const CalibrationProgress& progress,
                                   BoardDetections& seen) const {
  for (std::size_t k = 0; k < images_.size(); ++k) {
    auto& camera = seen.cameras[k];
    if (seen.otherBoardSeenBy(camera) != nullptr) {
      continue;
    }
    for (std::size_t i = 0; i < images_[k].size(); ++i) {
      if (!reportProgress(progress, CalibrationStage::BoardDetection, 1.0)) {
        return canceledError();
      }
      camera.missedImages[i].missReason = diagnoseMissedBoard(detector, images_[k][i]);
    }
  }
  return {};
}

std::vector<MissedRun> missedRuns(const BoardDetections::PerCamera& camera) {
  std::vector<MissedRun> runs;
  for (const MissedImage& image : camera.missedImages) {
    if (!runs.empty() && image.file.empty() && runs.back().missReason == image.missReason &&
        !isSeenBetween(camera, runs.back().lastNumber, image.number)) {
      runs.back().lastNumber = image.number;
      ++runs.back().imageCount;
      continue;
    }
    runs.push_back({image.file, image.number, image.number, 1, image.missReason});
  }
  return runs;
}

bool hasExplainedMiss(const BoardDetections::PerCamera& camera) {
  return std::ranges::any_of(camera.missedImages, [](const MissedImage& image) {
    return image.missReason.reason != BoardMiss::Reason::Unknown;
  });
}

std::string missedImagesText(const BoardDetections::PerCamera& camera) {
  const auto runs = missedRuns(camera);
  if (runs.empty()) {
    return {};
  }
  std::string text = "no board was found in ";
  if (runs.front().file.empty()) {
    text += camera.missedImages.size() == 1 ? "frame " : "frames ";
  }
  int others = 0;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    if (k < kMaxListedRuns) {
      text += (k == 0 ? "" : ", ") + runText(runs[k]);
    } else {
      others += runs[k].imageCount;
    }
  }
  return others == 0 ? text : fmt::format("{} and in {} others", text, others);
}

} // namespace dewpoint::setup
