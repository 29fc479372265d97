// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/calibration/board_guide.h"

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

#include <algorithm>

namespace dewpoint::setup {
namespace {

constexpr int kMoreInstants = 4; ///< of each pair, while the places are not known well enough

BoardGuideState::Outline outlineOf(const BoardDetection& detection) {
  std::vector<cv::Point2f> corners;
  for (const Eigen::Vector2d& pixel : detection.pixels) {
    corners.emplace_back(static_cast<float>(pixel.x()), static_cast<float>(pixel.y()));
  }
  std::vector<cv::Point2f> around;
  if (corners.size() >= 3) {
    cv::convexHull(corners, around);
  }
  BoardGuideState::Outline outline;
  for (const cv::Point2f& corner : around) {
    outline.emplace_back(corner.x, corner.y);
  }
  return outline;
}

} // namespace

BoardCalibrationRequest requestForCapturedViews(const BoardGuideRequest& request,
                                                const BoardGuideState& state) {
  BoardCalibrationRequest all = request.board;
  all.maxViews = std::max(all.maxViews, request.lensGuidance.maxViews);
  all.floorFrame = state.floorFrame;
  return all;
}

BoardGuide::BoardGuide(Project project, const BoardGuideRequest& request, int threads)
    : project_(std::move(project)), request_(request), detector_(request.board.board),
      team_(threads) {
  state_.phase =
      request.goal.estimatesLenses ? BoardGuideState::Phase::Lenses : BoardGuideState::Phase::Poses;
  for (const ProjectCamera& camera : project_.cameras) {
    seen_.cameras.push_back({camera.camera.name, 0, 0, 0, {}});
    state_.cameras.emplace_back().name = camera.camera.name;
  }
  viewsAtCalibration_.resize(project_.cameras.size());
  lenses_.resize(project_.cameras.size());
  state_.detections = std::make_shared<const BoardDetections>(seen_);
}

BoardGuide::Detections BoardGuide::detectIn(const FrameSet& frames) {
  Detections found(state_.cameras.size());
  const auto count = static_cast<std::int64_t>(std::min(found.size(), frames.frames.size()));
  team_.forEachRange(count, [&](std::int64_t begin, std::int64_t end) {
    for (auto k = static_cast<std::size_t>(begin); k < static_cast<std::size_t>(end); ++k) {
      if (frames.frames[k] != nullptr && !frames.frames[k]->image.empty()) {
        found[k] = detector_.detect(frames.frames[k]->image, DetectionEffort::Live);
      }
    }
  });
  for (std::size_t k = 0; k < found.size(); ++k) {
    state_.cameras[k].detection = found[k];
    state_.cameras[k].outline = found[k] ? outlineOf(*found[k]) : BoardGuideState::Outline();
    seen_.cameras[k].searchedImageCount +=
        k < frames.frames.size() && frames.frames[k] != nullptr ? 1 : 0;
  }
  return found;
}

/// Sizes of images are known only from images.
void BoardGuide::begin(const FrameSet& frames) {
  for (std::size_t k = 0; k < state_.cameras.size(); ++k) {
    const FramePtr frame = k < frames.frames.size() ? frames.frames[k] : nullptr;
    auto& camera = state_.cameras[k];
    if (frame != nullptr && camera.imageWidth == 0) {
      camera.imageWidth = frame->image.cols;
      camera.imageHeight = frame->image.rows;
      seen_.cameras[k].imageWidth = camera.imageWidth;
      seen_.cameras[k].imageHeight = camera.imageHeight;
      lenses_[k].emplace(request_.board.board, camera.imageWidth, camera.imageHeight,
                         request_.lensGuidance);
    }
  }
  if (state_.phase == BoardGuideState::Phase::Poses && !rigGuidance_) {
    beginRig();
  }
}

BoardGuideState BoardGuide::processFrame(const FrameSet& frames) {
  state_.frame = frames.index;
  begin(frames);
  if (state_.phase == BoardGuideState::Phase::Finished) {
    return state_;
  }
  const Detections found = detectIn(frames);
  const double time = seconds(frames.time);
  if (state_.phase == BoardGuideState::Phase::Lenses) {
    stepLenses(time, found);
  } else {
    stepRig(time, found);
  }
  return state_;
}

void BoardGuide::stepLenses(double time, const Detections& found) {
  for (std::size_t k = 0; k < lenses_.size(); ++k) {
    if (lenses_[k]) {
      storeLensState(k, lenses_[k]->update(time, found[k]));
    }
  }
  if (std::ranges::all_of(state_.cameras, [](const auto& camera) {
        return camera.lensGuidance.advice == GuidanceAdvice::Finished;
      })) {
    skipToPoses();
  }
}

void BoardGuide::storeLensState(std::size_t camera, const GuidanceState& state) {
  state_.cameras[camera].lensGuidance = state;
  if (state.wasCaptured) {
    storeView(camera);
    calibrateLens(camera);
  }
}

/// The detection that was just taken. Views have the numbers of their frames, so that those of one
/// moment belong together.
void BoardGuide::storeView(std::size_t camera) {
  auto& of = state_.cameras[camera];
  if (!of.detection) {
    return;
  }
  seen_.cameras[camera].views.push_back(
      {fmt::format("frame {}", state_.frame), state_.frame, *of.detection});
  if (of.capturedOutlines.size() < request_.maxOutlines) {
    of.capturedOutlines.push_back(of.outline);
  }
  state_.detections = std::make_shared<const BoardDetections>(seen_);
}

void BoardGuide::calibrateLens(std::size_t camera) {
  BoardGuidance& guidance = *lenses_[camera];
  const std::size_t count = guidance.views().size();
  if (!guidance.isCalibrationDue() || count == viewsAtCalibration_[camera]) {
    return;
  }
  viewsAtCalibration_[camera] = count;
  IntrinsicsRequest lensRequest;
  lensRequest.board = request_.board.board;
  lensRequest.views = guidance.views();
  lensRequest.width = state_.cameras[camera].imageWidth;
  lensRequest.height = state_.cameras[camera].imageHeight;
  lensRequest.model = request_.board.model;
  lensRequest.pixelShape = request_.board.pixelShape;
  if (const auto result = calibrateIntrinsics(lensRequest)) {
    guidance.acceptCalibration(*result);
    state_.cameras[camera].rmsPx = result->rmsPx;
    state_.cameras[camera].lensGuidance.projectionSigmaPx = result->independentProjectionSigmaPx;
    Camera& known = project_.cameras[camera].camera;
    known.intrinsics = result->camera.intrinsics;
    known.distortion = result->camera.distortion;
    known.lens = result->camera.lens;
  }
}

void BoardGuide::beginRig() {
  state_.phase = BoardGuideState::Phase::Poses;
  std::vector<int> widths;
  for (const auto& camera : state_.cameras) {
    widths.push_back(std::max(1, camera.imageWidth));
  }
  rigGuidance_.emplace(std::move(widths), request_.rigGuidance);
  state_.rigGuidance = rigGuidance_->state();
  if (state_.rigGuidance.isFinished) { // one camera alone has no pair
    state_.phase = BoardGuideState::Phase::Finished;
  }
}

BoardGuideState BoardGuide::skipToPoses() {
  if (state_.phase == BoardGuideState::Phase::Lenses) {
    if (request_.goal.estimatesPoses) {
      beginRig();
    } else {
      state_.phase = BoardGuideState::Phase::Finished;
    }
  }
  return state_;
}

void BoardGuide::stepRig(double time, const Detections& found) {
  storeRigState(rigGuidance_->update(time, found));
}

void BoardGuide::storeRigState(const RigGuidance::State& state) {
  state_.rigGuidance = state;
  if (state.wasCaptured) {
    for (std::size_t k = 0; k < state_.cameras.size(); ++k) {
      if (state_.cameras[k].detection) {
        storeView(k);
        ++state_.cameras[k].pairViewCount;
      }
    }
  }
  if (state.isFinished && state.instantCount < request_.maxInstants) {
    calibrateRig();
  } else if (state.isFinished) {
    state_.phase = BoardGuideState::Phase::Finished;
  }
}

/// Ends, or asks for more where the places are not known well enough.
void BoardGuide::calibrateRig() {
  ExtrinsicsRequest rigRequest;
  rigRequest.board = request_.board.board;
  for (std::size_t k = 0; k < project_.cameras.size(); ++k) {
    rigRequest.cameras.push_back({project_.cameras[k].camera, rigGuidance_->views()[k]});
  }
  const auto result = calibrateExtrinsics(rigRequest);
  bool enough = result.has_value();
  for (std::size_t k = 0; result && k < result->cameraFits.size(); ++k) {
    state_.cameras[k].positionSigma = result->cameraFits[k].centerSigma;
    enough = enough && result->cameraFits[k].centerSigma <= request_.requiredPositionSigma;
  }
  if (enough) {
    state_.phase = BoardGuideState::Phase::Finished;
  } else {
    rigGuidance_->requireMoreInstants(kMoreInstants);
    state_.rigGuidance = rigGuidance_->state();
  }
}

BoardGuideState BoardGuide::captureFloor() {
  const auto seeing = std::ranges::count_if(
      state_.cameras, [](const auto& camera) { return camera.detection.has_value(); });
  if (state_.phase == BoardGuideState::Phase::Poses && seeing >= 2) {
    state_.floorFrame = state_.frame;
  }
  return captureNow();
}

BoardGuideState BoardGuide::captureNow() {
  if (state_.phase == BoardGuideState::Phase::Poses && rigGuidance_) {
    storeRigState(rigGuidance_->captureNow());
  } else if (state_.phase == BoardGuideState::Phase::Lenses) {
    for (std::size_t k = 0; k < lenses_.size(); ++k) {
      if (lenses_[k] && state_.cameras[k].detection) {
        storeLensState(k, lenses_[k]->captureNow());
      }
    }
  }
  return state_;
}

} // namespace dewpoint::setup
