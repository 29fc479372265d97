// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/world_box.h"

#include <functional>
#include <optional>

class QObject;

namespace dewpoint::ui {

struct Workbench;

/// Calls `show` with the volume of interest, once now and after every change, for as long as `view`
/// exists. The argument is the project's volume; it is empty if the method does not use one or the
/// layer is switched off.
void connectVolume(const Workbench& bench, QObject* view,
                   const std::function<void(const std::optional<WorldBox>&)>& show);

} // namespace dewpoint::ui
