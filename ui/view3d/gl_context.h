// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <memory>
#include <string>

namespace dewpoint::ui {

/// OpenGL context on an off-screen surface. It is in a separate file because the OpenGL headers of
/// Qt and of VTK cannot be included together.
class GlContext {
public:
  GlContext();
  ~GlContext();
  GlContext(const GlContext&) = delete;
  GlContext& operator=(const GlContext&) = delete;

  /// Sets the OpenGL format that VTK requires. Must be called once before the QApplication is
  /// created.
  static void prepareSurfaceFormat();

  /// Creates the context and makes it current. Returns an empty string on success, otherwise a
  /// message for users.
  std::string start();
  bool isCurrent() const;
  /// Makes the context current. Does nothing if it is current already, because VTK would otherwise
  /// produce empty images.
  void makeCurrent();
  void doneCurrent();

private:
  class Handles;
  std::unique_ptr<Handles> handles_;
};

} // namespace dewpoint::ui
