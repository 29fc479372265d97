// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QObject>

class QMainWindow;

namespace dewpoint::ui {

class ViewDock;

/// Lets the name of each view stand once: in its tab where it has one, else in its title.
class DockNames : public QObject {
  Q_OBJECT
public:
  DockNames(QMainWindow& window, QObject* parent);

  /// Takes care of a dock from now on.
  void follow(ViewDock* dock);
  /// Looks at all docks once the layout has settled.
  void showSoon();

private:
  void show();

  QMainWindow& window_;
  bool isComing_ = false; ///< show() is about to
};

} // namespace dewpoint::ui
