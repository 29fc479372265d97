// SPDX-License-Identifier: GPL-3.0-or-later
// The marks of a timeline: steps of the document, named on the spot.
#include "ui/document/document.h"
#include "ui/text/retranslation.h"
#include "ui/timeline/timeline.h"

#include <QAccessible>
#include <QLineEdit>
#include <QLocale>

#include <algorithm>

namespace dewpoint::ui {

Timeline::Timeline(Selection& selection, Document& document, QWidget* parent)
    : QWidget(parent), selection_(selection), document_(document), editor_(new QLineEdit(this)) {
  setObjectName(QStringLiteral("timeline"));
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  editor_->setObjectName(QStringLiteral("markName"));
  editor_->hide();
  onRetranslate(this, [this] {
    setAccessibleName(tr("Timeline"));
    editor_->setAccessibleName(tr("Name of the mark"));
    update();
  });
  connect(&selection_, &Selection::momentChanged, this, [this] {
    sayMoment();
    update();
  });
  connect(&selection_, &Selection::spanChanged, this, qOverload<>(&QWidget::update));
  connect(&document_, &Document::changed, this, &Timeline::takeMarks);
  connect(&document_, &Document::replaced, this, &Timeline::takeMarks);
  takeMarks();
}

void Timeline::sayMoment() {
  if (QAccessible::isActive()) { // nobody else hears it
    const qint64 moment = selection_.moment();
    setAccessibleDescription(moment < 0 ? QString() : model_.describe(moment));
  }
}

void Timeline::takeMarks() {
  model_.marks = document_.project().marks;
  update();
}

std::optional<std::size_t> Timeline::markAt(const QPointF& point) const {
  const QFontMetricsF metrics(font());
  for (std::size_t k = model_.marks.size(); k-- > 0;) {
    if (markFlag(model_.marks[k], scale_, rows(), metrics).contains(point)) {
      return k;
    }
  }
  return std::nullopt;
}

void Timeline::stepMark(int direction) {
  const qint64 now = reached();
  std::optional<qint64> nearest;
  for (const ProjectMark& mark : model_.marks) {
    const bool ahead = direction > 0 ? mark.frame > now : mark.frame < now;
    if (ahead && (!nearest || std::abs(mark.frame - now) < std::abs(*nearest - now))) {
      nearest = mark.frame;
    }
  }
  if (nearest) {
    want(*nearest);
  }
}

void Timeline::addMark() {
  const qint64 frame = selection_.moment();
  if (frame < 0) {
    return;
  }
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
  const auto added = std::ranges::find(model_.marks, frame, &ProjectMark::frame);
  if (added != model_.marks.end()) {
    editName(static_cast<std::size_t>(added - model_.marks.begin()));
  }
}

bool Timeline::removeMark() {
  const qint64 frame = selection_.moment();
  const auto& marks = document_.project().marks;
  if (std::ranges::find(marks, frame, &ProjectMark::frame) == marks.end()) {
    return false;
  }
  (void)document_.edit(tr("Remove a mark"), [frame](Project& project) {
    std::erase_if(project.marks, [frame](const ProjectMark& mark) { return mark.frame == frame; });
  });
  return true;
}

void Timeline::editName(std::size_t index) {
  const ProjectMark mark = model_.marks.at(index);
  const QRectF flag = markFlag(mark, scale_, rows(), QFontMetricsF(font()));
  const QString name = QString::fromStdString(mark.name);
  const int left = std::clamp(static_cast<int>(flag.left()), 0, std::max(0, width() - 160));
  editor_->setGeometry(left, 0, 160, editor_->sizeHint().height());
  editor_->disconnect(this);
  editor_->setText(name);
  editor_->selectAll();
  editor_->show();
  editor_->raise();
  editor_->setFocus();
  connect(editor_, &QLineEdit::editingFinished, this, [this, mark, name] {
    editor_->disconnect(this);
    editor_->hide();
    setFocus();
    rename(mark.frame, name, editor_->text().trimmed());
  });
}

void Timeline::rename(qint64 frame, const QString& from, const QString& name) {
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
