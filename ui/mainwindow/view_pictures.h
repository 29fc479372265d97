// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/jobs/job_queue.h"
#include "ui/workbench/workbench.h"

#include <QImage>

namespace dewpoint::ui {

class ViewDock;

/// Pictures of views, as files or on the clipboard: from the menu of each dock's title, and for all
/// by an action.
class ViewPictures : public QObject {
  Q_OBJECT
public:
  /// Takes care of all docks that are made from now on.
  explicit ViewPictures(const Workbench& bench);

  /// Writes a picture as PNG beside the window; the message bar shows how it went.
  void write(const QImage& picture, const QString& file);

private:
  void addMenu(ViewDock* dock);
  void choose();
  void save(ViewDock* dock);

  Workbench bench_;
  JobQueue files_;
};

} // namespace dewpoint::ui
