// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/video_preview.h"

#include "ui/style/tabular_font.h"
#include "ui/text/quantity_text.h"
#include "ui/widgets/named.h"

#include <QImage>
#include <QLabel>
#include <QLocale>
#include <QSignalBlocker>
#include <QSlider>
#include <QVBoxLayout>

#include <algorithm>

namespace dewpoint::ui {

namespace {
constexpr QSize kVideoPreviewSize(480, 320); ///< logical pixels
} // namespace

VideoPreview::VideoPreview(QWidget* parent)
    : QWidget(parent), image_(named(new QLabel(this), "videoPreview")),
      slider_(named(new QSlider(Qt::Horizontal, this), "videoImage")),
      text_(named(new QLabel(this), "videoImageText")) {
  image_->setMinimumSize(kVideoPreviewSize);
  image_->setAlignment(Qt::AlignCenter);
  text_->setFont(tabularFont(text_->font()));
  slider_->setRange(0, 0);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(8);
  column->addWidget(image_, 1);
  column->addWidget(slider_);
  column->addWidget(text_);
  connect(slider_, &QSlider::valueChanged, this, [this] {
    updateText();
    Q_EMIT frameChosen();
  });
}

void VideoPreview::retranslateUi() {
  image_->setAccessibleName(tr("Preview"));
  slider_->setAccessibleName(tr("Image"));
  slider_->setToolTip(tr("Choose the image of the video that the preview shows"));
  updateText();
}

void VideoPreview::setFrames(const std::vector<std::int64_t>& frames) {
  if (frames == frames_) {
    return;
  }
  frames_ = frames;
  const QSignalBlocker quiet(slider_); // whoever sets the frames shows the first one
  const int last = std::max(0, static_cast<int>(frames_.size()) - 1);
  slider_->setRange(0, last);
  slider_->setValue(0);
  slider_->setPageStep(std::max(1, last / 10));
  slider_->setEnabled(last > 0);
  updateText();
}

std::int64_t VideoPreview::frame() const {
  return frames_[static_cast<std::size_t>(slider_->value())];
}

QSize VideoPreview::imageSize() const {
  return kVideoPreviewSize * devicePixelRatioF();
}

void VideoPreview::showImage(const QImage& image) {
  QPixmap pixmap = QPixmap::fromImage(image);
  pixmap.setDevicePixelRatio(devicePixelRatioF());
  image_->setPixmap(pixmap);
}

void VideoPreview::updateText() {
  const QLocale numbers;
  text_->setText(frames_.empty() ? QString()
                                 : tr("Image %1 of %2: frame %3")
                                       .arg(numbers.toString(slider_->value() + 1),
                                            numbers.toString(static_cast<int>(frames_.size())),
                                            frameNumberText(frame())));
}

} // namespace dewpoint::ui
