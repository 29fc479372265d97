// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/session.h"
#include "ui/document/recovery.h"

#include <QString>

#include <optional>

namespace dewpoint::ui {

/// Request to open a project, and instructions for the document once it is open. The request is
/// returned with the result, so it is not stored anywhere else.
struct OpenRequest {
  SessionRequest what;
  /// Reopens the document's project with other inputs; the document stays unchanged.
  bool keepHistory = false;
  bool unsaved = false;                          ///< no file contains this state of the project
  bool calibrate = false;                        ///< opens the page for calibration by hand
  bool guide = false;                            ///< opens the calibration guide
  QString note = {};                             ///< message to show once the project is open
  std::optional<RecoverableWork> recovered = {}; ///< copy from which the project was read
};

} // namespace dewpoint::ui
