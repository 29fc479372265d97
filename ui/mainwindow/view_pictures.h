// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/jobs/job_queue.h"
#include "ui/workbench/workbench.h"

#include <QImage>

namespace dewpoint::ui {

class ViewDock;

/// Saves pictures of views as files or to the clipboard: from the title menu of each dock, and
/// through an action for all docks.
class ViewPictures : public QObject {
  Q_OBJECT
public:
  /// Handles all docks that are created from now on.
  explicit ViewPictures(const Workbench& bench);

  /// Writes a picture as PNG in another thread; the message bar shows the result.
  void write(const QImage& picture, const QString& file);

private:
  void addMenu(ViewDock* dock);
  void choose();
  void save(ViewDock* dock);

  Workbench bench_;
  JobQueue files_;
};

} // namespace dewpoint::ui
