// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/formats/calibration_adaptation.h"
#include "core/project/project.h"

#include <opencv2/core/types.hpp>

#include <optional>
#include <string>
#include <vector>

namespace dewpoint::setup {

/// Returns the size, in pixels after rotation and cropping, of the images of a camera whose source
/// is a video or an image folder. Reads the first frame; the camera's calibration and table of
/// times are ignored. Returns the errors of the recording.
Result<cv::Size> imageSizeOf(const ProjectCamera& camera);

/// Adapts the calibration of a camera to the size of its images as described by `fit` (see
/// fittedToSize()), and appends a sentence about this to `decisions`. Changes nothing if the
/// calibration already has this size, or if the image size is not known yet: for live and simulated
/// cameras, and for recordings that cannot be opened. Returns Mismatch with both sizes if they
/// differ and `fit` is not set. Errors name `file`, from which the calibration was read.
Status fitCalibration(ProjectCamera& camera, const std::optional<SizeFit>& fit,
                      const std::string& file, std::vector<std::string>& decisions);

} // namespace dewpoint::setup
