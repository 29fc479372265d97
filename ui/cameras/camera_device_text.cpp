// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cameras/camera_device_text.h"

#include "ui/text/quantity_text.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

namespace dewpoint::ui {

namespace {

class CameraDeviceText {
  Q_DECLARE_TR_FUNCTIONS(CameraDeviceText)
};

using ControlWords = std::pair<std::string_view, const char*>;

/// Common controls by the name that V4L2 gives them.
constexpr std::array kControlWords{
    ControlWords{"brightness", QT_TRANSLATE_NOOP("CameraDeviceText", "Brightness")},
    ControlWords{"contrast", QT_TRANSLATE_NOOP("CameraDeviceText", "Contrast")},
    ControlWords{"saturation", QT_TRANSLATE_NOOP("CameraDeviceText", "Saturation")},
    ControlWords{"hue", QT_TRANSLATE_NOOP("CameraDeviceText", "Hue")},
    ControlWords{"hue_automatic", QT_TRANSLATE_NOOP("CameraDeviceText", "Automatic hue")},
    ControlWords{"gamma", QT_TRANSLATE_NOOP("CameraDeviceText", "Gamma")},
    ControlWords{"gain", QT_TRANSLATE_NOOP("CameraDeviceText", "Gain")},
    ControlWords{"gain_automatic", QT_TRANSLATE_NOOP("CameraDeviceText", "Automatic gain")},
    ControlWords{"sharpness", QT_TRANSLATE_NOOP("CameraDeviceText", "Sharpness")},
    ControlWords{"auto_exposure", QT_TRANSLATE_NOOP("CameraDeviceText", "Automatic exposure")},
    ControlWords{"exposure_time_absolute",
                 QT_TRANSLATE_NOOP("CameraDeviceText", "Exposure time (× 0.1 ms)")},
    ControlWords{"exposure_dynamic_framerate",
                 QT_TRANSLATE_NOOP("CameraDeviceText", "Lower frame rate in low light")},
    ControlWords{"white_balance_automatic",
                 QT_TRANSLATE_NOOP("CameraDeviceText", "Automatic white balance")},
    ControlWords{"white_balance_temperature",
                 QT_TRANSLATE_NOOP("CameraDeviceText", "White balance (K)")},
    ControlWords{"backlight_compensation",
                 QT_TRANSLATE_NOOP("CameraDeviceText", "Backlight compensation")},
    ControlWords{"power_line_frequency",
                 QT_TRANSLATE_NOOP("CameraDeviceText", "Power line frequency")},
    ControlWords{"focus_absolute", QT_TRANSLATE_NOOP("CameraDeviceText", "Focus")},
    ControlWords{"focus_automatic_continuous",
                 QT_TRANSLATE_NOOP("CameraDeviceText", "Automatic focus")},
    ControlWords{"zoom_absolute", QT_TRANSLATE_NOOP("CameraDeviceText", "Zoom")},
    ControlWords{"pan_absolute", QT_TRANSLATE_NOOP("CameraDeviceText", "Pan")},
    ControlWords{"tilt_absolute", QT_TRANSLATE_NOOP("CameraDeviceText", "Tilt")}};

QString cameraList(const std::vector<std::size_t>& cameras, const QStringList& names) {
  QStringList listed;
  for (const std::size_t camera : cameras) {
    listed << names.value(static_cast<qsizetype>(camera));
  }
  return listed.join(QStringLiteral(", "));
}

/// Bits per second in the unit in which buses are described.
QString megabits(double bitsPerSecond) {
  constexpr double kMega = 1e6;
  return numberText(bitsPerSecond / kMega, 0);
}

QString ratesText(const std::vector<double>& rates) {
  QStringList texts;
  for (const double rate : rates) {
    texts << rateText(rate);
  }
  return texts.join(QStringLiteral(" / "));
}

} // namespace

QString deviceName(const capture::CameraDevice& device) {
  return QString::fromStdString(device.identity.name.empty() ? device.path : device.identity.name);
}

QString devicePortText(const capture::CameraDevice& device) {
  QStringList parts{QString::fromStdString(device.path)};
  if (!device.identity.bus.empty()) {
    parts << CameraDeviceText::tr("connector %1").arg(QString::fromStdString(device.identity.bus));
  }
  if (!device.identity.serial.empty()) {
    parts << CameraDeviceText::tr("serial number %1")
                 .arg(QString::fromStdString(device.identity.serial));
  }
  return parts.join(QStringLiteral(" · "));
}

QString imageSizeText(int width, int height) {
  return QStringLiteral("%1 × %2").arg(width).arg(height);
}

QString imageFormatText(const QSize& size, double framesPerSecond) {
  const QString text = imageSizeText(size.width(), size.height());
  constexpr int kDecimals = 1;
  return framesPerSecond > 0.0 ? CameraDeviceText::tr("%1, %2 images per second")
                                     .arg(text, numberText(framesPerSecond, kDecimals))
                               : text;
}

QString formatSummaryText(const capture::CameraDevice& device) {
  QStringList formats;
  for (const capture::OfferedFormat& format : device.formats) {
    if (format.sizes.empty()) {
      formats << QString::fromStdString(format.pixelFormat);
      continue;
    }
    const capture::OfferedSize& size = format.sizes.front();
    formats << (size.frameRates.empty()
                    ? QStringLiteral("%1 %2").arg(QString::fromStdString(format.pixelFormat),
                                                  imageSizeText(size.width, size.height))
                    : CameraDeviceText::tr("%1 %2, %3 images per second")
                          .arg(QString::fromStdString(format.pixelFormat),
                               imageSizeText(size.width, size.height),
                               rateText(size.frameRates.front())));
  }
  return formats.join(QStringLiteral("; "));
}

QString formatDetailsText(const capture::CameraDevice& device) {
  QStringList lines;
  for (const capture::OfferedFormat& format : device.formats) {
    QStringList sizes;
    for (const capture::OfferedSize& size : format.sizes) {
      sizes << (size.frameRates.empty()
                    ? imageSizeText(size.width, size.height)
                    : QStringLiteral("%1 (%2)").arg(imageSizeText(size.width, size.height),
                                                    ratesText(size.frameRates)));
    }
    lines << QStringLiteral("%1: %2").arg(QString::fromStdString(format.pixelFormat),
                                          sizes.join(QStringLiteral(", ")));
  }
  return lines.join(QLatin1Char('\n'));
}

QString controlText(const capture::DeviceControl& control) {
  const auto* const known =
      std::ranges::find(kControlWords, std::string_view(control.name), &ControlWords::first);
  return known != kControlWords.end() ? CameraDeviceText::tr(known->second)
                                      : QString::fromStdString(control.label);
}

QString menuItemText(const capture::DeviceControl& control, const capture::ControlMenuItem& item) {
  if (control.name == "auto_exposure") { // the drivers' words are riddles
    switch (item.value) {
    case 0:
      return CameraDeviceText::tr("on");
    case 1:
      return CameraDeviceText::tr("off");
    case 2:
      return CameraDeviceText::tr("on, manual exposure time");
    case 3:
      return CameraDeviceText::tr("on, manual aperture");
    default:
      break;
    }
  }
  return QString::fromStdString(item.name);
}

QString colorAutomaticsText(const std::vector<capture::ColorAutomatic>& automatics) {
  QStringList names;
  for (const capture::ColorAutomatic automatic : automatics) {
    switch (automatic) {
    case capture::ColorAutomatic::Exposure:
      names << CameraDeviceText::tr("exposure");
      break;
    case capture::ColorAutomatic::Gain:
      names << CameraDeviceText::tr("gain");
      break;
    case capture::ColorAutomatic::WhiteBalance:
      names << CameraDeviceText::tr("white balance");
      break;
    case capture::ColorAutomatic::Hue:
      names << CameraDeviceText::tr("hue");
      break;
    }
  }
  return names.join(QStringLiteral(", "));
}

QString bandwidthShortageText(const capture::BandwidthShortage& shortage,
                              const QStringList& names) {
  return CameraDeviceText::tr("USB bus %1 cannot carry the images of %2: they need %3 Mbit/s, but "
                              "the bus has only %4 Mbit/s.")
      .arg(shortage.busNumber)
      .arg(cameraList(shortage.requestIndices, names), megabits(shortage.neededBitsPerSecond),
           megabits(shortage.availableBitsPerSecond));
}

QString bandwidthProposalText(const capture::BandwidthShortage& shortage,
                              const QStringList& names) {
  QStringList parts;
  for (const capture::BandwidthProposal& proposal : shortage.proposals) {
    parts << QStringLiteral("%1: %2").arg(
        names.value(static_cast<qsizetype>(proposal.requestIndex)),
        QString::fromStdString(describe(proposal.format)));
  }
  return parts.join(QStringLiteral(", "));
}

} // namespace dewpoint::ui
