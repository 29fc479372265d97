// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/clips/clip_declaration.h"

#include <span>

namespace dewpoint::experiment {

/// Returns all real clips in report order. R1 are recordings of calibrated cameras, and R2 are
/// recordings of one camera.
std::span<const ClipDeclaration> clipCatalog();

/// Returns the known recordings from which no clip is made.
std::span<const OmittedRecording> omittedRecordings();

} // namespace dewpoint::experiment
