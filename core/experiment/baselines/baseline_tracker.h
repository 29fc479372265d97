// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/baselines/baseline_kalman.h"
#include "core/experiment/baselines/blob_pairing.h"
#include "core/experiment/baselines/camera_followers.h"
#include "core/tracking/start_parameters.h"
#include "core/tracking/tracker_capabilities.h"

#include <optional>
#include <vector>

namespace dewpoint::experiment {

/// Options that select one of the baseline methods.
struct BaselineSetup {
  /// Creates a follower, which follows one target through the images of one camera. If null, there
  /// are no followers, and blobs are paired again in every frame.
  CameraFollowerFactory followerFactory = nullptr;
  /// True if a Kalman filter smooths the triangulated positions. A pair of blobs whose position is
  /// outside the gate of the filter is then used only if no other pair has a position inside the
  /// gate.
  bool usesKalmanFilter = false;
};

/// Tracker of the baseline methods. It locates each target in each camera's image by a color mask,
/// and computes the point nearest to the rays by least squares. It uses no particles, and no
/// appearance except the mask. The estimate of a target is valid while at least two cameras see the
/// target. With a Kalman filter, it is also valid while the filter predicts the position. The
/// tracker computes no probability, so `existenceProbability` is 0 or 1.
///
/// At the start, the tracker knows the same as the other methods: colors, sizes, calibration and
/// start volume. It pairs blobs of different cameras (blob_pairing.h). Each target is assigned the
/// pair that looks most like it and is nearest to its expected position. At first, the expected
/// position is the center of the start volume. Later, it is the last position or the Kalman
/// filter's prediction. Targets with the same color and size share the blobs.
///
/// If BaselineSetup::followerFactory is set, pairs of blobs are used only to start the followers. A
/// follower starts with the bounding box of its camera's blob. All followers of a target restart
/// when fewer than two are left, or when their rays miss each other by more than the pairing
/// allows. If a camera has no follower, a new one starts at the blob that best fits the position
/// computed from the other cameras. The tracker is deterministic; seed and parameters have no
/// effect.
class BaselineTracker final : public Tracker,
                              public TargetTracking,
                              public FixedTargetCount,
                              public RigConfigurable,
                              public ParticleCloud {
public:
  /// Creates a tracker. `start` is the volume in which it first searches for targets.
  BaselineTracker(const BaselineSetup& setup, const CameraRig& rig, std::vector<Target> targets,
                  const StartVolume& start);

  void setTargets(const std::vector<Target>& targets) override;
  std::size_t targetCount() const override { return targets_.size(); }
  void setCameras(const CameraRig& rig) override;
  void restart(std::uint64_t seed) override;
  int iterationsPerFrame() const override { return 1; }
  void beginFrame(FrameSetPtr frames) override { frames_ = std::move(frames); }
  void iterate(ThreadTeam& team) override;
  std::size_t trackCount() const override { return estimates_.size(); }
  TrackEstimate estimate(std::size_t track) const override { return estimates_.at(track); }
  void copyParticles(std::size_t target, int limit, Eigen::ArrayXXd& positions,
                     Eigen::ArrayXd& weights) const override;

private:
  struct Tracked {
    CameraFollowers followers;
    PositionKalmanFilter filter;
    std::optional<Eigen::Vector3d> lastPosition; ///< last or predicted position, world, meters
    double secondsSinceSeen = 0.0;               ///< seconds since the target was last seen
  };
  /// Images and blobs of one color in all cameras, in rig order.
  struct ImagesAndBlobs {
    std::vector<CameraImages> images;
    std::vector<CameraBlobs> blobs;
  };
  using TargetIndices = std::vector<std::size_t>; ///< indices of targets
  using MeasuredPositions = std::vector<std::optional<TriangulatedPoint>>;

  void predict();
  std::vector<TargetIndices> groups() const;
  ImagesAndBlobs viewsOf(const ColorRanges& color) const;
  void measure(const TargetIndices& members, MeasuredPositions& measured);
  TargetIndices follow(const TargetIndices& members, const ImagesAndBlobs& views,
                       MeasuredPositions& measured);
  std::optional<TriangulatedPoint> triangulateFollowers(Tracked& tracked,
                                                        const ImagesAndBlobs& views) const;
  void startMissingFollowers(std::size_t target, const ImagesAndBlobs& views,
                             const Eigen::Vector3d& position);
  void assignBlobs(const TargetIndices& members, const ImagesAndBlobs& views,
                   const std::vector<PairedBlobs>& pairs, MeasuredPositions& measured);
  ExpectedPosition expectedPositionOf(const Tracked& tracked) const;
  void updateEstimate(std::size_t target, const std::optional<TriangulatedPoint>& position);

  BaselineSetup setup_;
  BlobPairing pairing_;
  std::size_t cameraCount_ = 0;
  std::vector<Target> targets_;
  StartVolume start_;
  std::vector<Tracked> tracked_;
  FrameSetPtr frames_;
  std::optional<TimeStamp> time_;
  std::vector<SphereEstimate> estimates_;
};

} // namespace dewpoint::experiment
