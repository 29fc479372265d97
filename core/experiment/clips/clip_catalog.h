// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/clips/clip_declaration.h"

#include <span>

namespace dewpoint::experiment {

/// All real clips in the order of the report: R1 are recordings of calibrated cameras, R2
/// recordings of one camera.
std::span<const ClipDeclaration> clipCatalog();

/// Known recordings from which no clip is made.
std::span<const OmittedRecording> omittedRecordings();

} // namespace dewpoint::experiment
