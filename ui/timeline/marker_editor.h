// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

#include <QObject>
#include <QRectF>

class QLineEdit;
class QWidget;

namespace dewpoint::ui {

class Document;

/// Changes the project's markers, each change in an undoable step, and edits their names in place
/// in the timeline.
class MarkerEditor : public QObject {
  Q_OBJECT
public:
  MarkerEditor(QWidget& timeline, Document& document);

  /// Adds a marker at a frame that has no marker.
  void add(qint64 frame);
  /// Removes the marker at a frame. Returns false if there is none.
  bool remove(qint64 frame);
  /// Edits a marker's name in place, at its flag in the timeline (widget coordinates).
  void editName(const ProjectMarker& marker, const QRectF& flag);
  void retranslateUi();

private:
  void rename(qint64 frame, const QString& from, const QString& name);

  QWidget& timeline_;
  Document& document_;
  QLineEdit* name_;
};

} // namespace dewpoint::ui
