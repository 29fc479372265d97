// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/hold_text.h"

#include <QCoreApplication>

namespace dewpoint::ui {

QString holdText(HoldState state) {
  switch (state) {
  case HoldState::Held:
    return QCoreApplication::translate("HoldState", "● tracking");
  case HoldState::Ambiguous:
    return QCoreApplication::translate("HoldState", "◇ ambiguous");
  case HoldState::Hidden:
    return QCoreApplication::translate("HoldState", "◌ hidden");
  case HoldState::Searching:
    return QCoreApplication::translate("HoldState", "○ searching");
  case HoldState::Lost:
    return QCoreApplication::translate("HoldState", "▲ lost");
  case HoldState::Missing:
    return QCoreApplication::translate("HoldState", "✕ missing");
  case HoldState::NotTracked:
    return QCoreApplication::translate("HoldState", "– not tracked");
  case HoldState::NoBox:
    return QCoreApplication::translate("HoldState", "– no box");
  case HoldState::NoTarget:
    return QCoreApplication::translate("HoldState", "No target yet");
  case HoldState::Learning:
    return QCoreApplication::translate("HoldState", "◔ learning background");
  case HoldState::Nobody:
    return QCoreApplication::translate("HoldState", "◌ nobody in view");
  case HoldState::Gone:
    return QCoreApplication::translate("HoldState", "– not present");
  case HoldState::NoImages:
    break;
  }
  return QCoreApplication::translate("HoldState", "– no images");
}

} // namespace dewpoint::ui
