// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/seen_by_cameras.h"

#include "core/geometry/seen_volume.h"
#include "core/project/project_rig.h"

namespace dewpoint::setup {

std::optional<WorldBox> volumeSeenByCameras(const Project& project) {
  return seenVolume(rigOf(project));
}

} // namespace dewpoint::setup
