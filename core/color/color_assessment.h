// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_evidence.h"
#include "core/color/color_learning.h"

namespace dewpoint::color {

/// How well the range does on the evidence that was collected from these images.
ColorAssessment assessRange(const ColorRange& range, const ColorEvidence& evidence,
                            const std::vector<cv::Mat>& images);

} // namespace dewpoint::color
