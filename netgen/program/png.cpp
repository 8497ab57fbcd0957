#include "netgen/program/png.h"

#include <cmath>
#include <librsvg/rsvg.h>
#include <memory>

#include "netgen/program/output.h"

namespace epsnet::program {
namespace {

/// Owns an object of a C library.
template <class T, auto release>
struct Releaser {
  void operator()(T* object) const { release(object); }
};
template <class T, auto release>
using Owned = std::unique_ptr<T, Releaser<T, release>>;

[[noreturn]] void fail(GError* error) {
  std::string message = "cannot make a PNG picture: ";
  message += error == nullptr ? "unknown error" : error->message;
  g_clear_error(&error);
  throw JobError(message);
}

}  // namespace

std::string png_of_svg(const std::string& svg, std::uint32_t width) {
  GError* error = nullptr;
  const Owned<GInputStream, g_object_unref> stream(
      g_memory_input_stream_new_from_data(svg.data(), static_cast<gssize>(svg.size()), nullptr));
  // No limit, as a path of a fine net is a text node of more than 10 MB.
  const Owned<RsvgHandle, g_object_unref> picture(
      rsvg_handle_new_from_stream_sync(stream.get(), nullptr, RSVG_HANDLE_FLAG_UNLIMITED, nullptr, &error));
  if (!picture) fail(error);
  double own_width = 1;
  double own_height = 1;
  rsvg_handle_get_intrinsic_size_in_pixels(picture.get(), &own_width, &own_height);
  const double height = std::round(own_height / own_width * width);
  const Owned<cairo_surface_t, cairo_surface_destroy> surface(
      cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(width), static_cast<int>(height)));
  const Owned<cairo_t, cairo_destroy> pen(cairo_create(surface.get()));
  cairo_set_source_rgb(pen.get(), 1, 1, 1);
  cairo_paint(pen.get());
  const RsvgRectangle viewport{0, 0, static_cast<double>(width), height};
  if (rsvg_handle_render_document(picture.get(), pen.get(), &viewport, &error) == 0) fail(error);
  std::string result;
  const auto append = [](void* out, const unsigned char* bytes, unsigned count) {
    static_cast<std::string*>(out)->append(reinterpret_cast<const char*>(bytes), count);
    return CAIRO_STATUS_SUCCESS;
  };
  const cairo_status_t status = cairo_surface_write_to_png_stream(surface.get(), append, &result);
  if (status != CAIRO_STATUS_SUCCESS)
    throw JobError(std::string("cannot make a PNG picture: ") + cairo_status_to_string(status));
  return result;
}

}  // namespace epsnet::program
