// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/frame.h"
#include "core/experiment/scenarios/draft/scenario_draft.h"

#include <cstdint>

namespace dewpoint::experiment::scenarios {

/// Set `frame` of a finished draft as methods get it: stamped by its number, each image as late and
/// with such a stamp as its camera's timing says, null where none comes. A pure function.
FrameSetPtr frameSetOf(const ScenarioDraft& draft, std::int64_t frame);

} // namespace dewpoint::experiment::scenarios
