// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/tracking_state_text.h"

#include <QCoreApplication>

namespace dewpoint::ui {

QString trackingStateText(TrackingState state) {
  switch (state) {
  case TrackingState::Held:
    return QCoreApplication::translate("TrackingState", "● tracking");
  case TrackingState::Ambiguous:
    return QCoreApplication::translate("TrackingState", "◇ ambiguous");
  case TrackingState::Hidden:
    return QCoreApplication::translate("TrackingState", "◌ hidden");
  case TrackingState::Searching:
    return QCoreApplication::translate("TrackingState", "○ searching");
  case TrackingState::Lost:
    return QCoreApplication::translate("TrackingState", "▲ lost");
  case TrackingState::Missing:
    return QCoreApplication::translate("TrackingState", "✕ missing");
  case TrackingState::NotTracked:
    return QCoreApplication::translate("TrackingState", "– not tracked");
  case TrackingState::NoBox:
    return QCoreApplication::translate("TrackingState", "– no box");
  case TrackingState::NoTarget:
    return QCoreApplication::translate("TrackingState", "No target yet");
  case TrackingState::Learning:
    return QCoreApplication::translate("TrackingState", "◔ learning background");
  case TrackingState::Nobody:
    return QCoreApplication::translate("TrackingState", "◌ nobody in view");
  case TrackingState::Gone:
    return QCoreApplication::translate("TrackingState", "– not present");
  case TrackingState::NoImages:
    break;
  }
  return QCoreApplication::translate("TrackingState", "– no images");
}

} // namespace dewpoint::ui
