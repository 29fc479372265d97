// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/dewpoint/frame_images.h"
#include "core/tracking/dewpoint/tracked_objects.h"
#include "core/tracking/track_estimate.h"

#include <vector>

namespace dewpoint::tracking {

/// Adapts the colors of targets to slow changes of light. In every camera that shows a target
/// completely and alone, the color ranges move by the fraction `share` (0 to 1) toward the color in
/// this frame. Targets with an uncertain estimate keep their colors. A distractor gets the colors
/// of the target that it resembles. `estimates` contains the estimate of each target in this frame.
void adaptColors(TrackedObjects& objects, const FrameImages& images,
                 const std::vector<SphereEstimate>& estimates, double share);

} // namespace dewpoint::tracking
