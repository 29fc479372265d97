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

/// The color window of Barrera et al. 2005, equations 5 to 7. For camera c and the pixel u to which
/// particle X projects (rounded to the nearest pixel), with m the number of pixels in the 5x5
/// window around u whose color matches the target:
///   p_c = 1/25 when u is outside the image or X behind the camera; else p_c = max(m, 1) / 25.
/// A window cut by the border counts the pixels it has, the divisor stays 25. The likelihood is the
/// product over the cameras; a camera without an image contributes nothing.
/// States: columns 0 to 2 are x, y, z in meters, world frame.
class ColorWindow {
public:
  ColorWindow(const CameraRig& rig, const ColorClassifier& classifier);

  std::size_t cameraCount() const { return views_.size(); }
  void setClassifier(const ColorClassifier& classifier);
  /// The image (CV_8UC3, blue green red) that a camera shows from now on; empty for none.
  void setImage(std::size_t camera, const cv::Mat& image);
  /// Chooses how windows are counted, given how many will be needed on these images (the particles
  /// of all iterations): one by one, or from counts over the whole image where that takes less
  /// time. The result is the same. Not to be called while other threads use the model.
  void prepare(std::int64_t windowCount);

  void addLogLikelihood(ConstStateRows rows, LogWeightSegment logLikelihood) const;

  /// Matching pixels in the window around the projection of a point, 0 to 25; nothing when the
  /// point is outside the image or behind the camera, or the camera has no image.
  std::optional<int> matchCount(std::size_t camera, const Eigen::Vector3d& pointWorld) const;

private:
  struct View {
    Projector projector;
    cv::Mat image;
    WindowCounts counts; ///< empty while windows are counted one by one
  };

  static void pixelsOf(const View& view, std::int64_t count, const double* x, const double* y,
                       const double* z, std::int32_t* pixels);

  std::vector<View> views_;
  ColorClassifier classifier_;
};

} // namespace dewpoint::observation
