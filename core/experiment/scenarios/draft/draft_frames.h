// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/frame.h"
#include "core/experiment/scenarios/draft/scenario_draft.h"

#include <cstdint>

namespace dewpoint::experiment::scenarios {

/// Frame set `frame` of a finished draft as methods receive it. The set is stamped by its number.
/// The delay and the time stamp of each image follow its camera's timing; an image that does not
/// arrive is null. A pure function.
FrameSetPtr frameSetOf(const ScenarioDraft& draft, std::int64_t frame);

} // namespace dewpoint::experiment::scenarios
