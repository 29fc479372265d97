// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

namespace dewpoint::ui {

class ActionRegistry;

/// Declares all actions in the window. A new action needs a line here, a menu entry and a
/// connection.
void declareWindowActions(ActionRegistry& registry);

} // namespace dewpoint::ui
