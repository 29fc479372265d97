// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QByteArray>
#include <QKeySequence>
#include <QString>
#include <QStringList>

#include <optional>

namespace dewpoint::ui {

/// Color theme of the window: as the system, or always light or dark.
enum class Theme { System, Light, Dark };

/// Settings for calibrating with a board, shared by all projects.
struct BoardPreferences {
  QString board;            ///< in the format of parseBoard(); empty: the default board
  int lensModel = 0;        ///< value of IntrinsicsModel
  bool lenses = true;       ///< whether intrinsics are calibrated
  bool places = true;       ///< whether positions are calibrated
  double lensAccuracy = 0;  ///< requested accuracy of the intrinsics, pixels
  double placeAccuracy = 0; ///< requested accuracy of the positions, as a share of the distance
};

/// Settings that the program stores for the user between sessions, with types; all keys are in one
/// file. The class has no state, so create one wherever it is needed; all instances return the same
/// values. Settings of a project are stored in the project.
class Preferences {
public:
  Theme theme() const;
  void setTheme(Theme theme);

  /// Two letters; empty: the language of the system.
  QString language() const;
  void setLanguage(const QString& language);

  /// Size and position of the window (QWidget::saveGeometry); empty before the first session.
  QByteArray windowGeometry() const;
  void setWindowGeometry(const QByteArray& geometry);

  /// Project files opened or saved last, newest first. `RecentProjects` checks whether they still
  /// exist.
  QStringList recentProjects() const;
  void addRecentProject(const QString& file);
  void clearRecentProjects();

  /// Folder of the file selected last; empty: none yet.
  QString lastFolder() const;
  void setLastFolder(const QString& folder);

  /// Number of threads of the filter from the next run on; 0: selected by core/session
  /// (base::filterThreads). The results do not depend on it.
  int filterThreads() const;
  void setFilterThreads(int threads);

  /// Whether a run is played iteration by iteration until every target is held (Pace).
  bool slowUntilHeld() const;
  void setSlowUntilHeld(bool slow);

  /// Shortcut that the user assigned to an action (an empty one: no shortcut); nothing: the default
  /// shortcut.
  std::optional<QKeySequence> shortcut(const QString& action) const;
  void setShortcut(const QString& action, const std::optional<QKeySequence>& shortcut);

  /// Ids of the plots shown; nothing: the user has not selected any yet.
  std::optional<QStringList> shownPlots() const;
  void setShownPlots(const QStringList& plots);
  bool plotsOverTime() const;
  void setPlotsOverTime(bool time);

  /// Returns the stored settings; `otherwise` provides values that were never set.
  BoardPreferences board(const BoardPreferences& otherwise) const;
  void setBoard(const BoardPreferences& board);
};

/// Returns the theme named "system", "light" or "dark"; `System` for an unknown name.
Theme themeFromName(const QString& name);
/// Returns the name of a theme, as `themeFromName()` reads it.
QString themeName(Theme theme);

} // namespace dewpoint::ui
