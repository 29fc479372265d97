// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/scenarios/scenario.h"

#include <cstdint>

namespace dewpoint::experiment {

/// Returns whether a frame of a run is evaluated. Frames without a known truth are not evaluated
/// (ScenarioRun::measuredFrames).
bool isMeasured(const ScenarioRun& run, std::int64_t frame);

/// Returns whether the evaluated frames follow each other without gaps. Metrics that compare each
/// frame with the next one, such as the jitter, require this.
bool measuresSuccessiveFrames(const ScenarioRun& run);

/// Returns the part of a run that a SuiteRecorder evaluates: the evaluated frames, renumbered from
/// 0, with their truth and extents but without events or images. If all frames are evaluated,
/// returns the run itself. Metrics per frame are therefore per evaluated frame.
ScenarioRun measuredPart(const ScenarioRun& run);

} // namespace dewpoint::experiment
