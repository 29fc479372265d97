// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/scene/scene.h"

#include <opencv2/core.hpp>

#include <cstdint>
#include <memory>

namespace dewpoint::simulation {

/// Renders the images of a scene by ray casting. Everything at rest is rendered once per camera in
/// the constructor. Rendering a frame then requires little more than drawing the moving objects and
/// adding noise.
class SceneRenderer {
public:
  explicit SceneRenderer(Scene scene);
  ~SceneRenderer();
  SceneRenderer(const SceneRenderer&) = delete;
  SceneRenderer& operator=(const SceneRenderer&) = delete;
  SceneRenderer(SceneRenderer&&) noexcept;
  SceneRenderer& operator=(SceneRenderer&&) noexcept;

  /// Renders the image of one camera in one frame (CV_8UC3, BGR). The result depends only on scene,
  /// camera and frame, so the function may be called from several threads and in any order.
  cv::Mat render(int camera, std::int64_t frame) const;

  const Scene& scene() const;

private:
  struct Parts;
  std::unique_ptr<const Parts> parts_;
};

} // namespace dewpoint::simulation
