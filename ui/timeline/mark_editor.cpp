// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/timeline/mark_editor.h"

#include "ui/document/document.h"

#include <QLineEdit>
#include <QWidget>

#include <algorithm>

namespace dewpoint::ui {

MarkEditor::MarkEditor(QWidget& timeline, Document& document)
    : QObject(&timeline), timeline_(timeline), document_(document),
      name_(new QLineEdit(&timeline)) {
  name_->setObjectName(QStringLiteral("markName"));
  name_->hide();
}

void MarkEditor::retranslate() {
  name_->setAccessibleName(tr("Name of the mark"));
}

void MarkEditor::add(qint64 frame) {
  const auto place = [frame](const Project& project) {
    return std::ranges::lower_bound(project.marks, frame, {}, &ProjectMark::frame);
  };
  const auto& marks = document_.project().marks;
  const auto there = place(document_.project());
  if (there == marks.end() || there->frame != frame) {
    const std::string name = tr("Mark %1").arg(marks.size() + 1).toStdString();
    (void)document_.edit(tr("Add a mark"), [&](Project& project) {
      project.marks.insert(project.marks.begin() + (place(project) - project.marks.begin()),
                           {frame, name});
    });
  }
}

bool MarkEditor::remove(qint64 frame) {
  const auto& marks = document_.project().marks;
  if (std::ranges::find(marks, frame, &ProjectMark::frame) == marks.end()) {
    return false;
  }
  (void)document_.edit(tr("Remove a mark"), [frame](Project& project) {
    std::erase_if(project.marks, [frame](const ProjectMark& mark) { return mark.frame == frame; });
  });
  return true;
}

void MarkEditor::editName(const ProjectMark& mark, const QRectF& flag) {
  const QString name = QString::fromStdString(mark.name);
  const int left =
      std::clamp(static_cast<int>(flag.left()), 0, std::max(0, timeline_.width() - 160));
  name_->setGeometry(left, 0, 160, name_->sizeHint().height());
  name_->disconnect(this);
  name_->setText(name);
  name_->selectAll();
  name_->show();
  name_->raise();
  name_->setFocus();
  connect(name_, &QLineEdit::editingFinished, this, [this, frame = mark.frame, name] {
    name_->disconnect(this);
    name_->hide();
    timeline_.setFocus();
    rename(frame, name, name_->text().trimmed());
  });
}

void MarkEditor::rename(qint64 frame, const QString& from, const QString& name) {
  if (name.isEmpty() || name == from) {
    return;
  }
  (void)document_.edit(tr("Rename a mark"), [&](Project& project) {
    const auto mark = std::ranges::find(project.marks, frame, &ProjectMark::frame);
    if (mark != project.marks.end()) {
      mark->name = name.toStdString();
    }
  });
}

} // namespace dewpoint::ui
