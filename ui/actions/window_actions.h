// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

namespace dewpoint::ui {

class ActionRegistry;

/// Declares every action of the window: a new one is a line here, an entry of a menu, and a
/// connection.
void declareWindowActions(ActionRegistry& registry);

} // namespace dewpoint::ui
