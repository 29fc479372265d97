// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/actions/edit_actions.h"

#include <QCoreApplication>

namespace dewpoint::ui {

std::vector<ActionDeclaration> editActions() {
  const char* group = QT_TRANSLATE_NOOP("Actions", "Edit");
  return {
      {"actionUndo", group, QT_TRANSLATE_NOOP("Actions", "Undo"),
       QT_TRANSLATE_NOOP("Actions", "Undo the last change"), "undo", QKeySequence::Undo},
      {"actionRedo", group, QT_TRANSLATE_NOOP("Actions", "Redo"),
       QT_TRANSLATE_NOOP("Actions", "Redo the last undone change"), "redo", QKeySequence::Redo},
      {"actionLearnColor", group, QT_TRANSLATE_NOOP("Actions", "Learn the color"),
       QT_TRANSLATE_NOOP("Actions", "Click the target in a camera image to learn its color"),
       "learn", Qt::Key_L, true},
      {"actionAddTarget", group, QT_TRANSLATE_NOOP("Actions", "Add a target"),
       QT_TRANSLATE_NOOP("Actions", "Track one more object: click it in a camera image"),
       "add-target", Qt::SHIFT | Qt::Key_L, true},
      {"actionRemoveTarget", group, QT_TRANSLATE_NOOP("Actions", "Remove the target"),
       QT_TRANSLATE_NOOP("Actions", "Remove the selected target from the project"), "remove",
       Qt::SHIFT | Qt::Key_Delete},
      {"actionHideTarget", group, QT_TRANSLATE_NOOP("Actions", "Hide or show the target"),
       QT_TRANSLATE_NOOP("Actions", "Hide the selected target in the images and in the bird's-eye "
                                    "view, or show it again. A hidden target is still tracked"),
       nullptr, Qt::CTRL | Qt::SHIFT | Qt::Key_H},
      {"actionPlacePerson", group, QT_TRANSLATE_NOOP("Actions", "Add person…"),
       QT_TRANSLATE_NOOP("Actions",
                         "Click the person in a camera image, or the floor in the bird's-eye view"),
       nullptr, Qt::Key_P, true},
      {"actionRemovePerson", group, QT_TRANSLATE_NOOP("Actions", "Remove person"),
       QT_TRANSLATE_NOOP("Actions", "Remove the person selected in the table"), nullptr,
       Qt::CTRL | Qt::Key_Delete},
      {"actionCorrectPosition", group, QT_TRANSLATE_NOOP("Actions", "Correct position"),
       QT_TRANSLATE_NOOP("Actions", "Drag a target in the camera images to its true position in "
                                    "this frame; tracking continues from there"),
       nullptr, Qt::Key_X, true},
      {"actionRemoveCorrection", group, QT_TRANSLATE_NOOP("Actions", "Remove correction"),
       QT_TRANSLATE_NOOP("Actions", "Remove the correction of the selected target in this frame, "
                                    "or of all targets if none is selected"),
       nullptr, Qt::SHIFT | Qt::Key_X},
      {"actionShortcuts", group, QT_TRANSLATE_NOOP("Actions", "Shortcuts…"),
       QT_TRANSLATE_NOOP("Actions", "See and change all keyboard shortcuts"), nullptr,
       Qt::CTRL | Qt::Key_Comma},
  };
}

} // namespace dewpoint::ui
