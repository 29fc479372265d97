// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/formats/calibration_adaptation.h"
#include "core/project/project.h"

#include <opencv2/core/types.hpp>

#include <optional>
#include <string>
#include <vector>

namespace dewpoint::setup {

/// Returns the size of the images of a camera whose source is a video or an image folder, after
/// rotation, in pixels, whatever its calibration and its times say. Reads the first frame. Returns
/// the errors of the recording.
Result<cv::Size> imageSizeOf(const ProjectCamera& camera);

/// Fits the calibration of a camera to the size of its images, as fittedToSize() does, and appends
/// a sentence about it to `decisions`. Leaves it alone if the sizes are equal, or if the images
/// have no size yet: live cameras, simulated ones, and recordings that cannot be opened. Returns
/// Mismatch with both sizes if they differ and `fit` is not set. Errors name `file`, which the
/// calibration is from.
Status fitCalibration(ProjectCamera& camera, const std::optional<SizeFit>& fit,
                      const std::string& file, std::vector<std::string>& decisions);

} // namespace dewpoint::setup
