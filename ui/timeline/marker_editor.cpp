// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/timeline/marker_editor.h"

#include "ui/document/document.h"

#include <QLineEdit>
#include <QWidget>

#include <algorithm>

namespace dewpoint::ui {

MarkerEditor::MarkerEditor(QWidget& timeline, Document& document)
    : QObject(&timeline), timeline_(timeline), document_(document),
      name_(new QLineEdit(&timeline)) {
  name_->setObjectName(QStringLiteral("markName"));
  name_->hide();
}

void MarkerEditor::retranslateUi() {
  name_->setAccessibleName(tr("Name of the marker"));
}

void MarkerEditor::add(qint64 frame) {
  const auto place = [frame](const Project& project) {
    return std::ranges::lower_bound(project.markers, frame, {}, &ProjectMarker::frame);
  };
  const auto& markers = document_.project().markers;
  const auto there = place(document_.project());
  if (there == markers.end() || there->frame != frame) {
    const std::string name = tr("Marker %1").arg(markers.size() + 1).toStdString();
    (void)document_.edit(tr("Add a marker"), [&](Project& project) {
      project.markers.insert(project.markers.begin() + (place(project) - project.markers.begin()),
                             {frame, name});
    });
  }
}

bool MarkerEditor::remove(qint64 frame) {
  const auto& markers = document_.project().markers;
  if (std::ranges::find(markers, frame, &ProjectMarker::frame) == markers.end()) {
    return false;
  }
  (void)document_.edit(tr("Remove a marker"), [frame](Project& project) {
    std::erase_if(project.markers,
                  [frame](const ProjectMarker& marker) { return marker.frame == frame; });
  });
  return true;
}

void MarkerEditor::editName(const ProjectMarker& marker, const QRectF& flag) {
  const QString name = QString::fromStdString(marker.name);
  const int left =
      std::clamp(static_cast<int>(flag.left()), 0, std::max(0, timeline_.width() - 160));
  name_->setGeometry(left, 0, 160, name_->sizeHint().height());
  name_->disconnect(this);
  name_->setText(name);
  name_->selectAll();
  name_->show();
  name_->raise();
  name_->setFocus();
  connect(name_, &QLineEdit::editingFinished, this, [this, frame = marker.frame, name] {
    name_->disconnect(this);
    name_->hide();
    timeline_.setFocus();
    rename(frame, name, name_->text().trimmed());
  });
}

void MarkerEditor::rename(qint64 frame, const QString& from, const QString& name) {
  if (name.isEmpty() || name == from) {
    return;
  }
  (void)document_.edit(tr("Rename a marker"), [&](Project& project) {
    const auto marker = std::ranges::find(project.markers, frame, &ProjectMarker::frame);
    if (marker != project.markers.end()) {
      marker->name = name.toStdString();
    }
  });
}

} // namespace dewpoint::ui
