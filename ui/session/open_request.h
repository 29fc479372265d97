// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/session.h"
#include "ui/document/recovery.h"

#include <QString>

#include <optional>

namespace dewpoint::ui {

/// Request to open a project, with what the window must do once it is open. The request is returned
/// with the result, so it is not stored anywhere else.
struct OpenRequest {
  SessionRequest sessionRequest;
  /// True if the document's project is opened again with other inputs; the document then stays
  /// unchanged.
  bool keepsHistory = false;
  bool isUnsaved = false;             ///< no file contains the project in the state to open
  bool opensCalibrationPage = false;  ///< opens the page for calibration by hand
  bool opensCalibrationGuide = false; ///< opens the calibration guide
  QString message = {};               ///< message to show once the project is open
  std::optional<RecoverableWork> recovered = {}; ///< copy from which the project was read
};

} // namespace dewpoint::ui
