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
struct BoxConfidence {
  double similarity = 0.0; ///< similarity to the target, [0, 1]
  bool isVisible = true; ///< false: the target is hidden, and the box stays at its assumed position
};

/// Common interface of all methods that follow a box through images, used for comparisons.
class BoxFollower {
public:
  virtual ~BoxFollower() = default;
  /// Starts to follow the target that is inside `box` (pixels) in an image (CV_8UC3). Returns an
  /// error if the method cannot start there.
  virtual Status start(const cv::Mat& bgr, const ImageBox& box) = 0;
  /// Returns the box in the next image, or nothing if the method reports that it has lost the
  /// target.
  virtual std::optional<ImageBox> step(const cv::Mat& bgr) = 0;
  /// Returns the confidence in the last box, or nothing if the method reports none.
  virtual std::optional<BoxConfidence> confidence() const { return std::nullopt; }
};

/// Creates a follower with one of Dewpoint's own methods that track boxes, by the name of the
/// method. The follower uses one thread.
Result<std::unique_ptr<BoxFollower>> makeDewpointFollower(const std::string& method, int particles,
                                                          std::uint64_t seed);

/// Returns the names of OpenCV's trackers: "camshift", "meanshift", "csrt", "kcf".
const std::vector<std::string>& openCvFollowerNames();

/// Creates a follower with an OpenCV tracker and its default parameters, by a name from
/// openCvFollowerNames(). CamShift and meanShift work on the back-projection of the box's hue
/// histogram, as in OpenCV's samples (16 hues, pixels without color excluded). The trackers use no
/// random numbers.
std::unique_ptr<BoxFollower> makeOpenCvFollower(const std::string& name);

/// Returns the names of all methods that follow a box in one camera. OpenCV's methods have the
/// suffix "-box" ("csrt-box"), because the "csrt" of the accuracy suite is a method that
/// triangulates such boxes.
const std::vector<std::string>& boxFollowerNames();

/// Creates a follower by a name from boxFollowerNames(). `particles` and `seed` apply only to
/// Dewpoint's own methods. Returns NotFound for any other name.
Result<std::unique_ptr<BoxFollower>> makeFollowerByName(const std::string& name, int particles,
                                                        std::uint64_t seed);

} // namespace dewpoint::experiment
