// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QString>

#include <optional>

namespace dewpoint::ui {

/// What clicks on a target show of its radius (meters), where that is not the one `given` (0:
/// unknown); empty where they agree or show none.
QString clickRadiusText(double given, const std::optional<double>& shown);
/// What is said of a target that was marked as a part of something larger of its color; `radius` in
/// meters.
QString markedPartText(double radius);

} // namespace dewpoint::ui
