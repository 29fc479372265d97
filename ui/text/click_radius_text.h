// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QString>

#include <optional>

namespace dewpoint::ui {

/// Returns what clicks on a target show about its radius (meters) if that differs from `given` (0:
/// unknown); empty if they agree or if clicks show no radius.
QString clickRadiusText(double given, const std::optional<double>& shown);
/// Returns the text about a target that was marked as a part of a larger object of its color;
/// `radius` in meters.
QString markedPartText(double radius);

} // namespace dewpoint::ui
