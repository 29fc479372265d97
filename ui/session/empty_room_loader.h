// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QObject>
#include <QString>
#include <opencv2/core/mat.hpp>

#include <memory>
#include <string>
#include <vector>

namespace dewpoint::project {
struct Project;
} // namespace dewpoint::project

namespace dewpoint::ui {

class BackgroundJob;

/// Reads the pictures of a project's empty rooms beside the window; a run takes them and goes on.
class EmptyRoomLoader : public QObject {
  Q_OBJECT
public:
  explicit EmptyRoomLoader(QObject* parent = nullptr);
  ~EmptyRoomLoader() override;

  /// Reads those of this project instead of those that are being read.
  void load(const Project& project);
  /// Drops what is being read: neither loaded() nor failed() follows.
  void forget();

Q_SIGNALS:
  /// The files, one per camera, and what they show; empty where a camera has none.
  void loaded(const std::vector<std::string>& files, const std::vector<cv::Mat>& rooms);
  void failed(const QString& sentence);

private:
  void start();

  BackgroundJob* job_;
  std::shared_ptr<const Project> wanted_; ///< what is to be read next
  int generation_ = 0;                    ///< counts up; an answer to an earlier one is not given
};

} // namespace dewpoint::ui
