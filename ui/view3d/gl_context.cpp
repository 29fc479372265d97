// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view3d/gl_context.h"

#include <QCoreApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QSurfaceFormat>

namespace dewpoint::ui {

class GlContext::Handles {
public:
  QOffscreenSurface surface; ///< must outlive the context
  QOpenGLContext context;
};

void GlContext::prepareSurfaceFormat() {
  QSurfaceFormat format;
  format.setRenderableType(QSurfaceFormat::OpenGL);
  format.setVersion(3, 2);
  format.setProfile(QSurfaceFormat::CoreProfile);
  format.setDepthBufferSize(24);
  format.setStencilBufferSize(8);
  format.setSamples(0);
  QSurfaceFormat::setDefaultFormat(format);
}

GlContext::GlContext() : handles_(std::make_unique<Handles>()) {}

GlContext::~GlContext() = default;

std::string GlContext::start() {
  QOpenGLContext& context = handles_->context;
  context.setFormat(QSurfaceFormat::defaultFormat());
  if (!context.create()) {
    return QCoreApplication::translate("GlContext", "no OpenGL context can be made on this display")
        .toStdString();
  }
  handles_->surface.setFormat(context.format());
  handles_->surface.create();
  if (!handles_->surface.isValid() || !context.makeCurrent(&handles_->surface)) {
    return QCoreApplication::translate("GlContext", "the OpenGL context cannot be used")
        .toStdString();
  }
  if (context.isOpenGLES() || context.format().version() < qMakePair(3, 2)) {
    context.doneCurrent();
    return QCoreApplication::translate("GlContext", "OpenGL 3.2 is needed").toStdString();
  }
  return {};
}

bool GlContext::isCurrent() const {
  return QOpenGLContext::currentContext() == &handles_->context;
}

void GlContext::makeCurrent() {
  if (!isCurrent()) {
    handles_->context.makeCurrent(&handles_->surface);
  }
}

void GlContext::doneCurrent() {
  handles_->context.doneCurrent();
}

} // namespace dewpoint::ui
