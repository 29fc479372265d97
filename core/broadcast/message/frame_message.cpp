// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/broadcast/message/frame_message.h"

#include "core/base/units.h"
#include "core/geometry/seen_volume.h"
#include "core/session/snapshot/sight_lines.h"
#include "core/session/snapshot/snapshot_state.h"
#include "core/trajectory/motion.h"

#include <algorithm>
#include <utility>

namespace dewpoint::broadcast {
namespace {

/// The box around a box in other coordinates, whose axes are those of the first one, permuted.
WorldBox mapped(const WorldBox& box, const Eigen::Matrix3d& matrix) {
  const Eigen::Vector3d one = matrix * box.min;
  const Eigen::Vector3d other = matrix * box.max;
  return {one.cwiseMin(other), one.cwiseMax(other)};
}

TrajectorySample sampleOfTarget(const TrackSnapshot& snapshot, const TargetSnapshot& target) {
  TrajectorySample sample;
  const auto position = positionOf(target.estimate);
  sample.frame = snapshot.frame;
  sample.time = seconds(snapshot.frames->time);
  sample.isValid = position && position->mean.allFinite() && isConfirmed(target.estimate);
  sample.position = sample.isValid ? position->mean : Eigen::Vector3d::Zero();
  return sample;
}

/// The same samples, numbered so that frames which were skipped are no gap.
std::vector<TrajectorySample> renumbered(std::vector<TrajectorySample> samples) {
  std::int64_t number = 0;
  std::int64_t before = samples.empty() ? 0 : samples.front().frame;
  for (TrajectorySample& sample : samples) {
    number += trajectory::isTrackInterrupted(before, sample.frame) ? 2 : 1;
    before = std::exchange(sample.frame, number);
  }
  return samples;
}

std::vector<int> camerasSeeing(const TrackSnapshot& snapshot, const TargetSnapshot& target) {
  std::vector<int> cameras;
  for (const SightLine& line : sightLines(snapshot, target)) {
    if (line.seesTarget) {
      cameras.push_back(line.camera);
    }
  }
  return cameras;
}

} // namespace

Eigen::Matrix3d OutputCoordinates::outputFromWorld() const {
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Identity();
  if (axes == OutputAxes::YUp) {
    matrix << 0, 1, 0, 0, 0, 1, 1, 0, 0;
  } else if (axes == OutputAxes::YUpLeftHanded) {
    matrix << 1, 0, 0, 0, 0, 1, 0, 1, 0;
  }
  return unit == OutputUnit::Millimeter ? Eigen::Matrix3d(inMillimeters(1.0) * matrix) : matrix;
}

const char* stateWord(TrackingState state) {
  switch (state) {
  case TrackingState::Held:
    return "held";
  case TrackingState::Ambiguous:
    return "ambiguous";
  case TrackingState::Hidden:
    return "hidden";
  case TrackingState::Lost:
    return "lost";
  case TrackingState::Gone:
  case TrackingState::Nobody:
  case TrackingState::NoBox:
  case TrackingState::NoTarget:
    return "gone";
  case TrackingState::NoImages:
  case TrackingState::NotTracked:
  case TrackingState::Searching:
  case TrackingState::Missing:
  case TrackingState::Learning:
    break;
  }
  return "searching";
}

RigMessage rigMessageOf(const TrackSnapshot& snapshot, const OutputCoordinates& coordinates,
                        const std::optional<WorldBox>& volume) {
  RigMessage message;
  message.coordinates = coordinates;
  const Eigen::Matrix3d outputFromWorld = coordinates.outputFromWorld();
  for (const Camera& camera : *snapshot.rig) {
    message.cameras.push_back({camera.name, outputFromWorld * camera.center(),
                               (outputFromWorld * camera.opticalAxis()).normalized()});
  }
  const auto box = volume ? volume : seenVolume(*snapshot.rig);
  message.volume = mapped(box.value_or(message.volume), outputFromWorld);
  return message;
}

void RecentPositions::add(const TrackSnapshot& snapshot) {
  if (snapshot.frame <= frame_ || snapshot.seed != seed_) {
    trails_.clear();
  }
  frame_ = snapshot.frame;
  seed_ = snapshot.seed;
  for (const TargetSnapshot& target : snapshot.targets) {
    Trail& trail = trails_[target.target.name];
    trail.samples.push_back(sampleOfTarget(snapshot, target));
    if (trail.samples.size() > kPositionsPerVelocity) {
      trail.samples.erase(trail.samples.begin());
    }
    const auto before = std::exchange(trail.velocity, velocityOf(target.estimate));
    if (!trail.velocity) {
      const std::size_t last = trail.samples.size() - 1;
      trail.velocity =
          trajectory::velocityAt(renumbered(trail.samples), last, kPositionsPerVelocity - 1);
    }
    const std::size_t count = trail.samples.size();
    const double step =
        count < 2 ? 0.0 : trail.samples[count - 1].time - trail.samples[count - 2].time;
    const bool isKnown = before && trail.velocity && step > 0.0;
    trail.acceleration = isKnown ? Eigen::Vector3d((*trail.velocity - *before) / step)
                                 : Eigen::Vector3d(Eigen::Vector3d::Zero());
  }
}

std::optional<Eigen::Vector3d> RecentPositions::velocity(const std::string& target) const {
  const auto found = trails_.find(target);
  return found == trails_.end() ? std::nullopt : found->second.velocity;
}

Eigen::Vector3d RecentPositions::acceleration(const std::string& target) const {
  const auto found = trails_.find(target);
  return found == trails_.end() ? Eigen::Vector3d::Zero() : found->second.acceleration;
}

FrameMessage frameMessageOf(const TrackSnapshot& snapshot, const RecentPositions& recent,
                            const RigMessagePtr& rig) {
  FrameMessage message;
  message.frame = snapshot.frame;
  message.time = seconds(snapshot.frames->time);
  message.rig = rig;
  const Eigen::Matrix3d outputFromWorld = rig->coordinates.outputFromWorld();
  for (std::size_t k = 0; k < snapshot.targets.size(); ++k) {
    const TargetSnapshot& target = snapshot.targets[k];
    if (isAbsent(target.estimate)) {
      continue; // a person who has left
    }
    TargetMessage& sent = message.targets.emplace_back();
    sent.id = identityOf(target.estimate, k);
    sent.name = target.target.name;
    sent.state = stateWord(session::trackingState(target));
    sent.existenceProbability = existenceProbabilityOf(target.estimate);
    const auto position = positionOf(target.estimate);
    if (!position || !position->mean.allFinite() || !isConfirmed(target.estimate)) {
      continue;
    }
    sent.position = outputFromWorld * position->mean;
    sent.covariance = outputFromWorld * position->covariance * outputFromWorld.transpose();
    if (const auto velocity = recent.velocity(sent.name)) {
      sent.velocity = outputFromWorld * *velocity;
      sent.acceleration = outputFromWorld * recent.acceleration(sent.name);
    }
    sent.seeingCameras = camerasSeeing(snapshot, target);
  }
  return message;
}

} // namespace dewpoint::broadcast
