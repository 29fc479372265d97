// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QWidget>

class QLabel;
class QListWidget;
class QToolButton;

namespace dewpoint::ui {

class RecentProjects;

/// What the user sees while no project is open: the ways to begin, and where they were last.
class StartPage : public QWidget {
  Q_OBJECT
public:
  explicit StartPage(RecentProjects& recent, QWidget* parent = nullptr);

  /// Reads the list of recent projects again, and finds out which of them are still there.
  void refresh();

Q_SIGNALS:
  void demoWanted();
  void videosWanted();
  void camerasWanted();
  void projectWanted(const QString& file); ///< empty: to be chosen

protected:
  void changeEvent(QEvent* event) override;

private:
  QToolButton* addChoice(const char* name, const QString& icon);
  void retranslateUi();
  void drawIcons();
  void list();

  RecentProjects& projects_;
  QLabel* title_;
  QLabel* lead_;
  QWidget* choices_;
  std::vector<std::pair<QToolButton*, QString>> buttons_;
  QLabel* recentTitle_;
  QListWidget* recent_;
  QLabel* hint_;
};

} // namespace dewpoint::ui
