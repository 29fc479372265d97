// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QListWidget>

namespace dewpoint::ui {

class RecentProjects;

/// The projects that were open last, with a small picture, name, folder and date each. Those whose
/// file is gone are gray, with the reason, and cannot be opened. As high as its rows: the page
/// scrolls.
class RecentList : public QListWidget {
  Q_OBJECT
public:
  RecentList(RecentProjects& projects, QWidget* parent);

  /// Lists them again.
  void fill();

Q_SIGNALS:
  void wanted(const QString& file);

protected:
  void changeEvent(QEvent* event) override;

private:
  RecentProjects& projects_;
};

} // namespace dewpoint::ui
