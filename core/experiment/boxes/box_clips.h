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

/// Images of one camera with the true box of one target in each.
struct BoxClip {
  std::string name;
  std::string sentence; ///< what makes it hard
  std::vector<ImageBox> truth;
  double radius = 20.0;   ///< px: a center within it is a hit
  bool exactBoxes = true; ///< false: only centers are marked, and the box has a set size
  std::function<Result<cv::Mat>(std::int64_t)> image; ///< CV_8UC3; frames from 0
};

/// All images of a clip.
Result<std::vector<cv::Mat>> imagesOf(const BoxClip& clip);

/// What one camera sees of the first ball of a scene, named after both; boxes are empty where the
/// camera cannot see it.
BoxClip clipOfScene(const Scene& scene, int camera);

/// A rendered clip, seeded: a ball on a fast path over a cluttered desk, with sensor noise,
/// 320 x 240 pixels, 300 frames.
BoxClip simulatedBoxClip(std::uint64_t seed);

/// The clips that are found in a folder with `juggle1` (three balls, a clip each),
/// `throws_pinkball` (a clip per ball) and `otb`
/// (a folder per sequence, with groundtruth_rect.txt). Errors name a file that cannot be read.
Result<std::vector<BoxClip>> recordedBoxClips(const std::filesystem::path& folder);

} // namespace dewpoint::experiment
