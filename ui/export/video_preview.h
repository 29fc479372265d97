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

/// Preview of a video: one image of the video, and a slider that selects this image. The first
/// image is shown until the user moves the slider, and again when the frames of the video change.
class VideoPreview : public QWidget {
  Q_OBJECT
public:
  explicit VideoPreview(QWidget* parent = nullptr);

  /// Sets the number of the frame, counted from 0, that each image of the video shows. An empty
  /// list means that there is no video.
  void setFrames(const std::vector<std::int64_t>& frames);
  /// Returns the number of the frame that the selected image shows. The list of setFrames() must
  /// not be empty.
  std::int64_t frame() const;
  /// Returns the size in which images are shown, in device pixels.
  QSize imageSize() const;
  /// Shows an image; a null image clears the preview.
  void showImage(const QImage& image);
  void retranslateUi();

Q_SIGNALS:
  /// Emitted when the user selects another image.
  void frameChosen();

private:
  void updateText();

  QLabel* image_;
  QSlider* slider_;
  QLabel* text_;
  std::vector<std::int64_t> frames_;
};

} // namespace dewpoint::ui
