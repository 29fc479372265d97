// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/jobs/job_queue.h"

#include <QTextBrowser>

namespace dewpoint::ui {

/// Shows pages of Markdown, with links to each other and to their headings as on the web (GitHub's
/// names), and pictures no wider than a page; these are read beside the window. Links to the web
/// are opened by the desktop.
class ManualBrowser : public QTextBrowser {
  Q_OBJECT
public:
  explicit ManualBrowser(QWidget* parent = nullptr);

  /// Whether all pictures asked for are there.
  bool hasPictures() const { return waiting_ == 0; }
  /// The name by which links find a heading: "12. Targets of any shape" → "12-targets-of-any-shape"
  static QString slugOf(const QString& heading);

protected:
  void doSetSource(const QUrl& url, QTextDocument::ResourceType type) override;
  QVariant loadResource(int type, const QUrl& name) override;

private:
  /// Room around headings and in tables.
  void layOutPage();
  void scrollToHeading(const QString& slug);

  JobQueue pictures_;
  int waiting_ = 0;
};

} // namespace dewpoint::ui
