// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/frame.h"
#include "core/geometry/camera.h"
#include "core/geometry/ray.h"
#include "core/geometry/sphere_image.h"
#include "core/tracking/target.h"
#include "core/tracking/track_estimate.h"

#include <deque>
#include <optional>
#include <vector>

namespace dewpoint::camera_motion {

/// A target as one camera sees it, and where the other cameras say it is.
struct ReprojectionResidual {
  double time = 0.0;                                  ///< seconds
  Eigen::Vector3d world = Eigen::Vector3d::Zero();    ///< by the other cameras alone; meters
  Eigen::Vector2d pixel = Eigen::Vector2d::Zero();    ///< of its center
  Eigen::Vector2d residual = Eigen::Vector2d::Zero(); ///< pixel minus that of `world`, pixels
  double othersOff = 0.0; ///< how far the others disagree on `world` among themselves, pixels
};

/// Center of the pixels of the target's color around its expected position (CV_8UC3, pixels);
/// nothing when their number is not about that of its outline, or when they reach the edge of the
/// searched region: the target is hidden in part, or another object has its color.
std::optional<Eigen::Vector2d> colorCentroid(const cv::Mat& image, const ColorRanges& color,
                                             const SphereImage& expected);

/// Collects, camera by camera, how tracked targets disagree with what the other cameras see. One
/// camera that was moved has a residual that its sightings share; and the others, without it,
/// agree among themselves as before, while those of any other camera do not.
class ReprojectionResiduals {
public:
  static constexpr std::size_t kMost = 300; ///< of each camera, the newest
  explicit ReprojectionResiduals(const CameraRig& rig);

  /// After the iterations of a frame. A target that is not held, or has no radius, is passed over;
  /// a position needs three cameras, or two where the rig has only two: then each is compared with
  /// the estimate as it is.
  void add(const FrameSet& frames, const std::vector<Target>& targets,
           const std::vector<SphereEstimate>& estimates);
  const std::deque<ReprojectionResidual>& of(std::size_t camera) const {
    return sightings_[camera];
  }
  /// Medians over the sightings since a time (seconds), if they are at least `fewest`.
  struct Summary {
    Eigen::Vector2d residual = Eigen::Vector2d::Zero(); ///< component by component, pixels
    double othersOff = 0.0;                             ///< pixels
  };
  std::optional<Summary> summary(std::size_t camera, double since, std::size_t fewest) const;
  void restart();

private:
  void addTarget(const FrameSet& frames, const Target& target, const SphereEstimate& estimate);

  std::vector<SphereProjector> projectors_;
  std::vector<Unprojector> unprojectors_;
  std::vector<std::deque<ReprojectionResidual>> sightings_;
};

} // namespace dewpoint::camera_motion
