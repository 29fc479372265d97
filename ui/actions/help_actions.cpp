// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/actions/help_actions.h"

#include <QCoreApplication>

namespace dewpoint::ui {

std::vector<ActionDeclaration> helpActions() {
  const char* group = QT_TRANSLATE_NOOP("Actions", "Help");
  return {
      {"actionManual", group, QT_TRANSLATE_NOOP("Actions", "Manual"),
       QT_TRANSLATE_NOOP("Actions", "Open the manual at the page about the active view"), nullptr,
       Qt::Key_F1},
      {"actionQuickStart", group, QT_TRANSLATE_NOOP("Actions", "Quick start"),
       QT_TRANSLATE_NOOP("Actions", "What you see in the window, and how to begin in five steps"),
       nullptr, Qt::SHIFT | Qt::Key_F1},
      {"actionLegend", group, QT_TRANSLATE_NOOP("Actions", "Legend of the overlays"),
       QT_TRANSLATE_NOOP("Actions", "What crosses, ellipses and dots in the images mean"), nullptr,
       Qt::CTRL | Qt::Key_F1},
      {"actionMethods", group, QT_TRANSLATE_NOOP("Actions", "About the methods"),
       QT_TRANSLATE_NOOP("Actions", "Open the reference of the tracking methods")},
      {"actionMessages", group, QT_TRANSLATE_NOOP("Actions", "Messages"),
       QT_TRANSLATE_NOOP("Actions", "Read the messages of this window again, with their times, and "
                                    "copy them")},
      {"actionCheckProject", group, QT_TRANSLATE_NOOP("Actions", "Check project…"),
       QT_TRANSLATE_NOOP("Actions", "Check the recordings, times, calibration, colors and method "
                                    "of the project for problems")},
      {"actionReportProblem", group, QT_TRANSLATE_NOOP("Actions", "Report a problem…"),
       QT_TRANSLATE_NOOP("Actions",
                         "Collect the information that a bug report needs, ready to copy")},
      {"actionAbout", group, QT_TRANSLATE_NOOP("Actions", "About Dewpoint"),
       QT_TRANSLATE_NOOP("Actions", "Version, license, and how to cite Dewpoint")},
  };
}

} // namespace dewpoint::ui
