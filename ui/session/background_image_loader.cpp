// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/background_image_loader.h"

#include "core/session/run/background_images.h"
#include "ui/jobs/background_job.h"
#include "ui/text/error_sentence.h"

#include <functional>
#include <utility>

namespace dewpoint::ui {

BackgroundImageLoader::BackgroundImageLoader(QObject* parent)
    : QObject(parent), job_(new BackgroundJob(this)) {
  connect(job_, &BackgroundJob::ended, this, [this](bool canceled) {
    if (canceled && nextProject_) {
      start(); // it was changed again meanwhile
    }
  });
}

BackgroundImageLoader::~BackgroundImageLoader() = default;

void BackgroundImageLoader::load(const Project& project) {
  nextProject_ = std::make_shared<const Project>(project);
  ++generation_;
  if (job_->isRunning()) {
    job_->cancel();
  } else {
    start();
  }
}

void BackgroundImageLoader::cancel() {
  nextProject_.reset();
  ++generation_;
}

void BackgroundImageLoader::start() {
  job_->start([this, generation = generation_,
               project = std::exchange(nextProject_, nullptr)](const auto&) {
    auto images = loadBackgroundImages(*project);
    return std::function<void()>([this, generation, project, images = std::move(images)] {
      if (generation != generation_) {
        return; // of another project, or changed again
      }
      if (!images) {
        Q_EMIT failed(errorText(images.error()));
        return;
      }
      std::vector<std::string> files;
      for (const ProjectCamera& camera : project->cameras) {
        files.push_back(camera.backgroundImageFile);
      }
      Q_EMIT loaded(files, *images);
    });
  });
}

} // namespace dewpoint::ui
