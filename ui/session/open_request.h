// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/session.h"
#include "ui/document/recovery.h"

#include <QString>

#include <optional>

namespace dewpoint::ui {

/// Request to open a project, with what to do with the document once it is open. It travels with
/// the opening and comes back with the result, so it is stored nowhere else.
struct OpenRequest {
  SessionRequest what;
  /// The project of the document is reopened with other inputs; the document stays as it is.
  bool keepHistory = false;
  bool unsaved = false;                          ///< no file contains this state of the project
  bool calibrate = false;                        ///< opens the page for calibration by hand
  QString note = {};                             ///< message shown once the project is open
  std::optional<RecoverableWork> recovered = {}; ///< copy that the project comes from
};

} // namespace dewpoint::ui
