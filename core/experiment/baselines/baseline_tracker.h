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

struct BaselineSetup {
  /// Follows each target in each camera; null: the blobs are paired again in every frame.
  CameraFollowerFactory follower = nullptr;
  bool kalman = false; ///< a Kalman filter behind the triangulation, whose gate the pairing uses
};

/// The baselines: color mask, a position in each camera's image, least-squares intersection of the
/// rays, no particles and no appearance but the mask. A target is valid when two cameras see it (or
/// while its Kalman filter predicts); it knows no probability, so `existenceProbability` is 0 or 1.
///
/// They know what the methods know at the start: colors, sizes, calibration and the start volume.
/// Blobs of different cameras are paired (blob_pairing.h), and of the pairs each target takes the
/// one that looks most like it and is nearest to where it is expected: in the start volume at
/// first, then where it was last, or where its Kalman filter predicts it. Targets of one color and
/// size share the blobs.
///
/// With followers, the pairing only starts them: a follower begins with the box of its camera's
/// blob, and all of a target's begin again when fewer than two are left, or when their rays miss
/// each other by more than the pairing allows. A camera without a follower gets one at the blob
/// that fits the position of the others. Deterministic: seed and parameters mean nothing to it.
class BaselineTracker final : public Tracker,
                              public TargetFollowing,
                              public CameraCalibrated,
                              public ParticleCloud {
public:
  /// `start` is where the targets are first searched for.
  BaselineTracker(const BaselineSetup& setup, const CameraRig& rig, std::vector<Target> targets,
                  const StartVolume& start);

  void setTargets(const std::vector<Target>& targets) override;
  bool takesAnyNumber() const override { return false; }
  void setCameras(const CameraRig& rig) override;
  void restart(std::uint64_t seed) override;
  int iterationsPerFrame() const override { return 1; }
  void beginFrame(FrameSetPtr frames) override { frames_ = std::move(frames); }
  void iterate(ThreadTeam& team) override;
  std::size_t trackCount() const override { return estimates_.size(); }
  TrackEstimate estimate(std::size_t track) const override { return estimates_.at(track); }
  void particles(std::size_t target, int limit, Eigen::ArrayXXd& positions,
                 Eigen::ArrayXd& weights) const override;

private:
  struct Tracked {
    CameraFollowers followers;
    KalmanPoint filter;
    std::optional<Eigen::Vector3d> last; ///< where it was seen last, or is predicted
    double sinceSeen = 0.0;              ///< seconds
  };
  /// What the cameras show of one color, in the order of the rig.
  struct Views {
    std::vector<CameraImages> images;
    std::vector<CameraBlobs> blobs;
  };
  using Members = std::vector<std::size_t>; ///< indices of targets
  using Measured = std::vector<std::optional<TriangulatedPoint>>;

  void predict();
  std::vector<Members> groups() const;
  Views viewsOf(const ColorRanges& color) const;
  void measure(const Members& members, Measured& measured);
  Members follow(const Members& members, const Views& views, Measured& measured);
  std::optional<TriangulatedPoint> followed(Tracked& tracked, const Views& views) const;
  void joinCameras(std::size_t target, const Views& views, const Eigen::Vector3d& position);
  void find(const Members& members, const Views& views, const std::vector<PairedBlobs>& pairs,
            Measured& measured);
  ExpectedPosition expectedOf(const Tracked& tracked) const;
  void conclude(std::size_t target, const std::optional<TriangulatedPoint>& position);

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
