// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/independent_trackers.h"

#include "core/base/random.h"

#include <algorithm>
#include <utility>

namespace dewpoint::tracking {

IndependentTrackers::IndependentTrackers(std::vector<std::unique_ptr<Tracker>> trackers)
    : trackers_(std::move(trackers)), estimates_(trackers_.size()) {}

void IndependentTrackers::configure(const ParameterValues& parameters) {
  for (auto& tracker : trackers_) {
    tracker->configure(parameters);
  }
}

void IndependentTrackers::setTargets(const std::vector<Target>& targets) {
  const std::size_t count = std::min(targets.size(), trackers_.size());
  for (std::size_t k = 0; k < count; ++k) {
    trackers_[k]->setTarget(targets[k]);
  }
}

void IndependentTrackers::setCameras(const CameraRig& rig) {
  for (auto& tracker : trackers_) {
    tracker->setCameras(rig);
  }
}

void IndependentTrackers::restart(std::uint64_t seed) {
  for (std::size_t k = 0; k < trackers_.size(); ++k) {
    trackers_[k]->restart(derivedSeed(seed, static_cast<std::uint32_t>(k)));
  }
  estimates_.assign(trackers_.size(), TargetEstimate{});
}

int IndependentTrackers::iterationsPerFrame() const {
  return trackers_.empty() ? 0 : trackers_.front()->iterationsPerFrame();
}

void IndependentTrackers::beginFrame(FrameSetPtr frames) {
  for (auto& tracker : trackers_) {
    tracker->beginFrame(frames);
  }
}

void IndependentTrackers::iterate(ThreadTeam& team) {
  for (std::size_t k = 0; k < trackers_.size(); ++k) {
    estimates_[k] = trackers_[k]->iterate(team);
  }
}

void IndependentTrackers::particles(std::size_t target, int limit, Eigen::ArrayXXd& positions,
                                    Eigen::ArrayXd& weights) const {
  trackers_.at(target)->particles(limit, positions, weights);
}

std::unique_ptr<MultiTracker> IndependentTrackers::clone() const {
  std::vector<std::unique_ptr<Tracker>> copies;
  for (const auto& tracker : trackers_) {
    copies.push_back(tracker->clone());
  }
  auto copy = std::make_unique<IndependentTrackers>(std::move(copies));
  copy->estimates_ = estimates_;
  return copy;
}

std::size_t IndependentTrackers::memoryBytes() const {
  std::size_t bytes = 0;
  for (const auto& tracker : trackers_) {
    bytes += tracker->memoryBytes();
  }
  return bytes;
}

std::vector<CameraReport> IndependentTrackers::explain(std::size_t target) const {
  return trackers_.at(target)->explain();
}

std::vector<LikelihoodMap> IndependentTrackers::likelihoodMaps(std::size_t target,
                                                               int reach) const {
  return trackers_.at(target)->likelihoodMaps(reach);
}

} // namespace dewpoint::tracking
