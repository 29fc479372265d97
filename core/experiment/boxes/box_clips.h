// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/geometry/image_box.h"
#include "core/simulation/scene/scene.h"

#include <opencv2/core/mat.hpp>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace dewpoint::experiment {

/// Images of one camera, with the true bounding box of one target in each image.
struct BoxClip {
  std::string name;
  std::string description; ///< why the target is difficult to follow
  std::vector<ImageBox> truth;
  /// Largest distance between the found and the true center that counts as a hit, pixels.
  double hitRadiusPx = 20.0;
  bool hasExactBoxes =
      true; ///< false: the truth gives only centers, and its boxes have a fixed size
  std::function<Result<cv::Mat>(std::int64_t)>
      image; ///< returns the image (CV_8UC3) of a frame; frames are counted from 0
};

/// Returns all images of a clip (images of one camera with true boxes), or the first error of
/// reading one.
Result<std::vector<cv::Mat>> imagesOf(const BoxClip& clip);

/// Creates a clip (images with true boxes) of the first ball of a scene as seen by one camera. The
/// clip is named after the scene and the camera. Boxes are empty where the camera cannot see the
/// ball.
BoxClip clipOfScene(const Scene& scene, int camera);

/// Renders a clip (images with true boxes) from a seed: a ball moves on a fast path over a
/// cluttered desk. It has 300 frames of 320 x 240 pixels with sensor noise.
BoxClip simulatedBoxClip(std::uint64_t seed);

/// Reads the recorded clips (images with true boxes) in a folder. The folder may contain the
/// subfolders `juggle1` (three balls, one clip each), `throws_pinkball` (one clip per ball) and
/// `otb` (one folder per sequence, with groundtruth_rect.txt). If a file cannot be read, the error
/// names it.
Result<std::vector<BoxClip>> recordedBoxClips(const std::filesystem::path& folder);

} // namespace dewpoint::experiment
