// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/geometry/image_box.h"

#include <opencv2/core/mat.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace dewpoint::experiment {

/// Confidence that a follower reports for the box it found.
struct BoxClaim {
  double similarity = 0.0; ///< [0, 1]
  bool visible = true;     ///< false: box held at the assumed position
};

/// Interface of all methods that follow a box through images, for comparisons.
class BoxFollower {
public:
  virtual ~BoxFollower() = default;
  /// Starts with the target in `box` (pixels) of an image (CV_8UC3).
  virtual Status start(const cv::Mat& bgr, const ImageBox& box) = 0;
  /// Box in the next image; nothing if the method reports that it has lost the target.
  virtual std::optional<ImageBox> step(const cv::Mat& bgr) = 0;
  /// Confidence in the last box; nothing from methods that report none.
  virtual std::optional<BoxClaim> claim() const { return std::nullopt; }
};

/// Makes one of our methods that follow boxes, by name. It uses one thread.
Result<std::unique_ptr<BoxFollower>> makeBoxFollower(const std::string& method, int particles,
                                                     std::uint64_t seed);

/// Names of OpenCV's trackers: "camshift", "meanshift", "csrt", "kcf".
const std::vector<std::string>& openCvFollowers();

/// Makes a tracker of OpenCV with default parameters. CamShift and meanShift get the
/// back-projection of the box's hue histogram, as in OpenCV's samples (16 hues of pixels that have
/// a color). They use no random numbers.
std::unique_ptr<BoxFollower> makeOpenCvFollower(const std::string& name);

/// Names of all methods that follow the box of one camera: ours, and OpenCV's with the suffix
/// "-box" ("csrt-box"), because "csrt" is also the suite's method that triangulates such boxes.
const std::vector<std::string>& boxFollowerNames();

/// Makes a follower by a name of boxFollowerNames(); `particles` and `seed` apply to ours. NotFound
/// for any other name.
Result<std::unique_ptr<BoxFollower>> makeFollower(const std::string& name, int particles,
                                                  std::uint64_t seed);

} // namespace dewpoint::experiment
