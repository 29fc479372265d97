// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/base/thread_team.h"
#include "core/geometry/image_box.h"
#include "core/tracking/parameters.h"

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace dewpoint::tracking {

/// What a tracker of boxes believes after one image. Pixels from the image's upper left corner.
struct BoxEstimate {
  ImageBox box;
  double similarity = 0.0; ///< how alike the colors in the box are to the reference, [0, 1]
  double spread = 0.0;     ///< root mean square distance of the particles to their mean, px
  double effectiveSampleSize = 0.0;
  int particleCount = 0;
  bool visible = true;     ///< false while a hidden target is held where it is thought to be
  bool degenerate = false; ///< no particle had a usable weight; all were kept as equal
};

/// What is believed of a box in the images of one camera.
struct BoxBelief {
  int camera = 0; ///< in the order of the rig
  BoxEstimate estimate;
  Eigen::ArrayXXf centers; ///< of some particles: rows x y, pixels from the upper left corner
  Eigen::ArrayXf weights;  ///< one per row, linear
};

/// One method that follows a box through the images of one camera, which needs no calibration. Not
/// thread safe; the same seed gives the same bits for any size of the ThreadTeam.
class BoxTracker {
public:
  virtual ~BoxTracker() = default;
  /// Other parameters of the same method, from the next image on.
  virtual void configure(const ParameterValues& parameters) = 0;
  /// Takes the target in the box of an image (CV_8UC3) as what is to be followed, and forgets
  /// everything else. BadValue names "image" or "box".
  virtual Status start(const cv::Mat& bgr, const ImageBox& box, std::uint64_t seed) = 0;
  /// The next image, of the same size as the first (asserted). start() must have succeeded.
  virtual BoxEstimate step(const cv::Mat& bgr, ThreadTeam& team) = 0;
  /// The centers of at most `limit` particles, evenly picked, as last weighted: rows x y, with
  /// linear weights that sum to 1 over all particles.
  virtual void particles(int limit, Eigen::ArrayXXd& centers, Eigen::ArrayXd& weights) const = 0;
  /// A copy that goes on from here with the same bits.
  virtual std::unique_ptr<BoxTracker> clone() const = 0;
  /// About how many bytes a copy takes.
  virtual std::size_t memoryBytes() const = 0;
};

/// Names of the methods that follow boxes, the default first: "histogram", "sugandi". Their
/// parameters are declared as those of all others: methodParameters().
std::vector<std::string> boxMethodNames();
/// A tracker of the named method; NotFound for an unknown one, MissingKey for parameters that are
/// not those of the method.
Result<std::unique_ptr<BoxTracker>> makeBoxTracker(const std::string& method,
                                                   const ParameterValues& parameters);

/// The color image a tracker needs and a box of at least 2 x 2 pixels that lies in it, at least
/// with its center: BadValue names "image" or "box".
Status checkBox(const cv::Mat& bgr, const ImageBox& box);

/// The box around the thing that was clicked (see growRegion()): BadValue names "pixel" or "image".
Result<ImageBox> boxFromClick(const cv::Mat& bgr, double x, double y);

} // namespace dewpoint::tracking
