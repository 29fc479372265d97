// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/tracker_capabilities.h"

#include <memory>
#include <span>
#include <vector>

namespace dewpoint::tracking {

/// Method `parked`: believes that every target is where the parameters say, whatever the images
/// show.
class ParkedTracker final : public Tracker, public Configurable, public TargetTracking {
public:
  /// Of parkedParameters() (asserted).
  ParkedTracker(const ParameterValues& parameters, const std::vector<Target>& targets);

  void configure(const ParameterValues& parameters) override { parameters_ = parameters; }
  void restart(std::uint64_t seed) override;
  int iterationsPerFrame() const override { return 1; }
  void beginFrame(FrameSetPtr frames) override;
  void iterate(ThreadTeam& team) override;
  std::size_t trackCount() const override { return estimates_.size(); }
  TrackEstimate estimate(std::size_t track) const override { return estimates_.at(track); }
  void setTargets(const std::vector<Target>& targets) override;

private:
  ParameterValues parameters_;
  FrameSetPtr frames_;
  std::vector<SphereEstimate> estimates_;
};

std::span<const ParameterDeclaration> parkedParameters();

/// For the row of the catalog.
std::unique_ptr<Tracker> makeParked(const ParameterValues& parameters, const CameraRig& rig,
                                    const std::vector<Target>& targets);

} // namespace dewpoint::tracking
