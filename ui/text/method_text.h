// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/method_obstacle.h"

#include <QString>

namespace dewpoint::ui {

/// What a user reads of a method before choosing it, in the language of the window.
struct MethodWords {
  QString heading;  ///< what the methods among which it is listed are for
  QString title;    ///< what it follows
  QString sentence; ///< what sets it apart
  QString name;     ///< as in files and on the command line, in no language
  QString paper;    ///< of which it is, in no language; empty: of none
};
MethodWords methodWords(const Method& method);

/// Why a method cannot work here and what helps; empty when it can.
QString methodObstacleText(MethodObstacle obstacle);

} // namespace dewpoint::ui
