// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QObject>

namespace dewpoint::ui {

/// Monitors whether the system colors are dark, including when the user changes them while the
/// program runs.
class SystemColors : public QObject {
  Q_OBJECT
public:
  explicit SystemColors(QObject* parent = nullptr);

  bool isDark() const { return dark_; }

Q_SIGNALS:
  void changed(bool dark);
  /// Emitted when the application colors were replaced from outside. A theme must then be applied
  /// again.
  void replaced();

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  void readColors();

  bool dark_;
  bool refreshing_ = false;
};

} // namespace dewpoint::ui
