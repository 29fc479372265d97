// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QListWidget>

namespace dewpoint::ui {

class RecentProjects;

/// List of recent projects, each with a thumbnail, name, folder and date. Projects whose files are
/// missing are gray, show the reason and cannot be opened. The list is as tall as its rows, because
/// the page scrolls.
class RecentList : public QListWidget {
  Q_OBJECT
public:
  RecentList(RecentProjects& projects, QWidget* parent);

  /// Refills the list of projects.
  void fill();

Q_SIGNALS:
  void openRequested(const QString& file);

protected:
  void changeEvent(QEvent* event) override;

private:
  RecentProjects& projects_;
};

} // namespace dewpoint::ui
