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

/// Reads the background images of a project in another thread. The run continues and uses them once
/// they are loaded.
class EmptyRoomLoader : public QObject {
  Q_OBJECT
public:
  explicit EmptyRoomLoader(QObject* parent = nullptr);
  ~EmptyRoomLoader() override;

  /// Reads the images of this project; replaces a load under way.
  void load(const Project& project);
  /// Drops a load under way: neither `loaded()` nor `failed()` follows.
  void forget();

Q_SIGNALS:
  /// Files and images, one per camera; empty where a camera has none.
  void loaded(const std::vector<std::string>& files, const std::vector<cv::Mat>& rooms);
  void failed(const QString& sentence);

private:
  void start();

  BackgroundJob* job_;
  std::shared_ptr<const Project> wanted_; ///< project to read next
  int generation_ = 0; ///< incremented by each load; results of earlier loads are dropped
};

} // namespace dewpoint::ui
