// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/style/theme.h"

#include <QWidget>

class QDockWidget;
class QLabel;
class QToolButton;

namespace dewpoint::ui {

class ElidedLabel;

/// Title of a dock: its name, the state of what it shows (word, shape and color), and a button to
/// float it. A double click maximizes it; then a button with a word gives the other views back.
class DockTitle : public QWidget {
  Q_OBJECT
public:
  explicit DockTitle(QDockWidget* dock);

  /// Whether the name is shown: not where a tab above has it.
  void setNameShown(bool shown);
  void setState(HoldState state);
  /// Why the state is what it is, in a few words; empty: nothing to say.
  void setReason(const QString& reason);
  /// The same in place of the state, in the color of a target that is not seen.
  void setReasonAlone(const QString& reason);
  /// Adds a widget (a small tool button) before the float button.
  void addTool(QWidget* tool);
  /// Whether the dock fills the window.
  void setMaximized(bool maximized);

Q_SIGNALS:
  /// The whole window is wanted for the dock, or no longer.
  void maximizeWanted();
  /// The dock is wanted in a window of its own, or back in its place.
  void floatWanted();

protected:
  void changeEvent(QEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

private:
  void applyPalette();
  void showReason(const QString& reason, bool alone);

  QDockWidget* dock_;
  QLabel* name_;
  QLabel* state_;
  ElidedLabel* reason_;
  QToolButton* restore_; ///< while the dock fills the window
  QToolButton* float_;
  HoldState shown_ = HoldState::NoImages;
  bool stateful_ = false;
  bool reasonAlone_ = false;
};

} // namespace dewpoint::ui
