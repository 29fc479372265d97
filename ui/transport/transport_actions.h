// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QKeySequence>
#include <QObject>
#include <QString>

#include <utility>
#include <vector>

class QAction;
class QPalette;

namespace dewpoint {

/// The actions of the window, each with name, icon, shortcut and tooltip; what they do is connected
/// by the window.
class TransportActions : public QObject {
  Q_OBJECT
public:
  explicit TransportActions(QObject* parent = nullptr);

  QAction* play;
  QAction* nextFrame;
  QAction* nextIteration;
  QAction* restart;
  QAction* restartNewSeed;
  QAction* showMask;
  QAction* lookFromAbove;
  QAction* lookFromFront;
  QAction* lookFree;
  QAction* openProject;
  QAction* openDemo;
  QAction* save;
  QAction* saveAs;
  QAction* exportTrajectory;
  QAction* themeSystem;
  QAction* themeLight;
  QAction* themeDark;
  QAction* quit;

  /// The play action says what a press would do now.
  void setPlaying(bool playing);
  /// Redraws all icons in the colors of a palette.
  void drawIcons(const QPalette& palette);
  /// Gives a foreign action (undo, redo) an icon that follows the palette too.
  void adopt(QAction* action, const QString& icon, const QKeySequence& shortcut);

private:
  QAction* add(const char* name, const QString& text, const QKeySequence& shortcut,
               const QString& hint, const char* icon = nullptr);
  void setIconName(QAction* action, const QString& icon);

  std::vector<std::pair<QAction*, QString>> icons_;
};

/// Tooltip of an action: its sentence and its shortcut.
QString tooltipWithShortcut(const QString& sentence, const QKeySequence& shortcut);

} // namespace dewpoint
