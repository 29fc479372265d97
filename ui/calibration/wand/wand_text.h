// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/wand_settings.h"

#include <QString>

#include <vector>

namespace dewpoint::ui {

/// In words: "touches the floor".
QString touchText(TouchRole role);

/// What keeps a calibration with these settings from starting (obstacleOf()), as a sentence; empty
/// when nothing does.
QString validationMessage(const WandSettings& settings, const std::vector<TouchedInstant>& instants,
                          const Project& project);

} // namespace dewpoint::ui
