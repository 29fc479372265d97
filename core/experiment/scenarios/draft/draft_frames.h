// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/frame.h"
#include "core/experiment/scenarios/draft/scenario_draft.h"

#include <cstdint>

namespace dewpoint::experiment::scenarios {

/// Returns frame set number `frame` of a run whose draft is finished, as methods receive it. The
/// time stamp of the set is ScenarioDraft::timeOf(`frame`). The clock and the timing faults of each
/// camera determine the delay and time stamp of its image. An image that does not arrive is null.
/// This is a pure function.
FrameSetPtr frameSetOf(const ScenarioDraft& draft, std::int64_t frame);

} // namespace dewpoint::experiment::scenarios
