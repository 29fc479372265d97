// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QImage>
#include <QPoint>
#include <QSize>

#include <functional>
#include <memory>
#include <string>

class vtkRenderer;

namespace dewpoint::ui {

/// Renders a VTK scene in its own OpenGL context, which belongs to no window, and returns pictures.
/// Only for the GUI thread. Using it requires no VTK or OpenGL header.
class OffscreenVtk {
public:
  enum class Pointer {
    Move,
    LeftPress,
    LeftRelease,
    MiddlePress,
    MiddleRelease,
    RightPress,
    RightRelease,
    WheelUp,
    WheelDown
  };

  explicit OffscreenVtk(vtkRenderer* renderer);
  ~OffscreenVtk();
  OffscreenVtk(const OffscreenVtk&) = delete;
  OffscreenVtk& operator=(const OffscreenVtk&) = delete;

  /// Creates the context; call it once. Returns false if OpenGL is not usable: `reason()` then
  /// explains why, in English, and nothing else may be called.
  bool start();
  const std::string& reason() const;

  /// Renders one picture of this size in device pixels.
  QImage render(QSize size);

  /// Passes a mouse event to the trackball camera; `position` in device pixels from the top left
  /// corner.
  void pointer(Pointer what, QPoint position, bool shift, bool control);
  /// Called when the trackball has moved the camera.
  std::function<void()> onCameraMoved;

private:
  class Context;
  std::unique_ptr<Context> context_;
};

} // namespace dewpoint::ui
