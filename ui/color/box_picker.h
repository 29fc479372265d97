// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/run/snapshot.h"
#include "ui/jobs/latest_job.h"

#include <QObject>
#include <QRectF>

namespace dewpoint::ui {

class Document;

/// Gives a target its box, from where the user points, for the methods that follow boxes: a dragged
/// one as it is, for a click the box around what stands out there (boxFromClick(), in a thread).
/// What comes out is an undoable step of the document.
class BoxPicker : public QObject {
  Q_OBJECT
public:
  explicit BoxPicker(Document& document, QObject* parent = nullptr);

  /// Index of the target that gets the box; -1: a new one.
  void setTarget(int target) { target_ = target; }
  /// A click (an empty size) or a box in the image of a camera of this snapshot; pixels whose
  /// centers lie at whole numbers.
  void point(const TrackSnapshotPtr& snapshot, int camera, const QRectF& region);

Q_SIGNALS:
  /// A target has the box; `isFirst`: it had none before.
  void learned(int target, bool isFirst);
  void failed(const QString& sentence);

private:
  void applyResult(int target, const TargetBox& box);

  Document& document_;
  int target_ = 0;
  LatestJob looking_{LatestJob::Overtaken::Dropped};
};

} // namespace dewpoint::ui
