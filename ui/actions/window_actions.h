// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

namespace dewpoint::ui {

class ActionRegistry;

/// Adds all actions of the window to the registry.
void declareWindowActions(ActionRegistry& registry);

} // namespace dewpoint::ui
