// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/help/overlay_legend.h"

#include "ui/text/retranslation.h"

#include <QDialogButtonBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace dewpoint::ui {

namespace {
constexpr int kLegendSentenceWidth = 310; ///< so that two columns fit a small screen
} // namespace

OverlayLegend::OverlayLegend(QWidget* parent) : QDialog(parent) {
  setObjectName(QStringLiteral("overlayLegend"));
  auto* columns = new QHBoxLayout;
  columns->setSpacing(24);
  const auto addColumn = [&](const std::vector<LegendSign>& signs) {
    auto* rows = new QGridLayout;
    rows->setHorizontalSpacing(16);
    rows->setVerticalSpacing(8);
    addRows(rows, signs, this, kLegendSentenceWidth);
    columns->addLayout(rows);
  };
  addColumn({LegendSign::Particles, LegendSign::Estimate, LegendSign::Belief, LegendSign::Outline,
             LegendSign::Truth});
  addColumn(
      {LegendSign::Best, LegendSign::Ray, LegendSign::Mask, LegendSign::Inset, LegendSign::Range});
  auto* buttons = new QDialogButtonBox(this);
  auto* close = new QPushButton(this);
  buttons->addButton(close, QDialogButtonBox::RejectRole);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(16, 16, 16, 16);
  all->setSpacing(16);
  all->addLayout(columns);
  all->addWidget(buttons);
  all->setSizeConstraint(QLayout::SetFixedSize);
  onRetranslate(this, [this, close] {
    setWindowTitle(tr("Legend of the overlays"));
    close->setText(tr("Close"));
    close->setToolTip(tr("Close this window"));
  });
}

void OverlayLegend::addRows(QGridLayout* rows, const std::vector<LegendSign>& signs,
                            QWidget* parent, int sentenceWidth) {
  rows->setColumnStretch(1, 1);
  for (const LegendSign sign : signs) {
    auto* sentence = new QLabel(parent);
    sentence->setWordWrap(true);
    sentence->setFixedWidth(sentenceWidth);
    onRetranslate(sentence, [sentence, sign] {
      sentence->setText(LegendPicture::meaningOf(sign));
      // In a column of texts that wrap, the layout has to know how high each is.
      sentence->setMinimumHeight(sentence->heightForWidth(sentence->width()));
    });
    const int row = rows->rowCount();
    rows->addWidget(new LegendPicture(sign, parent), row, 0);
    rows->addWidget(sentence, row, 1, Qt::AlignVCenter);
  }
}

} // namespace dewpoint::ui
