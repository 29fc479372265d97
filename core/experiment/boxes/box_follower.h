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

/// A follower's statement about the box it found.
struct BoxClaim {
  double similarity = 0.0; ///< [0, 1]
  bool visible = true;     ///< false: held where the target is thought to be
};

/// Anything that follows a box through images, for comparisons.
class BoxFollower {
public:
  virtual ~BoxFollower() = default;
  virtual Status start(const cv::Mat& bgr, const ImageBox& box) = 0;
  /// Nothing where it reports that it has lost the target.
  virtual std::optional<ImageBox> step(const cv::Mat& bgr) = 0;
  /// Its statement about the last box; nothing from those that make none.
  virtual std::optional<BoxClaim> claim() const { return std::nullopt; }
};

/// One of our methods that follow boxes, by name; one thread.
Result<std::unique_ptr<BoxFollower>> makeBoxFollower(const std::string& method, int particles,
                                                     std::uint64_t seed);

/// Names of OpenCV's trackers: "camshift", "meanshift", "csrt", "kcf".
const std::vector<std::string>& openCvFollowers();

/// OpenCV's, with its default parameters. CamShift and meanShift get the back-projection of the
/// box's hue histogram, as in OpenCV's samples (16 hues of pixels that have a color). They have no
/// randomness.
std::unique_ptr<BoxFollower> makeOpenCvFollower(const std::string& name);

/// All methods that follow the box of one camera: ours, and OpenCV's with "-box" behind their names
/// ("csrt-box"), since "csrt" is also the suite's method that triangulates such boxes.
const std::vector<std::string>& boxFollowerNames();

/// By a name of boxFollowerNames(); `particles` and `seed` are for ours. NotFound for any other.
Result<std::unique_ptr<BoxFollower>> makeFollower(const std::string& name, int particles,
                                                  std::uint64_t seed);

} // namespace dewpoint::experiment
