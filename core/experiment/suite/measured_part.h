// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/scenarios/scenario.h"

#include <cstdint>

namespace dewpoint::experiment {

/// Whether a frame of a run has a truth to be measured against.
bool isMeasured(const ScenarioRun& run, std::int64_t frame);

/// Whether nothing lies between the frames that are measured, so that one can be compared with the
/// next.
bool measuresSuccessiveFrames(const ScenarioRun& run);

/// What a SuiteRecorder needs of a run of which only some frames are measured: a run of these
/// frames, numbered from 0 in their order, with their truth and extents and without events or
/// images. The run itself where all frames are measured. Rates are per measured frame.
ScenarioRun measuredPart(const ScenarioRun& run);

} // namespace dewpoint::experiment
