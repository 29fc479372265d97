// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/video_form.h"

#include "ui/widgets/choice_field.h"
#include "ui/widgets/decimal_field.h"
#include "ui/widgets/named.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QListWidget>
#include <QSignalBlocker>

#include <algorithm>
#include <array>
#include <cmath>

namespace dewpoint::ui {

namespace {

constexpr double kMostVideoSeconds = 1e6;
constexpr double kMostVideoRate = 240.0;
/// Rows of the field "Size" after the first, which is the size of the camera images.
constexpr std::array<QSize, 5> kVideoSizes{QSize(640, 360), QSize(1280, 720), QSize(1920, 1080),
                                           QSize(2560, 1440), QSize(3840, 2160)};
constexpr int kUsualSize = 2; ///< row of 1280 x 720

} // namespace

VideoForm::VideoForm(QWidget* parent) : QWidget(parent), form_(new QFormLayout(this)) {
  form_->setContentsMargins(0, 0, 0, 0);
  form_->setSpacing(8);
  makeFields();
  const auto change = [this] { Q_EMIT changed(); };
  for (QDoubleSpinBox* spin : {from_, to_, speed_, rate_}) {
    connect(spin, &QDoubleSpinBox::valueChanged, this, change);
  }
  connect(size_, &QComboBox::currentIndexChanged, this, change);
  connect(views_, &QListWidget::itemChanged, this, change);
  connect(titles_, &QCheckBox::toggled, this, change);
  connect(stamp_, &QCheckBox::toggled, this, change);
  connect(encoding_, &QComboBox::currentIndexChanged, this, &VideoForm::encodingChanged);
}

void VideoForm::makeFields() {
  views_ = named(new QListWidget(this), "videoViews");
  views_->setMaximumHeight(120);
  from_ = makeDecimalField("videoFrom", -1.0, kMostVideoSeconds, 3, this);
  to_ = makeDecimalField("videoTo", -1.0, kMostVideoSeconds, 3, this);
  speed_ = makeDecimalField("videoSpeed", 0.0, VideoTiming::kMaxPlaybackSpeed, 2, this);
  speed_->setSingleStep(0.1);
  speed_->setValue(1.0);
  size_ = named(new QComboBox(this), "videoSize");
  rate_ = makeDecimalField("videoRate", 0.0, kMostVideoRate, 3, this);
  encoding_ = named(new QComboBox(this), "videoEncoding");
  titles_ = named(new QCheckBox(this), "videoTitles");
  titles_->setChecked(true);
  stamp_ = named(new QCheckBox(this), "videoStamp");
  stamp_->setChecked(true);
  for (QWidget* field :
       std::initializer_list<QWidget*>{views_, from_, to_, speed_, size_, rate_, encoding_}) {
    auto* label = new QLabel(this);
    label->setBuddy(field);
    form_->addRow(label, field);
  }
  form_->addRow(QString(), titles_);
  form_->addRow(QString(), stamp_);
  fillChoices();
  size_->setCurrentIndex(kUsualSize);
  resetRange();
}

void VideoForm::fillChoices() {
  QStringList sizes{tr("camera images")};
  for (const QSize& size : kVideoSizes) {
    sizes << tr("%1 × %2", "pixels").arg(size.width()).arg(size.height());
  }
  setChoices(*size_, sizes);
  QStringList encodings;
  for (const VideoEncoding& encoding : encodings_) {
    encodings << (encoding.id == "h264"    ? tr("MP4 (H.264)")
                  : encoding.id == "vp8"   ? tr("WebM (VP8)")
                  : encoding.id == "mjpeg" ? tr("AVI (Motion JPEG)")
                                           : tr("Matroska (FFV1, lossless)"));
  }
  setChoices(*encoding_, encodings);
}

void VideoForm::retranslateUi() {
  fillChoices();
  const auto setTexts = [this](QWidget* field, const QString& label, const QString& hint) {
    qobject_cast<QLabel*>(form_->labelForField(field))->setText(label);
    field->setAccessibleName(label);
    field->setToolTip(hint);
  };
  setTexts(views_, tr("Views"), tr("The checked views are shown side by side"));
  setTexts(from_, tr("From"),
           tr("Time in the recording at which the video begins, 0 to 1,000,000 s"));
  setTexts(to_, tr("To"),
           tr("Time in the recording at which the video ends, 0 to 1,000,000 s. The end is the "
              "last tracked frame; later frames have no results"));
  setTexts(speed_, tr("Speed"),
           tr("Speed of the video, up to 100: 1 is real time, 0.1 is ten times slower, and 8 is "
              "eight times faster. With 0, every frame is shown once"));
  setTexts(size_, tr("Size"), tr("Width and height of the video in pixels"));
  setTexts(rate_, tr("Frame rate"), tr("Images of the video per second, 1 to 240"));
  setTexts(encoding_, tr("Format"), tr("Formats that this computer can write"));
  from_->setSpecialValueText(tr("the beginning"));
  to_->setSpecialValueText(tr("the end"));
  speed_->setSpecialValueText(tr("show every frame once"));
  rate_->setSpecialValueText(tr("as recorded"));
  from_->setSuffix(tr(" s"));
  to_->setSuffix(tr(" s"));
  speed_->setSuffix(tr(" ×"));
  rate_->setSuffix(tr(" per second"));
  titles_->setText(tr("Titles of the views"));
  titles_->setToolTip(tr("Write the name of each view into its corner"));
  stamp_->setText(tr("Frame and time"));
  stamp_->setToolTip(
      tr("Write the name of the recording, the frame number and the time into the video"));
}

void VideoForm::setViews(const std::vector<VideoView>& views) {
  QStringList shown;
  for (const VideoView& view : offered_) {
    shown << view.title;
  }
  QStringList titles;
  for (const VideoView& view : views) {
    titles << view.title;
  }
  offered_ = views;
  if (titles == shown) {
    return;
  }
  const QSignalBlocker quiet(views_);
  views_->clear();
  for (const QString& title : titles) {
    auto* item = new QListWidgetItem(title, views_);
    item->setFlags(item->flags() | Qt::ItemIsUserCheckable);
    item->setCheckState(Qt::Checked);
  }
}

void VideoForm::setEncodings(std::vector<VideoEncoding> encodings) {
  encodings_ = std::move(encodings);
  fillChoices();
  encoding_->setCurrentIndex(0);
  Q_EMIT encodingChanged();
}

VideoLayout VideoForm::videoLayout() const {
  VideoLayout look;
  for (int k = 0; k < views_->count(); ++k) {
    if (views_->item(k)->checkState() == Qt::Checked) {
      look.views.push_back(offered_[static_cast<std::size_t>(k)]);
    }
  }
  const int row = size_->currentIndex();
  if (row > 0) {
    look.size = kVideoSizes[static_cast<std::size_t>(row - 1)];
  } else if (!look.views.empty()) {
    look.size = naturalVideoSize(look.views);
  }
  look.showsTitles = titles_->isChecked();
  look.showsStamp = stamp_->isChecked();
  look.palette = palette();
  return look;
}

VideoTiming VideoForm::timing(double recorded) const {
  VideoTiming timing;
  timing.playbackSpeed = speed_->value() > 0.0 ? std::optional(speed_->value()) : std::nullopt;
  timing.framesPerSecond = rate_->value() > 0.0 ? rate_->value() : recorded;
  return timing;
}

std::optional<double> VideoForm::startSeconds() const {
  return from_->value() >= 0.0 ? std::optional(from_->value()) : std::nullopt;
}

std::optional<double> VideoForm::endSeconds() const {
  return to_->value() >= 0.0 ? std::optional(to_->value()) : std::nullopt;
}

std::optional<VideoEncoding> VideoForm::encoding() const {
  const int row = encoding_->currentIndex();
  return row >= 0 && static_cast<std::size_t>(row) < encodings_.size()
             ? std::optional(encodings_[static_cast<std::size_t>(row)])
             : std::nullopt;
}

QString VideoForm::fileSuffix() const {
  const auto chosen = encoding();
  return chosen ? QString::fromUtf8(chosen->suffix.data(),
                                    static_cast<qsizetype>(chosen->suffix.size()))
                : QString();
}

void VideoForm::setSelectedRange(std::optional<std::pair<double, double>> seconds) {
  const std::pair<double, double> all(from_->minimum(), to_->minimum());
  if (!seconds && std::pair(from_->value(), to_->value()) != proposedRange_) {
    return; // typed by hand since
  }
  // Outwards to what the fields can show, or rounding would lose the last frame.
  const double steps = std::pow(10.0, from_->decimals());
  from_->setValue(seconds ? std::floor(seconds->first * steps) / steps : all.first);
  to_->setValue(seconds ? std::ceil(seconds->second * steps) / steps : all.second);
  proposedRange_ = seconds ? std::pair(from_->value(), to_->value()) : all;
}

void VideoForm::resetRange() {
  from_->setValue(from_->minimum());
  to_->setValue(to_->minimum());
  proposedRange_ = {from_->value(), to_->value()};
}

} // namespace dewpoint::ui
