// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/target_exposure.h"
#include "core/session/snapshot/snapshot.h"

#include <string>
#include <vector>

namespace dewpoint::session {

/// Exposure of one target in the image of one camera.
struct ExposureInView {
  std::size_t target = 0; ///< index in TrackSnapshot::targets
  std::string name;       ///< name of the target
  /// True if the pixels are those inside the estimated outline; false if they are the region of a
  /// color sample.
  bool isTracked = false;
  TargetExposure exposure;
};

/// Returns the exposures of the targets in the image of one camera of a snapshot, in the order of
/// the targets. A target that is tracked and confirmed by this camera is measured inside its
/// estimated outline. Any other target is measured in the region of its newest color sample from
/// this camera, if the image still shows the sampled object there; otherwise it is left out. People
/// are left out, too. May take tens of milliseconds.
std::vector<ExposureInView> exposuresInView(const TrackSnapshot& snapshot, int camera);

/// Returns the worst of these exposures. Overexposed targets are worse than all others, and the one
/// with the largest fraction of clipped pixels is the worst. If no target is overexposed, the
/// fractions of clipped and of dark pixels are compared relative to their limits
/// (TargetExposure::kMostClipped, kMostDark). Null if the list is empty.
const ExposureInView* worstExposure(const std::vector<ExposureInView>& exposures);

} // namespace dewpoint::session
