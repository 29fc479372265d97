// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_classifier.h"
#include "core/filter/particle_set.h"
#include "core/geometry/camera.h"
#include "core/geometry/projector.h"
#include "core/observation/sphere/window_counts.h"

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace dewpoint::observation {

/// Observation model of Barrera et al. 2005, equations 5 to 7, with a window of 5x5 pixels. Let u
/// be the pixel (rounded) to which camera c projects a particle X, and m the number of pixels in
/// the window around u whose color matches the target. If u is outside the image or X is behind the
/// camera, p_c = 1 / 25; otherwise p_c = max(m, 1) / 25. If the image border cuts a window, only
/// the pixels inside the image count, and the divisor remains 25. The likelihood is the product of
/// p_c over all cameras that have an image.
///
/// States: columns 0 to 2 are x, y, z in meters, world frame.
class ColorWindow {
public:
  ColorWindow(const CameraRig& rig, const ColorClassifier& classifier);

  std::size_t cameraCount() const { return views_.size(); }
  void setClassifier(const ColorClassifier& classifier);
  /// Sets the current image (CV_8UC3, blue green red) of a camera. An empty image means that the
  /// camera has no image.
  void setImage(std::size_t camera, const cv::Mat& image);
  /// Chooses the faster of two ways to count the matching pixels of windows: individually for each
  /// window, or once for the whole image. Both ways give the same result. `windowCount` is the
  /// expected number of windows on the current images (particles of all iterations). Must not be
  /// called while other threads use the model.
  void prepare(std::int64_t windowCount);

  /// Adds the log likelihood of each state to `logLikelihood`.
  void addLogLikelihood(ConstStateRows rows, LogWeightSegment logLikelihood) const;

  /// Returns the number of matching pixels, 0 to 25, in the window around the projection of a world
  /// point (meters). Returns nothing if the point is outside the image or behind the camera, or if
  /// the camera has no image.
  std::optional<int> matchCount(std::size_t camera, const Eigen::Vector3d& pointWorld) const;

private:
  struct View {
    Projector projector;
    cv::Mat image;
    WindowCounts counts; ///< empty while windows are counted individually
  };

  static void projectToPixels(const View& view, std::int64_t count, const double* x,
                              const double* y, const double* z, std::int32_t* pixels);

  std::vector<View> views_;
  ColorClassifier classifier_;
};

} // namespace dewpoint::observation
