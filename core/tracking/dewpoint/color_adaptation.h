// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/dewpoint/frame_images.h"
#include "core/tracking/dewpoint/tracked_objects.h"
#include "core/tracking/track_estimate.h"

#include <vector>

namespace dewpoint::tracking {

/// Adapts the colors of targets to slow changes of light: in every camera that shows a target whole
/// and alone, `share` (0 to 1) of the way to the color that it has in this frame. Targets whose
/// estimate is not certain keep their colors; distractors take those of the target they look like.
/// `estimates`: those of the targets in this frame.
void adaptColors(TrackedObjects& objects, const FrameImages& images,
                 const std::vector<SphereEstimate>& estimates, double share);

} // namespace dewpoint::tracking
