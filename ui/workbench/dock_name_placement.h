// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QObject>

class QMainWindow;

namespace dewpoint::ui {

class ViewDock;

/// Shows the name of each view only once: in its tab if it has one, otherwise in its title.
class DockNamePlacement : public QObject {
  Q_OBJECT
public:
  DockNamePlacement(QMainWindow& window, QObject* parent);

  /// Starts to manage where the name of this dock is shown.
  void addDock(ViewDock* dock);
  /// Updates all docks once the layout has settled.
  void updateNamesSoon();

private:
  void show();

  QMainWindow& window_;
  bool isScheduled_ = false; ///< a call of show() is scheduled
};

} // namespace dewpoint::ui
