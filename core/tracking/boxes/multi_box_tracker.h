// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/random.h"
#include "core/observation/boxes/box_histogram.h"
#include "core/tracking/boxes/box_filter.h"
#include "core/tracking/tracker_capabilities.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace dewpoint::tracking {

/// Method that tracks boxes in a run with several cameras and targets. Each target has its own
/// filter, which processes the images of the camera in which the box was set. A target is absent
/// until the run is at the frame of its box, and is tracked from this frame on. There is one step
/// per image.
template <BoxFilter F>
class MultiBoxTracker final : public Tracker,
                              public Configurable,
                              public TargetTracking,
                              public BoxTracking,
                              public ReferenceColorReporting,
                              public CameraReporting,
                              public Copyable {
public:
  /// Creates a tracker. `parameters` must be declared by the filter's method (asserted).
  MultiBoxTracker(const ParameterValues& parameters, const std::vector<Target>& targets)
      : parameters_(parameters) {
    MultiBoxTracker::setTargets(targets);
  }

  void configure(const ParameterValues& parameters) override;
  /// Sets the targets. Their number may change. Targets that existed before are recognized by their
  /// indices if the number is unchanged, and by their names otherwise. Targets with an unchanged
  /// box continue; other targets start from scratch.
  void setTargets(const std::vector<Target>& targets) override;
  void restart(std::uint64_t seed) override;
  int iterationsPerFrame() const override { return 1; }
  /// Begins a frame. A target whose box belongs to this frame is present immediately, before any
  /// iteration.
  void beginFrame(FrameSetPtr frames) override;
  void iterate(ThreadTeam& team) override;
  std::size_t trackCount() const override { return followed_.size(); }
  TrackEstimate estimate(std::size_t track) const override;
  Status startFollowing(std::size_t target, const cv::Mat& bgr, const TargetBox& box,
                        std::uint64_t seed) override;
  BoxParticles boxParticles(std::size_t target, int limit) const override;
  std::vector<double> referenceHistogram(std::size_t target) const override {
    return followed_.at(target).referenceHistogram;
  }
  std::vector<CameraReport> cameraReports(std::size_t track) const override;
  bool canBeCopied() const override { return true; }
  std::unique_ptr<Tracker> clone() const override {
    return std::make_unique<MultiBoxTracker>(*this);
  }
  std::size_t memoryBytes() const override;

private:
  struct TrackedBox {
    std::string name;
    std::optional<TargetBox> box;
    std::optional<F> filter; ///< empty before the frame of the box
    std::int64_t startFrame = -1;
    BoxEstimate estimate;
    std::vector<double> referenceHistogram; ///< histogram of the box in its own frame
  };

  /// Returns the image of the camera in which a box was set, or null if this camera delivered no
  /// image.
  const cv::Mat* imageOf(const TargetBox& box) const;
  /// Starts tracking a target whose box was set in the current frame of the run.
  void start(std::size_t target);
  void step(TrackedBox& one, ThreadTeam& team) const;

  ParameterValues parameters_;
  std::uint64_t seed_ = 0;
  std::vector<TrackedBox> followed_;
  FrameSetPtr frames_;
};

template <BoxFilter F> void MultiBoxTracker<F>::configure(const ParameterValues& parameters) {
  parameters_ = parameters;
  for (TrackedBox& one : followed_) {
    if (one.filter) {
      one.filter->configure(parameters_);
    }
  }
}

template <BoxFilter F> void MultiBoxTracker<F>::setTargets(const std::vector<Target>& targets) {
  std::vector<TrackedBox> before = std::exchange(followed_, {});
  const bool sameNumber = before.size() == targets.size(); // then a target may have been renamed
  for (std::size_t k = 0; k < targets.size(); ++k) {
    const auto old = sameNumber ? before.begin() + static_cast<std::ptrdiff_t>(k)
                                : std::ranges::find(before, targets[k].name, &TrackedBox::name);
    if (old != before.end() && old->box == targets[k].box) {
      followed_.push_back(std::move(*old));
      followed_.back().name = targets[k].name;
    } else {
      followed_.push_back({targets[k].name, targets[k].box, std::nullopt, -1, {}, {}});
    }
  }
  for (std::size_t k = 0; k < followed_.size(); ++k) {
    start(k);
  }
}

template <BoxFilter F> void MultiBoxTracker<F>::beginFrame(FrameSetPtr frames) {
  frames_ = std::move(frames);
  for (std::size_t k = 0; k < followed_.size(); ++k) {
    start(k);
  }
}

template <BoxFilter F> void MultiBoxTracker<F>::restart(std::uint64_t seed) {
  seed_ = seed;
  frames_ = nullptr;
  for (TrackedBox& one : followed_) {
    one.filter.reset();
    one.startFrame = -1;
    one.estimate = {};
    one.referenceHistogram.clear();
  }
}

template <BoxFilter F> const cv::Mat* MultiBoxTracker<F>::imageOf(const TargetBox& box) const {
  const auto camera = static_cast<std::size_t>(box.camera);
  const bool there = frames_ && box.camera >= 0 && camera < frames_->frames.size() &&
                     frames_->frames[camera] && !frames_->frames[camera]->image.empty();
  return there ? &frames_->frames[camera]->image : nullptr;
}

template <BoxFilter F> void MultiBoxTracker<F>::start(std::size_t target) {
  const TrackedBox& one = followed_[target];
  if (!frames_ || !one.box || one.box->frame != frames_->index ||
      one.startFrame == frames_->index) {
    return;
  }
  if (const cv::Mat* image = imageOf(*one.box)) {
    // The box is outside the image: there is nothing to track.
    (void)startFollowing(target, *image, *one.box,
                         derivedSeed(seed_, static_cast<std::uint32_t>(target)));
  }
}

template <BoxFilter F>
Status MultiBoxTracker<F>::startFollowing(std::size_t target, const cv::Mat& bgr,
                                          const TargetBox& box, std::uint64_t seed) {
  TrackedBox& one = followed_.at(target);
  F filter(parameters_);
  if (const Status started = filter.start(bgr, box.box, seed); !started) {
    return started;
  }
  one.box = box;
  one.filter.emplace(std::move(filter));
  one.startFrame = box.frame;
  one.referenceHistogram = boxHistogram(bgr, box.box);
  one.estimate = BoxEstimate{};
  one.estimate.box = box.box;
  one.estimate.camera = box.camera;
  one.estimate.similarity = 1.0;
  one.estimate.particleCount = static_cast<int>(parameters_.at("particles"));
  one.estimate.effectiveSampleSize = one.estimate.particleCount;
  return {};
}

template <BoxFilter F> void MultiBoxTracker<F>::step(TrackedBox& one, ThreadTeam& team) const {
  if (!one.filter || one.startFrame == frames_->index) {
    return; // in its own image, the target is at the box as defined
  }
  if (const cv::Mat* image = imageOf(*one.box)) {
    one.estimate = one.filter->step(*image, team);
    one.estimate.camera = one.box->camera;
  } else {
    one.estimate.isVisible = false; // the camera delivered no image
  }
}

template <BoxFilter F> void MultiBoxTracker<F>::iterate(ThreadTeam& team) {
  for (std::size_t k = 0; frames_ && k < followed_.size(); ++k) {
    step(followed_[k], team);
  }
}

template <BoxFilter F> TrackEstimate MultiBoxTracker<F>::estimate(std::size_t track) const {
  const TrackedBox& one = followed_.at(track);
  return one.filter ? TrackEstimate(one.estimate) : TrackEstimate(AbsentEstimate{});
}

template <BoxFilter F>
BoxParticles MultiBoxTracker<F>::boxParticles(std::size_t target, int limit) const {
  const TrackedBox& one = followed_.at(target);
  if (!one.filter) {
    return {};
  }
  Eigen::ArrayXXd centers;
  Eigen::ArrayXd weights;
  one.filter->copyParticles(limit, centers, weights);
  return {centers.cast<float>(), weights.cast<float>()};
}

template <BoxFilter F>
std::vector<CameraReport> MultiBoxTracker<F>::cameraReports(std::size_t track) const {
  const TrackedBox& one = followed_.at(track);
  std::vector<CameraReport> reports;
  if (one.filter && frames_) {
    reports.resize(frames_->frames.size()); // the other cameras do not search for the target
    reports.at(static_cast<std::size_t>(one.box->camera)).status =
        imageOf(*one.box) == nullptr ? CameraStatus::NoImage
        : isConfirmed(one.estimate)  ? CameraStatus::None
        : one.estimate.isVisible     ? CameraStatus::OutOfView
                                     : CameraStatus::Hidden;
  }
  return reports;
}

template <BoxFilter F> std::size_t MultiBoxTracker<F>::memoryBytes() const {
  std::size_t bytes = sizeof(MultiBoxTracker);
  for (const TrackedBox& one : followed_) {
    bytes += sizeof(TrackedBox) + sizeof(double) * one.referenceHistogram.capacity() +
             (one.filter ? one.filter->memoryBytes() : 0);
  }
  return bytes;
}

} // namespace dewpoint::tracking
