// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/method_obstacle.h"

#include <QString>

namespace dewpoint::ui {

/// Texts about a method that help the user select one, translated.
struct MethodWords {
  QString heading;  ///< heading of its group: what the methods in it are for
  QString title;    ///< what it tracks
  QString sentence; ///< how it differs from others
  QString name;     ///< name in files and on the command line, not translated
  QString paper;    ///< paper it is from, not translated; empty: none
};
/// Returns the texts about a method.
MethodWords methodWords(const Method& method);

/// Returns why a method cannot be used here and what to do; empty if it can.
QString methodObstacleText(MethodObstacle obstacle);

} // namespace dewpoint::ui
