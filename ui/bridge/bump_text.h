// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/snapshot.h"

#include <QString>

namespace dewpoint {

/// The newest report of a camera that does not stand as it was calibrated; null when it does.
const BumpReport* bumpOf(const TrackSnapshot& snapshot, int camera);
/// "turned by 0.31°"; empty for null.
QString bumpText(const BumpReport* report);

} // namespace dewpoint
