// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/barrera/random_walk_tracker.h"

#include "core/tracking/start_parameters.h"

#include <algorithm>
#include <utility>

namespace dewpoint::tracking {

RandomWalkTracker::RandomWalkTracker(const ParameterValues& parameters) : parameters_(parameters) {
  filter_.start(drawStart());
}

void RandomWalkTracker::configure(const ParameterValues& parameters) {
  parameters_ = parameters;
  if (!started_) {
    filter_.start(drawStart());
  }
}

void RandomWalkTracker::restart(std::uint64_t seed) {
  key_.seed = seed;
  key_.iteration = 0;
  started_ = false;
  estimate_ = {};
  filter_.start(drawStart());
}

int RandomWalkTracker::iterationsPerFrame() const {
  return static_cast<int>(parameters_.at("iterations_per_frame"));
}

void RandomWalkTracker::beginFrame(FrameSetPtr frames) {
  key_.iteration = 0;
  key_.frame = frames ? static_cast<std::uint32_t>(frames->index) : 0;
  frames_ = std::move(frames);
}

cv::Mat RandomWalkTracker::imageOf(std::size_t camera) const {
  const bool present =
      frames_ && camera < frames_->frames.size() && frames_->frames[camera] != nullptr;
  return present ? frames_->frames[camera]->image : cv::Mat();
}

void RandomWalkTracker::particles(int limit, Eigen::ArrayXXd& positions,
                                  Eigen::ArrayXd& weights) const {
  const Eigen::ArrayXXd& states = filter_.states();
  const Eigen::Index shown = std::clamp<Eigen::Index>(limit, 0, states.rows());
  positions.resize(shown, 3);
  weights.resize(shown);
  for (Eigen::Index i = 0; i < shown; ++i) {
    const Eigen::Index picked = i * states.rows() / shown;
    positions.row(i) = states.row(picked);
    weights[i] = filter_.weights()[picked];
  }
}

std::size_t RandomWalkTracker::memoryBytes() const {
  // States twice (also those of the parents), weights and ancestors.
  return static_cast<std::size_t>(filter_.states().size()) * 3 * sizeof(double);
}

Eigen::ArrayXXd RandomWalkTracker::drawStart() const {
  const StartVolume volume = startVolume(parameters_);
  const RandomStream stream(key_.seed, 0, 0, RandomPurpose::Start);
  Eigen::ArrayXXd states(static_cast<Eigen::Index>(parameters_.at("particles")), 3);
  for (Eigen::Index i = 0; i < states.rows(); ++i) {
    const auto unit = stream.uniform3(static_cast<std::uint32_t>(i));
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      states(i, axis) = volume.center[axis] +
                        volume.half[axis] * (2.0 * unit[static_cast<std::size_t>(axis)] - 1.0);
    }
  }
  return states;
}

} // namespace dewpoint::tracking
