// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/jobs/job_queue.h"

#include <QTextBrowser>

namespace dewpoint::ui {

/// Shows Markdown pages with images and links. Links lead to other pages and headings and use the
/// same anchor names as GitHub. Images are never wider than the page and are read in another
/// thread. Web links open in the default browser.
class ManualBrowser : public QTextBrowser {
  Q_OBJECT
public:
  explicit ManualBrowser(QWidget* parent = nullptr);

  /// Returns whether all requested images are loaded.
  bool hasLoadedImages() const { return waiting_ == 0; }
  /// Returns the anchor name of a heading, for example "12-targets-of-any-shape" for "12. Targets
  /// of any shape".
  static QString slugOf(const QString& heading);

protected:
  void doSetSource(const QUrl& url, QTextDocument::ResourceType type) override;
  QVariant loadResource(int type, const QUrl& name) override;

private:
  /// Sets the spacing around headings and in tables.
  void layOutPage();
  void scrollToHeading(const QString& slug);

  JobQueue pictures_;
  int waiting_ = 0;
};

} // namespace dewpoint::ui
