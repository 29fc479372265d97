// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/color/learn_modes.h"

#include <QHBoxLayout>
#include <QToolButton>

namespace dewpoint::ui {

namespace {

using SampleAction = ColorLearner::SampleAction;

constexpr std::array kLearnModes{SampleAction::Replace, SampleAction::Add, SampleAction::Exclude};
constexpr std::array kLearnModeNames{"colorLearn", "colorAddSample", "colorExclude"};

} // namespace

LearnModes::LearnModes(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("learnModes"));
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(4);
  for (std::size_t k = 0; k < buttons_.size(); ++k) {
    auto* button = new QToolButton(this);
    button->setObjectName(QLatin1String(kLearnModeNames[k]));
    button->setCheckable(true);
    button->setFocusPolicy(Qt::StrongFocus);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    row->addWidget(button, 1);
    connect(button, &QToolButton::clicked, this, [this, k](bool down) {
      const Mode mode = down ? Mode(kLearnModes[k]) : Mode();
      setMode(mode);
      Q_EMIT modeChosen(mode);
    });
    buttons_[k] = button;
  }
}

void LearnModes::setMode(Mode mode) {
  for (std::size_t k = 0; k < buttons_.size(); ++k) {
    buttons_[k]->setChecked(mode == kLearnModes[k]);
  }
}

void LearnModes::setRefinementEnabled(bool canAdd, bool canExclude) {
  if (canAdd_ != canAdd || canExclude_ != canExclude) {
    canAdd_ = canAdd;
    canExclude_ = canExclude;
    showHints();
  }
}

bool LearnModes::offersMode(ColorLearner::SampleAction mode) const {
  return mode == SampleAction::Replace ||
         (!targetsAreBoxes_ && (mode == SampleAction::Add ? canAdd_ : canExclude_));
}

void LearnModes::setTargetsAreBoxes(bool targetsAreBoxes) {
  targetsAreBoxes_ = targetsAreBoxes;
  retranslateUi();
}

void LearnModes::retranslateUi() {
  setAccessibleName(tr("What a click in an image does"));
  buttons_[0]->setText(targetsAreBoxes_ ? tr("Box") : tr("Learn"));
  buttons_[1]->setText(tr("Add sample"));
  buttons_[2]->setText(tr("Exclude"));
  buttons_[1]->setVisible(!targetsAreBoxes_);
  buttons_[2]->setVisible(!targetsAreBoxes_);
  showHints();
}

void LearnModes::showHints() {
  buttons_[1]->setEnabled(canAdd_);
  buttons_[2]->setEnabled(canExclude_);
  buttons_[0]->setToolTip(targetsAreBoxes_
                              ? tr("Click the object in a camera image, or drag a box around "
                                   "it.\nWhen this button is off, Shift-click does the same.")
                              : tr("Click the target in a camera image, or drag a box around "
                                   "it,\nto learn its color again."));
  const QString first = tr("Learn the color first: click the target in a camera image.");
  buttons_[1]->setToolTip(
      canAdd_ ? tr("Click another part of the target, or the target in different light, to add its "
                   "color.\nWhen this button is off, Shift-click does the same.")
              : first);
  buttons_[2]->setToolTip(
      canExclude_
          ? tr("Click something that has the target's color but is not the target, to exclude "
               "it.\nWhen this button is off, Ctrl+Shift-click does the same; so does Alt-click, "
               "where the desktop does not use it.")
          : first);
}

QString LearnModes::hintOf(ColorLearner::SampleAction mode) const {
  switch (mode) {
  case SampleAction::Replace:
    break;
  case SampleAction::Add:
    return canExclude_ ? tr("Click: add a sample · Ctrl+Shift: exclude · Esc: stop")
                       : tr("Click: add a sample · Esc: stop");
  case SampleAction::Exclude:
    return tr("Click: exclude a color · Esc: stop");
  }
  return canExclude_ ? tr("Click: learn · Shift: add · Ctrl+Shift: exclude · Esc: stop")
         : canAdd_   ? tr("Click: learn · Shift: add · Esc: stop")
                     : tr("Click the new target · Esc: stop");
}

} // namespace dewpoint::ui
