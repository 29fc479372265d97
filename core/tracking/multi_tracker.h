// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/boxes/box_tracker.h"
#include "core/tracking/tracker.h"

#include <opencv2/core/mat.hpp>

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace dewpoint::tracking {

class PeopleTargets;

/// One method tracking all targets of a run together, so that targets of one color can be told
/// apart. `beginFrame` once per frame set, then `iterate` any number of times. Not thread safe;
/// the same seed gives the same bits for any size of the ThreadTeam.
class MultiTracker {
public:
  virtual ~MultiTracker() = default;
  virtual void configure(const ParameterValues& parameters) = 0;
  /// New colors and sizes for the same targets, in the same order and number.
  virtual void setTargets(const std::vector<Target>& targets) = 0;
  /// Whether setTargets() takes another number of targets, too.
  virtual bool takesAnyNumber() const { return false; }
  /// Another calibration of the same cameras, from the next iteration on; beliefs stay.
  virtual void setCameras(const CameraRig& rig) = 0;
  /// What the cameras show when no target is there, in the order of the rig (CV_8UC3; empty where
  /// it is not known); from the next restart on. Methods that know no background ignore it.
  virtual void setEmptyRooms(const std::vector<cv::Mat>& /*rooms*/) {}
  /// Forgets everything but the empty rooms and starts anew.
  virtual void restart(std::uint64_t seed) = 0;
  virtual int iterationsPerFrame() const = 0;
  virtual void beginFrame(FrameSetPtr frames) = 0;
  virtual void iterate(ThreadTeam& team) = 0;
  /// What is believed now, one per target; before the first iteration they are all not valid.
  virtual const std::vector<TargetEstimate>& estimates() const = 0;
  /// As Tracker::particles, of one target.
  virtual void particles(std::size_t target, int limit, Eigen::ArrayXXd& positions,
                         Eigen::ArrayXd& weights) const = 0;
  /// What a method of family Boxes believes of a target, with at most `particleLimit` particles;
  /// nothing before the target's box, and with other methods.
  virtual std::optional<BoxBelief> box(std::size_t /*target*/, int /*particleLimit*/) const {
    return std::nullopt;
  }
  /// A copy that goes on from here with the same bits, and shares nothing that either writes; null
  /// when the method cannot be copied.
  virtual std::unique_ptr<MultiTracker> clone() const { return nullptr; }
  virtual bool canBeCopied() const { return true; }
  /// About how many bytes a copy takes.
  virtual std::size_t memoryBytes() const { return 0; }
  /// What each camera has to say on a target being held or not, after the iterations of a frame;
  /// empty when the method cannot tell.
  virtual std::vector<CameraReport> explain(std::size_t) const { return {}; }
  /// Places that were considered at the last iteration; empty when the method considers none.
  virtual std::vector<ProposedPosition> proposals(std::size_t) const { return {}; }
  /// Around the estimate of a target, up to `reach` pixels in each direction; one per camera, or
  /// none when the method cannot tell.
  virtual std::vector<LikelihoodMap> likelihoodMaps(std::size_t, int /*reach*/) const { return {}; }
  /// The people whom the method finds by itself, in place of the project's targets; null for all
  /// methods that are not for people.
  virtual PeopleTargets* people() { return nullptr; }
  virtual const PeopleTargets* people() const { return nullptr; }
};

/// A tracker of the named method for these targets; NotFound for an unknown method, MissingKey when
/// `parameters` are not the method's.
Result<std::unique_ptr<MultiTracker>> makeMultiTracker(const std::string& method,
                                                       const ParameterValues& parameters,
                                                       const CameraRig& rig,
                                                       const std::vector<Target>& targets);

} // namespace dewpoint::tracking
