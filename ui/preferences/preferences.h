// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QByteArray>
#include <QKeySequence>
#include <QString>
#include <QStringList>

#include <optional>

namespace dewpoint::ui {

/// Color theme of the window: same as the system, or always light or dark.
enum class Theme { System, Light, Dark };

/// Settings for board calibration, shared by all projects.
struct BoardPreferences {
  QString boardText;                 ///< in the format of parseBoard(); empty for the default board
  int lensModel = 0;                 ///< value of IntrinsicsModel
  bool calibratesIntrinsics = true;  ///< whether intrinsics are calibrated
  bool calibratesPositions = true;   ///< whether the camera positions are calibrated
  double intrinsicsAccuracyPx = 0;   ///< requested accuracy of the intrinsics, pixels
  double positionAccuracyMeters = 0; ///< requested standard deviation of the camera positions
};

/// Typed settings that the program stores for the user between sessions. All keys are in one file.
/// The class has no state, so create one wherever it is needed; all instances return the same
/// values. Settings of a project are stored in the project.
class Preferences {
public:
  Theme theme() const;
  void setTheme(Theme theme);

  /// Returns the two-letter code of the window's language; empty for the system language.
  QString language() const;
  void setLanguage(const QString& language);

  /// Returns the window size and position (QWidget::saveGeometry); empty before the first session.
  QByteArray windowGeometry() const;
  void setWindowGeometry(const QByteArray& geometry);

  /// Returns the most recently opened or saved project files, newest first. `RecentProjects` checks
  /// whether they still exist.
  QStringList recentProjects() const;
  void addRecentProject(const QString& file);
  void clearRecentProjects();

  /// Returns the folder of the last selected file, or an empty string if there is none.
  QString lastFolder() const;
  void setLastFolder(const QString& folder);

  /// Returns the number of filter threads, used from the next run on; 0: a number that suits the
  /// computer (base::threadCountForFilter). The results do not depend on this number.
  int filterThreadCount() const;
  void setFilterThreadCount(int threads);

  /// Returns whether a run is played iteration by iteration until the cameras confirm every target
  /// (Pace::slowUntilTracking).
  bool isSlowUntilTracking() const;
  void setSlowUntilTracking(bool slow);

  /// Returns the pre-roll of takes (recordings of all cameras): how many seconds before the start
  /// are also recorded; 0: none.
  int preRollSeconds() const;
  void setPreRollSeconds(int seconds);

  /// Returns whether exported files contain notes about the run.
  bool exportsNotes() const;
  void setExportsNotes(bool notes);

  /// Returns the shortcut that the user assigned to an action; empty if the user removed the
  /// shortcut. Returns nothing if the action has its default shortcut.
  std::optional<QKeySequence> shortcut(const QString& action) const;
  void setShortcut(const QString& action, const std::optional<QKeySequence>& shortcut);

  /// Returns the ids of the plots shown, or nothing if the user has not selected any yet.
  std::optional<QStringList> shownPlots() const;
  void setShownPlots(const QStringList& plots);
  bool showsPlotsOverTime() const;
  void setShowsPlotsOverTime(bool time);

  /// Returns the stored settings for board calibration. `otherwise` provides values that were never
  /// set.
  BoardPreferences boardPreferences(const BoardPreferences& otherwise) const;
  void setBoardPreferences(const BoardPreferences& board);
};

/// Returns the theme with this name ("system", "light" or "dark"); `System` for an unknown name.
Theme themeFromName(const QString& name);
/// Returns the name of a theme, in the form that `themeFromName()` reads.
QString themeName(Theme theme);

} // namespace dewpoint::ui
