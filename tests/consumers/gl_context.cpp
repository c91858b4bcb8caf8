#include "consumers/gl_context.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GLES3/gl3.h>

#include <array>
#include <cstdlib>
#include <sstream>
#include <stdexcept>

#ifdef __SANITIZE_ADDRESS__
// Mesa leaves some kilobytes behind and is unloaded before the report, so that no suppression can name it.
extern "C" const char* __asan_default_options();
extern "C" const char* __asan_default_options() {
    return "detect_leaks=0";
}
#endif

namespace nacre::testing {
namespace {

[[noreturn]] void fail(const std::string& step) {
    std::ostringstream message;
    message << step << " (EGL error 0x" << std::hex << eglGetError()
            << "); this test draws with Mesa's software rasteriser: install the Debian packages libegl1, libegl-mesa0, "
               "libgles2 and libgl1-mesa-dri";
    throw std::runtime_error(message.str());
}

/// EGL's first device (EGL_EXT_platform_device: NVIDIA has no surfaceless platform), or EGL_NO_DISPLAY.
EGLDisplay first_device() {
    const auto query = reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
    EGLDeviceEXT device = EGL_NO_DEVICE_EXT;
    EGLint count = 0;
    if (query == nullptr || query(1, &device, &count) != EGL_TRUE || count == 0) return EGL_NO_DISPLAY;
    return eglGetPlatformDisplay(EGL_PLATFORM_DEVICE_EXT, device, nullptr);
}

std::string gl_string(GLenum name) {
    const GLubyte* text = glGetString(name);
    return text == nullptr ? "unknown" : reinterpret_cast<const char*>(text);
}

}  // namespace

GlContext::GlContext(GlApi api) {
    if (std::getenv("NACRE_TEST_HARDWARE_GL") == nullptr) {
        setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
    } else {
        display_ = first_device();
    }
    if (display_ == EGL_NO_DISPLAY) {
        display_ = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    }
    if (display_ == EGL_NO_DISPLAY) fail("no EGL display of the platform EGL_MESA_platform_surfaceless");
    if (eglInitialize(display_, nullptr, nullptr) != EGL_TRUE) fail("eglInitialize failed");
    try {
        create_context(api);
    } catch (...) {
        eglTerminate(display_);
        throw;
    }
}

void GlContext::create_context(GlApi api) {
    const bool es = api == GlApi::es_3_0;
    if (eglBindAPI(es ? EGL_OPENGL_ES_API : EGL_OPENGL_API) != EGL_TRUE) fail("eglBindAPI failed");
    const std::array<EGLint, 7> es_attributes{EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 0, EGL_NONE};
    const std::array<EGLint, 7> desktop_attributes{
        EGL_CONTEXT_MAJOR_VERSION,           4,       EGL_CONTEXT_MINOR_VERSION, 5, EGL_CONTEXT_OPENGL_PROFILE_MASK,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
    context_ = eglCreateContext(display_, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT,
                                es ? es_attributes.data() : desktop_attributes.data());
    const std::string name = es ? "OpenGL ES 3.0" : "OpenGL 4.5 core";
    if (context_ == EGL_NO_CONTEXT) fail("no " + name + " context");
    if (eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) != EGL_TRUE) {
        fail("the " + name + " context does not work without a surface");
    }
}

GlContext::~GlContext() {
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display_, context_);
    eglTerminate(display_);
}

std::string GlContext::description() const {
    return gl_string(GL_RENDERER) + ", " + gl_string(GL_VERSION);
}

}  // namespace nacre::testing
