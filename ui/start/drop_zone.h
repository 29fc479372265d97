// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QToolButton>

namespace dewpoint::ui {

/// Area that shows where videos can be dropped, while the new project has none. A click opens a
/// file dialog for videos. The window, not this widget, handles the drop.
class DropZone : public QToolButton {
  Q_OBJECT
public:
  explicit DropZone(QWidget* parent = nullptr);

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return sizeHint(); }

protected:
  void paintEvent(QPaintEvent* event) override;
  void changeEvent(QEvent* event) override;

private:
  void retranslateUi();

  QString line_;
};

} // namespace dewpoint::ui
