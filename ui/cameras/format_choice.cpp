// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cameras/format_choice.h"

#include "ui/cameras/camera_device_text.h"
#include "ui/style/spacing.h"
#include "ui/text/quantity_text.h"
#include "ui/text/retranslation.h"
#include "ui/widgets/choice_field.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSize>

#include <algorithm>
#include <utility>

namespace dewpoint::ui {

namespace {

/// Replaces the choices, and selects one; if it is not offered, it is added.
void fillChoice(QComboBox& box, ChoicesWithData choices, const QVariant& selected,
                const QString& text) {
  const QSignalBlocker quiet(&box);
  box.clear();
  const auto found =
      std::ranges::find_if(choices, [&](const auto& choice) { return choice.second == selected; });
  if (found == choices.end()) {
    choices.emplace_back(text, selected);
  }
  for (const auto& [words, data] : choices) {
    box.addItem(words, data);
    if (data == selected) {
      box.setCurrentIndex(box.count() - 1);
    }
  }
}

} // namespace

FormatChoice::FormatChoice(QWidget* parent)
    : QWidget(parent), pixelLabel_(new QLabel(this)), pixel_(makeChoiceField("deviceFormat", this)),
      sizeLabel_(new QLabel(this)), size_(makeChoiceField("deviceSize", this)),
      rateLabel_(new QLabel(this)), rate_(makeChoiceField("deviceRate", this)) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(kSpacing);
  for (const auto& [label, box] : {std::pair(pixelLabel_, pixel_), std::pair(sizeLabel_, size_),
                                   std::pair(rateLabel_, rate_)}) {
    label->setBuddy(box);
    row->addWidget(label);
    row->addWidget(box, 1);
    connect(box, &QComboBox::activated, this, &FormatChoice::apply);
  }
  onRetranslate(this, [this] { retranslateUi(); });
}

void FormatChoice::setFormats(const std::vector<capture::OfferedFormat>& offered,
                              const capture::DeviceFormat& requested) {
  offered_ = offered;
  requested_ = requested;
  fill();
}

std::vector<capture::OfferedSize> FormatChoice::sizes() const {
  std::vector<capture::OfferedSize> all;
  for (const capture::OfferedFormat& format : offered_) {
    if (!requested_.pixelFormat.empty() && format.pixelFormat != requested_.pixelFormat) {
      continue;
    }
    for (const capture::OfferedSize& size : format.sizes) {
      const auto known = std::ranges::find_if(all, [&](const capture::OfferedSize& other) {
        return other.width == size.width && other.height == size.height;
      });
      if (known == all.end()) {
        all.push_back(size);
        continue;
      }
      for (const double rate : size.frameRates) {
        if (std::ranges::find(known->frameRates, rate) == known->frameRates.end()) {
          known->frameRates.push_back(rate);
        }
      }
    }
  }
  return all;
}

void FormatChoice::fill() {
  ChoicesWithData formats{{tr("automatic"), QString()}};
  for (const capture::OfferedFormat& format : offered_) {
    const QString code = QString::fromStdString(format.pixelFormat);
    formats.emplace_back(
        format.description.empty()
            ? code
            : QStringLiteral("%1 (%2)").arg(code, QString::fromStdString(format.description)),
        code);
  }
  const QString code = QString::fromStdString(requested_.pixelFormat);
  fillChoice(*pixel_, std::move(formats), code, code);
  ChoicesWithData sizesOffered{{tr("automatic"), QSize(0, 0)}};
  ChoicesWithData rates{{tr("automatic"), 0.0}};
  for (const capture::OfferedSize& size : sizes()) {
    sizesOffered.emplace_back(imageSizeText(size.width, size.height),
                              QSize(size.width, size.height));
    const bool isRequested = size.width == requested_.width && size.height == requested_.height;
    for (const double rate : size.frameRates) {
      if (isRequested || (requested_.width == 0 && rates.size() == 1)) {
        rates.emplace_back(rateText(rate), rate);
      }
    }
  }
  fillChoice(*size_, std::move(sizesOffered), QSize(requested_.width, requested_.height),
             imageSizeText(requested_.width, requested_.height));
  fillChoice(*rate_, std::move(rates), requested_.frameRate, rateText(requested_.frameRate));
}

void FormatChoice::apply() {
  capture::DeviceFormat format = requested_;
  format.pixelFormat = pixel_->currentData().toString().toStdString();
  const QSize size = size_->currentData().toSize();
  format.width = size.width();
  format.height = size.height();
  format.frameRate = rate_->currentData().toDouble();
  if (format != requested_) {
    requested_ = format;
    fill();
    Q_EMIT formatChosen(format);
  }
}

void FormatChoice::retranslateUi() {
  pixelLabel_->setText(tr("Format"));
  pixel_->setToolTip(tr("Format in which the device sends its images. Compressed formats, such as "
                        "MJPG, use less of the bandwidth of the USB bus"));
  sizeLabel_->setText(tr("Size"));
  size_->setToolTip(tr("Size of the images, in pixels"));
  rateLabel_->setText(tr("Rate"));
  rate_->setToolTip(tr("Images per second"));
  fill();
}

} // namespace dewpoint::ui
