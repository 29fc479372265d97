// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/scenarios/scenario.h"

#include <cstdint>

namespace dewpoint::experiment {

/// Whether a frame of a run has a truth for its evaluation.
bool isMeasured(const ScenarioRun& run, std::int64_t frame);

/// Whether the evaluated frames are successive, so that each can be compared with the next.
bool measuresSuccessiveFrames(const ScenarioRun& run);

/// Part of a run for a SuiteRecorder when only some frames are evaluated: these frames, numbered
/// from 0 in their order, with their truth and extents and without events or images. Returns the
/// run itself if all frames are evaluated. Rates are per evaluated frame.
ScenarioRun measuredPart(const ScenarioRun& run);

} // namespace dewpoint::experiment
