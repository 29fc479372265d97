// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/workbench/workbench.h"

#include <filesystem>
#include <functional>

namespace dewpoint::ui {

class ProjectSaver;

/// Saves the project, asking where to when it has no file yet, and asks before unsaved changes are
/// lost.
class ChangesGuard : public QObject {
  Q_OBJECT
public:
  explicit ChangesGuard(const Workbench& bench, QObject* parent = nullptr);

  ProjectSaver& saver() { return *saver_; }
  /// Asks about unsaved changes. True: go on. False: not now; `then` runs once they are saved, if
  /// that was the answer.
  bool mayDiscard(const std::function<void()>& then);
  /// Runs `next` as soon as nothing unsaved is lost by it.
  void whenSettled(const std::function<void()>& next);

Q_SIGNALS:
  /// The project is in this file.
  void saved(const QString& file);

private:
  void connectSaver();
  void save();
  void askSaveAs();
  void saveTo(std::filesystem::path file); ///< by value: it may be the project's own

  Workbench bench_;
  ProjectSaver* saver_;
  std::function<void()> afterSaving_; ///< what waits until the project is in its file
};

} // namespace dewpoint::ui
