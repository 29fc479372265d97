// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/jobs/job_queue.h"

#include <QTextBrowser>

namespace dewpoint::ui {

/// Shows pages of Markdown with pictures and links. Links reach other pages and headings, by the
/// anchor names that GitHub uses. Pictures are never wider than the page and are read in another
/// thread. The desktop opens links to the web.
class ManualBrowser : public QTextBrowser {
  Q_OBJECT
public:
  explicit ManualBrowser(QWidget* parent = nullptr);

  /// Whether all requested pictures are loaded.
  bool hasPictures() const { return waiting_ == 0; }
  /// Anchor name of a heading: "12. Targets of any shape" → "12-targets-of-any-shape"
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
