// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/color/color_sample_list.h"

#include "core/project/project.h"
#include "ui/text/camera_names.h"
#include "ui/text/quantity_text.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QShortcut>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <string>

namespace dewpoint::ui {

ColorSampleList::ColorSampleList(QWidget* parent)
    : QWidget(parent), title_(new QLabel(this)), list_(new QListWidget(this)),
      remove_(new QPushButton(this)) {
  list_->setObjectName(QStringLiteral("colorSamples"));
  list_->setMaximumHeight(96);
  remove_->setObjectName(QStringLiteral("colorRemoveSample"));
  auto* head = new QHBoxLayout;
  head->addWidget(title_, 1);
  head->addWidget(remove_);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(8);
  column->addLayout(head);
  column->addWidget(list_);
  connect(remove_, &QPushButton::clicked, this, &ColorSampleList::removeChosen);
  connect(list_, &QListWidget::currentRowChanged, this,
          [this](int row) { remove_->setEnabled(row >= 0); });
  auto* del = new QShortcut(QKeySequence::Delete, list_);
  del->setContext(Qt::WidgetShortcut);
  connect(del, &QShortcut::activated, this, &ColorSampleList::removeChosen);
}

void ColorSampleList::retranslateUi() {
  title_->setText(tr("Learned from"));
  list_->setAccessibleName(tr("Samples from which the color was learned"));
  list_->setToolTip(tr("Shift-click in an image to add a sample, Ctrl+Shift-click or Alt-click to "
                       "exclude one. Samples marked “found” were detected in other cameras."));
  remove_->setText(tr("Remove"));
  remove_->setToolTip(tr("Remove the selected sample and learn from the others (Del). If the "
                         "sample is marked “found”, it becomes an excluded sample."));
}

void ColorSampleList::setSamples(const Project& project, int target) {
  const int row = list_->currentRow();
  const QSignalBlocker quiet(list_);
  list_->clear();
  if (target >= 0 && target < static_cast<int>(project.targets.size())) {
    for (const ColorSample& sample : project.targets[static_cast<std::size_t>(target)].samples) {
      const auto camera = static_cast<std::size_t>(sample.camera);
      const QString name = cameraName(
          camera < project.cameras.size() ? project.cameras[camera].camera.name : std::string(),
          camera);
      const QString text = sample.isExcluded          ? tr("excluded: %1, frame %2, pixel %3, %4")
                           : sample.isFoundByGeometry ? tr("found: %1, frame %2, pixel %3, %4")
                                                      : tr("%1, frame %2, pixel %3, %4");
      list_->addItem(text.arg(name)
                         .arg(frameNumberText(sample.frame))
                         .arg(std::lround(sample.x + sample.width / 2.0))
                         .arg(std::lround(sample.y + sample.height / 2.0)));
    }
  }
  list_->setCurrentRow(std::min(row, list_->count() - 1));
  remove_->setEnabled(list_->currentRow() >= 0);
  setVisible(list_->count() > 0);
}

void ColorSampleList::removeChosen() {
  Q_EMIT removeRequested(list_->currentRow());
}

} // namespace dewpoint::ui
