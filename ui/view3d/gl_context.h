// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <memory>
#include <string>

namespace dewpoint::ui {

/// An OpenGL context on an off-screen surface. Apart from the VTK code, because the OpenGL headers
/// of Qt and of VTK's loader cannot be read together.
class GlContext {
public:
  GlContext();
  ~GlContext();
  GlContext(const GlContext&) = delete;
  GlContext& operator=(const GlContext&) = delete;

  /// To be called once before the QApplication is made.
  static void prepareSurfaceFormat();

  /// Makes it, and current. Empty on success, otherwise why not, for people.
  std::string start();
  bool isCurrent() const;
  /// Only if it is not current: doing it again would go behind VTK's state cache (empty pictures).
  void makeCurrent();
  void doneCurrent();

private:
  class Handles;
  std::unique_ptr<Handles> handles_;
};

} // namespace dewpoint::ui
