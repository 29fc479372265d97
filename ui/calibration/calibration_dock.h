// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QString>
#include <QWidget>

#include <functional>

class QTabWidget;

namespace dewpoint::ui {

/// A widget with this property is scrolled into view when it appears.
inline constexpr auto kRevealed = "revealed";

/// Where cameras are calibrated: a panel beside the views, which stay live, with one page for each
/// way to do it.
class CalibrationDock : public QWidget {
  Q_OBJECT
public:
  explicit CalibrationDock(QWidget* parent = nullptr);

  /// Adds a page as a tab, in a scroll area; `title` is called again when the language changes. The
  /// page's objectName tells it from others.
  void addPage(QWidget* page, const std::function<QString()>& title);
  /// Shows the page with this objectName.
  void showPage(const QString& name);
  /// The objectName of the page that is shown; empty when there is none.
  QString shownPage() const;

Q_SIGNALS:
  /// Another page is shown.
  void pageChanged(const QString& name);

protected:
  /// Turning the wheel over a field scrolls the page, unless the field has the focus.
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  /// For the widest page, whose fields may have come or gone.
  void makeWideEnough();

  QTabWidget* tabs_;
};

} // namespace dewpoint::ui
