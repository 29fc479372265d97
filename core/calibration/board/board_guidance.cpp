// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/board/board_guidance.h"

#include <algorithm>
#include <cmath>

namespace dewpoint::calibration {
namespace {

// Tuned; where no source is named here or in the docs, the origin is not recorded.
constexpr double kNewPositionFraction = 0.08; // of the image's width: nearer is the same view again
/// New views after which calibrating again is worth its time.
constexpr std::size_t kViewsPerCalibration = 3;
/// Views before the user is led to come nearer.
constexpr std::size_t kViewsBeforeNear = 4;

/// Part of the image's area that the corners span.
double areaFraction(const BoardDetection& detection, const Intrinsics& image) {
  Eigen::Vector2d least = detection.pixels.front();
  Eigen::Vector2d most = least;
  for (const Eigen::Vector2d& pixel : detection.pixels) {
    least = least.cwiseMin(pixel);
    most = most.cwiseMax(pixel);
  }
  return (most - least).prod() / (static_cast<double>(image.width) * image.height);
}

Eigen::Vector2d centroidOf(const BoardDetection& detection) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (const Eigen::Vector2d& pixel : detection.pixels) {
    sum += pixel;
  }
  return sum / static_cast<double>(detection.pixels.size());
}

} // namespace

BoardGuidance::BoardGuidance(const BoardDescription& board, int width, int height,
                             GuidanceSettings settings)
    : board_(board), settings_(settings), camera_(guessedCamera(width, height)) {}

BoardTilt BoardGuidance::currentTilt(const BoardDetection& detection) const {
  const auto pose = boardPose(board_, detection, camera_);
  return pose ? tiltOf(*pose) : BoardTilt::Flat;
}

void BoardGuidance::updateMotion(double seconds, const BoardDetection& detection) {
  const auto moved = last_ ? motionBetween(*last_, detection) : std::nullopt;
  const double allowed =
      settings_.maxStillWidthsPerSecond * camera_.intrinsics.width * (seconds - lastSeconds_);
  if (!moved || *moved > allowed) {
    stillSince_ = seconds;
  }
  last_ = detection;
  lastSeconds_ = seconds;
}

bool BoardGuidance::addsInformation(const BoardDetection& detection) const {
  const BoardTilt tilt = currentTilt(detection);
  for (std::size_t k = 0; k < views_.size(); ++k) {
    const auto apart = motionBetween(views_[k].detection, detection);
    const bool samePlace = apart && *apart < kNewPositionFraction * camera_.intrinsics.width;
    if (samePlace && tilts_[k] == tilt) {
      return false;
    }
  }
  return true;
}

int BoardGuidance::emptiestRegion(const Eigen::Vector2d& middle) const {
  // Among equals the one farthest from where the board is.
  const auto& in = camera_.intrinsics;
  int emptiest = 0;
  std::pair<int, double> best;
  for (int k = 0; k < static_cast<int>(coverage_.cornerCounts.size()); ++k) {
    const int column = k % BoardCoverage::kColumns;
    const int row = k / BoardCoverage::kColumns;
    const Eigen::Vector2d place((column + 0.5) / BoardCoverage::kColumns * in.width,
                                (row + 0.5) / BoardCoverage::kRows * in.height);
    const std::pair rank(coverage_.cornerCounts[static_cast<std::size_t>(k)],
                         -(place - middle).norm());
    if (k == 0 || rank < best) {
      best = rank;
      emptiest = k;
    }
  }
  return emptiest;
}

GuidanceAdvice BoardGuidance::nextAdvice(const BoardDetection& detection,
                                         GuidanceState& state) const {
  const Eigen::Vector2d middle = centroidOf(detection);
  if (views_.empty()) {
    state.requestedRegion =
        BoardCoverage::regionOf(middle, camera_.intrinsics.width, camera_.intrinsics.height);
    return GuidanceAdvice::HoldStill;
  }
  state.requestedRegion = emptiestRegion(middle);
  // Tilts and places alternate, so that neither is all that is ever shown.
  if (views_.size() % 2 == 0) {
    const auto& tilts = coverage_.tiltCounts;
    state.tilt = static_cast<BoardTilt>(std::ranges::min_element(tilts) - tilts.begin());
    return GuidanceAdvice::TiltTo;
  }
  if (largestAreaFraction_ < settings_.requiredAreaFraction && views_.size() >= kViewsBeforeNear &&
      areaFraction(detection, camera_.intrinsics) < settings_.requiredAreaFraction) {
    return GuidanceAdvice::ComeNearer;
  }
  return GuidanceAdvice::MoveTo;
}

void BoardGuidance::advise(const BoardDetection& detection, GuidanceState& state) {
  if (!instruction_) {
    instruction_.emplace();
    instruction_->advice = nextAdvice(detection, *instruction_);
  }
  state.advice = instruction_->advice;
  state.requestedRegion = instruction_->requestedRegion;
  state.tilt = instruction_->tilt;
}

GuidanceState BoardGuidance::summary() const {
  GuidanceState state;
  state.coverage = coverage_;
  state.viewCount = static_cast<int>(views_.size());
  state.projectionSigmaPx = projectionPx_;
  return state;
}

void BoardGuidance::capture(GuidanceState& state) {
  BoardView view;
  view.instant = static_cast<std::int64_t>(views_.size());
  view.name = "view " + std::to_string(views_.size() + 1);
  view.detection = *last_;
  tilts_.push_back(currentTilt(*last_));
  coverage_.add(last_->pixels, tilts_.back(), camera_.intrinsics.width, camera_.intrinsics.height);
  largestAreaFraction_ = std::max(largestAreaFraction_, areaFraction(*last_, camera_.intrinsics));
  views_.push_back(std::move(view));
  stillSince_ = lastSeconds_;
  instruction_.reset();
  state = summary();
  state.wasCaptured = true;
}

GuidanceState BoardGuidance::update(double seconds,
                                    const std::optional<BoardDetection>& detection) {
  GuidanceState state = summary();
  const bool enough = views_.size() >= static_cast<std::size_t>(settings_.minViews) &&
                      projectionPx_ && *projectionPx_ <= settings_.requiredProjectionSigmaPx;
  if (enough || views_.size() >= static_cast<std::size_t>(settings_.maxViews)) {
    state.advice = GuidanceAdvice::Finished;
    return state;
  }
  if (!detection) {
    last_.reset();
    return state;
  }
  updateMotion(seconds, *detection);
  if (addsInformation(*detection)) {
    state.holdProgress = std::clamp((seconds - stillSince_) / settings_.holdSeconds, 0.0, 1.0);
    const bool soft =
        detection->edgeWidthPx > settings_.softEdgeWidthFraction * camera_.intrinsics.width;
    if (state.holdProgress >= 1.0 && !soft) {
      capture(state);
    } else if (state.holdProgress > 0.0) {
      state.advice = soft ? GuidanceAdvice::Sharpen : GuidanceAdvice::HoldStill;
      return state;
    }
  }
  advise(*detection, state);
  return state;
}

GuidanceState BoardGuidance::captureNow() {
  GuidanceState state = summary();
  if (last_) {
    capture(state);
    advise(*last_, state);
  }
  return state;
}

void BoardGuidance::acceptCalibration(const IntrinsicsResult& result) {
  const auto width = camera_.intrinsics.width;
  const auto height = camera_.intrinsics.height;
  camera_ = result.camera;
  camera_.intrinsics.width = width;
  camera_.intrinsics.height = height;
  projectionPx_ = result.independentProjectionSigmaPx;
  calibratedViews_ = result.views.size();
}

bool BoardGuidance::isCalibrationDue() const {
  const auto least = static_cast<std::size_t>(settings_.minViews);
  return views_.size() >= std::max(least, calibratedViews_ + kViewsPerCalibration);
}

} // namespace dewpoint::calibration
