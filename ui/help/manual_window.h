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

/// The manual: a list of its pages beside the page that is read. Not modal. When its folder is not
/// there it says so, and where it should be.
class ManualWindow : public QDialog {
  Q_OBJECT
public:
  /// `folder`: where the pages are; empty: not found, and `expected` is said instead.
  ManualWindow(const QString& folder, const QString& expected, QWidget* parent);

  /// Shows a page ("window.md", "window.md#it-is-here").
  void showPage(const QString& page);
  /// The file name of the page that is shown; empty while there is none.
  QString shownPage() const;

protected:
  void changeEvent(QEvent* event) override;

private:
  void retranslateUi();
  void fillList();
  /// In the list.
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
