// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cameras/address_form.h"

#include "core/setup/new_project/live_preview.h"
#include "ui/cameras/camera_device_text.h"
#include "ui/style/image.h"
#include "ui/style/spacing.h"
#include "ui/text/error_sentence.h"
#include "ui/text/retranslation.h"
#include "ui/widgets/choice_field.h"
#include "ui/widgets/path_field.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPixmap>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <memory>

namespace dewpoint::ui {

namespace {

/// What an address of each kind looks like; in the order of the list.
constexpr std::array kExamples{
    "rtsp://192.168.0.10:554/stream",   "http://192.168.0.10:8080/video",
    "rtp://0.0.0.0:5004?encoding=H264", "srt://192.168.0.10:7001",
    "gst:videotestsrc ! videoconvert",  "test:ball?width=640&height=480&rate=30"};

} // namespace

AddressForm::AddressForm(QWidget* parent)
    : QWidget(parent), label_(new QLabel(this)), kind_(makeChoiceField("addressKind", this)),
      address_(new PathField(this)), try_(new QPushButton(this)), add_(new QPushButton(this)),
      replace_(new QPushButton(this)), image_(new QLabel(this)), result_(new QLabel(this)) {
  address_->setObjectName(QStringLiteral("addressText"));
  try_->setObjectName(QStringLiteral("addressTry"));
  add_->setObjectName(QStringLiteral("addressAdd"));
  replace_->setObjectName(QStringLiteral("addressReplace"));
  result_->setObjectName(QStringLiteral("addressResult"));
  image_->setObjectName(QStringLiteral("addressImage"));
  arrange();
  onRetranslate(this, [this] { retranslateUi(); });
  connect(kind_, &QComboBox::activated, this, &AddressForm::chooseKind);
  connect(address_, &QLineEdit::textChanged, this, &AddressForm::refresh);
  connect(try_, &QPushButton::clicked, this,
          [this] { job_.isRunning() ? job_.abandon() : tryAddress(); });
  connect(add_, &QPushButton::clicked, this,
          [this] { Q_EMIT addRequested(address(), tried_ == address() ? size_ : QSize()); });
  connect(replace_, &QPushButton::clicked, this, [this] { Q_EMIT replaceRequested(address()); });
  connect(&job_, &BackgroundJob::started, this, &AddressForm::refresh);
  connect(&job_, &BackgroundJob::ended, this, [this](bool canceled) {
    if (canceled) {
      result_->clear();
    }
    refresh();
  });
  address_->setPlaceholderText(QLatin1String(kExamples.front()));
}

void AddressForm::arrange() {
  label_->setBuddy(address_);
  result_->setWordWrap(true);
  image_->hide();
  for (QPushButton* button : {try_, add_, replace_}) {
    button->setAutoDefault(false); // Enter in the field is not an answer
  }
  auto* first = new QHBoxLayout;
  first->setSpacing(kSpacing);
  first->addWidget(label_);
  first->addWidget(kind_, 1);
  auto* second = new QHBoxLayout;
  second->setSpacing(kSpacing);
  second->addWidget(try_);
  second->addWidget(add_);
  second->addWidget(replace_);
  second->addStretch(1);
  auto* found = new QHBoxLayout;
  found->setSpacing(kSpacing);
  found->addWidget(image_);
  found->addWidget(result_, 1);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(kSpacing);
  column->addLayout(first);
  column->addWidget(address_);
  column->addLayout(second);
  column->addLayout(found);
}

QString AddressForm::address() const {
  return address_->text().trimmed();
}

void AddressForm::setBlockedReason(const QString& reason) {
  blockedReason_ = reason;
  refresh();
}

void AddressForm::chooseKind(int kind) {
  const QString example = QLatin1String(kExamples.at(static_cast<std::size_t>(std::max(0, kind))));
  address_->setPlaceholderText(example);
  const bool isUntouched = address().isEmpty() || std::ranges::any_of(kExamples, [this](auto* one) {
                             return address() == QLatin1String(one);
                           });
  if (isUntouched) {
    address_->setText(example);
  }
  refresh();
}

void AddressForm::refresh() {
  const bool any = !address().isEmpty();
  const bool busy = job_.isRunning();
  try_->setText(busy ? tr("Cancel") : tr("Try"));
  try_->setEnabled(any || busy);
  for (QPushButton* button : {add_, replace_}) {
    button->setEnabled(any && blockedReason_.isEmpty());
  }
  add_->setToolTip(blockedReason_.isEmpty() ? tr("Add a camera with this address to the project")
                                            : blockedReason_);
  replace_->setToolTip(blockedReason_.isEmpty()
                           ? tr("Make this address the image source of the selected camera")
                           : blockedReason_);
  if (tried_ != address() && !busy) {
    image_->hide();
    result_->clear();
  }
}

void AddressForm::tryAddress() {
  tried_ = address();
  size_ = {};
  image_->hide();
  result_->setText(tr("Waiting for the first image…"));
  job_.start([this, address = tried_](const BackgroundJob::Progress& progress) {
    auto tried = std::make_shared<Result<LivePreview>>(
        captureLivePreview(address.toStdString(), [&progress] { return progress(-1.0); }));
    return [this, tried] {
      if (!*tried) {
        Error reason = tried->error();
        reason.file.clear(); // it stands above
        result_->setText(tr("✗ %1").arg(errorText(reason)));
        return;
      }
      size_ = QSize((*tried)->size.width, (*tried)->size.height);
      image_->setPixmap(QPixmap::fromImage(toQImage((*tried)->image)));
      image_->show();
      result_->setText(tr("✓ %1").arg(imageFormatText(size_, (*tried)->framesPerSecond)));
    };
  });
}

void AddressForm::retranslateUi() {
  label_->setText(tr("Address"));
  setChoices(*kind_, {tr("RTSP camera"), tr("MJPEG over HTTP"), tr("RTP over UDP"), tr("SRT"),
                      tr("GStreamer pipeline"), tr("Test pattern")});
  if (kind_->currentIndex() < 0 || address().isEmpty()) {
    kind_->setCurrentIndex(0);
  }
  kind_->setAccessibleName(tr("Kind of address"));
  kind_->setToolTip(tr("Shows what an address of this kind looks like"));
  address_->setAccessibleName(tr("Address of the camera"));
  address_->setToolTip(tr("Address of a network camera, a GStreamer pipeline or a test pattern"));
  try_->setToolTip(tr("Open the address, and show the first image, its size and the frame rate"));
  add_->setText(tr("Add"));
  replace_->setText(tr("Assign to selected camera"));
  refresh();
}

} // namespace dewpoint::ui
