#include "io/image/swatch_canvas.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "nacre/base/image.h"

namespace nacre {
namespace {

struct PixelRange {
    int begin;
    int end;
};

// The pixels that [low, high] touches, within [0, size).
PixelRange pixels_between(double low, double high, int size) {
    const double limit = size;
    return {static_cast<int>(std::clamp(std::floor(low), 0.0, limit)),
            static_cast<int>(std::clamp(std::ceil(high), 0.0, limit))};
}

struct PixelBox {
    PixelRange columns;
    PixelRange rows;
};

// The pixels within `reach` of a line, of a picture of this size. @pre there are points
PixelBox pixels_near(const std::vector<Point>& points, double reach, int width, int height) {
    const auto [left, right] =
        std::minmax_element(points.begin(), points.end(), [](const Point& a, const Point& b) { return a.x < b.x; });
    const auto [top, bottom] =
        std::minmax_element(points.begin(), points.end(), [](const Point& a, const Point& b) { return a.y < b.y; });
    return {pixels_between(left->x - reach, right->x + reach, width),
            pixels_between(top->y - reach, bottom->y + reach, height)};
}

// How much of pixel i lies in [low, high].
double overlap(int i, double low, double high) {
    return std::max(0.0, std::min(high, i + 1.0) - std::max(low, static_cast<double>(i)));
}

double box_coverage(int x, int y, const Box& box) {
    return overlap(x, box.left, box.right) * overlap(y, box.top, box.bottom);
}

double distance_to_segment(Point p, Point a, Point b) {
    const double dx = b.x - a.x;
    const double dy = b.y - a.y;
    const double length_squared = dx * dx + dy * dy;
    const double along = length_squared > 0.0 ? ((p.x - a.x) * dx + (p.y - a.y) * dy) / length_squared : 0.0;
    const double t = std::clamp(along, 0.0, 1.0);
    return std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

// Always one line.
std::string printable(std::string text) {
    for (char& c : text) {
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = ' ';
    }
    return text;
}

void remove_last_letter(std::string& text) {
    const auto continues = [](char c) { return (c & 0xC0) == 0x80; };
    while (!text.empty() && continues(text.back())) text.pop_back();
    if (!text.empty()) text.pop_back();
}

// Down to two thirds of the size, then without its end.
void fit_to_width(std::string& text, int& size_px, double max_width_px, const TextFace& face) {
    // No letter is so narrow that more would fit; this bounds the search for long texts.
    constexpr std::size_t longest = 300;
    if (text.size() > longest) text.resize(longest);
    const auto is_too_wide = [&](const std::string& candidate) {
        return face.width_px(candidate, size_px) > max_width_px;
    };
    const int smallest_px = 2 * size_px / 3;
    while (size_px > smallest_px && is_too_wide(text)) --size_px;
    if (!is_too_wide(text)) return;
    std::string shortened = text;
    do {
        remove_last_letter(shortened);
        text = shortened + "…";
    } while (!shortened.empty() && is_too_wide(text));
}

// The coverage of everything within `reach` pixels of the letters.
Image<float> widened(const Image<float>& image, int reach) {
    Image<float> result(image.width(), image.height());
    for (int j = -reach; j <= reach; ++j) {
        for (int i = -reach; i <= reach; ++i) {
            const auto nearness = static_cast<float>(std::clamp(reach + 0.5 - std::hypot(i, j), 0.0, 1.0));
            for (int y = reach; y < image.height() - reach; ++y) {
                for (int x = reach; x < image.width() - reach; ++x)
                    result.at(x, y) = std::max(result.at(x, y), nearness * image.at(x + i, y + j));
            }
        }
    }
    return result;
}

double start_of(const Text& text, double width_px) {
    switch (text.align) {
        case Align::left:
            return text.baseline.x;
        case Align::centre:
            return text.baseline.x - 0.5 * width_px;
        case Align::right:
            return text.baseline.x - width_px;
    }
    return text.baseline.x;
}

}  // namespace

Canvas::Canvas(int width, int height, double background, const std::string& font)
    : pixels_(width, height, {background, background, background}), face_(font) {}

void Canvas::blend(int x, int y, Ink ink, double coverage) {
    if (x < 0 || x >= pixels_.width() || y < 0 || y >= pixels_.height()) return;
    Rgb& pixel = pixels_.at(x, y);
    const double opacity = ink.opacity * coverage;
    pixel.r = std::lerp(pixel.r, ink.grey, opacity);
    pixel.g = std::lerp(pixel.g, ink.grey, opacity);
    pixel.b = std::lerp(pixel.b, ink.grey, opacity);
}

void Canvas::paste(int left, int top, const Image<Rgb>& image) {
    // Light beyond the display's range must not glow through the antialiased edges of what is drawn over it.
    const auto clamped = [](double value) { return std::clamp(value, 0.0, 1.0); };
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const Rgb& colour = image.at(x, y);
            pixels_.at(left + x, top + y) = {clamped(colour.r), clamped(colour.g), clamped(colour.b)};
        }
    }
}

void Canvas::draw(const Polyline& line) {
    // Segments overlap at their joints; the largest coverage wins, so that joints are no darker than the line.
    if (line.points.empty()) return;
    const double reach = 0.5 * line.width_px + 0.5;
    const PixelBox all = pixels_near(line.points, reach, pixels_.width(), pixels_.height());
    Image<float> coverage(all.columns.end - all.columns.begin, all.rows.end - all.rows.begin);
    const auto coverage_at = [&](int x, int y) -> float& {
        return coverage.at(x - all.columns.begin, y - all.rows.begin);
    };
    for (std::size_t i = 0; i + 1 < line.points.size(); ++i) {
        const Point a = line.points[i];
        const Point b = line.points[i + 1];
        const auto [columns, rows] = pixels_near({a, b}, reach, pixels_.width(), pixels_.height());
        for (int y = rows.begin; y < rows.end; ++y) {
            for (int x = columns.begin; x < columns.end; ++x) {
                const double here = std::clamp(reach - distance_to_segment({x + 0.5, y + 0.5}, a, b), 0.0, 1.0);
                coverage_at(x, y) = std::max(coverage_at(x, y), static_cast<float>(here));
            }
        }
    }
    for (int y = all.rows.begin; y < all.rows.end; ++y) {
        for (int x = all.columns.begin; x < all.columns.end; ++x) {
            const double inside = line.clip ? box_coverage(x, y, *line.clip) : 1.0;
            if (coverage_at(x, y) > 0.0F) blend(x, y, line.ink, inside * coverage_at(x, y));
        }
    }
}

void Canvas::draw(const Rectangle& rectangle) {
    const Box& box = rectangle.box;
    const double line = rectangle.line_px.value_or(0.0);
    const Box inner{box.left + line, box.top + line, box.right - line, box.bottom - line};
    const PixelRange rows = pixels_between(box.top, box.bottom, pixels_.height());
    const PixelRange columns = pixels_between(box.left, box.right, pixels_.width());
    for (int y = rows.begin; y < rows.end; ++y) {
        for (int x = columns.begin; x < columns.end; ++x) {
            const double hole = rectangle.line_px ? box_coverage(x, y, inner) : 0.0;
            blend(x, y, rectangle.ink, box_coverage(x, y, box) - hole);
        }
    }
}

void Canvas::draw(const Text& text) {
    constexpr int halo_px = 3;
    constexpr Ink halo_ink{0.04, 0.7};
    std::string line = printable(text.text);
    int size_px = text.size_px;
    if (text.max_width_px > 0.0) fit_to_width(line, size_px, text.max_width_px, face_);
    const TextPixels letters = face_.draw(line, size_px);
    const int left = static_cast<int>(std::lround(start_of(text, face_.width_px(line, size_px)))) + letters.left;
    const int top = static_cast<int>(std::lround(text.baseline.y)) + letters.top;
    const auto lay = [&](const Image<float>& coverage, Ink ink) {
        for (int y = 0; y < coverage.height(); ++y) {
            for (int x = 0; x < coverage.width(); ++x) blend(left + x, top + y, ink, coverage.at(x, y));
        }
    };
    if (text.halo) lay(widened(letters.coverage, halo_px), halo_ink);
    lay(letters.coverage, {text.grey});
}

}  // namespace nacre
