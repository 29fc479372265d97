// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/session.h"
#include "ui/document/recovery.h"

#include <QString>

#include <optional>

namespace dewpoint::ui {

/// A request to open a project, and what becomes of the document once it is open. It goes along
/// with the opening and comes back with the result, so nothing waits for it elsewhere.
struct OpenRequest {
  SessionRequest what;
  bool keepHistory = false; ///< the project of the document, with other inputs: it stays as it is
  bool unsaved = false;     ///< it is in no file as it is
  bool calibrate = false;   ///< with its calibration by hand in front
  QString note = {};        ///< shown once it is open
  std::optional<RecoverableWork> recovered = {}; ///< the copy it comes from
};

} // namespace dewpoint::ui
