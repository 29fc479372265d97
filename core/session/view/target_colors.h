// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/snapshot/display_colors.h"
#include "core/tracking/target.h"

#include <vector>

namespace dewpoint::tracking {
struct MethodFamily;
} // namespace dewpoint::tracking

namespace dewpoint::session {

struct TrackSnapshot;

/// Returns, for each target, the inputs from which `displayColors()` computes the color in which
/// all views draw the target. The learned color is used only for methods that identify targets by
/// color. A person has the color of its identity.
std::vector<DisplayColorSource> displayColorSources(const std::vector<Target>& targets,
                                                    const MethodFamily& family);
/// Returns, for each target of a snapshot, the inputs from which `displayColors()` computes its
/// color.
std::vector<DisplayColorSource> displayColorSources(const TrackSnapshot& snapshot);

} // namespace dewpoint::session
