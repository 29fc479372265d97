// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/jobs/job_queue.h"
#include "ui/workbench/workbench.h"

#include <QImage>

namespace dewpoint::ui {

class ViewDock;

/// Saves images of views to files or the clipboard, from the title menu of each dock and through an
/// action for all docks.
class ViewPictures : public QObject {
  Q_OBJECT
public:
  /// Creates an object that handles all docks created from now on.
  explicit ViewPictures(const Workbench& bench);

  /// Writes an image to a PNG file in another thread. The message bar shows whether this succeeded.
  void write(const QImage& picture, const QString& file);

private:
  void addMenu(ViewDock* dock);
  void choose();
  void save(ViewDock* dock);

  Workbench bench_;
  JobQueue files_;
};

} // namespace dewpoint::ui
