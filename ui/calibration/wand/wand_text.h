// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/calibration/wand_refinement.h"
#include "core/setup/calibration/wand_settings.h"

#include <QString>
#include <QStringList>

#include <vector>

namespace dewpoint::ui {

/// Returns what happens to the ball at a marked time, in words: "touches the floor".
QString touchText(WandEvent role);

/// Returns a sentence that explains why a calibration with these settings cannot start
/// (`obstacleOf()`), or an empty string if it can.
QString validationMessage(const WandSettings& settings, const std::vector<MarkedInstant>& instants,
                          const Project& project);

/// Returns the translated motionGapText(). `cameraNames`: of all cameras of the project.
QString motionGapMessage(const MotionGap& gap, const QStringList& cameraNames);

/// Returns the translated knownBetterText().
QString knownBetterMessage(const WandRefinement& refinement);

} // namespace dewpoint::ui
