// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/view/video_plan.h"
#include "ui/export/video_picture.h"

#include <QWidget>

#include <optional>
#include <utility>
#include <vector>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QListWidget;

namespace dewpoint::ui {

/// Fields that define an exported video: its views, range, speed, size, frame rate and encoding.
class VideoForm : public QWidget {
  Q_OBJECT
public:
  explicit VideoForm(QWidget* parent = nullptr);

  /// Lists the views that can be exported. If the list is unchanged, its check marks are kept.
  void setViews(const std::vector<VideoView>& views);
  /// Lists the encodings that this computer can write.
  void setEncodings(std::vector<VideoEncoding> encodings);
  bool hasEncodings() const { return !encodings_.empty(); }

  /// Returns the composition of the images, with only the checked views and without the name of the
  /// recording.
  VideoLayout videoLayout() const;
  /// Returns the speed and frame rate of the video. `recorded` is the frame rate of the recording.
  VideoTiming timing(double recorded) const;
  /// Return the first and the last time to export (seconds); empty for the beginning and the end of
  /// the run.
  std::optional<double> startSeconds() const;
  std::optional<double> endSeconds() const;
  /// Returns the selected encoding; empty if there is none.
  std::optional<VideoEncoding> encoding() const;
  /// Returns the suffix of the selected encoding, including the dot; empty if there is none.
  QString fileSuffix() const;

  /// Proposes to export only this time range (seconds). If `seconds` is empty, the proposal is
  /// withdrawn, unless the user has edited the range.
  void setSelectedRange(std::optional<std::pair<double, double>> seconds);
  /// Resets the time range to the whole run, for another project.
  void resetRange();
  void retranslateUi();

Q_SIGNALS:
  void changed();
  void encodingChanged();

private:
  void makeFields();
  void fillChoices();

  QFormLayout* form_;
  QListWidget* views_ = nullptr;
  QDoubleSpinBox* from_ = nullptr;
  QDoubleSpinBox* to_ = nullptr;
  QDoubleSpinBox* speed_ = nullptr;
  QComboBox* size_ = nullptr;
  QDoubleSpinBox* rate_ = nullptr;
  QComboBox* encoding_ = nullptr;
  QCheckBox* titles_ = nullptr;
  QCheckBox* stamp_ = nullptr;
  std::vector<VideoView> offered_;
  std::vector<VideoEncoding> encodings_;
  std::pair<double, double> proposedRange_; ///< proposed range, seconds
};

} // namespace dewpoint::ui
