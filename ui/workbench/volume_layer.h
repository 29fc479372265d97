// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/world_box.h"

#include <functional>
#include <optional>

class QObject;

namespace dewpoint::ui {

struct Workbench;

/// Tells a view which volume of interest to show, now and whenever that changes: the project's, or
/// nothing where its method goes by none or the layer is switched off. As long as `view` lives.
void connectVolume(const Workbench& bench, QObject* view,
                   const std::function<void(const std::optional<WorldBox>&)>& show);

} // namespace dewpoint::ui
