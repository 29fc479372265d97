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

/// A target as one camera sees it, compared with its position from the other cameras.
struct ReprojectionResidual {
  double time = 0.0; ///< seconds
  Eigen::Vector3d world =
      Eigen::Vector3d::Zero(); ///< position from the other cameras alone; meters
  Eigen::Vector2d pixel = Eigen::Vector2d::Zero(); ///< center of the target in the image
  Eigen::Vector2d residual =
      Eigen::Vector2d::Zero(); ///< `pixel` minus the projection of `world`, pixels
  double othersOff =
      0.0; ///< disagreement of the other cameras about `world` among themselves, pixels
};

/// Centroid (pixels) of the pixels in the target's color around its expected position in an image
/// (CV_8UC3). Nothing if their number differs too much from the area of the target's outline, or if
/// they reach the edge of the searched region: then the target is partly hidden, or another object
/// has its color.
std::optional<Eigen::Vector2d> colorCentroid(const cv::Mat& image, const ColorRanges& color,
                                             const SphereImage& expected);

/// Collects, for each camera, the disagreement between tracked targets and the other cameras. A
/// camera that was moved has a residual that its sightings share; without it, the other cameras
/// agree among themselves as before. For any camera that was not moved, the others do not agree.
class ReprojectionResiduals {
public:
  static constexpr std::size_t kMost = 300; ///< maximum number for each camera; the newest are kept
  explicit ReprojectionResiduals(const CameraRig& rig);

  /// Adds the targets after the iterations of a frame. A target that is not held, or has no radius,
  /// is ignored. A position needs three cameras; in a rig of only two, two are enough, and each is
  /// compared with the estimate itself.
  void add(const FrameSet& frames, const std::vector<Target>& targets,
           const std::vector<SphereEstimate>& estimates);
  /// Sightings of a camera, oldest first.
  const std::deque<ReprojectionResidual>& of(std::size_t camera) const {
    return sightings_[camera];
  }
  /// Componentwise medians over sightings of a camera.
  struct Summary {
    Eigen::Vector2d residual = Eigen::Vector2d::Zero(); ///< component by component, pixels
    double othersOff = 0.0;                             ///< pixels
  };
  /// Summary of the sightings of a camera since a time (seconds); nothing if there are fewer than
  /// `fewest`.
  std::optional<Summary> summary(std::size_t camera, double since, std::size_t fewest) const;
  void restart();

private:
  void addTarget(const FrameSet& frames, const Target& target, const SphereEstimate& estimate);

  std::vector<SphereProjector> projectors_;
  std::vector<Unprojector> unprojectors_;
  std::vector<std::deque<ReprojectionResidual>> sightings_;
};

} // namespace dewpoint::camera_motion
