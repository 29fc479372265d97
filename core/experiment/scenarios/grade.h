// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <optional>
#include <string>

namespace dewpoint::experiment {

/// Realism of a run. `Ideal` has sensor noise, shading and clutter but no other faults. `Room` has
/// the faults of images, time stamps and calibration that webcams in a room have (see GradeModel
/// for numbers). `Wild` has larger faults, and different cameras, furniture, lamps and people in
/// each run. `Real` are recordings of real cameras.
enum class Grade { Ideal, Room, Wild, Real };

/// Returns the name of a grade: "ideal", "room", "wild" or "real".
const char* gradeName(Grade grade);
/// Returns the grade with this name, or nothing for an unknown name.
std::optional<Grade> gradeFromName(const std::string& name);

} // namespace dewpoint::experiment
