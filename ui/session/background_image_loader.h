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

/// Reads the background images of a project in another thread, while the run continues.
class BackgroundImageLoader : public QObject {
  Q_OBJECT
public:
  explicit BackgroundImageLoader(QObject* parent = nullptr);
  ~BackgroundImageLoader() override;

  /// Reads the background images of `project`. Replaces a load in progress.
  void load(const Project& project);
  /// Cancels a load in progress. Neither `loaded()` nor `failed()` follows.
  void cancel();

Q_SIGNALS:
  /// Emitted with the files and the images, one per camera; empty if a camera has no background
  /// image.
  void loaded(const std::vector<std::string>& files, const std::vector<cv::Mat>& images);
  void failed(const QString& sentence);

private:
  void start();

  BackgroundJob* job_;
  std::shared_ptr<const Project> nextProject_; ///< project to read next
  int generation_ = 0; ///< incremented by each load; results of earlier loads are ignored
};

} // namespace dewpoint::ui
