// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/dewpoint/frame_images.h"
#include "core/tracking/dewpoint/tracked_objects.h"
#include "core/tracking/track_estimate.h"

#include <vector>

namespace dewpoint::tracking {

/// Adapts the colors of targets to slow changes of light. In every camera that shows a target
/// completely and alone, the color moves by `share` (0 to 1) toward the color in this frame.
/// Targets with an uncertain estimate keep their colors. Distractors use the colors of the target
/// that they resemble. `estimates` are those of the targets in this frame.
void adaptColors(TrackedObjects& objects, const FrameImages& images,
                 const std::vector<SphereEstimate>& estimates, double share);

} // namespace dewpoint::tracking
