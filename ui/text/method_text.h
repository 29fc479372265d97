// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/method_obstacle.h"

#include <QString>

namespace dewpoint::ui {

/// Translated texts about a method, which help the user to select one.
struct MethodTexts {
  QString heading;     ///< heading of the group of methods with the same use
  QString title;       ///< what the method tracks
  QString description; ///< how the method differs from others
  QString name;        ///< name in files and on the command line, not translated
  QString paper;       ///< paper that describes it, not translated; empty for none
};
/// Returns the translated texts about a method.
MethodTexts methodTexts(const Method& method);

/// Returns why a method cannot be used here and what to do, or an empty string if it can be used.
QString methodObstacleText(MethodObstacle obstacle);

} // namespace dewpoint::ui
