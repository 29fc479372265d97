// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/actions/action_registry.h"

#include <vector>

namespace dewpoint::ui {

/// Returns the declarations of the actions in the menu Edit, except those about cameras
/// (cameraActions()), for declareWindowActions(), which adds them to the window.
std::vector<ActionDeclaration> editActions();

} // namespace dewpoint::ui
