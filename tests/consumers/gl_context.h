#pragma once

#include <string>

namespace nacre::testing {

enum class GlApi { es_3_0, desktop_4_5 };

/// A current OpenGL context without window, display server or graphics card; gone with this object.
///
/// EGL's surfaceless platform on Mesa's software rasteriser, so that every machine gives the same numbers. With
/// NACRE_TEST_HARDWARE_GL in the environment EGL's first device instead, if it lists any. One object at a time: the
/// display is the process's. libGLESv2 serves both APIs, because glvnd dispatches every entry point by the current
/// context.
class GlContext {
public:
    /// @throws std::runtime_error that names the step that failed and the Debian packages it needs
    explicit GlContext(GlApi api);
    ~GlContext();
    GlContext(const GlContext&) = delete;
    GlContext& operator=(const GlContext&) = delete;

    /// Renderer and version, as the driver says them.
    std::string description() const;

private:
    void create_context(GlApi api);

    void* display_ = nullptr;  // EGLDisplay and EGLContext, kept out of this header
    void* context_ = nullptr;
};

}  // namespace nacre::testing
