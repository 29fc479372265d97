// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/actions/camera_actions.h"

#include <QCoreApplication>

namespace dewpoint::ui {

std::vector<ActionDeclaration> cameraActions() {
  const char* group = QT_TRANSLATE_NOOP("Actions", "Edit");
  return {
      {"actionCameras", group, QT_TRANSLATE_NOOP("Actions", "Cameras…"),
       QT_TRANSLATE_NOOP("Actions", "Add, remove, replace and adjust the cameras of the project"),
       nullptr, Qt::Key_F8},
      {"actionLockColors", group, QT_TRANSLATE_NOOP("Actions", "Lock colors"),
       QT_TRANSLATE_NOOP("Actions", "Switch off the automatic exposure, gain and white balance of "
                                    "all connected cameras, and keep the current values"),
       nullptr, Qt::SHIFT | Qt::Key_F8},
  };
}

} // namespace dewpoint::ui
