// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QString>

#include <optional>

namespace dewpoint::ui {

/// Returns a text about the target radius (meters) found from clicks if it differs from `given` (0
/// if unknown). Returns an empty string if they agree or if the clicks do not determine a radius.
QString clickRadiusText(double given, const std::optional<double>& shown);
/// Returns the text about a target that was marked as part of a larger object of the same color.
/// `radius` is in meters.
QString markedPartText(double radius);

} // namespace dewpoint::ui
