// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/barrera/random_walk_tracker.h"

#include "core/filter/evenly_picked.h"
#include "core/filter/prepared_gaussian.h"
#include "core/tracking/start_parameters.h"

#include <algorithm>
#include <utility>

namespace dewpoint::tracking {

RandomWalkTracker::RandomWalkTracker(const ParameterValues& parameters) : parameters_(parameters) {
  filter_.start(drawStartParticles());
}

void RandomWalkTracker::configure(const ParameterValues& parameters) {
  parameters_ = parameters;
  if (!started_) {
    filter_.start(drawStartParticles());
  }
}

void RandomWalkTracker::setVolumeOfInterest(const std::optional<WorldBox>& volume) {
  volume_ = volume;
  if (!started_ || !isInVolumeOfInterest(estimate_.mean)) {
    filter_.start(drawStartParticles());
  }
}

void RandomWalkTracker::restart(std::uint64_t seed) {
  key_.seed = seed;
  key_.iteration = 0;
  started_ = false;
  estimate_ = {};
  filter_.start(drawStartParticles());
}

int RandomWalkTracker::iterationsPerFrame() const {
  return static_cast<int>(parameters_.at("iterations_per_frame"));
}

void RandomWalkTracker::beginFrame(FrameSetPtr frames) {
  key_.iteration = 0;
  key_.frame = frames ? static_cast<std::uint32_t>(frames->index) : 0;
  frames_ = std::move(frames);
}

SphereEstimate RandomWalkTracker::correct(const Gaussian3& position) {
  const auto count = static_cast<Eigen::Index>(parameters_.at("particles"));
  filter_.start(PreparedGaussian3(position).draw(count, key_.stream(RandomPurpose::Start)));
  started_ = true;
  estimate_.mean = position.mean;
  estimate_.best = position.mean;
  estimate_.covariance = position.covariance;
  estimate_.effectiveSampleSize = static_cast<double>(count);
  estimate_.particleCount = static_cast<int>(count);
  estimate_.isDegenerate = false;
  estimate_.isValid = true;
  estimate_.existenceProbability = 1.0;
  return estimate_;
}

cv::Mat RandomWalkTracker::imageOf(std::size_t camera) const {
  const bool present =
      frames_ && camera < frames_->frames.size() && frames_->frames[camera] != nullptr;
  return present ? frames_->frames[camera]->image : cv::Mat();
}

void RandomWalkTracker::copyParticles(int limit, Eigen::ArrayXXd& positions,
                                      Eigen::ArrayXd& weights) const {
  const Eigen::ArrayXXd& states = filter_.states();
  pickEvenly(states, filter_.weights(), limit, 3, positions, weights);
}

std::size_t RandomWalkTracker::memoryBytes() const {
  // States twice (also those of the parents), weights and ancestors.
  return static_cast<std::size_t>(filter_.states().size()) * 3 * sizeof(double);
}

Eigen::ArrayXXd RandomWalkTracker::drawStartParticles() const {
  const StartVolume start = startVolumeOf(parameters_);
  return drawUniformPositions(volume_ ? startVolumeWithin(start, *volume_) : start,
                              static_cast<Eigen::Index>(parameters_.at("particles")),
                              RandomStream(key_.seed, 0, 0, RandomPurpose::Start));
}

} // namespace dewpoint::tracking
