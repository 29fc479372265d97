// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/added_method/parked_tracker.h"

#include <utility>

namespace dewpoint::tracking {

ParkedTracker::ParkedTracker(const ParameterValues& parameters, const std::vector<Target>& targets)
    : parameters_(parameters), estimates_(targets.size()) {}

void ParkedTracker::restart(std::uint64_t /*seed*/) {
  estimates_.assign(estimates_.size(), SphereEstimate{});
}

void ParkedTracker::beginFrame(FrameSetPtr frames) {
  frames_ = std::move(frames);
}

void ParkedTracker::iterate(ThreadTeam& /*team*/) {
  for (SphereEstimate& estimate : estimates_) {
    estimate.mean = {parameters_.at("parked_x"), parameters_.at("parked_y"), 0.0};
    estimate.best = estimate.mean;
    estimate.particleCount = 1;
    estimate.effectiveSampleSize = 1.0;
    estimate.isValid = frames_ != nullptr;
    estimate.existenceProbability = 1.0;
  }
}

void ParkedTracker::setTargets(const std::vector<Target>& targets) {
  estimates_.resize(targets.size());
}

std::span<const ParameterDeclaration> parkedParameters() {
  static const std::vector<ParameterDeclaration> kDeclarations{
      {"parked_x", ParameterKind::Real, "Parked x", "m", -10.0, 10.0, 0.01, 0.25,
       "Where the targets are, along x."},
      {"parked_y", ParameterKind::Real, "Parked y", "m", -10.0, 10.0, 0.01, 0.5,
       "Where the targets are, along y."}};
  return kDeclarations;
}

std::unique_ptr<Tracker> makeParked(const ParameterValues& parameters, const CameraRig& /*rig*/,
                                    const std::vector<Target>& targets) {
  return std::make_unique<ParkedTracker>(parameters, targets);
}

} // namespace dewpoint::tracking
