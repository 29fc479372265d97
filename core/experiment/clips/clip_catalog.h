// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/clips/clip_declaration.h"

#include <span>

namespace dewpoint::experiment {

/// Returns all real clips (recordings with ground truth) in report order. Names of clips from
/// calibrated cameras begin with R1, and names of clips from a single camera begin with R2.
std::span<const ClipDeclaration> clipCatalog();

/// Returns the known recordings from which no clip is made, each with the reason.
std::span<const OmittedRecording> omittedRecordings();

} // namespace dewpoint::experiment
