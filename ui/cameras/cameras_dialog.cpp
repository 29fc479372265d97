// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cameras/cameras_dialog.h"

#include "core/project/project.h"
#include "core/setup/new_project/project_devices.h"
#include "ui/cameras/camera_device_text.h"
#include "ui/cameras/camera_edits.h"
#include "ui/cameras/color_locker.h"
#include "ui/cameras/control_sync.h"
#include "ui/cameras/device_watch.h"
#include "ui/cameras/project_pane.h"
#include "ui/cameras/source_pane.h"
#include "ui/document/camera_list_model.h"
#include "ui/document/document.h"
#include "ui/style/spacing.h"
#include "ui/text/retranslation.h"

#include <QDialogButtonBox>
#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>
#include <QMainWindow>
#include <QPushButton>
#include <QVBoxLayout>

#include <chrono>
#include <map>

namespace dewpoint::ui {

namespace {

/// Between two images of the project's cameras, as of the previews.
constexpr std::chrono::milliseconds kBetweenPictures(300);

} // namespace

CamerasDialog::CamerasDialog(const Workbench& bench, const CameraParts& parts)
    : QDialog(&bench.window), bench_(bench), parts_(parts),
      project_(new ProjectPane(bench, parts, this)),
      sources_(new SourcePane(
          bench, parts, [this] { return project_->camera(); }, this)),
      bandwidth_(new QLabel(this)), fit_(new QPushButton(this)), message_(new QLabel(this)),
      buttons_(new QDialogButtonBox(QDialogButtonBox::Close, this)) {
  setObjectName(QStringLiteral("camerasDialog"));
  bandwidth_->setObjectName(QStringLiteral("bandwidthWarning"));
  fit_->setObjectName(QStringLiteral("bandwidthFit"));
  message_->setObjectName(QStringLiteral("camerasMessage"));
  arrange();
  connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(&bench_.session, &SessionController::closed, this, &QDialog::reject);
  connectSnapshots();
  connect(&bench_.document, &Document::projectReplaced, this, [this] {
    setMessage({});
    updateBandwidth();
  });
  connect(&bench_.document, &Document::changed, this, [this] {
    setMessage({}); // it has been dealt with
    updateBandwidth();
  });
  connect(&parts_.watch, &DeviceWatch::changed, this, &CamerasDialog::updateBandwidth);
  connect(&parts_.edits, &CameraEdits::failed, this, &CamerasDialog::setMessage);
  connect(&parts_.controls, &ControlSync::failed, this, &CamerasDialog::setMessage);
  connect(&parts_.locker, &ColorLocker::completed, this, &CamerasDialog::setMessage);
  connect(&parts_.locker, &ColorLocker::failed, this, &CamerasDialog::setMessage);
  connect(fit_, &QPushButton::clicked, this, &CamerasDialog::useProposals);
  onRetranslate(this, [this] { retranslateUi(); });
  setMessage({});
}

void CamerasDialog::connectSnapshots() {
  bench_.connectView(project_);
  bench_.connectImageView(sources_);
  // The dialog is opened in the middle of a run, and a run that is paused sends no snapshot.
  const TrackSnapshotPtr& shown = bench_.session.shownSnapshot();
  project_->setSnapshot(shown);
  sources_->setSnapshot(bench_.session.withMissingImagesFilled(shown));
  // Also while nothing new comes: devices are assigned, and a measured exposure becomes stale.
  connect(&redraw_, &QTimer::timeout, this, [this] {
    project_->showImages();
    sources_->showImages();
  });
}

void CamerasDialog::arrange() {
  bandwidth_->setWordWrap(true);
  message_->setWordWrap(true);
  for (QAbstractButton* button : buttons_->buttons()) {
    button->setIcon({}); // as in the other dialogs
  }
  for (QPushButton* button : findChildren<QPushButton*>()) {
    button->setAutoDefault(false); // Enter in a field is not an answer
  }
  auto* line = new QFrame(this);
  line->setFrameShape(QFrame::VLine);
  line->setFrameShadow(QFrame::Sunken);
  auto* panes = new QHBoxLayout;
  panes->setSpacing(2 * kSpacing);
  panes->addWidget(project_, 1);
  panes->addWidget(line);
  panes->addWidget(sources_, 1);
  auto* warning = new QHBoxLayout;
  warning->setSpacing(kSpacing);
  warning->addWidget(bandwidth_, 1);
  warning->addWidget(fit_);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(2 * kSpacing, 2 * kSpacing, 2 * kSpacing, 2 * kSpacing);
  column->setSpacing(kSpacing);
  column->addLayout(panes, 1);
  column->addLayout(warning);
  column->addWidget(message_);
  column->addWidget(buttons_);
  resize(980, 720);
}

void CamerasDialog::retranslateUi() {
  setWindowTitle(tr("Cameras – Dewpoint"));
  fit_->setText(tr("Fit formats to the USB bus"));
  updateBandwidth();
}

void CamerasDialog::setMessage(const QString& text) {
  message_->setText(text);
  message_->setVisible(!text.isEmpty());
}

void CamerasDialog::updateBandwidth() {
  shortages_ = projectBandwidthShortages(bench_.document.project(), parts_.watch.devices());
  QStringList names;
  for (int k = 0; k < bench_.cameras.rowCount(); ++k) {
    names << bench_.cameras.nameOf(k);
  }
  QStringList sentences;
  QStringList proposals;
  for (const capture::BandwidthShortage& shortage : shortages_) {
    sentences << QStringLiteral("▲ ") + bandwidthShortageText(shortage, names);
    if (!shortage.proposals.empty()) {
      proposals << bandwidthProposalText(shortage, names);
    }
  }
  if (!proposals.isEmpty()) {
    sentences << tr("These formats fit the USB bus: %1.").arg(proposals.join(QStringLiteral(", ")));
  }
  bandwidth_->setText(sentences.join(QLatin1Char('\n')));
  bandwidth_->setVisible(!sentences.isEmpty());
  fit_->setVisible(!proposals.isEmpty());
  fit_->setToolTip(proposals.join(QLatin1Char('\n')));
}

void CamerasDialog::useProposals() {
  std::map<int, capture::DeviceFormat> formats;
  for (const capture::BandwidthShortage& shortage : shortages_) {
    for (const capture::BandwidthProposal& proposal : shortage.proposals) {
      formats[static_cast<int>(proposal.requestIndex)] = proposal.format;
    }
  }
  parts_.edits.setFormats(formats);
}

void CamerasDialog::showEvent(QShowEvent* event) {
  QDialog::showEvent(event);
  parts_.watch.start();
  sources_->setPreviewing(true);
  redraw_.start(kBetweenPictures);
}

void CamerasDialog::hideEvent(QHideEvent* event) {
  QDialog::hideEvent(event);
  sources_->setPreviewing(false);
  redraw_.stop();
}

} // namespace dewpoint::ui
