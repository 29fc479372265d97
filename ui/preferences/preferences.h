// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QByteArray>
#include <QKeySequence>
#include <QString>
#include <QStringList>

#include <optional>

namespace dewpoint::ui {

/// Colors of the window: those of the system, or always light or dark ones.
enum class Theme { System, Light, Dark };

/// The user's settings for calibrating with a board, from project to project.
struct BoardPreferences {
  QString board;            ///< as parseBoard() reads it; empty: the program's own
  int lensModel = 0;        ///< IntrinsicsModel
  bool lenses = true;       ///< lenses are to be found,
  bool places = true;       ///< and positions
  double lensAccuracy = 0;  ///< pixels
  double placeAccuracy = 0; ///< share of the distance
};

/// Everything the program remembers of the user from one start to the next: typed, and with all
/// keys in one file. It has no state of its own, so one is made wherever it is needed; all of a
/// program say the same. What belongs to a project is in the project.
class Preferences {
public:
  Theme theme() const;
  void setTheme(Theme theme);

  /// Two letters; empty: the system's.
  QString language() const;
  void setLanguage(const QString& language);

  /// Size and position of the window (QWidget::saveGeometry); empty at the first start.
  QByteArray windowGeometry() const;
  void setWindowGeometry(const QByteArray& geometry);

  /// Project files that were opened or saved last, the newest first; whether they are still
  /// there, RecentProjects finds out.
  QStringList recentProjects() const;
  void addRecentProject(const QString& file);
  void clearRecentProjects();

  /// The folder in which a file was chosen last; empty: none yet.
  QString lastFolder() const;
  void setLastFolder(const QString& folder);

  /// How many threads the filter uses from the next run on; 0: as core/session chooses
  /// (base::filterThreads). Results are the same with any number.
  int filterThreads() const;
  void setFilterThreads(int threads);

  /// Whether a run is played iteration by iteration until every target is held (Pace).
  bool slowUntilHeld() const;
  void setSlowUntilHeld(bool slow);

  /// A shortcut that was chosen for an action (an empty one: none); nothing: as declared.
  std::optional<QKeySequence> shortcut(const QString& action) const;
  void setShortcut(const QString& action, const std::optional<QKeySequence>& shortcut);

  /// Ids of the plots that are shown; nothing: none were chosen yet.
  std::optional<QStringList> shownPlots() const;
  void setShownPlots(const QStringList& plots);
  bool plotsOverTime() const;
  void setPlotsOverTime(bool time);

  /// `otherwise` stands in for what was never set.
  BoardPreferences board(const BoardPreferences& otherwise) const;
  void setBoard(const BoardPreferences& board);
};

/// "system", "light" or "dark"; an unknown name is the system's.
Theme themeFromName(const QString& name);
QString themeName(Theme theme);

} // namespace dewpoint::ui
