#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "nacre/optics/lobe.h"
#include "pipeline/baked_lut.h"
#include "pipeline/decide.h"
#include "pipeline/json.h"
#include "pipeline/loaded_scene.h"

namespace nacre {

/// What the page does with nacre: a scene is opened from its text, and its LUTs are baked in memory. The answers are
/// JSON of the types in page/api.ts; numbers by the thousand come beside it, as bytes.
///
/// Colour spaces are the core's own (lut/rgb_colour_space.h): the page has no OpenColorIO. Files that a scene names are
/// read from the program's file system, which in the page lies in memory. Every call throws Error with the message that
/// the program prints.
class Session {
public:
    /// Reads and plans a scene. What is wrong with it is part of the answer; then the scene that was open stays open.
    /// So does the scene of the same text, with what was baked of it.
    Json open(const std::string& text);

    /// To be told when a file has come that scenes may name.
    void files_changed() { files_changed_ = true; }

    struct Answer {
        Json json;
        std::vector<float> numbers;
    };
    /// Decides, computes and measures a LUT; a second call is answered from memory.
    /// @param is_coarse  at a bound eight times as wide, and not measured: a quick answer. It is not kept
    /// @throws Error if its bound was given and is out of reach, as the program refuses it
    /// The numbers are R, G, B of every texel as stored, the first row that of the smallest y.
    Answer bake(const std::string& lut, bool is_coarse = false);

    /// What a bound costs: the LUT as it would be with it.
    Json cost(const std::string& lut, double max_de00);

    /// The files of a LUT as `nacre bake` writes them.
    std::string exr(const std::string& lut);
    std::string manifest(const std::string& lut);

    /// Linear Rec.709 of bands, `columns` times `rows` of them: x is the width from 0 to `most_width_nm`, y the height
    /// from 0 to 1; the rest is that of `lobe`. Under the scene's light.
    std::vector<float> palette_field(const Lobe& lobe, double most_width_nm, int columns, int rows) const;

    /// The scene of the best structure of a mechanism that shows the picks of a palette: { text, summary }.
    /// @param step  called now and then with the number of calls before. May be empty; what it throws ends the search
    Json find_structure(const std::string& material, const std::string& mechanism,
                        const std::function<void(int done)>& step) const;

    /// CIE XYZ relative to D65 of a LUT's texels before they are converted and rounded: three numbers each.
    std::vector<double> xyz(const std::string& lut);

    /// Of the open scene.
    std::vector<std::string> luts() const;
    bool has_second_axis(const std::string& lut) const { return planned(lut).job.y.has_value(); }

private:
    struct Entry {
        DecidedLut decided;
        std::unique_ptr<BakedLut> baked;  // null until it is asked for
    };

    const LoadedScene& scene() const;
    const PlannedLut& planned(const std::string& lut) const;
    Entry& baked(const std::string& lut);

    std::vector<LoadedScene> scenes_;  // at most one
    std::vector<Entry> entries_;       // of the LUTs that were baked
    std::string text_;                 // of the open scene
    bool files_changed_ = false;       // since it was opened
};

}  // namespace nacre
