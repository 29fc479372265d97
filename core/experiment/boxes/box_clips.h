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

/// Images of one camera, with the true box of one target in each.
struct BoxClip {
  std::string name;
  std::string sentence; ///< why it is difficult
  std::vector<ImageBox> truth;
  double radius = 20.0;   ///< px: a center within this distance is a hit
  bool exactBoxes = true; ///< false: only centers are marked, and the box has a fixed size
  std::function<Result<cv::Mat>(std::int64_t)> image; ///< CV_8UC3; frames from 0
};

/// Reads all images of a clip.
Result<std::vector<cv::Mat>> imagesOf(const BoxClip& clip);

/// Makes a clip of one camera's view of the first ball of a scene, named after both. Boxes are
/// empty where the camera cannot see the ball.
BoxClip clipOfScene(const Scene& scene, int camera);

/// Renders a seeded clip: a ball on a fast path over a cluttered desk, with sensor noise, 320 x 240
/// pixels, 300 frames.
BoxClip simulatedBoxClip(std::uint64_t seed);

/// Clips found in a folder with `juggle1` (three balls, one clip each), `throws_pinkball` (one clip
/// per ball) and `otb` (one folder per sequence, with groundtruth_rect.txt). An error names a file
/// that cannot be read.
Result<std::vector<BoxClip>> recordedBoxClips(const std::filesystem::path& folder);

} // namespace dewpoint::experiment
