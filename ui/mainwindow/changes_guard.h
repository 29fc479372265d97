// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/workbench/workbench.h"

#include <filesystem>
#include <functional>

namespace dewpoint::ui {

class ProjectSaver;

/// Saves the project, asking for a file if it has none, and asks before unsaved changes are lost.
class ChangesGuard : public QObject {
  Q_OBJECT
public:
  explicit ChangesGuard(const Workbench& bench, QObject* parent = nullptr);

  ProjectSaver& saver() { return *saver_; }
  /// Asks the user about unsaved changes, and returns whether they may be discarded. If the user
  /// chooses to save, returns false, and `then` runs once the changes are saved.
  bool confirmDiscard(const std::function<void()>& then);
  /// Runs `next` immediately if there are no unsaved changes or the user discards them. If the user
  /// chooses to save, runs it after the changes are saved.
  void runAfterSaveOrDiscard(const std::function<void()>& next);

Q_SIGNALS:
  /// Emitted when the project was saved to this file.
  void saved(const QString& file);

private:
  void connectSaver();
  void save();
  void askSaveAs();
  void saveTo(std::filesystem::path file); ///< by value, because it may be the project's own path

  Workbench bench_;
  ProjectSaver* saver_;
  std::function<void()> afterSaving_; ///< runs once the project is saved
};

} // namespace dewpoint::ui
