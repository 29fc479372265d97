// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/actions/action_registry.h"

#include <vector>

namespace dewpoint::ui {

/// Returns the declarations of the actions in the menu Help, for declareWindowActions(), which adds
/// them to the window.
std::vector<ActionDeclaration> helpActions();

} // namespace dewpoint::ui
