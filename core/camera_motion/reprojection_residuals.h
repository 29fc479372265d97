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

/// Sighting of a target by one camera, compared with the position of the target according to the
/// other cameras.
struct ReprojectionResidual {
  double captureTime = 0.0; ///< capture time of the image, seconds
  /// Position of the target according to the other cameras alone (in a rig of two cameras: the
  /// estimate of the tracker), meters.
  Eigen::Vector3d world = Eigen::Vector3d::Zero();
  Eigen::Vector2d pixel = Eigen::Vector2d::Zero(); ///< center of the target in the image
  /// `pixel` minus the projection of `world`, pixels.
  Eigen::Vector2d residual = Eigen::Vector2d::Zero();
  /// Disagreement of the other cameras among themselves, pixels: the largest distance, over the
  /// images of the other cameras, between the center of the target and the projection of `world`.
  double otherCamerasDisagreementPx = 0.0;
};

/// Returns the centroid (pixels) of the pixels with the target's color in a search region around
/// the expected outline, in an image (CV_8UC3). Returns nothing if the number of these pixels
/// differs too much from the area of the outline, or if some of these pixels lie at the edge of the
/// search region. In both cases, the target is probably partly hidden, or another object has its
/// color. Also returns nothing if the search region exceeds the image, or if the radius of the
/// outline is less than 2 pixels.
std::optional<Eigen::Vector2d> findColorCentroid(const cv::Mat& image, const ColorRanges& color,
                                                 const SphereImage& expected);

/// Collects the deviations of each camera's sightings from the sightings of the other cameras. If a
/// camera was moved, all its sightings have about the same residual, and the other cameras agree
/// among themselves. For every camera that was not moved, the other cameras disagree, because the
/// moved camera is one of them.
class ReprojectionResiduals {
public:
  /// Maximum number of residuals per camera; the newest ones are kept.
  static constexpr std::size_t kMaxResidualsPerCamera = 300;
  explicit ReprojectionResiduals(const CameraRig& rig);

  /// Adds the sightings of a frame, after the tracker has processed this frame. Targets without a
  /// valid estimate, or without a radius, are ignored. In a rig of three or more cameras, a
  /// sighting is added only if at least two other cameras see the target. In a rig of two cameras,
  /// each camera is compared with the estimate of the tracker.
  void add(const FrameSet& frames, const std::vector<Target>& targets,
           const std::vector<SphereEstimate>& estimates);
  /// Returns the residuals of a camera, oldest first.
  const std::deque<ReprojectionResidual>& residuals(std::size_t camera) const {
    return sightings_[camera];
  }
  /// Medians over the sightings of a camera.
  struct Summary {
    /// Median residual, component by component, pixels.
    Eigen::Vector2d residual = Eigen::Vector2d::Zero();
    double otherCamerasDisagreementPx = 0.0; ///< median disagreement of the other cameras, pixels
  };
  /// Returns the medians over the sightings of a camera at or after the time `since` (seconds).
  /// Returns nothing if there are fewer than `fewest` such sightings.
  std::optional<Summary> summarize(std::size_t camera, double since, std::size_t fewest) const;
  /// Discards all sightings.
  void restart();

private:
  void addTarget(const FrameSet& frames, const Target& target, const SphereEstimate& estimate);

  std::vector<SphereProjector> projectors_;
  std::vector<Unprojector> unprojectors_;
  std::vector<std::deque<ReprojectionResidual>> sightings_;
};

} // namespace dewpoint::camera_motion
