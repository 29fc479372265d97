// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/actions/action_registry.h"

#include <vector>

namespace dewpoint::ui {

/// Returns the actions of the menu Edit, except for those about cameras (cameraActions()).
/// declareWindowActions() declares them.
std::vector<ActionDeclaration> editActions();

} // namespace dewpoint::ui
