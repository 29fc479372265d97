// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/jobs/job_thread.h"

#include <QImage>
#include <QObject>
#include <QSet>
#include <QSize>
#include <QString>

#include <map>
#include <memory>
#include <stop_token>

namespace dewpoint::ui {

/// What a preview shows: an image, or why there is none.
struct PreviewState {
  QImage image;
  QSize size;                   ///< of the images as the source sends them, pixels
  double framesPerSecond = 0.0; ///< measured; 0 while it is not known
  QString problem;              ///< one sentence; empty while the source delivers
};

/// Shows small images of several live sources, a few each second. Each source is opened, read and
/// closed in a thread of its own. A source that cannot be opened is tried again every two seconds.
class PreviewStreams : public QObject {
  Q_OBJECT
public:
  explicit PreviewStreams(QObject* parent = nullptr);
  ~PreviewStreams() override; ///< closes all, without waiting for them

  /// Shows exactly these sources: opens those that are new and closes the others.
  void show(const QSet<QString>& locations);
  /// Returns what is known of a source; null if it is not shown.
  const PreviewState* state(const QString& location) const;

Q_SIGNALS:
  void changed(const QString& location);

private:
  struct Stream {
    std::stop_source stop;
    PreviewState state;
  };
  void open(const QString& location);

  JobMailbox mailbox_;
  std::map<QString, Stream> streams_;
};

} // namespace dewpoint::ui
