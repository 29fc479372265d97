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

/// Manual window: a list of pages next to the current page. Not modal. If the folder with the pages
/// is missing, the window shows where it should be.
class ManualWindow : public QDialog {
  Q_OBJECT
public:
  /// Creates the window. `folder` is the folder with the pages. If `folder` is empty, the window
  /// shows `expected`, the folder where the pages should be.
  ManualWindow(const QString& folder, const QString& expected, QWidget* parent);

  /// Shows a page ("window.md") or a heading in it ("window.md#correct-position").
  void showPage(const QString& page);
  /// Returns the file name of the page shown, or an empty string if there is none.
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
