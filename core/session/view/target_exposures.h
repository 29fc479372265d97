// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/target_exposure.h"
#include "core/session/snapshot/snapshot.h"

#include <string>
#include <vector>

namespace dewpoint::session {

/// Exposure (over- or underexposure) of one target in the image of one camera.
struct ExposureInView {
  std::size_t target = 0; ///< index in TrackSnapshot::targets
  std::string name;       ///< name of the target
  /// True if the pixels inside the target's estimated outline were measured; false if those in the
  /// region of a color sample were.
  bool isTracked = false;
  TargetExposure exposure;
};

/// Returns the exposures of the targets in the image of one camera of a snapshot, in the order of
/// the targets. A target that is tracked and confirmed by this camera is measured inside its
/// estimated outline. Any other target is measured in the region of its newest color sample from
/// this camera, if the image still shows the sampled object there. Otherwise, the target is left
/// out, and so are people. May take tens of milliseconds.
std::vector<ExposureInView> exposuresInView(const TrackSnapshot& snapshot, int camera);

/// Returns the worst exposure; null if the list is empty. If targets are overexposed, this is the
/// one with the largest fraction of clipped (saturated) pixels. Otherwise, the fractions of clipped
/// and of dark pixels are compared relative to their limits (TargetExposure::kMaxClippedShare,
/// kMaxDarkShare).
const ExposureInView* worstExposure(const std::vector<ExposureInView>& exposures);

} // namespace dewpoint::session
