// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/observation/region/region_observation.h"
#include "core/tracking/dewpoint/frame_images.h"
#include "core/tracking/dewpoint/track/region_track.h"
#include "core/tracking/dewpoint/track/shape_belief.h"

#include <cstdint>
#include <vector>

namespace dewpoint::tracking {

/// Shape of a target: the belief about whether it is a ball, and a track that treats it as an
/// object of any shape. This track is used while the target is believed not to be a ball.
class ShapeTracking {
public:
  ShapeTracking(const Target& target, const CameraRig& rig)
      : belief_(target), track_(target), observation_(rig) {}
  /// Creates a copy without images. Images must be passed to the copy again.
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

  /// Returns whether the shape must be measured in the images of this frame although the target is
  /// assumed to be a ball. `ballFound` is true if the ball was found in this frame.
  bool needsImages(bool ballFound) const;
  /// Learns about the shape of the object at the position where a ball was found. If the object
  /// turns out not to be a ball, the track begins at this position.
  void measureBall(const TrackHypothesis& ball, const RandomKey& key, ThreadTeam& team);
  /// Updates the track with the images of the frame, and learns about the shape from the result.
  /// `occupied`: space that other targets occupy.
  void update(const std::vector<OccupiedSphere>& occupied, const RandomKey& key, ThreadTeam& team);
  /// Sets the position of the target to a position given by the user. `radius` (meters) is used if
  /// the extent of the target is unknown.
  void correct(const Gaussian3& position, double radius, const RandomKey& key, ThreadTeam& team);

private:
  void learn(const std::vector<RegionMeasurement>& views, const Eigen::Vector3d& position,
             double radius);

  ShapeBelief belief_;
  RegionTrack track_;
  RegionObservation observation_;
  double sinceLearned_ = 0.0; ///< seconds
  std::int64_t frames_ = 0;   ///< number of frames since the restart
};

} // namespace dewpoint::tracking
