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

/// Target as seen by one camera, compared with its position from the other cameras.
struct ReprojectionResidual {
  double time = 0.0; ///< seconds
  Eigen::Vector3d world =
      Eigen::Vector3d::Zero(); ///< position derived from the other cameras alone; meters
  Eigen::Vector2d pixel = Eigen::Vector2d::Zero(); ///< center of the target in the image
  Eigen::Vector2d residual =
      Eigen::Vector2d::Zero();     ///< `pixel` minus the projection of `world`, pixels
  double othersDisagreement = 0.0; ///< disagreement among the other cameras about `world`, pixels
};

/// Returns the centroid (pixels) of the pixels in the target's color around its expected position
/// in an image (CV_8UC3). Returns nothing if the number of pixels differs too much from the area of
/// the target's outline, or if they reach the edge of the search region. In those cases, the target
/// is partly hidden or another object has its color.
std::optional<Eigen::Vector2d> colorCentroid(const cv::Mat& image, const ColorRanges& color,
                                             const SphereImage& expected);

/// Collects, for each camera, the disagreement between its view of tracked targets and that of the
/// other cameras. If a camera was moved, its sightings share a common residual, and the other
/// cameras still agree with each other without it. For a camera that was not moved, the others do
/// not agree.
class ReprojectionResiduals {
public:
  static constexpr std::size_t kMost = 300; ///< maximum number per camera; the newest are kept
  explicit ReprojectionResiduals(const CameraRig& rig);

  /// Adds the targets after the iterations for a frame. Targets without a valid estimate, or
  /// without a radius, are ignored. A position requires three cameras. In a rig of only two, two
  /// are enough, and each camera is compared with the estimate itself.
  void add(const FrameSet& frames, const std::vector<Target>& targets,
           const std::vector<SphereEstimate>& estimates);
  /// Returns the sightings of a camera, oldest first.
  const std::deque<ReprojectionResidual>& sightings(std::size_t camera) const {
    return sightings_[camera];
  }
  /// Component-wise medians over the sightings of a camera.
  struct Summary {
    Eigen::Vector2d residual = Eigen::Vector2d::Zero(); ///< per component, pixels
    double othersDisagreement = 0.0;                    ///< pixels
  };
  /// Returns a summary of a camera's sightings since a time (seconds). Returns nothing if there are
  /// fewer than `fewest` sightings.
  std::optional<Summary> summary(std::size_t camera, double since, std::size_t fewest) const;
  /// Discards all sightings.
  void restart();

private:
  void addTarget(const FrameSet& frames, const Target& target, const SphereEstimate& estimate);

  std::vector<SphereProjector> projectors_;
  std::vector<Unprojector> unprojectors_;
  std::vector<std::deque<ReprojectionResidual>> sightings_;
};

} // namespace dewpoint::camera_motion
