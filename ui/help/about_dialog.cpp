// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/help/about_dialog.h"

#include "ui/text/retranslation.h"

#include <QClipboard>
#include <QDialogButtonBox>
#include <QFile>
#include <QFontDatabase>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QIcon>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QVBoxLayout>

namespace dewpoint::ui {

namespace {

constexpr int kEmblem = 72;
constexpr int kAboutWidth = 420;
constexpr QSize kLicenseSize(560, 320);

/// As it stands in a list of references. Not translated: a title stays as it is.
QString citation() {
  return QStringLiteral("Dewpoint: color particle filters that track in 3D with ordinary cameras. "
                        "Version %1, 2026.")
      .arg(QStringLiteral(DEWPOINT_VERSION));
}

} // namespace

AboutDialog::AboutDialog(QWidget* parent)
    : QDialog(parent), name_(new QLabel(this)), purpose_(new QLabel(this)),
      license_(new QLabel(this)), citeHeading_(new QLabel(this)), citation_(new QLabel(this)),
      licenseText_(new QPlainTextEdit(this)), showLicense_(new QPushButton(this)),
      copy_(new QPushButton(this)), close_(new QPushButton(this)) {
  setObjectName(QStringLiteral("aboutDialog"));
  auto* emblem = new QLabel(this);
  emblem->setPixmap(QIcon(QStringLiteral(":/icons/dewpoint.svg")).pixmap(kEmblem, kEmblem));
  name_->setObjectName(QStringLiteral("aboutName"));
  QFont large = name_->font();
  large.setPointSizeF(large.pointSizeF() * 1.5);
  large.setWeight(QFont::DemiBold);
  name_->setFont(large);
  QFont bold = citeHeading_->font();
  bold.setWeight(QFont::DemiBold);
  citeHeading_->setFont(bold);
  citation_->setObjectName(QStringLiteral("aboutCitation"));
  citation_->setText(citation());
  citation_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  for (QLabel* label : {purpose_, license_, citation_}) {
    label->setWordWrap(true);
    label->setMinimumWidth(kAboutWidth);
  }
  licenseText_->setObjectName(QStringLiteral("aboutLicenseText"));
  licenseText_->setReadOnly(true);
  licenseText_->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  licenseText_->setMinimumSize(kLicenseSize);
  licenseText_->hide();
  showLicense_->setObjectName(QStringLiteral("aboutShowLicense"));
  auto* words = new QVBoxLayout;
  words->setSpacing(8);
  words->addWidget(name_);
  words->addWidget(purpose_);
  words->addWidget(license_);
  words->addSpacing(8);
  words->addWidget(citeHeading_);
  words->addWidget(citation_);
  auto* top = new QHBoxLayout;
  top->setSpacing(20);
  top->addWidget(emblem, 0, Qt::AlignTop);
  top->addLayout(words, 1);
  auto* buttons = new QDialogButtonBox(this);
  buttons->addButton(showLicense_, QDialogButtonBox::ActionRole);
  buttons->addButton(copy_, QDialogButtonBox::ActionRole);
  buttons->addButton(close_, QDialogButtonBox::RejectRole);
  close_->setDefault(true);
  connect(showLicense_, &QPushButton::clicked, this, &AboutDialog::showLicense);
  connect(copy_, &QPushButton::clicked, this,
          [] { QGuiApplication::clipboard()->setText(citation()); });
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(20, 20, 20, 16);
  all->setSpacing(16);
  all->addLayout(top);
  all->addWidget(licenseText_, 1);
  all->addWidget(buttons);
  onRetranslate(this, [this] { retranslateUi(); });
}

void AboutDialog::showLicense() {
  if (licenseText_->isHidden()) {
    QFile file(QStringLiteral(":/license.txt"));
    if (file.open(QIODevice::ReadOnly)) {
      licenseText_->setPlainText(QString::fromUtf8(file.readAll()));
    }
  }
  licenseText_->setVisible(licenseText_->isHidden());
  showLicense_->setText(licenseText_->isHidden() ? tr("Show license") : tr("Hide license"));
  adjustSize();
}

void AboutDialog::retranslateUi() {
  setWindowTitle(tr("About Dewpoint"));
  name_->setText(tr("Dewpoint %1").arg(QStringLiteral(DEWPOINT_VERSION)));
  purpose_->setText(tr("Tracks colored objects in 3D, live, from ordinary cameras with particle "
                       "filters."));
  license_->setText(tr("Free software under the GNU General Public License, version 3 or later "
                       "(GPL-3.0-or-later), without any warranty."));
  citeHeading_->setText(tr("How to cite"));
  showLicense_->setText(licenseText_->isHidden() ? tr("Show license") : tr("Hide license"));
  showLicense_->setToolTip(tr("Show or hide the full text of the license"));
  copy_->setText(tr("Copy citation"));
  copy_->setToolTip(tr("Copy the entry for your reference list"));
  close_->setText(tr("Close"));
  close_->setToolTip(tr("Close this window"));
}

} // namespace dewpoint::ui
