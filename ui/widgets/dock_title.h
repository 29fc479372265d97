// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/style/theme.h"

#include <QWidget>

class QDockWidget;
class QLabel;
class QToolButton;

namespace dewpoint::ui {

class ElidedLabel;

/// Title of a dock: its name, the state of its content (word, shape and color), and a button to
/// float it. A double click maximizes the dock; a text button then restores the other views.
class DockTitle : public QWidget {
  Q_OBJECT
public:
  explicit DockTitle(QDockWidget* dock);

  /// Sets whether the name is shown. It is hidden if a tab above already shows it.
  void setNameShown(bool shown);
  void setState(TrackingState state);
  /// Sets the reason, in a few words, for the state shown (for example why a target is not
  /// tracked). An empty string removes the reason.
  void setReason(const QString& reason);
  /// Shows a reason (such as "hidden here") instead of the state of the target, in the color used
  /// for a target that is not seen.
  void showReasonInsteadOfState(const QString& reason);
  /// Adds a widget (a small tool button) before the button that floats the dock.
  void addTool(QWidget* tool);
  /// Sets whether the dock fills the window.
  void setMaximized(bool maximized);

  /// Returns a width at which only parts of the texts are visible.
  QSize minimumSizeHint() const override;

Q_SIGNALS:
  /// Emitted when the user wants to maximize the dock or restore the other views.
  void maximizeRequested();
  /// Emitted when the user wants to float the dock or put it back.
  void floatRequested();

protected:
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

private:
  void applyPalette();
  /// Keeps the whole name visible as long as there is room for the sign of the state.
  void fitName();
  void showReason(const QString& reason, bool alone);

  QDockWidget* dock_;
  QLabel* name_;
  QLabel* state_;
  ElidedLabel* reason_;
  QToolButton* restore_; ///< visible while the dock fills the window
  QToolButton* float_;
  TrackingState shown_ = TrackingState::NoImages;
  bool stateful_ = false;
  bool reasonAlone_ = false;
};

} // namespace dewpoint::ui
