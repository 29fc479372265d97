// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/snapshot/snapshot.h"
#include "ui/jobs/latest_job.h"

#include <QObject>
#include <QRectF>

namespace dewpoint::ui {

class Document;

/// Sets the bounding box of a target where the user points in an image, for methods that track
/// boxes. A dragged box is used unchanged. For a click, `boxFromClick()` finds the region that
/// stands out at this pixel, in another thread. The result is an undoable step of the document.
class BoxPicker : public QObject {
  Q_OBJECT
public:
  explicit BoxPicker(Document& document, QObject* parent = nullptr);

  /// Sets the index of the target that gets the box; -1 for a new target.
  void setTarget(int target) { target_ = target; }
  /// Handles a click (`region` has an empty size) or a dragged box in a camera image of this
  /// snapshot. Pixel centers lie at integer coordinates.
  void pick(const TrackSnapshotPtr& snapshot, int camera, const QRectF& region);

Q_SIGNALS:
  /// Emitted when a target has received its box. `isFirst` is true if the target had no box before.
  void boxDefined(int target, bool isFirst);
  void failed(const QString& sentence);

private:
  void applyResult(int target, const TargetBox& box);

  Document& document_;
  int target_ = 0;
  LatestJob job_{LatestJob::SupersededJob::Dropped};
};

} // namespace dewpoint::ui
