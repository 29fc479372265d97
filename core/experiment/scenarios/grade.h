// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <optional>
#include <string>

namespace dewpoint::experiment {

/// How rough the images, time stamps and calibration of a run are: `Ideal` has sensor noise,
/// shading and clutter, and nothing wrong; `Room` has what webcams in a room have (GradeModel says
/// what, with numbers); `Wild` has more of it, and other cameras, furniture, lamps and people in
/// each run; `Real` are recordings of real cameras.
enum class Grade { Ideal, Room, Wild, Real };

/// "ideal", "room", "wild" or "real".
const char* gradeName(Grade grade);
/// Nothing for another name.
std::optional<Grade> gradeNamed(const std::string& name);

} // namespace dewpoint::experiment
