// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/observation/region/region_observation.h"
#include "core/tracking/dewpoint/frame_images.h"
#include "core/tracking/dewpoint/track/region_track.h"
#include "core/tracking/dewpoint/track/shape_belief.h"

#include <cstdint>
#include <vector>

namespace dewpoint::tracking {

/// Shape of a target: the belief about whether it is a ball, and a track of it as an object of any
/// shape, which is used while it is believed not to be a ball.
class ShapeTracking {
public:
  ShapeTracking(const Target& target, const CameraRig& rig)
      : belief_(target), track_(target), observation_(rig) {}
  /// A copy has no images; they must be passed to it again.
  ShapeTracking(const ShapeTracking& other, const CameraRig& rig)
      : belief_(other.belief_), track_(other.track_), observation_(rig),
        sinceLearned_(other.sinceLearned_), frames_(other.frames_) {}

  void setCameras(const CameraRig& rig) { observation_ = RegionObservation(rig); }
  void setTarget(const Target& target);
  void restart(const StartVolume& start);
  void predict(double interval, const RandomKey& key);

  const ShapeBelief& belief() const { return belief_; }
  RegionTrack& track() { return track_; }
  const RegionTrack& track() const { return track_; }
  RegionObservation& observation() { return observation_; }
  const RegionObservation& observation() const { return observation_; }

  /// Returns whether the images of this frame are needed while the target is assumed to be a ball;
  /// `ballFound` states whether the ball was found.
  bool wantsImages(bool ballFound) const;
  /// Learns about the shape from what lies where a ball was found. Where it turns out to be none,
  /// the track begins there.
  void measureBall(const TrackHypothesis& ball, const RandomKey& key, ThreadTeam& team);
  /// Updates the track by the images, and learns from it about the shape.
  void update(const std::vector<OccupiedSphere>& occupied, const RandomKey& key, ThreadTeam& team);
  /// Sets the position of the target as given by the user; `radius` in meters is used if its extent
  /// is unknown.
  void correct(const Gaussian3& position, double radius, const RandomKey& key, ThreadTeam& team);

private:
  void learn(const std::vector<RegionMeasurement>& views, const Eigen::Vector3d& position,
             double radius);

  ShapeBelief belief_;
  RegionTrack track_;
  RegionObservation observation_;
  double sinceLearned_ = 0.0; ///< seconds
  std::int64_t frames_ = 0;   ///< since the restart
};

} // namespace dewpoint::tracking
