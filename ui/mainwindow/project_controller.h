// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/workbench/workbench.h"

#include <filesystem>

class QMenu;
class QMimeData;
class QStackedWidget;

namespace dewpoint::project {
struct Project;
} // namespace dewpoint::project

namespace dewpoint::ui {

class NewProjectPage;
class Recovery;
class RecoveryOffer;
class StartPage;

/// How work begins and ends: the pages in the middle of the window, opening, saving and closing
/// projects, recent ones, dropped files, and what is asked before unsaved changes go.
class ProjectController : public QObject {
  Q_OBJECT
public:
  /// Makes the pages, as the central widget of the window.
  explicit ProjectController(const Workbench& bench);

  /// Opens a project in the background; empty path: the demo.
  void open(const std::filesystem::path& file);
  /// Shows the start page.
  void showStart();
  /// Keeps unsaved work in this folder, and offers what an earlier window left there.
  void useRecovery(const std::filesystem::path& folder);
  /// Whether the window may close. The copy of what was given up goes.
  bool mayClose();
  void fillRecentMenu(QMenu* menu);
  /// Whether there is anything that could be opened.
  static bool canDrop(const QMimeData& data);
  void drop(const QMimeData& data);

private:
  void makePages();
  void connectPages();
  void connectActions();
  void connectRun();
  void beginNew(const QStringList& files);
  void openMade(const Project& project, const QString& note);
  void askOpen();
  void askSaveAs();
  void save();
  void saveTo(std::filesystem::path file);
  void close();
  bool mayDiscard();

  Workbench bench_;
  QStackedWidget* pages_ = nullptr;
  StartPage* startPage_ = nullptr;
  NewProjectPage* newProject_ = nullptr;
  RecoveryOffer* recovery_ = nullptr;
};

} // namespace dewpoint::ui
