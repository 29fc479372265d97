// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QString>
#include <QWidget>

#include <functional>

class QTabWidget;

namespace dewpoint::ui {

/// Name of a widget property. A widget with this property is scrolled into view when it appears.
inline constexpr auto kRevealedProperty = "revealed";

/// Panel for calibrating cameras, with one page per method. The camera views next to it stay live.
class CalibrationDock : public QWidget {
  Q_OBJECT
public:
  explicit CalibrationDock(QWidget* parent = nullptr);

  /// Adds a page as a tab, in a scroll area. The objectName of the page identifies it. `title`
  /// returns the tab's title, and is called again when the language changes.
  void addPage(QWidget* page, const std::function<QString()>& title);
  /// Sets a widget that is shown above the tabs, whichever page is open.
  void setHeader(QWidget* header);
  /// Shows the page with this objectName.
  void showPage(const QString& name);
  /// Returns the objectName of the current page, or an empty string if there is none.
  QString shownPage() const;

Q_SIGNALS:
  /// Emitted when another page is shown, with the objectName of the page.
  void pageChanged(const QString& name);

protected:
  /// Makes the wheel scroll the page when the pointer is over a field without keyboard focus.
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  /// Adjusts the width to the widest page. Called after fields of a page may have been shown or
  /// hidden.
  void adjustWidth();

  QTabWidget* tabs_;
};

} // namespace dewpoint::ui
