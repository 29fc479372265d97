// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QDialog>

class QLabel;
class QListWidget;
class QStackedWidget;
class QToolButton;

namespace dewpoint::ui {

class ManualBrowser;

/// Window of the manual: a list of pages beside the current page. Not modal. If the folder is
/// missing, it shows where the folder should be.
class ManualWindow : public QDialog {
  Q_OBJECT
public:
  /// `folder`: folder of the pages; empty: not found, and the window shows `expected` instead.
  ManualWindow(const QString& folder, const QString& expected, QWidget* parent);

  /// Shows a page ("window.md", "window.md#correct-position").
  void showPage(const QString& page);
  /// File name of the page shown; empty if there is none.
  QString shownPage() const;

protected:
  void changeEvent(QEvent* event) override;

private:
  void retranslateUi();
  void fillList();
  /// Selects a page in the list.
  void choose(const QString& page);
  void drawIcons();

  QString folder_;
  QString expected_;
  QListWidget* list_;
  ManualBrowser* text_;
  QToolButton* back_;
  QToolButton* forward_;
  QLabel* missing_;
};

} // namespace dewpoint::ui
