// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/world_box.h"

#include <functional>
#include <optional>

class QObject;

namespace dewpoint::ui {

struct Workbench;

/// Calls `show` with the project's volume of interest, now and after every change, as long as
/// `view` exists. The volume is empty if the project has none, if the method does not use it, or if
/// the user has hidden it.
void connectVolume(const Workbench& bench, QObject* view,
                   const std::function<void(const std::optional<WorldBox>&)>& show);

} // namespace dewpoint::ui
