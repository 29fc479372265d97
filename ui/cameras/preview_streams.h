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

/// State of a preview: its image, or the reason why there is none.
struct PreviewState {
  QImage image;
  QSize size;                   ///< size of the images that the source sends, pixels
  double framesPerSecond = 0.0; ///< measured; 0 while it is not known
  QString problem; ///< reason why there is no image, as one sentence; empty while images arrive
};

/// Reads small images from several live sources for previews, a few images per second. Each source
/// is opened, read and closed in a thread of its own. If a source cannot be opened, another attempt
/// follows every two seconds.
class PreviewStreams : public QObject {
  Q_OBJECT
public:
  explicit PreviewStreams(QObject* parent = nullptr);
  ~PreviewStreams() override; ///< closes all sources without waiting for this to finish

  /// Sets the sources to read: opens new sources, and closes all that are not in `locations`.
  void setLocations(const QSet<QString>& locations);
  /// Returns the state of the preview of a source; null if the source is not being read.
  const PreviewState* previewState(const QString& location) const;

Q_SIGNALS:
  void changed(const QString& location);

private:
  struct Stream {
    std::stop_source stopSource;
    PreviewState state;
  };
  void open(const QString& location);

  JobMailbox mailbox_;
  std::map<QString, Stream> streams_;
};

} // namespace dewpoint::ui
