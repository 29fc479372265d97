// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QString>

#include <optional>

namespace dewpoint::ui {

/// Returns a text about the target radius found from clicks, `shown`, if it differs from the radius
/// in the project, `given` (0 if unknown). Both are in meters. Returns an empty string if they
/// agree, or if the clicks do not determine a radius.
QString clickRadiusText(double given, const std::optional<double>& shown);
/// Returns the text for a target whose clicks mark only a part of a larger object of the same
/// color. `radius` is the radius of this part in meters.
QString markedPartText(double radius);

} // namespace dewpoint::ui
