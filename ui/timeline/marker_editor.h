// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

#include <QObject>
#include <QRectF>

class QLineEdit;
class QWidget;

namespace dewpoint::ui {

class Document;

/// Changes the markers of the project, each time as an undoable step, and edits their names on the
/// spot in the timeline.
class MarkerEditor : public QObject {
  Q_OBJECT
public:
  MarkerEditor(QWidget& timeline, Document& document);

  /// Adds a marker at a frame that has none.
  void add(qint64 frame);
  /// Removes the marker at a frame; false when there is none.
  bool remove(qint64 frame);
  /// Edits the name of a marker where its flag lies in the timeline.
  void editName(const ProjectMarker& marker, const QRectF& flag);
  void retranslate();

private:
  void rename(qint64 frame, const QString& from, const QString& name);

  QWidget& timeline_;
  Document& document_;
  QLineEdit* name_;
};

} // namespace dewpoint::ui
