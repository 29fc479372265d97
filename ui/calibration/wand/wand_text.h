// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/calibration/wand_refinement.h"
#include "core/setup/calibration/wand_settings.h"

#include <QString>
#include <QStringList>

#include <vector>

namespace dewpoint::ui {

/// Returns what happens to the ball in a marked frame, for example "The ball touches the floor".
QString wandEventText(WandEvent role);

/// Returns a sentence that explains why a calibration with these settings cannot start
/// (`obstacleOf()`), or an empty string if it can.
QString validationMessage(const WandSettings& settings, const std::vector<MarkedInstant>& instants,
                          const Project& project);

/// Returns one or two translated sentences about missing motion of the wand and what to do about it
/// (motionGapText()). `cameraNames` are the names of all cameras of the project.
QString motionGapMessage(const MotionGap& gap, const QStringList& cameraNames);

/// Returns a translated sentence that says that the cameras before a refinement are known more
/// accurately than its result (oldCamerasMoreAccurateText()).
QString lessAccurateResultMessage(const WandRefinement& refinement);

} // namespace dewpoint::ui
