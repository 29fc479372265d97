// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/people/people_cameras.h"

#include "core/geometry/projector.h"
#include "core/tracking/frame_gap.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>

namespace dewpoint::tracking {
namespace {

constexpr double kOverwhelmed = 0.6;   ///< share of foreground that cannot be people
constexpr int kBackgroundUpdates = 10; ///< times that a background image is learned

/// The same camera with images `factor` times as large.
Camera reduced(const Camera& camera, double factor) {
  Camera result = camera;
  Intrinsics& k = result.intrinsics;
  k.width = std::max(1, static_cast<int>(std::lround(k.width * factor)));
  k.height = std::max(1, static_cast<int>(std::lround(k.height * factor)));
  k.focalX *= factor;
  k.focalY *= factor;
  k.centerX = (k.centerX + 0.5) * factor - 0.5;
  k.centerY = (k.centerY + 0.5) * factor - 0.5;
  return result;
}

void reduceImage(const cv::Mat& image, const Intrinsics& size, cv::Mat& result) {
  if (image.cols == size.width && image.rows == size.height) {
    result = image;
    return;
  }
  cv::Mat smaller; // never into `result`, which may share the pixels of a frame
  cv::resize(image, smaller, cv::Size(size.width, size.height), 0.0, 0.0, cv::INTER_AREA);
  result = smaller;
}

} // namespace

PeopleCameras::PeopleCameras(const CameraRig& rig, const PeopleSettings& settings)
    : settings_(settings) {
  setRig(rig);
  restart();
}

void PeopleCameras::setRig(const CameraRig& rig) {
  rig_ = rig;
  std::vector<View> views;
  for (std::size_t k = 0; k < rig.size(); ++k) {
    const int width = rig[k].intrinsics.width;
    const bool reduce = settings_.maxImageWidth > 0 && width > settings_.maxImageWidth;
    const Camera camera =
        reduced(rig[k], reduce ? double(settings_.maxImageWidth) / std::max(1, width) : 1.0);
    View view{camera, Projector(camera), {}, {}, {}, 0};
    if (k < views_.size()) { // what was learned stays
      view.model = std::move(views_[k].model);
      view.learnedFrameCount = views_[k].learnedFrameCount;
    }
    views.push_back(std::move(view));
  }
  views_ = std::move(views);
  states_.resize(views_.size());
}

void PeopleCameras::restart() {
  frame_ = -1;
  sinceStart_ = 0.0;
  views_.clear();
  states_.clear();
  setRig(rig_);
}

bool PeopleCameras::canBeCopied() const {
  return std::ranges::all_of(
      views_, [](const View& view) { return !view.model || view.model.copyable() != nullptr; });
}

std::size_t PeopleCameras::memoryBytes() const {
  std::size_t sum = 0;
  for (const View& view : views_) {
    sum += view.image.total() * view.image.elemSize() + view.mask.total();
    const CopyableForeground* const copyable = view.model.copyable();
    sum += copyable != nullptr ? copyable->memoryBytes() : 0;
  }
  return sum;
}

ForegroundSettings PeopleCameras::foregroundSettings() const {
  ForegroundSettings settings = settings_.foreground;
  const double rate = 1.0 / std::max(1e-3, interval_);
  settings.learningFrameCount = static_cast<int>(std::ceil(settings_.learningSeconds * rate));
  settings.memoryFrameCount = settings_.backgroundMemorySeconds * rate;
  return settings;
}

void PeopleCameras::computeForegroundMasks(const FrameSet& frames, const std::vector<cv::Mat>& keep,
                                           ThreadTeam& team) {
  const double gap = seconds(frames.time - time_);
  interval_ = frame_ < 0 || gap <= 0.0 ? kDefaultGap : std::min(gap, kLongestGap);
  sinceStart_ += frame_ < 0 ? 0.0 : interval_;
  time_ = frames.time;
  ++frame_;
  team.forEachRange(
      static_cast<std::int64_t>(views_.size()), [&](std::int64_t begin, std::int64_t end) {
        for (auto k = static_cast<std::size_t>(begin); k < static_cast<std::size_t>(end); ++k) {
          updateMask(frames, k, k < keep.size() ? keep[k] : cv::Mat());
        }
      });
}

void PeopleCameras::learnBackgroundImage(std::size_t camera) {
  View& view = views_[camera];
  cv::Mat room;
  reduceImage(backgroundImages_[camera], view.camera.intrinsics, room);
  for (int k = 0; k < kBackgroundUpdates; ++k) {
    view.model->learn(room);
  }
}

void PeopleCameras::updateMask(const FrameSet& frames, std::size_t camera, const cv::Mat& keep) {
  View& view = views_[camera];
  PeopleCameraState& state = states_[camera];
  state.isUsable = false;
  state.foregroundFraction = 0.0;
  view.mask = cv::Mat();
  if (camera >= frames.frames.size() || !frames.frames[camera] ||
      frames.frames[camera]->image.empty()) {
    return;
  }
  reduceImage(frames.frames[camera]->image, view.camera.intrinsics, view.image);
  const bool knowsRoom = camera < backgroundImages_.size() && !backgroundImages_[camera].empty();
  if (!view.model && (knowsRoom || frame_ > 0 || settings_.learningSeconds <= 0.0)) {
    // From the second frame on, when the rate is known, unless there is nothing to wait for.
    view.model = makeForegroundModel(foregroundSettings());
    if (knowsRoom) {
      learnBackgroundImage(camera);
    }
  }
  const bool learning = !knowsRoom && sinceStart_ < settings_.learningSeconds;
  state.learningProgress = learning ? sinceStart_ / settings_.learningSeconds : 1.0;
  if (learning || !view.model) {
    if (view.model) {
      view.model->learn(view.image);
      ++view.learnedFrameCount;
    }
    return;
  }
  view.model->subtract(view.image, keep, view.mask);
  state.foregroundFraction =
      static_cast<double>(cv::countNonZero(view.mask)) / static_cast<double>(view.mask.total());
  state.isUsable = state.foregroundFraction < kOverwhelmed;
}

} // namespace dewpoint::tracking
