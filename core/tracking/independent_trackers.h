// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/random.h"
#include "core/tracking/tracker_capabilities.h"

#include <algorithm>
#include <concepts>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace dewpoint::tracking {

/// Filter for one target, independent of all other targets. A copy continues with bit-identical
/// results.
template <class F>
concept TargetFilter = std::copy_constructible<F> &&
    std::constructible_from<F, ParameterValues, CameraRig, Target> &&
    requires(F filter, const F& finished, const ParameterValues& parameters, const Target& target,
             const CameraRig& rig, const std::optional<WorldBox>& volume, std::uint64_t seed,
             FrameSetPtr frames, ThreadTeam& team, Eigen::ArrayXXd& positions,
             Eigen::ArrayXd& weights, const Gaussian3& position) {
  filter.configure(parameters);
  filter.setTarget(target);
  filter.setCameras(rig);
  filter.setVolumeOfInterest(volume);
  filter.restart(seed);
  filter.beginFrame(frames);
  { filter.iterate(team) } -> std::same_as<SphereEstimate>;
  { filter.correct(position) } -> std::same_as<SphereEstimate>;
  { finished.iterationsPerFrame() } -> std::same_as<int>;
  finished.copyParticles(0, positions, weights);
  { finished.cameraReports() } -> std::same_as<std::vector<CameraReport>>;
  { finished.memoryBytes() } -> std::same_as<std::size_t>;
};

/// TargetFilter that also provides likelihood maps.
template <class F>
concept MappingFilter = TargetFilter<F> && requires(const F& finished) {
  { finished.likelihoodMaps(0) } -> std::same_as<std::vector<LikelihoodMap>>;
};

/// Tracker with one independent filter per target. The filter of target k is started with
/// derivedSeed(seed, k).
template <TargetFilter F>
class IndependentTrackers : public Tracker,
                            public Configurable,
                            public TargetTracking,
                            public FixedTargetCount,
                            public RigConfigurable,
                            public VolumeBounded,
                            public PositionCorrecting,
                            public ParticleCloud,
                            public CameraReporting,
                            public Copyable {
public:
  IndependentTrackers(const ParameterValues& parameters, const CameraRig& rig,
                      const std::vector<Target>& targets)
      : estimates_(targets.size()) {
    filters_.reserve(targets.size());
    for (const Target& target : targets) {
      filters_.emplace_back(parameters, rig, target);
    }
  }

  void configure(const ParameterValues& parameters) override {
    for (F& filter : filters_) {
      filter.configure(parameters);
    }
  }
  void setTargets(const std::vector<Target>& targets) override {
    const std::size_t count = std::min(targets.size(), filters_.size());
    for (std::size_t k = 0; k < count; ++k) {
      filters_[k].setTarget(targets[k]);
    }
  }
  std::size_t targetCount() const override { return filters_.size(); }
  void setCameras(const CameraRig& rig) override {
    for (F& filter : filters_) {
      filter.setCameras(rig);
    }
  }
  void setVolumeOfInterest(const std::optional<WorldBox>& volume) override {
    for (F& filter : filters_) {
      filter.setVolumeOfInterest(volume);
    }
  }
  void restart(std::uint64_t seed) override {
    for (std::size_t k = 0; k < filters_.size(); ++k) {
      filters_[k].restart(derivedSeed(seed, static_cast<std::uint32_t>(k)));
    }
    estimates_.assign(filters_.size(), SphereEstimate{});
  }
  int iterationsPerFrame() const override {
    return filters_.empty() ? 0 : filters_.front().iterationsPerFrame();
  }
  void beginFrame(FrameSetPtr frames) override {
    for (F& filter : filters_) {
      filter.beginFrame(frames);
    }
  }
  void iterate(ThreadTeam& team) override {
    for (std::size_t k = 0; k < filters_.size(); ++k) {
      estimates_[k] = filters_[k].iterate(team);
    }
  }
  void correctPosition(std::size_t target, const Gaussian3& position,
                       ThreadTeam& /*team*/) override {
    estimates_.at(target) = filters_.at(target).correct(position);
  }
  std::size_t trackCount() const override { return estimates_.size(); }
  TrackEstimate estimate(std::size_t track) const override { return estimates_.at(track); }
  void copyParticles(std::size_t track, int limit, Eigen::ArrayXXd& positions,
                     Eigen::ArrayXd& weights) const override {
    filters_.at(track).copyParticles(limit, positions, weights);
  }
  std::vector<CameraReport> cameraReports(std::size_t track) const override {
    return filters_.at(track).cameraReports();
  }
  bool canBeCopied() const override { return true; }
  std::unique_ptr<Tracker> clone() const override {
    return std::make_unique<IndependentTrackers>(*this);
  }
  std::size_t memoryBytes() const override {
    std::size_t bytes = 0;
    for (const F& filter : filters_) {
      bytes += filter.memoryBytes();
    }
    return bytes;
  }

protected:
  const F& filter(std::size_t track) const { return filters_.at(track); }

private:
  std::vector<F> filters_;
  std::vector<SphereEstimate> estimates_;
};

/// IndependentTrackers for filters that also provide likelihood maps.
template <MappingFilter F>
class IndependentMappingTrackers final : public IndependentTrackers<F>, public LikelihoodMapping {
public:
  using IndependentTrackers<F>::IndependentTrackers;

  std::vector<LikelihoodMap> likelihoodMaps(std::size_t track, int reach) const override {
    return this->filter(track).likelihoodMaps(reach);
  }
  std::unique_ptr<Tracker> clone() const override {
    return std::make_unique<IndependentMappingTrackers>(*this);
  }
};

/// Creates a tracker with one filter per target, for an entry in the catalog of methods.
template <TargetFilter F>
std::unique_ptr<Tracker> makeIndependentTrackers(const ParameterValues& parameters,
                                                 const CameraRig& rig,
                                                 const std::vector<Target>& targets) {
  if constexpr (MappingFilter<F>) {
    return std::make_unique<IndependentMappingTrackers<F>>(parameters, rig, targets);
  } else {
    return std::make_unique<IndependentTrackers<F>>(parameters, rig, targets);
  }
}

} // namespace dewpoint::tracking
