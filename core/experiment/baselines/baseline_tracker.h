// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_classifier.h"
#include "core/experiment/baselines/baseline_blobs.h"
#include "core/experiment/baselines/baseline_kalman.h"
#include "core/tracking/tracker_capabilities.h"

#include <memory>
#include <optional>
#include <vector>

namespace dewpoint::experiment {

/// What turns the masks of one frame into at most one bearing per camera, for a target that is the
/// only one of its color.
class BearingFinder {
public:
  virtual ~BearingFinder() = default;
  /// Forgets what it remembers of earlier frames.
  virtual void forget() = 0;
  /// Masks as from matchImage(), one per camera, empty where there is no image.
  virtual std::vector<std::optional<Eigen::Vector2d>> find(const std::vector<cv::Mat>& masks) = 0;
};

/// The center of the largest blob of each camera.
class LargestBlobFinder final : public BearingFinder {
public:
  void forget() override {}
  std::vector<std::optional<Eigen::Vector2d>> find(const std::vector<cv::Mat>& masks) override;
};

/// Makes a finder for one target.
using BearingFinderFactory = std::unique_ptr<BearingFinder> (*)();

struct BaselineSetup {
  BearingFinderFactory finder = nullptr;
  bool kalman = false;     ///< a Kalman filter behind the triangulation
  bool manyBlobs = true;   ///< several targets of one color share the blobs; else each has a finder
  double residualPx = 4.0; ///< several targets: how far from a ray a position may be
};

/// The baselines: color mask, a position in each camera's image, least-squares intersection of the
/// rays, no particles and no appearance but the mask. A target is valid when two cameras see it (or
/// while its Kalman filter predicts); it knows no probability, so `existenceProbability` is 0 or 1.
///
/// Targets of one color: the positions that blobs of two or more cameras agree on are given to the
/// targets so that the sum of the distances to where they were last is least. Deterministic: seed
/// and parameters mean nothing to it.
class BaselineTracker final : public Tracker,
                              public TargetFollowing,
                              public CameraCalibrated,
                              public ParticleCloud {
public:
  BaselineTracker(const BaselineSetup& setup, const CameraRig& rig, std::vector<Target> targets);

  void configure(const ParameterValues&) override {}
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
    std::unique_ptr<BearingFinder> finder;
    KalmanPoint filter;
    std::optional<Eigen::Vector3d> last; ///< where it was seen last
  };
  using Measured = std::vector<std::optional<TriangulatedPoint>>;

  std::vector<cv::Mat> masksOf(const ColorRange& color) const;
  std::optional<Bearing> bearingOf(std::size_t camera, std::size_t blob,
                                   const Eigen::Vector2d& pixel) const;
  std::optional<TriangulatedPoint> findOne(Tracked& tracked,
                                           const std::vector<cv::Mat>& masks) const;
  void findMany(const std::vector<std::size_t>& members, const std::vector<cv::Mat>& masks,
                Measured& measured) const;
  void predict();
  void conclude(std::size_t target, const std::optional<TriangulatedPoint>& position);

  BaselineSetup setup_;
  std::vector<Unprojector> cameras_;
  std::vector<double> focalLengths_;
  std::vector<Target> targets_;
  std::vector<Tracked> tracked_;
  FrameSetPtr frames_;
  std::optional<TimeStamp> time_;
  std::vector<SphereEstimate> estimates_;
};

} // namespace dewpoint::experiment
