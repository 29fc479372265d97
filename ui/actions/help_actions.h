// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/actions/action_registry.h"

#include <vector>

namespace dewpoint::ui {

/// Returns the actions of the menu Help. declareWindowActions() declares them.
std::vector<ActionDeclaration> helpActions();

} // namespace dewpoint::ui
