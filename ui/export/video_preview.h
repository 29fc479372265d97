// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QWidget>

#include <cstdint>
#include <vector>

class QImage;
class QLabel;
class QSlider;

namespace dewpoint::ui {

/// Preview of a video: one of its images, and a slider that chooses which one. The first image is
/// shown until the user moves the slider, and again when the video consists of other frames.
class VideoPreview : public QWidget {
  Q_OBJECT
public:
  explicit VideoPreview(QWidget* parent = nullptr);

  /// Sets the frame that each image of the video shows, counted from 0. Empty: there is no video.
  void setFrames(const std::vector<std::int64_t>& frames);
  /// Returns the frame of the chosen image. There must be frames.
  std::int64_t frame() const;
  /// Returns the size in which images are shown, in device pixels.
  QSize imageSize() const;
  /// Shows an image; a null image clears the preview.
  void showImage(const QImage& image);
  void retranslateUi();

Q_SIGNALS:
  /// Emitted when the user chooses another image.
  void frameChosen();

private:
  void updateText();

  QLabel* image_;
  QSlider* slider_;
  QLabel* text_;
  std::vector<std::int64_t> frames_;
};

} // namespace dewpoint::ui
